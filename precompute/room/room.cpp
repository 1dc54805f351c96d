// Where a point of the room lies in the patch numbering.
#include "precompute/room/room.h"

#include <algorithm>
#include <cmath>

namespace fiatlux {

std::uint32_t Room::patchAt(std::uint32_t triangle, bool back, const Vec3& point) const {
  const std::uint32_t index = back ? triangles[triangle].backChart : triangles[triangle].chart;
  if (index == kNone) return kNone;
  const Chart& chart = charts[index];
  const Vec3 local = point - chart.origin;
  const auto cell = [](double x, double edge, std::uint32_t count) {
    return static_cast<std::uint32_t>(std::clamp(x / edge, 0.0, count - 0.5));
  };
  const std::uint32_t column = cell(dot(local, chart.uAxis), chart.cellU, chart.columns);
  const std::uint32_t row = cell(dot(local, chart.vAxis), chart.cellV, chart.rows);
  const std::uint32_t patch = chart.patchOfCell[row * chart.columns + column];
  if (patch != kNone) return patch;
  // note: a point on the edge of a chart may round into an empty cell; it belongs to the nearest cell beside
  // it
  std::uint32_t nearest = kNone;
  double least = 1e300;
  for (std::uint32_t r = row - (row > 0); r <= std::min(row + 1, chart.rows - 1); ++r)
    for (std::uint32_t c = column - (column > 0); c <= std::min(column + 1, chart.columns - 1); ++c) {
      const std::uint32_t p = chart.patchOfCell[r * chart.columns + c];
      if (p == kNone) continue;
      const double du = dot(local, chart.uAxis) / chart.cellU - (c + 0.5),
                   dv = dot(local, chart.vAxis) / chart.cellV - (r + 0.5);
      const double distance = std::max(std::abs(du), std::abs(dv));
      if (distance < least) least = distance, nearest = p;
    }
  return nearest;
}

std::uint32_t Room::patchMet(const Vec3& origin, const Vec3& direction, std::uint32_t triangle,
                             double distance) const {
  if (triangle == kNone) return kNone;
  const auto& [a, b, c] = triangles[triangle].vertex;
  const Vec3 front = cross(positions[b] - positions[a], positions[c] - positions[a]);
  return patchAt(triangle, dot(direction, front) > 0, origin + distance * direction);
}

}  // namespace fiatlux
