// Candidates are planes that face down; each is looked at once, and rules choose among them, the strictest
// first.
#include "precompute/geometry/ceilings.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>
#include <tuple>

#include "precompute/room/bounds.h"

namespace fiatlux {
namespace {

constexpr double kLevel = 0.9, kNamedLevel = 0.5;  // cos 26 degrees; 60 degrees where its author says ceiling
constexpr std::size_t kMostCandidates = 256;       // the named ones and then the largest ones
constexpr double kCrumb = 1e-3;                    // of the largest candidate's area: not worth a look

/// What a plane must have before it.
struct Rule {
  double low, high;  // m, to the floor below
  double path;       // m, mean way of rays by the cosine
};
constexpr Rule kUsual{2, 6, 1}, kUnusual{1.2, 50, 1}, kNamed{1.5, 50, 0.5};
constexpr double kOverFloor = 0.3;        // share of the plane that lies over such a floor
constexpr double kClose = 1;              // m: over what is closer there is no room
constexpr double kHollow = 0.5;           // share of the plane over such: it is the top of a cavity
constexpr double kMostLost = 0.6;         // share of the rays that may be lost
constexpr double kUsualEnough = 1 / 3.0;  // of the area by the unusual rule: then the usual one decides
constexpr double kFrontsEnough = 0.2;     // of the area with backs of sheets: then fronts alone count
constexpr double kSmallRoom = 0.7;     // mean way in heights above the floor, where nothing has a usual size
constexpr double kOfFootprint = 0.25;  // of the bounding box's: as large is a ceiling of any size
constexpr double kOrnament = 0.05;     // of what looks like a ceiling: a named rose is none
constexpr double kSameFloor = 1;       // m: floors closer than this are of one storey
constexpr double kBeside = 0.03;       // of the largest one's area: a ceiling of the same storey
constexpr double kStoreyShare = 0.1;   // of the largest storey's: one more storey

// Many small planes at one height are the panels of one ceiling.
constexpr double kPanel = 4;         // m2
constexpr double kOneHeight = 0.01;  // m
constexpr std::size_t kPanels = 8;

struct Candidate {
  std::vector<Face> faces;
  double area;  // m2
  double at;    // m, its height
  std::uint32_t leaf;
  bool named;
  bool isBack;  // of a sheet whose front faces up: a floor, or the cap of a wall
  FreeSpace::View view;

  double floor() const { return at - view.height(); }
  bool isOutdoors() const { return view.sky >= kOpenSky; }
  bool keeps(const Rule& rule) const {
    return view.floorsWithin(rule.low, rule.high) >= kOverFloor && view.floorsWithin(0, kClose) < kHollow &&
           view.path >= rule.path && view.lost < kMostLost;
  }
};
using Candidates = std::vector<Candidate>;

std::vector<Face> facesOf(const SurfaceGroup& group, const Region& region) {
  std::vector<Face> faces;
  for (const std::uint32_t f : region.faces) faces.push_back(group.set.faces[f]);
  return faces;
}

bool isSmallAndAlike(const Candidate& a, const Candidate& b) {
  return a.area < kPanel && b.area < kPanel && a.named == b.named && a.isBack == b.isBack &&
         std::abs(a.at - b.at) < kOneHeight;
}

/// Panels at one height as one; as its leaf that of the largest.
void joinPanels(Candidates& all) {
  std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
    return std::tuple(a.area >= kPanel, a.named, a.isBack, a.at, -a.area) <
           std::tuple(b.area >= kPanel, b.named, b.isBack, b.at, -b.area);
  });
  Candidates joined;
  for (std::size_t i = 0, j; i < all.size(); i = j) {
    for (j = i + 1; j < all.size() && isSmallAndAlike(all[i], all[j]); ++j) {
    }
    if (j - i < kPanels) {
      std::move(all.begin() + static_cast<std::ptrdiff_t>(i), all.begin() + static_cast<std::ptrdiff_t>(j),
                std::back_inserter(joined));
      continue;
    }
    Candidate whole = std::move(all[i]);
    for (std::size_t k = i + 1; k < j; ++k) {
      whole.area += all[k].area;
      whole.faces.insert(whole.faces.end(), all[k].faces.begin(), all[k].faces.end());
    }
    joined.push_back(std::move(whole));
  }
  all = std::move(joined);
}

/// Named ones first, then by area.
Candidates candidatesOf(const SourceScene& source, const WeldedMesh& mesh, const SurfaceTree& tree,
                        const FreeSpace& space) {
  Candidates all;
  for (const SurfaceGroup& group : tree.groups)
    for (std::size_t r = 0; r < group.regions.size(); ++r) {
      const Region& region = group.regions[r];
      const SourceMesh& from = source.meshes[group.set.faces[region.faces[0]].mesh];
      const bool named = saysCeiling(from.node) || saysCeiling(from.extras.surface) ||
                         (from.material >= 0 && saysCeiling(source.materials[from.material].name));
      if (region.normal.y > -(named ? kNamedLevel : kLevel)) continue;
      const Face& face = group.set.faces[region.faces[0]];
      const bool isBack = face.back && mesh.triangles[face.triangle].backMesh == kNone;
      all.push_back(
          {facesOf(group, region), region.area, region.centroid.y, group.leafOfRegion[r], named, isBack, {}});
    }
  joinPanels(all);
  double largest = 0;
  for (const Candidate& c : all) largest = std::max(largest, c.area);
  all.erase(
      std::remove_if(all.begin(), all.end(), [&](const Candidate& c) { return c.area < kCrumb * largest; }),
      all.end());
  std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
    return a.named != b.named ? a.named : a.area > b.area;
  });
  if (all.size() > kMostCandidates) all.resize(kMostCandidates);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].view = space.from(all[i].faces, i);
  return all;
}

template <class Test>
Candidates chosen(const Candidates& all, const Test& test) {
  Candidates some;
  std::copy_if(all.begin(), all.end(), std::back_inserter(some), test);
  return some;
}

double areaOf(const Candidates& candidates) {
  double area = 0;
  for (const Candidate& c : candidates) area += c.area;
  return area;
}

/// Those that keep the usual rule, or the unusual one where that is most of what there is.
Candidates roomy(const Candidates& all) {
  const auto keeping = [&](const Rule& rule) {
    return chosen(all, [&](const Candidate& c) { return c.keeps(rule); });
  };
  Candidates usual = keeping(kUsual), unusual = keeping(kUnusual);
  return areaOf(usual) >= kUsualEnough * areaOf(unusual) ? usual : unusual;
}

/// What is drawn facing down; backs of sheets only where that is next to nothing.
Candidates roomyFrontsFirst(const Candidates& all) {
  Candidates fronts = roomy(chosen(all, [](const Candidate&c) { return !c.isBack; })), any = roomy(all);
  return areaOf(fronts) >= kFrontsEnough * areaOf(any) ? fronts : any;
}

/// Indoors, or where there is nothing indoors, in the open.
Candidates roomyIndoorsFirst(const Candidates& all) {
  const Candidates indoors =
      roomyFrontsFirst(chosen(all, [](const Candidate& c) { return !c.isOutdoors(); }));
  return indoors.empty() ? roomyFrontsFirst(all) : indoors;
}

/// Without regard to what its author says; `footprint`: of the bounding box, m2.
Candidates byLooks(const Candidates& all, double footprint) {
  Candidates found = roomyIndoorsFirst(all);
  if (!found.empty()) return found;
  return chosen(all, [&](const Candidate& c) {
    return !c.isBack && c.area >= kOfFootprint * footprint && c.view.height() > 0 &&
           c.view.path >= kSmallRoom * c.view.height() && c.view.lost < kMostLost;
  });
}

/// By name, and of storeys where nothing is named, by looks.
Candidates proposed(const Candidates& all, double footprint) {
  const Candidates looking = byLooks(all, footprint);
  Candidates found = chosen(all, [](const Candidate& c) { return c.named && c.keeps(kNamed); });
  if (areaOf(found) < kOrnament * areaOf(looking)) found.clear();
  const std::size_t named = found.size();
  for (const Candidate& c : looking) {
    if (named > 0 && (c.isBack || !c.keeps(kUsual))) continue;  // the earth below a floor, say
    const auto hasNamed = [&](const Candidate& other) {
      return std::abs(other.floor() - c.floor()) < kSameFloor;
    };
    if (std::none_of(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(named), hasNamed))
      found.push_back(c);
  }
  if (!found.empty()) return found;
  return chosen(all, [&](const Candidate& c) { return c.named && c.area >= kOfFootprint * footprint; });
}

/// Those on one floor together; `found` is in order of area.
std::vector<Candidates> storeysOf(Candidates found) {
  std::stable_sort(found.begin(), found.end(),
                   [](const Candidate& a, const Candidate& b) { return a.area > b.area; });
  std::vector<Candidates> storeys;
  for (const Candidate& c : found) {
    const auto home = std::find_if(storeys.begin(), storeys.end(), [&](const Candidates& storey) {
      return std::abs(storey[0].floor() - c.floor()) < kSameFloor;
    });
    if (home == storeys.end())
      storeys.push_back({c});
    else if (c.named || c.area >= kBeside * (*home)[0].area)
      home->push_back(c);
  }
  std::stable_sort(storeys.begin(), storeys.end(),
                   [](const Candidates& a, const Candidates& b) { return areaOf(a) > areaOf(b); });
  return storeys;
}

}  // namespace

bool saysCeiling(const std::string& name) {
  constexpr std::array<std::string_view, 6> kWords = {"ceiling", "decke",    "plafond",
                                                      "techo",   "soffitto", "ifccovering"};
  constexpr std::array<std::string_view, 8> kOthers = {"lamp",   "light",    "leuchte",    "fan",
                                                       "ventil", "tischdec", "plafonnier", "bettdec"};
  std::string lower = name;
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const auto says = [&](std::string_view word) { return lower.find(word) != std::string::npos; };
  return std::any_of(kWords.begin(), kWords.end(), says) &&
         std::none_of(kOthers.begin(), kOthers.end(), says);
}

std::vector<Ceiling> proposeCeilings(const SourceScene& source, const WeldedMesh& mesh,
                                     const SurfaceTree& tree, const FreeSpace& space) {
  const Vec3 size = boundsOf(mesh.positions).size();
  const std::vector<Candidates> storeys =
      storeysOf(proposed(candidatesOf(source, mesh, tree, space), size.x * size.z));
  std::vector<Ceiling> ceilings;
  for (const Candidates& storey : storeys) {
    const double area = areaOf(storey);
    if (!ceilings.empty() && area < kStoreyShare * ceilings[0].area) break;
    Ceiling ceiling{tree.names[storey[0].leaf], {}, area, storey[0].view.height(), storey[0].isOutdoors()};
    for (const Candidate& c : storey)
      ceiling.faces.insert(ceiling.faces.end(), c.faces.begin(), c.faces.end());
    ceilings.push_back(std::move(ceiling));
  }
  return ceilings;
}

}  // namespace fiatlux
