// Where a point of the room lies in the patch numbering, and points spread over a patch.
#include "precompute/room.h"

#include <algorithm>

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

Room::PointOnPatch Room::pointOnPatch(std::uint32_t p, double u, double v) const {
  const std::uint32_t first = fragmentOffset[p];
  if (fragmentOffset[p + 1] - first == 2) {
    // A whole cell: one rectangle, on which stratified (u, v) stay stratified.
    const auto& [a, b, c] = fragments[first].corner;
    const auto& [a2, c2, d] = fragments[first + 1].corner;
    const auto same = [](const Vec3& x, const Vec3& y) { return length(x - y) < 1e-12; };
    if (same(a, a2) && same(c, c2) && length((b - a) + (d - a) - (c - a)) < 1e-9 * length(c - a))
      return {a + u * (b - a) + v * (d - a), normalized(cross(b - a, d - a))};
  }
  // Choose a fragment by area with u, then stretch u back to [0, 1) within it.
  const auto crossOf = [&](std::uint32_t f) {
    const auto& [a, b, c] = fragments[f].corner;
    return cross(b - a, c - a);
  };
  double total = 0;
  for (std::uint32_t f = fragmentOffset[p]; f < fragmentOffset[p + 1]; ++f) total += length(crossOf(f));
  double before = 0;
  std::uint32_t chosen = fragmentOffset[p];
  for (std::uint32_t f = chosen; f < fragmentOffset[p + 1]; ++f) {
    const double area = length(crossOf(f));
    chosen = f;
    if (u * total < before + area || f + 1 == fragmentOffset[p + 1]) {
      u = area > 0 ? std::clamp((u * total - before) / area, 0.0, 1.0) : 0.5;
      break;
    }
    before += area;
  }
  const auto& [a, b, c] = fragments[chosen].corner;
  const double root = std::sqrt(u);
  return {(1 - root) * a + (root * (1 - v)) * b + (root * v) * c, normalized(crossOf(chosen))};
}

}  // namespace fiatlux
