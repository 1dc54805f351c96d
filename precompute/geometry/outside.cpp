#include "precompute/geometry/outside.h"

#include <algorithm>
#include <cassert>
#include <map>

#include "core/base/short_number.h"
#include "precompute/base/error.h"

namespace fiatlux {
namespace {

constexpr double kVoid = 0.5;            // share of lost rays from which a side looks into the void
constexpr double kMostlyOneSided = 0.5;  // of a region
constexpr double kMostlyEncloses = 0.5;  // of a closed body
constexpr std::uint32_t kSwallows = 16;  // rays of others, at least, that it must meet
constexpr double kRoomy = 1;             // m, mean way of rays behind it
constexpr std::size_t kMostNames = 4;    // in the note
constexpr double kLittle = 1e-4;         // of the room's area: not worth a line

/// "20 m2" and "'floor' 12 m2, 'wall' 8 m2": what there is of each name, most first.
struct AreaList {
  double total = 0;  // m2
  std::string text;

  explicit AreaList(const std::map<std::string, double>& areas) {
    std::vector<std::pair<double, std::string>> order;
    for (const auto& [name, area] : areas) order.emplace_back(-area, name), total += area;
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < order.size() && i < kMostNames; ++i)
      text += (i ? ", '" : "'") + order[i].second + "' " + shortNumber(-order[i].first) + " m2";
    if (order.size() > kMostNames) text += " and " + std::to_string(order.size() - kMostNames) + " more";
  }
};

/// Whether a region lies wholly on such sides.
bool liesOn(const std::vector<std::array<bool, 2>>& sides, const SurfaceGroup& group, const Region& region) {
  return std::all_of(region.faces.begin(), region.faces.end(), [&](std::uint32_t f) {
    const Face& face = group.set.faces[f];
    return sides[face.triangle][face.back];
  });
}

/// A region whose front looks into the void, and whose back is met by what it encloses.
struct Enclosing {
  std::uint32_t leaf = 0;
  double area = 0;           // m2
  std::vector<Face> turned;  // its one-sided faces, as they would be turned
};

std::vector<Enclosing> whatEncloses(const WeldedMesh& mesh, const SurfaceTree& tree, const Outlook& outlook,
                                    const FreeSpace& space) {
  std::vector<Enclosing> found;
  for (const SurfaceGroup& group : tree.groups)
    for (std::size_t r = 0; r < group.regions.size(); ++r) {
      const Region& region = group.regions[r];
      double lost = 0, area = 0;
      std::uint32_t swallowed = 0;
      std::vector<Face> turned;
      for (const std::uint32_t f : region.faces) {
        const Face& face = group.set.faces[f];
        if (face.back || outlook.isSurface(face.triangle, true)) continue;
        const double own = length(areaVector(mesh.positions, face.vertex));
        area += own, lost += own * outlook.lost(face.triangle, false);
        swallowed += outlook.swallowed(face.triangle, true);
        turned.push_back(face), std::swap(turned.back().vertex[1], turned.back().vertex[2]);
      }
      // note: behind the outer face of a wall, which what ends in the wall looks at, there is no room
      if (area < kMostlyOneSided * region.area || lost < kVoid * area || swallowed < kSwallows ||
          space.from(turned, 0).path < kRoomy)
        continue;
      found.push_back({group.leafOfRegion[r], region.area, std::move(turned)});
    }
  return found;
}

/// A closed body is a room drawn from outside where most of it encloses; else it stands in an open room, on a
/// floor that goes on below it and looks at the backs.
void leaveBodiesWhole(const SourceScene& source, const WeldedMesh& mesh, std::vector<Enclosing>& found) {
  const std::vector<std::uint32_t> bodies = closedBodies(source, mesh);
  std::vector<double> encloses(bodies.size(), 0), whole(bodies.size(), 0);
  const auto add = [&](std::uint32_t t, std::vector<double>& areas) {
    if (bodies[t] != kNone) areas[bodies[t]] += length(areaVector(mesh.positions, mesh.triangles[t].vertex));
  };
  for (std::uint32_t t = 0; t < bodies.size(); ++t) add(t, whole);
  for (const Enclosing& region : found)
    for (const Face& face : region.turned) add(face.triangle, encloses);
  std::erase_if(found, [&](const Enclosing& region) {
    const std::uint32_t body = bodies[region.turned.front().triangle];
    return body != kNone && encloses[body] < kMostlyEncloses * whole[body];
  });
}

}  // namespace

bool turnOutwardSheets(WeldedMesh& mesh, std::vector<Face>& faces, Outlook& outlook) {
  assert(faces.size() >= mesh.triangles.size());
  bool turned = false;
  for (std::size_t f = mesh.triangles.size(); f < faces.size(); ++f) {
    Face& back = faces[f];
    Face& front = faces[back.triangle];
    if (mesh.triangles[back.triangle].backMesh != kNone) continue;  // two sheets, each with its own name
    if (outlook.lost(back.triangle, false) < kVoid || outlook.lost(back.triangle, true) >= kVoid) continue;
    std::swap(front.vertex, back.vertex);
    mesh.triangles[back.triangle].vertex = front.vertex;
    outlook.turn(back.triangle);
    turned = true;
  }
  return turned;
}

std::string turnWhatEncloses(const SourceScene& source, WeldedMesh& mesh, const SurfaceTree& tree,
                             const Outlook& outlook, const FreeSpace& space) {
  std::vector<Enclosing> found = whatEncloses(mesh, tree, outlook, space);
  if (found.empty()) return "";
  leaveBodiesWhole(source, mesh, found);
  std::map<std::string, double> areas;
  for (const Enclosing& region : found) {
    for (const Face& face : region.turned) mesh.triangles[face.triangle].vertex = face.vertex;
    areas[tree.names[region.leaf]] += region.area;
  }
  if (areas.empty()) return "";
  const AreaList list(areas);
  return shortNumber(list.total) +
         " m2 have one side, which looks away from the room they enclose, and are turned: " + list.text +
         "; --double-sided gives all faces two sides";
}

Outside leaveOut(const std::vector<std::array<bool, 2>>& sides, SurfaceTree& tree) {
  Outside outside;
  outside.nameOfTriangle.assign(sides.size(), kNone);
  const double total = areaOf(tree);

  // Take the regions out, and note what they were called.
  std::map<std::uint32_t, std::uint32_t> nameOfLeaf;
  std::map<std::string, double> areas;
  std::vector<bool> stays(tree.names.size(), false);
  for (SurfaceGroup& group : tree.groups) {
    std::vector<Region> regions;
    std::vector<std::uint32_t> leaves;
    for (std::size_t r = 0; r < group.regions.size(); ++r) {
      const Region& region = group.regions[r];
      const std::uint32_t leaf = group.leafOfRegion[r];
      if (!liesOn(sides, group, region)) {
        stays[leaf] = true;
        regions.push_back(std::move(group.regions[r]));
        leaves.push_back(leaf);
        continue;
      }
      const auto [found, fresh] = nameOfLeaf.emplace(leaf, static_cast<std::uint32_t>(outside.names.size()));
      if (fresh) outside.names.push_back(tree.names[leaf]);
      areas[tree.names[leaf]] += region.area;
      for (const std::uint32_t f : region.faces)
        if (!group.set.faces[f].back) outside.nameOfTriangle[group.set.faces[f].triangle] = found->second;
    }
    group.regions = std::move(regions);
    group.leafOfRegion = std::move(leaves);
  }
  if (outside.names.empty()) return outside;

  // Leaves without a region go, the others move up.
  std::vector<std::uint32_t> newLeaf(tree.names.size(), kNone);
  std::vector<std::string> names;
  for (std::uint32_t leaf = 0; leaf < newLeaf.size(); ++leaf) {
    if (!stays[leaf]) continue;
    newLeaf[leaf] = static_cast<std::uint32_t>(names.size());
    names.push_back(std::move(tree.names[leaf]));
  }
  tree.names = std::move(names);
  for (SurfaceGroup& group : tree.groups)
    for (std::uint32_t& leaf : group.leafOfRegion) leaf = newLeaf[leaf];
  const AreaList list(areas);
  if (list.total > kLittle * total)
    outside.note =
        shortNumber(list.total) +
        " m2 face the void or rest on something, no light comes there, and they are left out: " + list.text;
  return outside;
}

std::string noteOfShutOff(const std::vector<std::array<bool, 2>>& sides, const SurfaceTree& tree) {
  std::map<std::string, double> areas;
  for (const SurfaceGroup& group : tree.groups)
    for (std::size_t r = 0; r < group.regions.size(); ++r)
      if (liesOn(sides, group, group.regions[r]))
        areas[tree.names[group.leafOfRegion[r]]] += group.regions[r].area;
  const AreaList list(areas);
  if (!(list.total > kLittle * areaOf(tree))) return "";
  return shortNumber(list.total) +
         " m2 are shut off from all places for luminaires and stay dark (a sealed room, the inside of a "
         "wall): " +
         list.text;
}

}  // namespace fiatlux
