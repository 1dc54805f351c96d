// Triangles around the room's centre (single precision is finest there), traced by Embree; as Wasm by a tree
// of our own.
#include "precompute/rays/ray_tracer.h"

#include <cassert>
#include <limits>
#include <utility>
#include <vector>

#include "precompute/rays/blocker_tree.h"
#include "precompute/room/bounds.h"
#ifdef __EMSCRIPTEN__
#include "precompute/rays/triangle_tree.h"
#else
#include "precompute/rays/embree_scene.h"
#endif

namespace fiatlux {

namespace {

constexpr double kOffset = 4e-6;  // of the diagonal: a few roundings of a coordinate in single precision
constexpr double kTouch = 1e-6;   // of the diagonal: what two places must share to be in each other's way

#ifdef __EMSCRIPTEN__
using Geometry = TriangleTree;
#else
using Geometry = EmbreeScene;
#endif

}  // namespace

struct RayTracer::Parts {
  Geometry geometry;
  BlockerTree blockers;
  Vec3 center;  // m, of the bounding box
  double offset = 0;
};

RayTracer::RayTracer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
RayTracer::RayTracer(RayTracer&&) noexcept = default;
RayTracer& RayTracer::operator=(RayTracer&&) noexcept = default;
RayTracer::~RayTracer() = default;

Result<RayTracer> RayTracer::build(std::span<const Vec3> positions, std::span<const Triangle> triangles) {
  const Bounds bounds = boundsOf(positions);
  const Vec3 center = bounds.empty() ? Vec3{} : 0.5 * (bounds.low + bounds.high);
  std::vector<Geometry::Position> local;
  local.reserve(positions.size());
  for (const Vec3& p : positions) local.push_back(inFloats(p - center));
  Result<Geometry> geometry = Geometry::build(local, triangles);
  if (!geometry) return geometry.error();
  const double diagonal = bounds.diagonal();
  BlockerTree blockers(local, triangles, static_cast<float>(kTouch * diagonal));
  return RayTracer(
      std::make_unique<Parts>(Parts{std::move(*geometry), std::move(blockers), center, kOffset * diagonal}));
}

Result<RayTracer> RayTracer::build(const Room& room) {
  std::vector<Triangle> triangles;
  for (const RoomTriangle& t : room.triangles) triangles.push_back(t.vertex);
  return build(room.positions, triangles);
}

void RayTracer::aim(RayPacket& rays, const Vec3& origin, const Vec3& direction, double reach) const {
  assert(rays.count < RayPacket::kSize);
  const std::uint32_t i = rays.count++;
  const Vec3 local = origin - parts_->center;
  rays.originX[i] = static_cast<float>(local.x);
  rays.originY[i] = static_cast<float>(local.y);
  rays.originZ[i] = static_cast<float>(local.z);
  rays.directionX[i] = static_cast<float>(direction.x);
  rays.directionY[i] = static_cast<float>(direction.y);
  rays.directionZ[i] = static_cast<float>(direction.z);
  rays.reach[i] = static_cast<float>(reach);
}

void RayTracer::intersect(const RayPacket& rays, HitPacket& hits) const {
  parts_->geometry.intersect(rays, hits);
}

void RayTracer::occluded(const RayPacket& rays, bool* blocked, bool coherent) const {
  parts_->geometry.occluded(rays, blocked, coherent);
}

RayHit RayTracer::firstHit(const Vec3& origin, const Vec3& direction) const {
  RayPacket ray;
  aim(ray, origin, direction, std::numeric_limits<float>::infinity());
  HitPacket hit;
  intersect(ray, hit);
  if (hit.triangle[0] == kNone) return {};
  return {hit.triangle[0], hit.distance[0]};
}

bool RayTracer::isBlocked(const Vec3& from, const Vec3& to) const {
  RayPacket ray;
  aim(ray, from, to - from, 1);
  bool blocked[RayPacket::kSize];
  occluded(ray, blocked);
  return blocked[0];
}

Place RayTracer::place(const std::array<Vec3, 4>& corners) const {
  Place place;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec3 local = corners[i] - parts_->center;
    place.corner[0][i] = static_cast<float>(local.x);
    place.corner[1][i] = static_cast<float>(local.y);
    place.corner[2][i] = static_cast<float>(local.z);
  }
  return place;
}

Between RayTracer::between(const Place& from, const Place& to) const {
  return parts_->blockers.between(from, to);
}

Between RayTracer::between(const Place& from, const Place& to, Blockers& found) const {
  return parts_->blockers.between(from, to, found);
}

const Vec3& RayTracer::center() const { return parts_->center; }
double RayTracer::offset() const { return parts_->offset; }

}  // namespace fiatlux
