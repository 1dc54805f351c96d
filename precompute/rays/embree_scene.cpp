// Embree 3: one static scene of triangles, watertight ("robust") traversal, packets of eight.
#include "precompute/rays/embree_scene.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cstring>

#include "core/scene/patches.h"

namespace fiatlux {

struct EmbreeScene::Parts {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  ~Parts() {
    if (scene) rtcReleaseScene(scene);
    if (device) rtcReleaseDevice(device);
  }
};

EmbreeScene::EmbreeScene(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
EmbreeScene::EmbreeScene(EmbreeScene&&) noexcept = default;
EmbreeScene& EmbreeScene::operator=(EmbreeScene&&) noexcept = default;
EmbreeScene::~EmbreeScene() = default;

namespace {

/// Copies the triangles into a geometry of the device; nullptr where there is no memory.
RTCGeometry geometryOf(RTCDevice device, std::span<const EmbreeScene::Position> positions,
                       std::span<const EmbreeScene::Triangle> triangles) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), positions.size()));
  auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(EmbreeScene::Triangle), triangles.size()));
  if ((!vertices && !positions.empty()) || (!indices && !triangles.empty())) {
    rtcReleaseGeometry(geometry);
    return nullptr;
  }
  for (const EmbreeScene::Position& p : positions) vertices = std::copy(p.begin(), p.end(), vertices);
  for (const EmbreeScene::Triangle& t : triangles) indices = std::copy(t.begin(), t.end(), indices);
  rtcCommitGeometry(geometry);
  return geometry;
}

}  // namespace

Result<EmbreeScene> EmbreeScene::build(std::span<const Position> positions,
                                       std::span<const Triangle> triangles) {
  auto parts = std::make_unique<Parts>();
  parts->device = rtcNewDevice("threads=1,set_affinity=0");
  if (!parts->device) return Error{"the ray tracer (Embree) does not start on this machine"};
  parts->scene = rtcNewScene(parts->device);
  rtcSetSceneFlags(parts->scene, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = geometryOf(parts->device, positions, triangles);
  if (!geometry) return Error{"not enough memory for the room's triangles; use a coarser mesh"};
  rtcAttachGeometry(parts->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(parts->scene);
  if (rtcGetDeviceError(parts->device) != RTC_ERROR_NONE)
    return Error{"the ray tracer (Embree) refuses the room's triangles"};
  return EmbreeScene(std::move(parts));
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

void EmbreeScene::intersect(const RayPacket& rays, HitPacket& hits) const {
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

void EmbreeScene::occluded(const RayPacket& rays, bool* blocked, bool coherent) const {
  alignas(32) std::int32_t valid[RayPacket::kSize];
  RTCRay8 query;
  fill(rays, query, valid);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  if (coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcOccluded8(valid, parts_->scene, &context, &query);
  for (std::uint32_t i = 0; i < rays.count; ++i) blocked[i] = query.tfar[i] < 0;
}

}  // namespace fiatlux
