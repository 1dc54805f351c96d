#include "core/transport/intensity_map.h"

#include <algorithm>
#include <cmath>

namespace fiatlux {
namespace {

/// Of the square's place (u, v) in [-1, 1]^2.
Vec3 directionAt(double u, double v) {
  const double z = 1 - std::abs(u) - std::abs(v);
  if (z >= 0) return normalized({u, v, z});
  return normalized({std::copysign(1 - std::abs(v), u), std::copysign(1 - std::abs(u), v), z});
}

}  // namespace

IntensityMap::IntensityMap(const Intensity& intensity) {
  candela_.reserve((kEdge + 1) * (kEdge + 1));
  for (int row = 0; row <= kEdge; ++row)
    for (int column = 0; column <= kEdge; ++column)
      candela_.push_back(
          static_cast<float>(intensity(directionAt(2.0 * column / kEdge - 1, 2.0 * row / kEdge - 1))));
}

double IntensityMap::at(const Vec3& direction) const {
  const double scale = 1 / (std::abs(direction.x) + std::abs(direction.y) + std::abs(direction.z));
  double u = scale * direction.x, v = scale * direction.y;
  if (direction.z < 0) {
    const double folded = std::copysign(1 - std::abs(v), u);
    v = std::copysign(1 - std::abs(u), v);
    u = folded;
  }
  const double x = 0.5 * kEdge * (u + 1), y = 0.5 * kEdge * (v + 1);
  const int column = std::clamp(static_cast<int>(x), 0, kEdge - 1),
            row = std::clamp(static_cast<int>(y), 0, kEdge - 1);
  const double right = x - column, down = y - row;
  const float* corner = &candela_[static_cast<std::size_t>(row * (kEdge + 1) + column)];
  const double above = corner[0] + right * (corner[1] - corner[0]);
  const double below = corner[kEdge + 1] + right * (corner[kEdge + 2] - corner[kEdge + 1]);
  return above + down * (below - above);
}

}  // namespace fiatlux
