// Directions over a surface, distributed by the cosine of their angle to the normal.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/vec3.h"

namespace fiatlux {

/// Two unit vectors that complete a unit normal (Duff et al. 2017, without a branch on the axis).
struct Frame {
  Vec3 x, y, z;
  explicit Frame(const Vec3& n) : z(n) {
    const double sign = std::copysign(1.0, n.z);
    const double a = -1 / (sign + n.z), b = n.x * n.y * a;
    x = {1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
    y = {b, sign + n.y * n.y * a, -n.y};
  }
};

/// Unit direction for (u, v) in [0, 1)^2: the concentric map to the disc (Shirley and Chiu 1997), lifted to
/// the sphere.
inline Vec3 cosineDirection(const Frame& frame, double u, double v) {
  const double a = 2 * u - 1, b = 2 * v - 1;
  double radius = 0, angle = 0;
  if (std::abs(a) > std::abs(b)) {
    radius = a;
    angle = std::numbers::pi / 4 * (b / a);
  } else if (b != 0) {
    radius = b;
    angle = std::numbers::pi / 2 - std::numbers::pi / 4 * (a / b);
  }
  const double height = std::sqrt(std::max(0.0, 1 - radius * radius));
  return (radius * std::cos(angle)) * frame.x + (radius * std::sin(angle)) * frame.y + height * frame.z;
}

}  // namespace fiatlux
