// What a ray meets first, and whether anything lies between two points, or between two whole places.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include "core/base/result.h"
#include "precompute/rays/blockers.h"
#include "precompute/rays/shaft.h"
#include "precompute/room/room.h"

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

/// What one ray met first.
struct RayHit {
  std::uint32_t triangle = kNone;  // kNone = nothing
  double distance = 0;             // in lengths of the direction
};

/// Knows triangles, not what they are to the light; keeps a copy of them. Thread-safe once built.
class RayTracer {
 public:
  using Triangle = std::array<std::uint32_t, 3>;  // indices into the positions

  /// `positions` in m. Errors: no memory, or triangles that Embree refuses.
  static Result<RayTracer> build(std::span<const Vec3> positions, std::span<const Triangle> triangles);
  /// The same of a room's triangles, in their order.
  static Result<RayTracer> build(const Room& room);
  RayTracer(RayTracer&&) noexcept;
  RayTracer& operator=(RayTracer&&) noexcept;
  ~RayTracer();

  /// Adds a ray to the packet (count < kSize), world coordinates, metres. `reach` in lengths of `direction`.
  void aim(RayPacket& rays, const Vec3& origin, const Vec3& direction, double reach) const;
  void intersect(const RayPacket& rays, HitPacket& hits) const;
  /// blocked[i]: a triangle's front or back crosses ray i. `coherent`: faster where the rays go nearly the
  /// same way, slower where not.
  void occluded(const RayPacket& rays, bool* blocked, bool coherent = false) const;

  /// One ray alone, world coordinates, metres: what it meets first, however far.
  RayHit firstHit(const Vec3& origin, const Vec3& direction) const;
  /// Whether a triangle's front or back crosses the straight way between two points, m.
  bool isBlocked(const Vec3& from, const Vec3& to) const;

  /// Four corners in turn, world coordinates, metres.
  Place place(const std::array<Vec3, 4>& corners) const;
  /// What all rays from one place to another meet, as far as that can be said without casting any. What
  /// stands between them by less than a part of the offset is not seen.
  Between between(const Place& from, const Place& to) const;
  /// The same, and where that is unknown, `found` is all that may stand there; full where it is too much for
  /// that.
  Between between(const Place& from, const Place& to, Blockers& found) const;

  /// m, world coordinates: what those of a packet are told from.
  const Vec3& center() const;
  /// How far off a surface rays should start, m: beyond the rounding of coordinates, far below any detail.
  double offset() const;

 private:
  struct Parts;
  explicit RayTracer(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

/// A room and the tracer of its triangles: HitPacket::triangle is an index into Room::triangles.
struct TracedRoom {
  Room room;
  RayTracer tracer;
};

}  // namespace fiatlux
