// A triangle cut along the grid lines of its chart (Sutherland and Hodgman's clipping, row by row, then cell
// by cell).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "precompute/room/room.h"

namespace fiatlux {

struct GridCorner {
  double u, v;  // in cells of the chart
  Vec3 position;
};

inline GridCorner gridCorner(const Chart& chart, const Vec3& p) {
  const Vec3 local = p - chart.origin;
  return {dot(local, chart.uAxis) / chart.cellU, dot(local, chart.vAxis) / chart.cellV, p};
}

/// Keeps its buffers between calls.
class GridCut {
 public:
  /// Calls visit(cell, polygon) for each cell that the triangle touches. Points outside the grid count to the
  /// nearest cell.
  template <class Visit>
  void cut(const Chart& chart, const std::array<Vec3, 3>& triangle, Visit visit) {
    whole_.clear();
    for (const Vec3& p : triangle) whole_.push_back(gridCorner(chart, p));
    const auto rows = range(whole_, &GridCorner::v, chart.rows);
    for (std::uint32_t r = rows.first; r <= rows.second; ++r) {
      band_ = whole_;
      if (r > rows.first) clip(band_, &GridCorner::v, r, 1);
      if (r < rows.second) clip(band_, &GridCorner::v, r + 1, -1);
      if (band_.size() < 3) continue;
      const auto columns = range(band_, &GridCorner::u, chart.columns);
      for (std::uint32_t c = columns.first; c <= columns.second; ++c) {
        cell_ = band_;
        if (c > columns.first) clip(cell_, &GridCorner::u, c, 1);
        if (c < columns.second) clip(cell_, &GridCorner::u, c + 1, -1);
        if (cell_.size() >= 3)
          visit(r * chart.columns + c, static_cast<const std::vector<GridCorner>&>(cell_));
      }
    }
  }

 private:
  using Coordinate = double GridCorner::*;

  /// First and last cell that a polygon touches along one coordinate.
  static std::pair<std::uint32_t, std::uint32_t> range(const std::vector<GridCorner>& polygon, Coordinate x,
                                                       std::uint32_t count) {
    double low = 1e300, high = -1e300;
    for (const GridCorner& c : polygon) low = std::min(low, c.*x), high = std::max(high, c.*x);
    const auto cell = [&](double at) { return static_cast<std::uint32_t>(std::clamp(at, 0.0, count - 1.0)); };
    const std::uint32_t first = cell(std::floor(low));
    return {first, std::max(first, cell(std::ceil(high) - 1))};
  }

  /// Keeps what has sign * (x - at) >= 0.
  void clip(std::vector<GridCorner>& polygon, Coordinate x, double at, double sign) {
    out_.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const GridCorner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      const double da = sign * (a.*x - at), db = sign * (b.*x - at);
      if (da >= 0) out_.push_back(a);
      if ((da < 0) == (db < 0) || da == 0 || db == 0) continue;
      const double t = da / (da - db);
      GridCorner c{a.u + t * (b.u - a.u), a.v + t * (b.v - a.v), a.position + t * (b.position - a.position)};
      c.*x = at;
      out_.push_back(c);
    }
    std::swap(polygon, out_);
  }

  std::vector<GridCorner> whole_, band_, cell_, out_;
};

}  // namespace fiatlux
