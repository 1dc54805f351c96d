// Embree 3: one static scene of triangles around the room's centre (single precision is finest there),
// watertight ("robust") traversal, packets of eight.
#include "precompute/rays/ray_tracer.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "precompute/room/bounds.h"

namespace fiatlux {

struct RayTracer::Parts {
  const Room* room = nullptr;
  Vec3 center;
  double offset = 0;
  std::vector<Vec3> normal;  // of each triangle's front, any length
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

Result<RayTracer> RayTracer::build(const Room& room) {
  auto parts = std::make_unique<Parts>();
  parts->room = &room;
  const Bounds bounds = boundsOf(room.positions);
  if (!bounds.empty()) parts->center = 0.5 * (bounds.low + bounds.high);
  parts->offset = 4e-6 * bounds.diagonal();
  for (const RoomTriangle& t : room.triangles) {
    const Vec3& a = room.positions[t.vertex[0]];
    parts->normal.push_back(cross(room.positions[t.vertex[1]] - a, room.positions[t.vertex[2]] - a));
  }

  parts->device = rtcNewDevice("threads=1,set_affinity=0");
  if (!parts->device) return Error{"the ray tracer (Embree) does not start on this machine"};
  parts->scene = rtcNewScene(parts->device);
  rtcSetSceneFlags(parts->scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(parts->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), room.positions.size()));
  auto* indices = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t),
                              room.triangles.size()));
  if ((!vertices && !room.positions.empty()) || (!indices && !room.triangles.empty())) {
    rtcReleaseGeometry(geometry);
    return Error{"not enough memory for the room's triangles; use a coarser mesh"};
  }
  for (const Vec3& p : room.positions) {
    const Vec3 local = p - parts->center;
    *vertices++ = static_cast<float>(local.x);
    *vertices++ = static_cast<float>(local.y);
    *vertices++ = static_cast<float>(local.z);
  }
  for (const RoomTriangle& t : room.triangles) indices = std::copy(t.vertex.begin(), t.vertex.end(), indices);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(parts->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(parts->scene);
  if (rtcGetDeviceError(parts->device) != RTC_ERROR_NONE)
    return Error{"the ray tracer (Embree) refuses the room's triangles"};
  return RayTracer(std::move(parts));
}

void RayTracer::aim(RayPacket& rays, const Vec3& origin, const Vec3& direction, double reach) const {
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

std::uint32_t RayTracer::patchOf(const Vec3& origin, const Vec3& direction, std::uint32_t triangle,
                                 double distance) const {
  if (triangle == kNone) return kNone;
  const bool back = dot(direction, parts_->normal[triangle]) > 0;
  return parts_->room->patchAt(triangle, back, origin + distance * direction);
}

double RayTracer::offset() const { return parts_->offset; }

}  // namespace fiatlux
