// The kernel of radiosity: what a small piece of surface sends to another, if nothing stands between.
#pragma once

#include <numbers>

#include "core/base/vec3.h"
#include "precompute/rays/float8.h"

namespace fiatlux {

/// Power that a small piece of surface at one end of d, from `leaving` to `arriving`, sends to a unit of area
/// at the other: cos cos / (pi r^2), 0 where they face away.
inline double kernel(const Vec3& d, const Vec3& leaving, const Vec3& arriving) {
  const double out = dot(d, leaving), in = -dot(d, arriving);
  if (out <= 0 || in <= 0) return 0;
  const double squared = dot(d, d);
  return out * in / (std::numbers::pi * squared * squared);
}

/// Eight vectors, a lane each.
struct EightVectors {
  Float8 x, y, z;
};
inline Float8 dot(const EightVectors& a, const EightVectors& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

/// The same of eight pairs.
inline Float8 eightKernels(const EightVectors& d, const EightVectors& leaving, const EightVectors& arriving) {
  const Float8 out = max8(dot(d, leaving), all8(0)), in = max8(-dot(d, arriving), all8(0)),
               squared = dot(d, d);
  return out * in / (std::numbers::pi_v<float> * squared * squared);
}

}  // namespace fiatlux
