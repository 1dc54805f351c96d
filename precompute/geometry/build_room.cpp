// The stages of a room in order: weld, find surfaces, lay charts, cut patches, cluster, hang sites.
#include "precompute/geometry/build_room.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "core/base/short_number.h"
#include "precompute/base/error.h"
#include "precompute/base/names.h"
#include "precompute/geometry/charts.h"
#include "precompute/geometry/clusters.h"
#include "precompute/geometry/covered.h"
#include "precompute/geometry/cut_patches.h"
#include "precompute/geometry/mounts.h"
#include "precompute/geometry/outside.h"
#include "precompute/geometry/surfaces.h"
#include "precompute/gltf/reflectance.h"
#include "precompute/room/bounds.h"
#include "precompute/room/memory.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kMostClusters = 3000;
constexpr std::size_t kMostTransparent = 8;              // of transparent materials, in warnings
constexpr double kTooWide = 100, kInMillimetres = 2000;  // m: what no room is, and what no building is
constexpr double kTooNarrow = 0.5;                       // m
constexpr double kRegionShare = 0.01;                    // of the area: such a plane is a surface of its own
constexpr double kPieces = 40;                           // on the diagonal: how fine a first look round is
constexpr double kNearCorner = 0.4;               // of a side, from the centre: where its light is tried
constexpr double kFloorLike = 0.7;                // cos 45 degrees: a measuring plane that lies
constexpr double kMostRoomOption = 1e6;           // m
constexpr std::uint32_t kMostClusterEdge = 4096;  // patches

// The patch size that is chosen where none is given.
constexpr double kUsualPatches = 25000, kManyPatches = 100000;  // of a room, of a huge one
constexpr double kFinestPatch = 0.05, kCoarsestPatch = 0.5;     // m
constexpr double kFewMore = 1.15;                               // times as many are fine
constexpr double kSnaps = 0.25;  // e to this: how much a patch may change to divide the sites' spacing
constexpr int kCoarsenings = 3;

/// The source's meshes by what they are to the light.
struct Roles {
  std::vector<std::uint32_t> reflectors, measures;
};

Roles assignRoles(const SourceScene& source, const RoomOptions& options, std::vector<std::string>& warnings) {
  for (const std::string& name : options.measures) {
    const std::vector<std::string> names = askedNames(source);
    if (std::find(names.begin(), names.end(), name) == names.end()) unknownName("--measure", name, names);
  }
  Roles roles;
  std::set<std::string> transparent;
  for (std::uint32_t m = 0; m < source.meshes.size(); ++m) {
    const SourceMesh& mesh = source.meshes[m];
    const auto named = [&](const std::string& name) {
      return name == mesh.node || name == mesh.extras.surface;
    };
    if (mesh.extras.measure || std::any_of(options.measures.begin(), options.measures.end(), named)) {
      roles.measures.push_back(m);
    } else if (mesh.material >= 0 && source.materials[mesh.material].alpha == SourceMaterial::Alpha::kBlend) {
      transparent.insert(source.materials[mesh.material].name);
    } else {
      roles.reflectors.push_back(m);
    }
  }
  for (const std::string& name : transparent)
    if (transparent.size() <= kMostTransparent || name == *transparent.begin())
      warnings.push_back("material '" + name +
                         "' is transparent (alpha BLEND): it is no wall, light passes it unchanged" +
                         (transparent.size() <= kMostTransparent
                              ? ""
                              : "; so are " + std::to_string(transparent.size() - 1) + " more"));
  return roles;
}

void warnOfScale(const WeldedMesh& mesh, std::vector<std::string>& warnings) {
  const double width = boundsOf(mesh.positions).longestEdge();
  if (width > kTooWide)
    warnings.push_back("the room is " + shortNumber(width) + " m wide: the file is probably in " +
                       (width > kInMillimetres ? "millimetres: pass --scale 0.001"
                                               : "centimetres or millimetres: pass --scale 0.01 or 0.001"));
  if (width < kTooNarrow)
    warnings.push_back("the room is only " + shortNumber(width) +
                       " m wide: pass --scale with the metres of one unit of the file");
}

/// The reflectors on common vertices; refuses what is no room, and warns of what was dropped.
WeldedMesh weldReflectors(const SourceScene& source, const Roles& roles, std::vector<std::string>& warnings) {
  WeldedMesh mesh = weld(source, roles.reflectors);
  if (mesh.triangles.empty())
    throw CommandError(
        roles.reflectors.empty()
            ? "no surfaces: everything is transparent or a measuring plane; give the walls an opaque material"
            : "no surfaces: every triangle has zero area; check the scale of the nodes");
  if (mesh.withoutArea > 0)
    warnings.push_back("triangles without area are left out: " + std::to_string(mesh.withoutArea));
  if (mesh.duplicates > 0)
    warnings.push_back("triangles that repeat others are left out: " + std::to_string(mesh.duplicates));
  warnOfScale(mesh, warnings);
  return mesh;
}

RayTracer tracerOf(const WeldedMesh& mesh) {
  std::vector<RayTracer::Triangle> triangles;
  for (const WeldedTriangle& t : mesh.triangles) triangles.push_back(t.vertex);
  return orThrow(RayTracer::build(mesh.positions, triangles));
}

std::vector<Face> frontFaces(const WeldedMesh& mesh) {
  std::vector<Face> faces;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    faces.push_back({mesh.triangles[t].vertex, t, mesh.triangles[t].mesh, mesh.triangles[t].source, false});
  return faces;
}

/// The room's surfaces without its outside, and where luminaires may hang.
struct Inside {
  SurfaceTree tree;
  UniqueNames names;  // those that are taken
  std::optional<FreeSpace> space;
  std::vector<Mount> mounts;
  Outside outside;
};

/// Where light starts that a person has placed already.
std::vector<LightPlace> placesOf(const std::vector<Luminaire>& luminaires) {
  std::vector<LightPlace> places;
  for (const Luminaire& l : luminaires) {
    const bool isotropic = l.distribution == Luminaire::Distribution::kIsotropic;
    const bool toAllSides = isotropic || l.distribution == Luminaire::Distribution::kPhotometric;
    const Vec3 clear = isotropic ? Vec3{} : kLuminaireClearance * l.normal;
    const Vec3 u = kNearCorner * l.width * l.axis, v = kNearCorner * l.height * cross(l.normal, l.axis);
    for (const Vec3& from : {Vec3{}, u + v, u - v, v - u, -u - v})
      places.push_back({l.position + from + clear, toAllSides ? Vec3{} : l.normal});
  }
  return places;
}

/// Finds surfaces and mounts; turns sheets that look outward; leaves out what no light can reach.
Inside findInside(const SourceScene& source, const RoomOptions& options, const RayTracer& tracer,
                  WeldedMesh& mesh, std::vector<std::string>& warnings) {
  std::vector<Face> faces = frontFaces(mesh);
  const std::vector<Face> backs = backFaces(source, mesh);
  faces.insert(faces.end(), backs.begin(), backs.end());
  UniqueNames firstNames;
  Inside inside;
  inside.tree = findSurfaces(source, mesh, faces, kRegionShare, firstNames);
  Outlook outlook(mesh, tracer, makeCharts(mesh, inside.tree, mesh.diagonal / kPieces, 0));
  if (turnOutwardSheets(mesh, faces, outlook)) {
    // What is turned over has other planes and other names: found anew, which is rare.
    inside.tree = findSurfaces(source, mesh, faces, kRegionShare, inside.names);
  } else {
    inside.names = std::move(firstNames);
  }
  inside.space.emplace(mesh, tracer, faces);
  inside.mounts = findMounts(source, mesh, inside.tree, faces, *inside.space, options, warnings);
  const Outlook::Unlit unlit =
      outlook.unlit(facesWithSites(mesh, inside.mounts), placesOf(options.luminaires));
  inside.outside = leaveOut(unlit.outside, inside.tree);
  for (const std::string& note : {inside.outside.note, noteOfShutOff(unlit.shutOff, inside.tree)})
    if (!note.empty()) warnings.push_back(note);
  return inside;
}

/// A patch size and the charts for it.
struct Cut {
  double patch = 0;  // m
  std::vector<ChartDraft> charts;
};

/// The patch size that gives about 25 000 patches, between 0.05 and 0.5 m (huge rooms: up to 100 000
/// patches), and where a mount's site spacing is known a whole fraction of it, so that squares of light end
/// where patches do.
Cut fittingCut(const SourceScene& source, const WeldedMesh& mesh, const SurfaceTree& tree) {
  double spacing = 0;
  for (const SourceMesh& from : source.meshes)
    if (from.extras.mount && from.extras.siteSpacing && spacing == 0) spacing = *from.extras.siteSpacing;
  const auto snapped = [&](double patch) {
    const double fraction = spacing > 0 ? spacing / std::max(1.0, std::round(spacing / patch)) : patch;
    return std::abs(std::log(fraction / patch)) < kSnaps ? fraction : patch;
  };
  const double area = areaOf(tree);
  double patch = std::clamp(std::sqrt(area / kUsualPatches), kFinestPatch,
                            std::max(kCoarsestPatch, std::sqrt(area / kManyPatches)));

  // Thin and small things get more patches than their area says: coarsen until the number fits.
  for (int i = 0;; ++i) {
    Cut cut{snapped(patch), makeCharts(mesh, tree, snapped(patch), 0)};
    const double count = foreseenPatches(cut.charts);
    if (i == kCoarsenings || count < kFewMore * kUsualPatches || cut.patch >= kCoarsestPatch) return cut;
    patch = std::min(patch * std::sqrt(count / kUsualPatches), kCoarsestPatch);
  }
}

void addSurfaces(const SurfaceTree& tree, bool measuring, Room& room) {
  for (const std::string& name : tree.names) {
    Surface surface;
    surface.name = name;
    surface.measuring = measuring;
    room.surfaces.push_back(surface);
  }
  room.warnings.insert(room.warnings.end(), tree.warnings.begin(), tree.warnings.end());
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

/// Measuring planes: what lies looks up, whichever way it was drawn.
void addMeasuringPlanes(const SourceScene& source, const Roles& roles, const RoomOptions& options,
                        UniqueNames& names, Room& room) {
  if (roles.measures.empty()) return;
  const double patch = room.patchSize;
  const WeldedMesh mesh = weld(source, roles.measures);
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
  if (!(options.drop >= 0 && options.drop < kMostRoomOption)) refuse("--drop");
  if (!(options.memory > 0 && options.memory < 1e9)) refuse("--memory");
}

TracedRoom build(const SourceScene& source, const RoomOptions& options) {
  checkOptions(options);
  Room room;
  room.sourceHash = source.hash;
  room.warnings = source.warnings;
  const Roles roles = assignRoles(source, options, room.warnings);
  WeldedMesh mesh = weldReflectors(source, roles, room.warnings);

  // note: built before sheets are turned over, for a ray does not mind which side it meets
  RayTracer tracer = tracerOf(mesh);
  Inside inside = findInside(source, options, tracer, mesh, room.warnings);
  auto [patch, charts] = options.patch > 0
                             ? Cut{options.patch, makeCharts(mesh, inside.tree, options.patch, 0)}
                             : fittingCut(source, mesh, inside.tree);
  room.patchSize = patch;
  checkGrids(charts, options, patch, kMostClusters);

  addSurfaces(inside.tree, false, room);
  const ReflectanceMap reflectance(source);
  appendPatches(mesh, charts, patch, &reflectance, room);
  room.patches.count = room.patches.rows();
  addTriangles(mesh, charts, inside.outside, room);
  const std::uint32_t edge = assignClusters(room, options.cluster, kMostClusters, options.paper);
  if (edge != options.cluster)
    room.warnings.push_back("clusters are " + std::to_string(edge) + " x " + std::to_string(edge) +
                            " patches, so that there are at most " + std::to_string(kMostClusters));
  addMeasuringPlanes(source, roles, options, inside.names, room);
  room.patches.covered = coveredRows(room, tracer);
  sumSurfaces(room);
  addSites(mesh, inside.mounts, tracer, *inside.space, options, room);
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
