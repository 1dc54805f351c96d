#include "precompute/geometry/mounts.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>

#include "core/base/short_number.h"
#include "core/scene/luminaire.h"
#include "precompute/base/error.h"
#include "precompute/base/names.h"
#include "precompute/geometry/ceilings.h"
#include "precompute/geometry/open_floor.h"
#include "precompute/geometry/sites.h"

namespace fiatlux {
namespace {

bool within(const std::string& path, const std::string& name) {
  return path == name ||
         (path.size() > name.size() && path.compare(0, name.size(), name) == 0 && path[name.size()] == '/');
}

// What is proposed.
constexpr double kLow = 1.8, kHigh = 9;                              // m: heights of ceilings worth a word
constexpr double kFoot = 0.3048, kLowInFeet = 2.3, kHighInFeet = 4;  // m: usual ones, were they in feet
constexpr double kHeadroom = 1;                                      // m, free below a site
constexpr double kSqueezed = 0.3;                                    // m, to both sides of it: within a wall
constexpr double kOnWall = 0.005;                                    // m: a place as near to a wall is on it
constexpr double kUnder = 0.05;   // m: what comes as near to a ceiling stands below it; it may be rough
constexpr double kWithin = 0.98;  // of a site's square: what touches its edge does not cross it
constexpr int kExact = 17;        // digits of a number in an identity
constexpr std::size_t kMostStoreys = 4;  // that are told

// The spacing of sites where none is said.
constexpr double kUsualSites = 256, kManySites = 400;           // in all, of a usual and of a huge room
constexpr double kStep = 0.05, kFinest = 0.3, kCoarsest = 1.5;  // m

std::vector<Mount> markedMounts(const SourceScene& source, const std::vector<Face>& faces) {
  std::vector<Mount> mounts;
  std::unordered_map<std::uint32_t, std::size_t> ofNode;
  for (const Face& face : faces) {
    const SourceMesh& mesh = source.meshes[face.mesh];
    if (!mesh.extras.mount) continue;
    const auto [found, fresh] = ofNode.emplace(mesh.nodeIndex, mounts.size());
    if (fresh)
      mounts.push_back({mesh.node,
                        {},
                        mesh.extras.siteSpacing.value_or(0),
                        mesh.extras.siteSize.value_or(0),
                        mesh.extras.drop.value_or(0),
                        false,
                        false});
    mounts[found->second].faces.push_back(face);
  }
  return mounts;
}

/// Adds the faces of all surfaces below `name`, of the nodes of that name, or of what a pattern matches.
void addFaces(const SourceScene& source, const SurfaceTree& tree, const std::vector<Face>& faces,
              const std::string& name, Mount& mount) {
  const bool isPattern = name.find_first_of("*?") != std::string::npos;
  const auto isAsked = [&](const std::string& path) {
    return isPattern ? matchesPattern(name, path) : within(path, name) || within(path, name + " (back)");
  };
  for (const SurfaceGroup& group : tree.groups)
    for (std::size_t r = 0; r < group.regions.size(); ++r)
      if (isAsked(tree.names[group.leafOfRegion[r]]))
        for (const std::uint32_t f : group.regions[r].faces) mount.faces.push_back(group.set.faces[f]);
  if (!mount.faces.empty()) return;
  for (const Face& face : faces) {
    const std::string& node = source.meshes[face.mesh].node;
    if (isPattern ? matchesPattern(name, node) : node == name) mount.faces.push_back(face);
  }
}

/// Says what might have been meant: by meaning where a ceiling was asked for, else by spelling.
[[noreturn]] void unknownMount(const SourceScene& source, const WeldedMesh& mesh, const SurfaceTree& tree,
                               const FreeSpace& space, const std::string& name) {
  std::vector<std::string> names = askedNames(source), ceilings;
  names.insert(names.end(), tree.names.begin(), tree.names.end());
  if (saysCeiling(name) || matchesPattern("*roof*", name)) {
    std::copy_if(names.begin(), names.end(), std::back_inserter(ceilings), saysCeiling);
    if (ceilings.empty())
      for (const Ceiling& ceiling : proposeCeilings(source, mesh, tree, space))
        ceilings.push_back(ceiling.name);
  }
  unknownName("--mount", name, ceilings.empty() ? names : ceilings);
}

void addNamedMounts(const SourceScene& source, const WeldedMesh& mesh, const SurfaceTree& tree,
                    const std::vector<Face>& faces, const FreeSpace& space,
                    const std::vector<std::string>& wanted, std::vector<Mount>& mounts) {
  for (const std::string& name : wanted) {
    Mount mount{name, {}};
    addFaces(source, tree, faces, name, mount);
    if (mount.faces.empty()) unknownMount(source, mesh, tree, space, name);
    for (const Face& face : mount.faces) {
      const NodeExtras& extras = source.meshes[face.mesh].extras;
      mount.spacing = extras.siteSpacing.value_or(mount.spacing);
      mount.size = extras.siteSize.value_or(mount.size);
      mount.drop = extras.drop.value_or(mount.drop);
    }
    mounts.push_back(std::move(mount));
  }
}

/// What is said of a ceiling as high as few are, or as those of a room in feet; "" of a usual one.
std::string wordOnHeight(double height) {
  const bool isOfFeet = kFoot * height >= kLowInFeet && kFoot * height <= kHighInFeet;
  if (!(height > 0) || (height >= kLow && height <= kHigh && !isOfFeet)) return "";
  return "the ceiling is " + shortNumber(height) +
         (isOfFeet ? " m above the floor: is that so? in feet it would be " + shortNumber(kFoot * height) +
                         " m: --scale 0.3048"
                   : " m above the floor: is that so? --scale says how many metres a unit of the file has");
}

/// The ceilings of every storey, the largest first.
std::vector<Mount> proposedMounts(const SourceScene& source, const WeldedMesh& mesh, const SurfaceTree& tree,
                                  const FreeSpace& space, std::vector<std::string>& warnings) {
  const std::vector<Ceiling> ceilings = proposeCeilings(source, mesh, tree, space);
  std::vector<Mount> mounts;
  std::string told;
  for (const Ceiling& ceiling : ceilings) {
    mounts.push_back({ceiling.name, ceiling.faces, 0, 0, 0, true, !ceiling.isOutdoors});
    if (mounts.size() > kMostStoreys) continue;
    told += (told.empty()         ? "'"
             : mounts.size() == 2 ? ", of other storeys '"
                                  : ", '") +
            ceiling.name + "' (" + shortNumber(ceiling.area) + " m2" +
            (ceiling.height > 0 ? ", " + shortNumber(ceiling.height) + " m above the floor)" : ")");
  }
  if (mounts.empty()) return mounts;
  if (mounts.size() > kMostStoreys) told += " and " + std::to_string(mounts.size() - kMostStoreys) + " more";
  warnings.push_back("no mount is marked: luminaires are proposed to hang on " + told +
                     "; choose with --mount");
  const std::string height = wordOnHeight(ceilings[0].height);
  if (!height.empty()) warnings.push_back(height);
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
                              const std::vector<Face>& faces, const FreeSpace& space,
                              const RoomOptions& options, std::vector<std::string>& warnings) {
  std::vector<Mount> mounts;
  if (options.ceiling == 0) mounts = markedMounts(source, faces);
  addNamedMounts(source, mesh, tree, faces, space, options.mounts, mounts);
  if (!mounts.empty() || !options.requireSites || options.ceiling > 0) return mounts;
  return proposedMounts(source, mesh, tree, space, warnings);
}

Mount planeMount(const WeldedMesh& mesh, const SurfaceTree& tree, const FreeSpace& space,
                 const RoomOptions& options, std::vector<std::string>& warnings) {
  const std::optional<OpenFloor> floor = largestFloor(mesh, tree, space);
  if (!floor)
    throw CommandError(
        "nowhere to hang luminaires: no node is marked as mount, nothing faces down over a floor, and there "
        "is "
        "no floor with free space above; pass --mount with one of " +
        closestNames("ceiling", tree.names));
  const double height = options.ceiling > 0 ? options.ceiling : proposedHeight(*floor);
  if (options.ceiling == 0)
    warnings.push_back("nothing is a ceiling: luminaires are proposed to hang in a plane " +
                       shortNumber(height) + " m above '" + floor->name + "' (" + shortNumber(floor->area) +
                       " m2); --ceiling says another height, --mount another place");
  return {floor->name, floor->faces, 0, 0, 0, true, false, height};
}

std::vector<Face> facesWithSites(const WeldedMesh& mesh, const std::vector<Mount>& mounts) {
  std::vector<Face> all;
  for (const Mount& mount : mounts) {
    if (mount.lift > 0) continue;
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
    const Vec3 from = site.position + kLuminaireClearance * site.normal;
    return tracer.isBlocked(from, from + drop * site.normal);
  };
  sites.erase(std::remove_if(sites.begin(), sites.end(), isInTheWay), sites.end());
  for (Site& site : sites) site.position += drop * site.normal;
  if (sites.size() < before)
    warnings.push_back(std::to_string(before - sites.size()) + " of " + std::to_string(before) +
                       " sites of mount '" + mount.name + "' are left out: something is less than " +
                       shortNumber(drop) + " m below them; pass a smaller --drop");
}

/// Sites on a plane that is lifted off the mount's faces and looks down upon them.
std::vector<Site> liftedSites(const WeldedMesh& mesh, const Mount& mount, double spacing, double size) {
  WeldedMesh plane = mesh;
  for (Vec3& p : plane.positions) p.y += mount.lift;
  std::vector<Face> faces = mount.faces;
  for (Face& face : faces) std::swap(face.vertex[1], face.vertex[2]);
  return sitesOn(plane, faces, spacing, size);
}

/// Whether anything crosses a site's square, as it lies around `middle`.
bool isCrossed(const RayTracer& tracer, const Site& site, const Vec3& middle) {
  RayPacket ways;
  const double half = 0.5 * kWithin * site.size;
  const Vec3 u = half * site.axis, v = half * cross(site.normal, site.axis);
  for (const Vec3& way : {u, -u, v, -v, u + v, u - v, v - u, -u - v}) tracer.aim(ways, middle, way, 1);
  bool blocked[RayPacket::kSize];
  tracer.occluded(ways, blocked);
  return std::any_of(blocked, blocked + ways.count, [](bool b) { return b; });
}

/// Takes away the sites of a proposal that would shine on what is close, hang within a wall, partly even, or
/// outdoors.
void keepFree(const Mount& mount, const RayTracer& tracer, const FreeSpace& space, std::vector<Site>& sites) {
  const auto isSqueezed = [&](const Vec3& from, const Vec3& side) {
    RayPacket sides;
    tracer.aim(sides, from, side, kSqueezed), tracer.aim(sides, from, -side, kSqueezed);
    bool blocked[RayPacket::kSize];
    tracer.occluded(sides, blocked);
    return blocked[0] && blocked[1];
  };
  // Rays that begin on a wall meet it or not as the tracer pleases; across it all of them do.
  const auto isOnWall = [&](const Vec3& from, const Site& site) {
    RayPacket across;
    for (const Vec3& side : {site.axis, cross(site.normal, site.axis)})
      tracer.aim(across, from - kOnWall * side, 2 * kOnWall * side, 1);
    bool blocked[RayPacket::kSize];
    tracer.occluded(across, blocked);
    return blocked[0] || blocked[1];
  };
  const auto isUseless = [&](const Site& site) {
    const Vec3 below = site.position + kLuminaireClearance * site.normal;
    if (isOnWall(below, site)) return true;
    const double height = space.floorBelow(below).value_or(0);
    const Vec3 floor = below - Vec3{0, height - kLuminaireClearance, 0};
    return height < kHeadroom || isSqueezed(below, site.axis) ||
           isSqueezed(below, cross(site.normal, site.axis)) ||
           isCrossed(tracer, site, site.position + (mount.lift > 0 ? 0 : kUnder) * site.normal) ||
           (mount.lift > 0 && space.isWithinBody(below)) ||
           (mount.isIndoors && space.skyAbove(floor) >= kOpenSky);
  };
  std::vector<Site> kept;
  std::remove_copy_if(sites.begin(), sites.end(), std::back_inserter(kept), isUseless);
  if (!kept.empty()) sites = std::move(kept);  // else a room that is small altogether
}

}  // namespace

std::vector<LightPlace> placesInTheOpen(const WeldedMesh& mesh, const std::vector<Mount>& mounts,
                                        const FreeSpace& space) {
  constexpr double kSpacing = 0.5;  // m
  std::vector<LightPlace> places;
  for (const Mount& mount : mounts) {
    if (mount.lift == 0) continue;
    const double area = mountArea(mesh, mount.faces);
    const double spacing = std::max(kSpacing, std::sqrt(area / kUsualSites));
    for (const Site& site : liftedSites(mesh, mount, spacing, spacing))
      if (space.floorBelow(site.position).value_or(0) >= kHeadroom)
        places.push_back({site.position, site.normal});
  }
  return places;
}

void addSites(const WeldedMesh& mesh, const std::vector<Mount>& mounts, const RayTracer& tracer,
              const FreeSpace& space, const RoomOptions& options, Room& room) {
  double area = 0;
  for (const Mount& mount : mounts) area += mountArea(mesh, mount.faces);
  const double sensible = std::clamp(std::round(std::sqrt(area / kUsualSites) / kStep) * kStep, kFinest,
                                     std::max(kCoarsest, std::sqrt(area / kManySites)));
  for (const Mount& mount : mounts)
    if (mount.isProposed)
      room.assumptions += mount.lift > 0 ? " plane=" + shortNumber(mount.lift, kExact) : " place=free";
  for (const Mount& mount : mounts) {
    const double spacing = options.siteSpacing > 0 ? options.siteSpacing
                           : mount.spacing > 0     ? mount.spacing
                                                   : sensible;
    const double size = options.siteSize > 0 ? options.siteSize : mount.size > 0 ? mount.size : spacing;
    const double expected = mountArea(mesh, mount.faces) / (spacing * spacing);
    RunCounts counts = countsOf(options, room);
    counts.sites += expected;
    orThrow(checkMemory(counts, options.memory));
    std::vector<Site> sites =
        mount.lift > 0 ? liftedSites(mesh, mount, spacing, size) : sitesOn(mesh, mount.faces, spacing, size);
    if (sites.empty())
      room.warnings.push_back("mount '" + mount.name + "' has no room for a whole square of " +
                              shortNumber(size) + " m; pass a smaller --site-spacing");
    if (mount.isProposed) keepFree(mount, tracer, space, sites);
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
