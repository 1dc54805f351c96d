#include "core/transport/intensity_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fiatlux {
namespace {

constexpr int kCoarse = 8;  // crossings from one to the next where what is summed is little

/// Of the square's place (u, v) in [-1, 1]^2, on the octahedron.
Vec3 placeAt(double u, double v) {
  const double z = 1 - std::abs(u) - std::abs(v);
  if (z >= 0) return {u, v, z};
  return {std::copysign(1 - std::abs(v), u), std::copysign(1 - std::abs(u), v), z};
}

Vec3 directionAt(double u, double v) { return normalized(placeAt(u, v)); }

}  // namespace

IntensityMap::IntensityMap(const Intensity& intensity, bool mirrored) : candela_((kEdge + 1) * (kEdge + 1)) {
  const int first = mirrored ? kEdge / 2 : 0;
  for (int row = first; row <= kEdge; ++row)
    for (int column = first; column <= kEdge; ++column)
      candela_[index(row, column)] =
          static_cast<float>(intensity(directionAt(2.0 * column / kEdge - 1, 2.0 * row / kEdge - 1)));
  for (int row = 0; mirrored && row <= kEdge; ++row)
    for (int column = 0; column <= kEdge; ++column)
      candela_[index(row, column)] =
          candela_[index(std::max(row, kEdge - row), std::max(column, kEdge - column))];
  all_ = sum(1, nullptr);
}

/// lm, by every `stride`th crossing: into all directions, or into those that are `behind`.
double IntensityMap::sum(int stride, const Vec3* behind) const {
  double lumens = 0;
  for (int row = 0; row <= kEdge; row += stride)
    for (int column = 0; column <= kEdge; column += stride) {
      const float candela = candela_[index(row, column)];
      if (candela == 0) continue;
      const Vec3 place = placeAt(2.0 * column / kEdge - 1, 2.0 * row / kEdge - 1);
      const double side = behind ? dot(place, *behind) : -1;
      if (side > 0) continue;
      // A cell's solid angle is du dv / r^3; crossings on a rim have half a cell.
      const double squared = dot(place, place);
      const double share =
          (row % kEdge == 0 ? 0.5 : 1) * (column % kEdge == 0 ? 0.5 : 1) * (side == 0 ? 0.5 : 1);
      lumens += share * candela / (squared * std::sqrt(squared));
    }
  return lumens * std::pow(2.0 * stride / kEdge, 2);
}

double IntensityMap::flux(const Vec3& before) const { return all_ - sum(kCoarse, &before); }

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

void IntensityMap::look(const float* x, const float* y, const float* z, int count, float* candela) const {
  constexpr int kMost = 64;
  std::array<float, kMost> right, below, corners[4];
  std::array<int, kMost> corner;
  for (int first = 0; first < count; first += kMost) {
    const int n = std::min(kMost, count - first);
    // Places on the square, in cells. note: whole numbers by one loop, which the compiler makes vectors of.
    for (int i = 0; i < n; ++i) {
      const float dx = x[first + i], dy = y[first + i], dz = z[first + i];
      const float scale = 1 / (std::abs(dx) + std::abs(dy) + std::abs(dz));
      const float u = scale * dx, v = scale * dy;
      const float outU = 1 - std::abs(v), outV = 1 - std::abs(u);
      const float foldedU = u < 0 ? -outU : outU, foldedV = v < 0 ? -outV : outV;
      const float across = 0.5f * kEdge * ((dz < 0 ? foldedU : u) + 1);
      const float down = 0.5f * kEdge * ((dz < 0 ? foldedV : v) + 1);
      int column = static_cast<int>(across), row = static_cast<int>(down);
      column = column < 0 ? 0 : column > kEdge - 1 ? kEdge - 1 : column;
      row = row < 0 ? 0 : row > kEdge - 1 ? kEdge - 1 : row;
      right[i] = across - static_cast<float>(column), below[i] = down - static_cast<float>(row);
      corner[i] = row * (kEdge + 1) + column;
    }
    for (int i = 0; i < n; ++i) {
      const float* at = candela_.data() + corner[i];
      corners[0][i] = at[0], corners[1][i] = at[1];
      corners[2][i] = at[kEdge + 1], corners[3][i] = at[kEdge + 2];
    }
    for (int i = 0; i < n; ++i) {
      const float upper = corners[0][i] + right[i] * (corners[1][i] - corners[0][i]);
      const float lower = corners[2][i] + right[i] * (corners[3][i] - corners[2][i]);
      candela[first + i] = upper + below[i] * (lower - upper);
    }
  }
}

}  // namespace fiatlux
