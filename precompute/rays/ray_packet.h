// Rays that are traced together, and what they met. In single precision around the tracer's centre.
#pragma once

#include <cstdint>

namespace fiatlux {

/// Eight rays side by side. Set each lane with RayTracer::aim before a call; lanes from `count` on are
/// ignored.
struct RayPacket {
  static constexpr std::uint32_t kSize = 8;
  std::uint32_t count = 0;
  alignas(32) float originX[kSize], originY[kSize], originZ[kSize];
  alignas(32) float directionX[kSize], directionY[kSize], directionZ[kSize];
  alignas(32) float reach[kSize];  // how far a ray goes, in lengths of its direction
};

/// What the rays of a packet met first.
struct HitPacket {
  std::uint32_t triangle[RayPacket::kSize];  // kNone = nothing
  float distance[RayPacket::kSize];          // in lengths of the direction
};

}  // namespace fiatlux
