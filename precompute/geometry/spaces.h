// The spaces of a building: its air in cubes, parted where it is no wider than a door, or lower than on both
// sides of it, as below a lintel, but for beams from wall to wall. A cube is solid where a triangle may be;
// what has more than half a metre of air to all sides is the core of a space, and cores grow at one pace
// until they meet, in the middle of openings (a watershed of the distance to what is solid).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/base/vec3.h"
#include "precompute/gltf/source_scene.h"

namespace fiatlux {

/// Cubes along the axes.
struct CubeGrid {
  Vec3 low;         // m
  double edge = 0;  // m
  std::array<int, 3> count{};

  std::size_t size() const {
    return static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(count[1]) *
           static_cast<std::size_t>(count[2]);
  }
  /// From one cube to the next along an axis, in an array of all.
  std::size_t stride(int axis) const {
    const auto x = static_cast<std::size_t>(count[0]);
    return axis == 0 ? 1 : axis == 1 ? x : x * static_cast<std::size_t>(count[1]);
  }
  /// Which cube holds a point, in so many steps along each axis; cut off at the grid's sides.
  std::array<int, 3> stepsTo(const Vec3& point) const;
  std::size_t indexOf(const std::array<int, 3>& steps) const;
  std::array<int, 3> stepsOf(std::size_t cube) const;
  /// m, the corner of a cube with the least coordinates.
  Vec3 cornerAt(const std::array<int, 3>& steps) const {
    return low + edge * Vec3{static_cast<double>(steps[0]), static_cast<double>(steps[1]),
                             static_cast<double>(steps[2])};
  }
};

class Spaces {
 public:
  static constexpr std::uint32_t kNowhere = 0;   // solid, or air that no space reaches
  static constexpr std::uint32_t kOutdoors = 1;  // under the open sky; spaces follow

  /// Whether a model is small enough for openings to be told.
  static bool canTell(const SourceScene& source);
  /// `inside` is to lie in one of the spaces: where it lies under the open sky, the room has no ceiling, and
  /// nothing counts as outdoors. Throws CommandError where openings cannot be told.
  Spaces(const SourceScene& source, const Vec3& inside);
  /// Where all lies under the open sky, nothing counts as outdoors. Only where openings can be told.
  explicit Spaces(const SourceScene& source);

  const CubeGrid& grid() const { return grid_; }
  std::uint32_t count() const { return next_ - kOutdoors - 1; }
  std::uint32_t of(std::size_t cube) const { return spaces_[cube]; }
  bool isSolid(std::size_t cube) const { return solid_[cube] != 0; }
  /// Of the air nearest to a point, within half a metre; kNowhere where there is none.
  std::uint32_t at(const Vec3& point) const;
  /// By space: whether it is reached from one of them through so many openings at most.
  std::vector<bool> reached(std::uint32_t from, std::uint32_t openings) const;

 private:
  /// The up to six cubes beside one.
  template <class Tell>
  void eachNeighbour(std::size_t cube, const Tell& tell) const {
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t stride = grid_.stride(axis);
      const auto count = static_cast<std::size_t>(grid_.count[static_cast<std::size_t>(axis)]);
      const std::size_t at = cube / stride % count;
      if (at > 0) tell(cube - stride);
      if (at + 1 < count) tell(cube + stride);
    }
  }
  void fill(const SourceScene& source);
  void part(bool hasOutdoors);
  std::vector<std::uint16_t> topsOfAir(int most, std::vector<std::uint8_t>& isLow) const;
  void narrowBelowLintels(std::vector<std::uint8_t>& narrow) const;
  int airAlong(int axis, std::size_t cube) const;
  void findCores(bool hasOutdoors);
  void grow();

  CubeGrid grid_;
  std::vector<std::uint8_t> solid_;     // by cube
  std::vector<std::uint32_t> spaces_;   // by cube
  std::uint32_t next_ = kOutdoors + 1;  // the first number that no space has
};

/// From a plane, in edges of cubes: so far from it no cube meets it.
inline constexpr double kClearOfPlane = 1.5;

/// Whether `isMet` says so of a cube that a triangle may meet.
template <class IsMet>
bool anyCube(const CubeGrid& grid, const Vec3& a, const Vec3& b, const Vec3& c, const IsMet& isMet) {
  const auto one = grid.stepsTo(a), two = grid.stepsTo(b), three = grid.stepsTo(c);
  std::array<int, 3> low{}, high{};
  bool isSmall = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low[axis] = std::min({one[axis], two[axis], three[axis]});
    high[axis] = std::max({one[axis], two[axis], three[axis]});
    isSmall = isSmall && high[axis] - low[axis] <= 1;
  }
  if (isSmall) {
    std::array<int, 3> at{};
    for (at[2] = low[2]; at[2] <= high[2]; ++at[2])
      for (at[1] = low[1]; at[1] <= high[1]; ++at[1])
        for (at[0] = low[0]; at[0] <= high[0]; ++at[0])
          if (isMet(grid.indexOf(at))) return true;
    return false;
  }
  // Halved at the longest side until it lies within two cubes a side.
  const double ab = length(b - a), bc = length(c - b), ca = length(a - c);
  if (bc >= ab && bc >= ca) return anyCube(grid, b, c, a, isMet);
  if (ca > ab) return anyCube(grid, c, a, b, isMet);
  const Vec3 middle = 0.5 * (a + b);
  return anyCube(grid, a, middle, c, isMet) || anyCube(grid, middle, b, c, isMet);
}

/// By cube: whether one of those is true, or one at most `reach` cubes away along each axis.
std::vector<std::uint8_t> widened(const CubeGrid& grid, std::vector<std::uint8_t> cubes, int reach);

}  // namespace fiatlux
