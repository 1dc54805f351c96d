// Where sites lie in relation to each other: their coordinates along the grid of their mounts, told apart to
// two millimetres, so that "the next site of the same pitch" and "the mirror image" are look-ups.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/scene/scene.h"

namespace fiatlux {

/// Sites of equal pitch on some line: indices into SiteGrid::values of one direction, ascending; the pitch is
/// 0 of a single one.
struct Chain {
  std::vector<std::uint32_t> at;
  double pitch = 0;  // m
};

class SiteGrid {
 public:
  explicit SiteGrid(const Scene& scene);

  /// The distinct coordinates along a direction, m, ascending: 0 runs along the room's x as far as the
  /// mounts' grids do, 1 across it.
  const std::vector<double>& values(int direction) const { return values_[direction]; }
  std::uint32_t planeCount() const { return static_cast<std::uint32_t>(squares_.size()); }
  /// Do a plane's coordinates run along the same directions as those of the plane with the most sites?
  bool isSquare(std::uint32_t plane) const { return squares_[plane] != 0; }

  std::uint32_t siteCount() const { return static_cast<std::uint32_t>(cells_.size()); }
  /// Of a site: indices into the values of both directions, and its plane; each way to hang has planes of it.
  const std::array<std::uint32_t, 3>& cell(std::uint32_t site) const { return cells_[site]; }
  /// The site there, or kNone.
  std::uint32_t siteAt(std::uint32_t first, std::uint32_t second, std::uint32_t plane) const {
    const auto found = siteOfCell_.find(keyOf({first, second, plane}));
    return found == siteOfCell_.end() ? kNone : found->second;
  }

  /// The index of a coordinate, or kNone.
  std::uint32_t indexOf(int direction, double value) const;

 private:
  static std::uint64_t keyOf(const std::array<std::uint32_t, 3>& cell) {
    return (std::uint64_t{cell[2]} << 42) | (std::uint64_t{cell[1]} << 21) | cell[0];
  }

  std::vector<double> values_[2];
  std::vector<char> squares_;  // of each plane
  std::vector<std::array<std::uint32_t, 3>> cells_;
  std::unordered_map<std::uint64_t, std::uint32_t> siteOfCell_;
};

/// The chains along one direction of a grid, which must outlive them.
class Chains {
 public:
  Chains(const SiteGrid& grid, int direction);

  /// The most coordinates of one.
  std::uint32_t longest() const { return longest_; }
  /// All of `count` coordinates, the order being that of first and pitch.
  std::vector<Chain> of(std::uint32_t count) const;

 private:
  const std::vector<double>& values_;
  std::vector<Chain> long_;  // the longest of each first and pitch, of three at least
  std::uint32_t longest_ = 0;
};

}  // namespace fiatlux
