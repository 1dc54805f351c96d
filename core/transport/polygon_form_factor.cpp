// Lambert's sum over edges, after the polygon is clipped at the receiver's horizon.
#include "core/transport/polygon_form_factor.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace fiatlux {

namespace {

/// Angle between a and b times the component along n of the unit normal of their plane.
double edgeTerm(const Vec3& a, const Vec3& b, const Vec3& n) {
  const Vec3 c = cross(a, b);
  const double sine = length(c);
  return sine > 0 ? std::atan2(sine, dot(a, b)) / sine * dot(c, n) : 0;
}

}  // namespace

double polygonFormFactor(const Vec3& point, const Vec3& normal, const Vec3* corners, std::size_t count) {
  constexpr std::size_t kMost = 16;
  assert(count >= 3 && count + 2 <= kMost);
  Vec3 local[kMost];
  double height[kMost];
  bool above = true;
  for (std::size_t i = 0; i < count; ++i) {
    local[i] = corners[i] - point;
    height[i] = dot(local[i], normal);
    above = above && height[i] >= 0;
  }
  Vec3 clipped[kMost];
  const Vec3* polygon = local;
  std::size_t sides = count;
  if (!above) {
    // Keep what is above the horizon; a convex polygon crosses it twice at most.
    sides = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t next = i + 1 < count ? i + 1 : 0;
      if (height[i] >= 0) clipped[sides++] = local[i];
      if ((height[i] >= 0) != (height[next] >= 0)) {
        const double t = height[i] / (height[i] - height[next]);
        clipped[sides++] = local[i] + t * (local[next] - local[i]);
      }
    }
    polygon = clipped;
  }
  double sum = 0;
  for (std::size_t i = 0; i < sides; ++i)
    sum += edgeTerm(polygon[i], polygon[i + 1 < sides ? i + 1 : 0], normal);
  return std::min(1.0, std::abs(sum) / (2 * std::numbers::pi));
}

}  // namespace fiatlux
