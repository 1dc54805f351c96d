#include "precompute/geometry/mounts.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

#include "core/base/short_number.h"
#include "core/scene/luminaire.h"
#include "precompute/base/error.h"
#include "precompute/base/names.h"
#include "precompute/geometry/sites.h"
#include "precompute/room/bounds.h"

namespace fiatlux {
namespace {

bool within(const std::string& path, const std::string& name) {
  return path == name ||
         (path.size() > name.size() && path.compare(0, name.size(), name) == 0 && path[name.size()] == '/');
}

// What is proposed as a mount: planes that look down and lie high, of some size beside the largest one and
// about as high.
constexpr double kCeilingLike = 0.9;                  // cos 26 degrees
constexpr double kBeside = 0.1, kAsHigh = 0.3;        // of its area; m
constexpr double kHidden = 0.5;                       // share of lost rays: it looks into the void
constexpr double kNamedWeight = 16, kWordWeight = 4;  // of the author's "ceiling", of ours

// The spacing of sites where none is said.
constexpr double kUsualSites = 256, kManySites = 1000;          // in all, of a usual and of a huge room
constexpr double kStep = 0.05, kFinest = 0.3, kCoarsest = 1.5;  // m

std::vector<Mount> markedMounts(const SourceScene& source, const std::vector<Face>& faces) {
  std::vector<Mount> mounts;
  std::unordered_map<std::uint32_t, std::size_t> ofNode;
  for (const Face& face : faces) {
    const SourceMesh& mesh = source.meshes[face.mesh];
    if (!mesh.extras.mount) continue;
    const auto [found, fresh] = ofNode.emplace(mesh.nodeIndex, mounts.size());
    if (fresh)
      mounts.push_back({mesh.node, {}, mesh.extras.siteSpacing.value_or(0), mesh.extras.drop.value_or(0)});
    mounts[found->second].faces.push_back(face);
  }
  return mounts;
}

void addNamedMounts(const SourceScene& source, const SurfaceTree& tree, const std::vector<Face>& faces,
                    const std::vector<std::string>& wanted, std::vector<Mount>& mounts) {
  for (const std::string& name : wanted) {
    Mount mount{name, {}, 0};
    for (const SurfaceGroup& group : tree.groups)
      for (std::size_t r = 0; r < group.regions.size(); ++r)
        if (within(tree.names[group.leafOfRegion[r]], name) ||
            within(tree.names[group.leafOfRegion[r]], name + " (back)"))
          for (const std::uint32_t f : group.regions[r].faces) mount.faces.push_back(group.set.faces[f]);
    if (mount.faces.empty())
      for (const Face& face : faces)
        if (source.meshes[face.mesh].node == name) mount.faces.push_back(face);
    if (mount.faces.empty()) {
      std::vector<std::string> names = askedNames(source);
      names.insert(names.end(), tree.names.begin(), tree.names.end());
      unknownName("--mount", name, names);
    }
    for (const Face& face : mount.faces) {
      const NodeExtras& extras = source.meshes[face.mesh].extras;
      mount.spacing = extras.siteSpacing.value_or(mount.spacing);
      mount.drop = extras.drop.value_or(mount.drop);
    }
    mounts.push_back(std::move(mount));
  }
}

/// The ceiling: the largest plane that faces down in the upper half, and others about as high.
std::vector<Mount> proposedMounts(const SourceScene& source, const WeldedMesh& mesh, const SurfaceTree& tree,
                                  const Outlook& outlook, std::vector<std::string>& warnings) {
  const Bounds bounds = boundsOf(mesh.positions);
  const double low = bounds.low.y, middle = 0.5 * (low + bounds.high.y);
  struct Candidate {
    const SurfaceGroup* group;
    const Region* region;
    std::uint32_t leaf;
  };
  std::vector<Candidate> candidates;
  const Candidate* best = nullptr;
  const auto isHidden = [&](const SurfaceGroup& group, const Region& region) {
    const Face& face = group.set.faces[region.faces[0]];
    return outlook.lost(face.triangle, face.back) >= kHidden;
  };

  // What looks into the void only where there is nothing else.
  for (const bool evenHidden : {false, true}) {
    if (!candidates.empty()) break;
    for (const SurfaceGroup& group : tree.groups)
      for (std::size_t r = 0; r < group.regions.size(); ++r)
        if (group.regions[r].normal.y < -kCeilingLike && group.regions[r].centroid.y > middle &&
            (evenHidden || !isHidden(group, group.regions[r])))
          candidates.push_back({&group, &group.regions[r], group.leafOfRegion[r]});
  }
  // What its author calls a ceiling counts more than what looks like one, and that more than a plain roof.
  const auto weight = [&](const Candidate& c) {
    const SourceMesh& from = source.meshes[c.group->set.faces[c.region->faces[0]].mesh];
    const auto saysCeiling = [](const std::string& name) { return name.find("eiling") != std::string::npos; };
    const bool named = saysCeiling(from.node) || saysCeiling(from.extras.surface) ||
                       (from.material >= 0 && saysCeiling(source.materials[from.material].name));
    return c.region->area * (named ? kNamedWeight : saysCeiling(tree.names[c.leaf]) ? kWordWeight : 1);
  };
  for (const Candidate& c : candidates)
    if (!best || weight(c) > weight(*best)) best = &c;
  std::vector<Mount> mounts;
  if (!best) return mounts;

  // The best one, and what lies about as high.
  mounts.push_back({tree.names[best->leaf], {}, 0});
  double area = 0;
  for (const Candidate& c : candidates) {
    if (c.region->area < kBeside * best->region->area ||
        std::abs(c.region->centroid.y - best->region->centroid.y) > kAsHigh)
      continue;
    area += c.region->area;
    for (const std::uint32_t f : c.region->faces) mounts[0].faces.push_back(c.group->set.faces[f]);
  }
  warnings.push_back("no mount is marked: luminaires are proposed to hang on '" + mounts[0].name + "' (" +
                     shortNumber(area) + " m2, " + shortNumber(best->region->centroid.y - low) +
                     " m up); choose with --mount");
  return mounts;
}

}  // namespace

std::vector<std::string> askedNames(const SourceScene& source) {
  std::set<std::string> names;
  for (const SourceMesh& mesh : source.meshes) {
    names.insert(mesh.node);
    if (!mesh.extras.surface.empty()) names.insert(mesh.extras.surface);
  }
  return {names.begin(), names.end()};
}

void unknownName(const char* option, const std::string& name, const std::vector<std::string>& names) {
  throw CommandError(std::string(option) + " '" + cleanText(name) +
                     "': no node or surface is called that; the closest are " + closestNames(name, names));
}

std::vector<Mount> findMounts(const SourceScene& source, const WeldedMesh& mesh, const SurfaceTree& tree,
                              const std::vector<Face>& faces, const Outlook& outlook,
                              const RoomOptions& options, std::vector<std::string>& warnings) {
  std::vector<Mount> mounts = markedMounts(source, faces);
  addNamedMounts(source, tree, faces, options.mounts, mounts);
  if (!mounts.empty() || !options.requireSites) return mounts;
  mounts = proposedMounts(source, mesh, tree, outlook, warnings);
  if (mounts.empty())
    throw CommandError(
        "nowhere to hang luminaires: no node is marked as mount and nothing large and high faces down; "
        "pass --mount with one of " +
        closestNames("ceiling", tree.names));
  return mounts;
}

std::vector<Face> facesWithSites(const WeldedMesh& mesh, const std::vector<Mount>& mounts) {
  std::vector<Face> all;
  for (const Mount& mount : mounts) {
    const std::vector<Face> faces = facesForSites(mesh, mount.faces);
    all.insert(all.end(), faces.begin(), faces.end());
  }
  return all;
}

namespace {

/// Hangs the sites `drop` metres lower, without those that something stands in the way of.
void lower(const Mount& mount, double drop, const RayTracer& tracer, std::vector<Site>& sites,
           std::vector<std::string>& warnings) {
  const std::size_t before = sites.size();
  const auto isInTheWay = [&](const Site& site) {
    RayPacket cord;
    const double clear = kLuminaireClearance;
    tracer.aim(cord, site.position + clear * site.normal, site.normal, drop);
    bool blocked[RayPacket::kSize];
    tracer.occluded(cord, blocked);
    return blocked[0];
  };
  sites.erase(std::remove_if(sites.begin(), sites.end(), isInTheWay), sites.end());
  for (Site& site : sites) site.position += drop * site.normal;
  if (sites.size() < before)
    warnings.push_back(std::to_string(before - sites.size()) + " of " + std::to_string(before) +
                       " sites of mount '" + mount.name + "' are left out: something is less than " +
                       shortNumber(drop) + " m below them; pass a smaller --drop");
}

}  // namespace

void addSites(const WeldedMesh& mesh, const std::vector<Mount>& mounts, const RayTracer& tracer,
              const RoomOptions& options, Room& room) {
  double area = 0;
  for (const Mount& mount : mounts) area += mountArea(mesh, mount.faces);
  const double sensible = std::clamp(std::round(std::sqrt(area / kUsualSites) / kStep) * kStep, kFinest,
                                     std::max(kCoarsest, std::sqrt(area / kManySites)));
  for (const Mount& mount : mounts) {
    const double spacing = options.siteSpacing > 0 ? options.siteSpacing
                           : mount.spacing > 0     ? mount.spacing
                                                   : sensible;
    const double size = options.siteSize > 0 ? options.siteSize : spacing;
    const double expected = mountArea(mesh, mount.faces) / (spacing * spacing);
    RunCounts counts = countsOf(options, room);
    counts.sites += expected;
    orThrow(checkMemory(counts, options.memory));
    std::vector<Site> sites = sitesOn(mesh, mount.faces, spacing, size);
    if (sites.empty())
      room.warnings.push_back("mount '" + mount.name + "' has no room for a whole square of " +
                              shortNumber(size) + " m; pass a smaller --site-spacing");
    const double drop = options.drop > 0 ? options.drop : mount.drop;
    if (drop > 0 && !sites.empty()) lower(mount, drop, tracer, sites, room.warnings);
    room.sites.insert(room.sites.end(), sites.begin(), sites.end());
  }
  if (room.sites.empty() && options.requireSites)
    throw CommandError("no site fits on any mount (" +
                       (mounts.empty() ? "none" : "'" + mounts[0].name + "'") +
                       "): pass a smaller --site-spacing, or another --mount");
}

}  // namespace fiatlux
