// Points in a lattice of cubes, to find those that lie on a segment: T-junctions of surfaces and of the
// picture.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/base/vec3.h"

namespace fiatlux {

/// Some vertices (indices into positions) in cubes of edge `cell` (m).
class VertexLattice {
 public:
  VertexLattice(const std::vector<Vec3>& positions, const std::vector<std::uint32_t>& vertices, double cell)
      : cell_(cell) {
    for (const std::uint32_t v : vertices)
      cells_[key(at(positions[v].x), at(positions[v].y), at(positions[v].z))].push_back(v);
  }

  /// Calls visit(v) for vertices near the segment (some more than once); returns how much work that was.
  template <class Visit>
  std::size_t alongSegment(const Vec3& a, const Vec3& b, double margin, Visit visit) const {
    // March in steps of a cell and look at the cells around each step.
    const double l = length(b - a);
    const auto steps = static_cast<std::size_t>(std::ceil(l / cell_)) + 1;
    std::size_t work = 0;
    std::uint64_t seen[27];
    int seenCount = 0;
    for (std::size_t s = 0; s < steps; ++s) {
      const auto step = static_cast<double>(s);
      const Vec3 low = a + (l > 0 ? std::min(1.0, step * cell_ / l) : 0.0) * (b - a);
      const Vec3 high = a + (l > 0 ? std::min(1.0, (step + 1) * cell_ / l) : 1.0) * (b - a);
      const auto range = [&](double p, double q) {
        return std::pair{at(std::min(p, q) - margin), at(std::max(p, q) + margin)};
      };
      const auto [x0, x1] = range(low.x, high.x);
      const auto [y0, y1] = range(low.y, high.y);
      const auto [z0, z1] = range(low.z, high.z);
      std::uint64_t now[27];
      int nowCount = 0;
      for (auto x = x0; x <= x1; ++x)
        for (auto y = y0; y <= y1; ++y)
          for (auto z = z0; z <= z1; ++z) {
            const std::uint64_t k = key(x, y, z);
            if (nowCount < 27) now[nowCount++] = k;
            if (std::find(seen, seen + seenCount, k) != seen + seenCount) continue;
            ++work;
            const auto found = cells_.find(k);
            if (found == cells_.end()) continue;
            work += found->second.size();
            for (const std::uint32_t v : found->second) visit(v);
          }
      std::copy(now, now + nowCount, seen);
      seenCount = nowCount;
    }
    return work;
  }

 private:
  std::int64_t at(double x) const { return static_cast<std::int64_t>(std::floor(x / cell_)); }
  static std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z) {
    return (static_cast<std::uint64_t>(x) & 0x1fffff) << 42 |
           (static_cast<std::uint64_t>(y) & 0x1fffff) << 21 | (static_cast<std::uint64_t>(z) & 0x1fffff);
  }
  double cell_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

}  // namespace fiatlux
