// The stages of a room in order: weld, find surfaces, lay charts, cut patches, cluster, hang sites.
#include "precompute/geometry/build_room.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/short_number.h"
#include "precompute/base/error.h"
#include "precompute/base/names.h"
#include "precompute/geometry/charts.h"
#include "precompute/geometry/clusters.h"
#include "precompute/geometry/covered.h"
#include "precompute/geometry/cut_patches.h"
#include "precompute/geometry/inside.h"
#include "precompute/geometry/patch_size.h"
#include "precompute/geometry/plain_reflectance.h"
#include "precompute/geometry/working_plane.h"
#include "precompute/gltf/reflectance.h"
#include "precompute/room/memory.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kMostClusters = 3000;
constexpr double kFloorLike = 0.7;                // cos 45 degrees: a measuring plane that lies
constexpr double kMostRoomOption = 1e6;           // m
constexpr std::uint32_t kMostClusterEdge = 4096;  // patches

void addSurfaces(const SurfaceTree& tree, bool measuring, Room& room) {
  for (const std::string& name : tree.names) {
    Surface surface;
    surface.name = name;
    surface.measuring = measuring;
    room.surfaces.push_back(surface);
  }
  room.warnings.insert(room.warnings.end(), tree.warnings.begin(), tree.warnings.end());
}

/// The surface that most rays straight down from the sites meet with its upper side; kNone where none does.
std::uint32_t floorBelow(const Room& room, const RayTracer& tracer) {
  std::vector<std::uint32_t> met(room.surfaces.size(), 0);
  constexpr Vec3 kStraightDown{0, -1, 0};
  for (const Site& site : room.sites) {
    const Vec3 from = site.position + tracer.offset() * site.normal;
    const auto [triangle, distance] = tracer.firstHit(from, kStraightDown);
    const std::uint32_t p = room.patchMet(from, kStraightDown, triangle, distance);
    if (p != kNone && room.patches.normal[p].y > kFloorLike) ++met[room.patches.surface[p]];
  }
  const auto most = std::max_element(met.begin(), met.end());
  if (most == met.end() || *most == 0) return kNone;
  return static_cast<std::uint32_t>(most - met.begin());
}

/// Areas, reflectances and counts of the surfaces, from their patches; areas and reflectances of what is not
/// covered.
void sumSurfaces(Room& room) {
  for (std::uint32_t p = 0; p < room.patches.rows(); ++p) {
    Surface& surface = room.surfaces[room.patches.surface[p]];
    ++surface.patches;
    if (!room.patches.counts(p)) continue;
    surface.area += room.patches.area[p];
    surface.reflectance += room.patches.area[p] * room.patches.reflectance[p];
  }
  for (Surface& surface : room.surfaces)
    if (surface.area > 0) surface.reflectance /= surface.area;
}

void addTriangles(const WeldedMesh& mesh, const std::vector<ChartDraft>& drafts, const Outside& outside,
                  Room& room) {
  room.positions = mesh.positions;
  for (const WeldedTriangle& t : mesh.triangles)
    room.triangles.push_back(
        {t.vertex,
         kNone,
         kNone,
         {t.mesh, t.source},
         {t.backMesh == kNone ? t.mesh : t.backMesh, t.backMesh == kNone ? t.source : t.backSource},
         outside.nameOfTriangle[room.triangles.size()]});
  room.leftOut = outside.names;
  for (std::uint32_t d = 0; d < drafts.size(); ++d)
    for (const Face& face : drafts[d].faces)
      (face.back ? room.triangles[face.triangle].backChart : room.triangles[face.triangle].chart) = d;
}

/// The border of a plane of several nodes is one that each of them has.
void takeBorders(const SourceScene& source, const WeldedMesh& mesh, const std::vector<ChartDraft>& charts,
                 Room& room) {
  std::map<std::uint32_t, double> borderOf;
  for (const ChartDraft& chart : charts)
    for (const Face& face : chart.faces) {
      const double border = source.meshes[mesh.triangles[face.triangle].mesh].extras.border.value_or(0);
      const auto known = borderOf.emplace(chart.chart.surface, border).first;
      known->second = std::min(known->second, border);
    }
  for (const auto& [surface, border] : borderOf) room.surfaces[surface].border = border;
}

/// Measuring planes: what lies looks up, whichever way it was drawn.
void addMeasuringPlanes(const SourceScene& source, const std::vector<std::uint32_t>& meshes,
                        const RoomOptions& options, UniqueNames& names, Room& room) {
  if (meshes.empty()) return;
  const double patch = room.patchSize;
  const WeldedMesh mesh = weld(source, meshes);
  std::vector<Face> faces = frontFaces(mesh);
  for (Face& face : faces) {
    const Vec3 normal = normalized(areaVector(mesh.positions, face.vertex));
    if (normal.y < -kFloorLike) std::swap(face.vertex[1], face.vertex[2]);
  }
  const auto first = static_cast<std::uint32_t>(room.surfaces.size());
  const SurfaceTree tree = findSurfaces(source, mesh, faces, 0, names);
  addSurfaces(tree, true, room);
  std::vector<ChartDraft> charts = makeCharts(mesh, tree, patch, first);
  checkGrids(charts, options, patch, kMostClusters);
  takeBorders(source, mesh, charts, room);
  appendPatches(mesh, charts, patch, nullptr, room);
}

void checkOptions(const RoomOptions& options) {
  const auto refuse = [](const char* what) {
    throw CommandError(std::string(what) + " must be positive and finite");
  };
  if (!(options.patch >= 0 && options.patch < kMostRoomOption)) refuse("--patch");
  if (options.cluster < 1 || options.cluster > kMostClusterEdge)
    throw CommandError("--cluster must be between 1 and " + std::to_string(kMostClusterEdge));
  if (!(options.siteSpacing >= 0 && options.siteSpacing < kMostRoomOption)) refuse("--site-spacing");
  if (!(options.siteSize >= 0 && options.siteSize < kMostRoomOption)) refuse("--site-size");
  if (!(options.ceiling >= 0 && options.ceiling < kMostRoomOption)) refuse("--ceiling");
  if (!(options.plane >= 0 && options.plane < kMostRoomOption)) refuse("--plane");
  if (!(options.planeRim >= 0 && options.planeRim < kMostRoomOption)) refuse("--plane-rim");
  if (!(options.drop >= 0 && options.drop < kMostRoomOption)) refuse("--drop");
  if (!(options.memory > 0 && options.memory < 1e9)) refuse("--memory");
}

/// Patches as long as the options say, or so many times as long as they want of such a room.
Cut cutFor(const SourceScene& source, const WeldedMesh& mesh, const RayTracer& tracer, const Inside& inside,
           RoomOptions options) {
  Cut cut = cutOf(source, mesh, inside.tree, options);
  if (!options.coarser) return cut;
  options.requireSites = false;  // note: that none is found is said in its turn
  Room room;
  addSites(mesh, inside.mounts, tracer, *inside.space, options, room);
  options.patch =
      cut.patch * options.coarser(foreseenPatches(cut.charts), static_cast<double>(room.sites.size()),
                                  static_cast<double>(mesh.triangles.size()));
  return cutOf(source, mesh, inside.tree, options);
}

TracedRoom build(const SourceScene& source, const RoomOptions& options) {
  checkOptions(options);
  Room room;
  room.sourceHash = source.hash;
  std::vector<std::string> details = source.warnings;
  const Roles roles = assignRoles(source, options, details);
  WeldedMesh mesh = weldReflectors(source, roles, details);

  // note: built before sheets are turned over, for a ray does not mind which side it meets
  RayTracer tracer = tracerOf(mesh);
  Inside inside = findInside(source, options, tracer, mesh, room.warnings);
  room.leading = room.warnings.size();
  room.warnings.insert(room.warnings.end(), details.begin(), details.end());
  auto [patch, charts] = cutFor(source, mesh, tracer, inside, options);
  room.patchSize = patch;
  checkGrids(charts, options, patch, kMostClusters);

  addSurfaces(inside.tree, false, room);
  if (inside.turned) room.assumptions += " turned";
  const AssumedReflectance assumed = assumeReflectance(source, inside.tree);
  if (!assumed.note.empty()) room.warnings.push_back(assumed.note), room.assumptions += " materials=roles";
  const ReflectanceMap reflectance(source, &assumed.ofTriangle);
  appendPatches(mesh, charts, patch, &reflectance, room);
  room.patches.count = room.patches.rows();
  addTriangles(mesh, charts, inside.outside, room);
  const std::uint32_t edge = assignClusters(room, options.cluster, kMostClusters, options.paper);
  if (edge != options.cluster)
    room.warnings.push_back("clusters are " + std::to_string(edge) + " x " + std::to_string(edge) +
                            " patches, so that there are at most " + std::to_string(kMostClusters));
  addMeasuringPlanes(source, roles.measures, options, inside.names, room);
  if (options.plane > 0)
    addMeasuringPlanes(workingPlane(mesh, inside, options), {0}, options, inside.names, room);
  room.patches.covered = coveredRows(room, tracer, options.threads);
  sumSurfaces(room);
  addSites(mesh, inside.mounts, tracer, *inside.space, options, room);
  room.floor = floorBelow(room, tracer);
  orThrow(checkMemory(countsOf(options, room), options.memory));
  return {std::move(room), std::move(tracer)};
}

}  // namespace

Result<TracedRoom> buildTracedRoom(const SourceScene& source, const RoomOptions& options) {
  return atDoor([&] { return build(source, options); },
                "not enough memory for this room; pass a larger --patch");
}

Result<Room> buildRoom(const SourceScene& source, const RoomOptions& options) {
  Result<TracedRoom> traced = buildTracedRoom(source, options);
  if (!traced) return traced.error();
  return std::move(traced->room);
}

}  // namespace fiatlux
