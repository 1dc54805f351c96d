// Directions by the axis that is nearest to them.
#pragma once

#include <cmath>

#include "core/base/vec3.h"

namespace fiatlux {

/// Which of -x, +x, -y, +y, -z, +z a direction is nearest to, 0..5.
inline int dominantDirection(const Vec3& n) {
  const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
  const int axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  return 2 * axis + ((axis == 0 ? n.x : axis == 1 ? n.y : n.z) > 0);
}

}  // namespace fiatlux
