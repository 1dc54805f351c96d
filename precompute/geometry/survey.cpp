#include "precompute/geometry/survey.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "precompute/base/error.h"
#include "precompute/geometry/inside.h"
#include "precompute/geometry/patch_size.h"
#include "precompute/geometry/sites.h"
#include "precompute/geometry/working_plane.h"
#include "precompute/room/bounds.h"

namespace fiatlux {
namespace {

using Use = SurveyedSurface::Use;
using Facing = SurveyedSurface::Facing;

constexpr double kOneWay = 0.7;                    // |mean normal| from which a surface faces one way
constexpr double kMeanLevel = 0.7;                 // cos 45 degrees
constexpr double kDeskLow = 0.6, kDeskHigh = 1.1;  // m over the floor: where people work
constexpr double kLeastDesk = 0.2;                 // m2
constexpr double kMuchLost = 0.2;                  // share of the light

/// One surface of the tree, its normals summed up.
struct Sum {
  double area = 0;
  Vec3 normal;  // m2
  Bounds bounds;
};

std::vector<Sum> sumsOf(const WeldedMesh& mesh, const SurfaceTree& tree) {
  std::vector<Sum> sums(tree.names.size());
  for (const SurfaceGroup& group : tree.groups)
    for (std::size_t r = 0; r < group.regions.size(); ++r) {
      Sum& sum = sums[group.leafOfRegion[r]];
      sum.area += group.regions[r].area;
      for (const std::uint32_t f : group.regions[r].faces) {
        sum.normal += areaVector(mesh.positions, group.set.faces[f].vertex);
        for (const std::uint32_t v : group.set.faces[f].vertex) sum.bounds.include(mesh.positions[v]);
      }
    }
  return sums;
}

SurveyedSurface surveyed(const std::string& name, const Sum& sum, double ground) {
  SurveyedSurface surface{name, sum.area, sum.bounds.low.y - ground, sum.bounds.high.y - ground};
  const Vec3 normal = normalized(sum.normal);
  surface.tilt = std::acos(std::clamp(std::abs(normal.y), 0.0, 1.0)) * 180 / std::numbers::pi;
  if (length(sum.normal) >= kOneWay * sum.area)
    surface.facing = normal.y > kMeanLevel    ? Facing::kUp
                     : normal.y < -kMeanLevel ? Facing::kDown
                                              : Facing::kSideways;
  return surface;
}

/// The surfaces on which luminaires would hang, and those that lie below them. Returns the share of light
/// that is lost, of the mount that loses most.
double suggestMounts(const WeldedMesh& mesh, const Inside& inside, std::vector<SurveyedSurface>& surfaces) {
  double lost = 0, area = 0;
  std::map<std::pair<std::uint32_t, bool>, std::uint32_t> leafOfSide;
  for (const SurfaceGroup& group : inside.tree.groups)
    for (std::size_t r = 0; r < group.regions.size(); ++r)
      for (const std::uint32_t f : group.regions[r].faces)
        leafOfSide[{group.set.faces[f].triangle, group.set.faces[f].back}] = group.leafOfRegion[r];
  for (const Mount& mount : inside.mounts) {
    std::vector<std::size_t> below(surfaces.size(), 0);
    const std::vector<Face> faces = mount.lift > 0 ? mount.faces : facesForSites(mesh, mount.faces);
    for (const Face& face : faces)
      if (const auto leaf = leafOfSide.find({face.triangle, face.back}); leaf != leafOfSide.end())
        surfaces[leaf->second].use = mount.lift > 0 ? Use::kFloor : Use::kMount;
    if (mount.lift > 0) continue;
    const FreeSpace::View view = inside.space->from(faces, 0);
    const double own = mountArea(mesh, faces);
    lost += own * view.lost, area += own;
    for (const auto& side : view.floorSides)
      if (const auto leaf = leafOfSide.find(side); leaf != leafOfSide.end()) ++below[leaf->second];
    const auto most = std::max_element(below.begin(), below.end());
    if (most != below.end() && *most > 0)
      surfaces[static_cast<std::size_t>(most - below.begin())].use = Use::kFloor;
  }
  return area > 0 ? lost / area : 0;
}

std::string warningOfLoss(double lost) {
  return "about " + std::to_string(std::lround(100 * lost)) +
         " % of the light would be lost: it leaves the model, or meets the backs of faces; close the "
         "openings, "
         "turn the faces, or pass --double-sided";
}

/// What lies about as high over a floor as a desk does.
void suggestPlanes(std::vector<SurveyedSurface>& surfaces) {
  for (const SurveyedSurface& floor : surfaces) {
    if (floor.use != Use::kFloor) continue;
    for (SurveyedSurface& surface : surfaces) {
      const double over = surface.high - floor.high;
      if (surface.use == Use::kNone && surface.facing == Facing::kUp && over > kDeskLow && over < kDeskHigh &&
          surface.area > kLeastDesk)
        surface.use = Use::kMeasuringPlane;
    }
  }
}

/// Patches and sites of the room, but for its measuring planes.
void foresee(const SourceScene& source, const WeldedMesh& mesh, const RayTracer& tracer, const Inside& inside,
             const RoomOptions& options, Survey& result) {
  const Cut cut = cutOf(source, mesh, inside.tree, options);
  result.patch = cut.patch;
  result.triangles = static_cast<std::uint32_t>(mesh.triangles.size());
  result.rows = foreseenPatches(cut.charts);
  RoomOptions even = options;
  even.requireSites = false;  // note: none is an answer, too
  Room room;
  addSites(mesh, inside.mounts, tracer, *inside.space, even, room);
  result.sites = static_cast<std::uint32_t>(room.sites.size());
  result.warnings.insert(result.warnings.end(), room.warnings.begin(), room.warnings.end());
}

Survey survey(const SourceScene& source, const RoomOptions& options) {
  Survey result;
  std::vector<std::string> details = source.warnings;
  const Roles roles = assignRoles(source, options, details);
  WeldedMesh mesh = weldReflectors(source, roles, details);
  const RayTracer tracer = tracerOf(mesh);
  Inside inside = findInside(source, options, tracer, mesh, result.warnings);
  result.warnings.insert(result.warnings.end(), details.begin(), details.end());

  const Bounds bounds = boundsOf(mesh.positions);
  result.size = bounds.high - bounds.low;
  const double ground = bounds.low.y;
  const std::vector<Sum> sums = sumsOf(mesh, inside.tree);
  for (std::size_t s = 0; s < sums.size(); ++s)
    result.surfaces.push_back(surveyed(inside.tree.names[s], sums[s], ground));
  result.lost = suggestMounts(mesh, inside, result.surfaces);
  if (result.lost > kMuchLost) result.warnings.insert(result.warnings.begin(), warningOfLoss(result.lost));
  suggestPlanes(result.surfaces);

  const auto addPlanes = [&](const SourceScene& from, const std::vector<std::uint32_t>& meshes) {
    const WeldedMesh planes = weld(from, meshes);
    const SurfaceTree tree = findSurfaces(from, planes, frontFaces(planes), 0, inside.names);
    const std::vector<Sum> own = sumsOf(planes, tree);
    for (std::size_t s = 0; s < own.size(); ++s) {
      result.surfaces.push_back(surveyed(tree.names[s], own[s], ground));
      result.surfaces.back().use = Use::kMeasuringPlane;
    }
    result.rows += areaOf(tree) / (result.patch * result.patch);
  };
  foresee(source, mesh, tracer, inside, options, result);
  if (!roles.measures.empty()) addPlanes(source, roles.measures);
  if (options.plane > 0) addPlanes(workingPlane(mesh, inside, options), {0});
  std::stable_sort(result.surfaces.begin(), result.surfaces.end(),
                   [](const SurveyedSurface& a, const SurveyedSurface& b) { return a.area > b.area; });
  return result;
}

}  // namespace

Result<Survey> surveyRoom(const SourceScene& source, const RoomOptions& options) {
  return atDoor([&] { return survey(source, options); }, "not enough memory for this model; make it smaller");
}

}  // namespace fiatlux
