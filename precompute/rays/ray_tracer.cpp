// Embree 3: one static scene of triangles around the room's centre (single precision is finest there),
// watertight ("robust") traversal, packets of eight.
#include "precompute/rays/ray_tracer.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cassert>
#include <cstring>
#include <vector>

#include "precompute/room/bounds.h"

namespace fiatlux {

namespace {

constexpr double kOffset = 4e-6;  // of the diagonal: a few roundings of a coordinate in single precision

}  // namespace

struct RayTracer::Parts {
  Vec3 center;  // m, of the bounding box
  double offset = 0;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  ~Parts() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }
};

RayTracer::RayTracer(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
RayTracer::RayTracer(RayTracer&&) noexcept = default;
RayTracer& RayTracer::operator=(RayTracer&&) noexcept = default;
RayTracer::~RayTracer() = default;

namespace {

/// Copies the triangles into a geometry of the device, around `center`; nullptr where there is no memory.
RTCGeometry geometryOf(RTCDevice device, const Vec3& center, std::span<const Vec3> positions,
                       std::span<const RayTracer::Triangle> triangles) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), positions.size()));
  auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(RayTracer::Triangle), triangles.size()));
  if ((!vertices && !positions.empty()) || (!indices && !triangles.empty())) {
    rtcReleaseGeometry(geometry);
    return nullptr;
  }
  for (const Vec3& p : positions) {
    const Vec3 local = p - center;
    *vertices++ = static_cast<float>(local.x);
    *vertices++ = static_cast<float>(local.y);
    *vertices++ = static_cast<float>(local.z);
  }
  for (const RayTracer::Triangle& t : triangles) indices = std::copy(t.begin(), t.end(), indices);
  rtcCommitGeometry(geometry);
  return geometry;
}

}  // namespace

Result<RayTracer> RayTracer::build(std::span<const Vec3> positions, std::span<const Triangle> triangles) {
  auto parts = std::make_unique<Parts>();
  const Bounds bounds = boundsOf(positions);
  if (!bounds.empty()) parts->center = 0.5 * (bounds.low + bounds.high);
  parts->offset = kOffset * bounds.diagonal();
  parts->device = rtcNewDevice("threads=1,set_affinity=0");
  if (!parts->device) return Error{"the ray tracer (Embree) does not start on this machine"};
  parts->scene = rtcNewScene(parts->device);
  rtcSetSceneFlags(parts->scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = geometryOf(parts->device, parts->center, positions, triangles);
  if (!geometry) return Error{"not enough memory for the room's triangles; use a coarser mesh"};
  rtcAttachGeometry(parts->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(parts->scene);
  if (rtcGetDeviceError(parts->device) != RTC_ERROR_NONE)
    return Error{"the ray tracer (Embree) refuses the room's triangles"};
  return RayTracer(std::move(parts));
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

namespace {

void fill(const RayPacket& rays, RTCRay8& out, std::int32_t* valid) {
  std::memcpy(out.org_x, rays.originX, sizeof rays.originX);
  std::memcpy(out.org_y, rays.originY, sizeof rays.originY);
  std::memcpy(out.org_z, rays.originZ, sizeof rays.originZ);
  std::memcpy(out.dir_x, rays.directionX, sizeof rays.directionX);
  std::memcpy(out.dir_y, rays.directionY, sizeof rays.directionY);
  std::memcpy(out.dir_z, rays.directionZ, sizeof rays.directionZ);
  std::memcpy(out.tfar, rays.reach, sizeof rays.reach);
  for (std::uint32_t i = 0; i < RayPacket::kSize; ++i) {
    valid[i] = i < rays.count ? -1 : 0;
    out.tnear[i] = 0;
    out.time[i] = 0;
    out.mask[i] = ~0u;
    out.id[i] = i;
    out.flags[i] = 0;
  }
}

}  // namespace

void RayTracer::intersect(const RayPacket& rays, HitPacket& hits) const {
  alignas(32) std::int32_t valid[RayPacket::kSize];
  RTCRayHit8 query;
  fill(rays, query.ray, valid);
  for (std::uint32_t i = 0; i < RayPacket::kSize; ++i) query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect8(valid, parts_->scene, &context, &query);
  for (std::uint32_t i = 0; i < rays.count; ++i) {
    hits.triangle[i] = query.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID ? kNone : query.hit.primID[i];
    hits.distance[i] = query.ray.tfar[i];
  }
}

void RayTracer::occluded(const RayPacket& rays, bool* blocked, bool coherent) const {
  alignas(32) std::int32_t valid[RayPacket::kSize];
  RTCRay8 query;
  fill(rays, query, valid);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  if (coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcOccluded8(valid, parts_->scene, &context, &query);
  for (std::uint32_t i = 0; i < rays.count; ++i) blocked[i] = query.tfar[i] < 0;
}

double RayTracer::offset() const { return parts_->offset; }

}  // namespace fiatlux
