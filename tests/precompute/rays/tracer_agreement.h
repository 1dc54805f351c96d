// Whether two tracers answer alike: the same hits, but for those within a tracer's offset of an edge.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "core/base/vec3.h"
#include "core/scene/patches.h"
#include "precompute/rays/ray_tracer.h"
#include "precompute/room/bounds.h"

namespace fiatlux::testing {

/// Triangles as tracers take them: in single precision around their centre.
struct LocalTriangles {
  std::vector<std::array<float, 3>> positions;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  Vec3 center;  // m

  LocalTriangles(std::span<const Vec3> from, std::vector<std::array<std::uint32_t, 3>> of)
      : triangles(std::move(of)) {
    const Bounds bounds = boundsOf(from);
    center = 0.5 * (bounds.low + bounds.high);
    for (const Vec3& p : from) {
      const Vec3 d = p - center;
      positions.push_back({static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z)});
    }
  }

  Vec3 corner(std::uint32_t triangle, int i) const {
    const auto& p = positions[triangles[triangle][static_cast<std::size_t>(i)]];
    return {p[0], p[1], p[2]};
  }

  /// Distance of a point from the nearest edge of a triangle, m.
  double fromEdge(std::uint32_t triangle, const Vec3& point) const {
    double nearest = INFINITY;
    for (int i = 0; i < 3; ++i) {
      const Vec3 a = corner(triangle, i), d = corner(triangle, (i + 1) % 3) - a;
      const double along = std::clamp(dot(point - a, d) / std::max(dot(d, d), 1e-300), 0.0, 1.0);
      nearest = std::min(nearest, length(point - a - along * d));
    }
    return nearest;
  }
};

inline void aimAt(RayPacket& rays, const Vec3& origin, const Vec3& direction, double reach) {
  const std::uint32_t i = rays.count++;
  rays.originX[i] = static_cast<float>(origin.x);
  rays.originY[i] = static_cast<float>(origin.y);
  rays.originZ[i] = static_cast<float>(origin.z);
  rays.directionX[i] = static_cast<float>(direction.x);
  rays.directionY[i] = static_cast<float>(direction.y);
  rays.directionZ[i] = static_cast<float>(direction.z);
  rays.reach[i] = static_cast<float>(reach);
}

/// How many rays of a packet met something else here than there, and not at the same place, nor at an edge.
inline std::uint32_t differing(const LocalTriangles& scene, double offset, const RayPacket& rays,
                               const HitPacket& here, const HitPacket& there) {
  // Rays start the offset away from a corner's walls: on the other's plane, but for a rounding.
  const double nearEdge = 1.01 * offset;
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < rays.count; ++i) {
    const Vec3 origin{rays.originX[i], rays.originY[i], rays.originZ[i]};
    const Vec3 direction{rays.directionX[i], rays.directionY[i], rays.directionZ[i]};
    const bool met = here.triangle[i] != kNone, metThere = there.triangle[i] != kNone;
    if (!met && !metThere) continue;
    if (met && metThere) {
      // A ray that grazes its plane meets it a little earlier or later.
      const double apart = std::abs(double{here.distance[i]} - there.distance[i]) * length(direction);
      if (here.triangle[i] == there.triangle[i] || apart <= offset) continue;
    }
    const auto isAtEdge = [&](const HitPacket& hits) {
      return hits.triangle[i] != kNone &&
             scene.fromEdge(hits.triangle[i], origin + hits.distance[i] * direction) <= nearEdge;
    };
    if (!isAtEdge(here) && !isAtEdge(there)) ++count;
  }
  return count;
}

}  // namespace fiatlux::testing
