#include "precompute/geometry/open_floor.h"

#include <algorithm>
#include <cmath>

#include "precompute/room/bounds.h"

namespace fiatlux {
namespace {

constexpr double kLying = 0.9, kStanding = 0.3;  // cosines: of what lies, of what stands
constexpr double kFreeAbove = 1;                 // m, mean way of rays by the cosine
constexpr double kInTheOpen = 0.9;               // share of the rays that meet nothing: no walls around
constexpr double kIndoors = 0.35;                // or hardly any: a ceiling above
constexpr double kLeastFloor = 1.5;              // m2: a piece of a scan is none
constexpr double kAsHigh = 0.1, kBesides = 0.1;  // m; of the largest one's area
constexpr double kNear = 0.5, kTall = 1.8;       // m: a wall stands as near to the floor, and is as high
constexpr double kUsualPlane = 2.7, kLowPlane = 2.2, kHighPlane = 4;  // m, of the plane

struct Plane {
  const SurfaceGroup* group;
  const Region* region;
  std::uint32_t leaf;
};

std::vector<Face> facesOfPlane(const Plane& plane) {
  std::vector<Face> faces;
  for (const std::uint32_t f : plane.region->faces) faces.push_back(plane.group->set.faces[f]);
  return faces;
}

Bounds boundsOf(const WeldedMesh& mesh, const std::vector<Face>& faces) {
  Bounds bounds;
  for (const Face& face : faces)
    for (const std::uint32_t v : face.vertex) bounds.include(mesh.positions[v]);
  return bounds;
}

/// Where most of the walls around a floor end, by their area, m above it.
double wallsAround(const WeldedMesh& mesh, const SurfaceTree& tree, const Bounds& floor) {
  std::vector<std::pair<double, double>> tops;  // m above the floor; m2
  double area = 0;
  for (const SurfaceGroup& group : tree.groups)
    for (std::size_t r = 0; r < group.regions.size(); ++r) {
      const Region& region = group.regions[r];
      if (std::abs(region.normal.y) > kStanding) continue;
      const Vec3& at = region.centroid;
      if (at.x < floor.low.x - kNear || at.x > floor.high.x + kNear || at.z < floor.low.z - kNear ||
          at.z > floor.high.z + kNear)
        continue;
      const Bounds own = boundsOf(mesh, facesOfPlane({&group, &region, 0}));
      if (std::abs(own.low.y - floor.low.y) > kNear || own.high.y - floor.low.y < kTall) continue;
      tops.emplace_back(own.high.y - floor.low.y, region.area);
      area += region.area;
    }
  std::sort(tops.begin(), tops.end());
  double below = 0;
  for (const auto& [top, own] : tops)
    if ((below += own) >= area / 2) return top;
  return 0;
}

}  // namespace

std::optional<OpenFloor> largestFloor(const WeldedMesh& mesh, const SurfaceTree& tree,
                                      const FreeSpace& space) {
  std::vector<Plane> planes;
  for (const SurfaceGroup& group : tree.groups)
    for (std::size_t r = 0; r < group.regions.size(); ++r)
      if (group.regions[r].normal.y > kLying)
        planes.push_back({&group, &group.regions[r], group.leafOfRegion[r]});
  std::stable_sort(planes.begin(), planes.end(),
                   [](const Plane& a, const Plane& b) { return a.region->area > b.region->area; });

  // The first that has walls and a ceiling, walls, or free space at all.
  const Plane* best = nullptr;
  double least = 2;
  constexpr std::size_t kMostLooks = 64;
  for (std::size_t i = 0; i < std::min(planes.size(), kMostLooks); ++i) {
    const FreeSpace::View view = space.from(facesOfPlane(planes[i]), i);
    if (view.path < kFreeAbove || (best && planes[i].region->area < kLeastFloor)) continue;
    const double rank = view.lost < kIndoors ? 0 : view.lost < kInTheOpen ? 1 : 1.5;
    if (rank < least) least = rank, best = &planes[i];
  }
  if (!best) return std::nullopt;

  OpenFloor floor{tree.names[best->leaf], {}, 0, 0};
  for (const Plane& plane : planes) {
    if (std::abs(plane.region->centroid.y - best->region->centroid.y) > kAsHigh ||
        plane.region->area < kBesides * best->region->area)
      continue;
    const std::vector<Face> faces = facesOfPlane(plane);
    floor.faces.insert(floor.faces.end(), faces.begin(), faces.end());
    floor.area += plane.region->area;
  }
  floor.walls = wallsAround(mesh, tree, boundsOf(mesh, floor.faces));
  // Below a sloped roof, where it is high enough over half of the floor; things that stand there are lower.
  std::vector<double> roof = space.heightsAbove(floor.faces);
  roof.erase(roof.begin(), std::lower_bound(roof.begin(), roof.end(), kTall));
  if (const double most = roof.empty() ? 0 : roof[roof.size() / 2]; std::isfinite(most) && most > 0)
    floor.walls = floor.walls > 0 ? std::min(floor.walls, most) : most;
  return floor;
}

double proposedHeight(const OpenFloor& floor) {
  constexpr double kStep = 0.1, kBelowTop = 0.05;  // m
  if (floor.walls == 0) return kUsualPlane;
  return std::clamp(kStep * std::floor((floor.walls - kBelowTop) / kStep + 1e-6), kLowPlane, kHighPlane);
}

}  // namespace fiatlux
