// Directions over a surface, distributed by the cosine of their angle to the normal.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/vec3.h"
#include "precompute/rays/float8.h"

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

/// The same of eight, told along the axes of a frame.
struct EightDirections {
  alignas(32) float x[8], y[8], z[8];
};
inline EightDirections cosineDirections(Float8 u, Float8 v) {
  const Float8 a = 2 * u - 1, b = 2 * v - 1;
  const Mask8 isAcross = a * a > b * b;
  const Float8 radius = isAcross ? a : b;
  const Float8 angle = std::numbers::pi_v<float> / 4 * (isAcross ? b : a) / (radius != 0 ? radius : all8(1));
  // note: |angle| is pi / 4 at most, where these series are off by 3e-8.
  const Float8 squared = angle * angle;
  const Float8 sine = angle * (1 - squared * (1.0f / 6 - squared * (1.0f / 120 - squared * (1.0f / 5040))));
  const Float8 cosine =
      1 - squared * (0.5f - squared * (1.0f / 24 - squared * (1.0f / 720 - squared * (1.0f / 40320))));
  const Float8 along = radius * cosine, aside = radius * sine, below = 1 - radius * radius;
  const Float8 x = isAcross ? along : aside, y = isAcross ? aside : along;
  EightDirections directions;
  for (int i = 0; i < 8; ++i) {
    directions.x[i] = x[i];
    directions.y[i] = y[i];
    directions.z[i] = std::sqrt(std::max(0.0f, below[i]));
  }
  return directions;
}

}  // namespace fiatlux
