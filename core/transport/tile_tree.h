// What a ray meets of a room of which only the patches are known: a tree of boxes over their tiles
// (patch_tiles.h). For a few hundred thousand rays; rooms are computed by precompute/rays.
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/scene.h"

namespace fiatlux {

/// Immutable. Measuring planes are not in it.
class TileTree {
 public:
  /// The scene must have a light operator.
  explicit TileTree(const Scene& scene);

  /// The patch that is met first, from its front or its back, by a ray from `origin` along `direction`; kNone
  /// where there is none within `reach` lengths of it.
  std::uint32_t firstMet(const Vec3& origin, const Vec3& direction, double reach) const;
  /// Whether anything stands between two points; what either of them touches does not.
  bool isBlocked(const Vec3& from, const Vec3& to) const;

 private:
  struct Tile {
    Vec3 center, normal, u, v;  // m; u and v are half edges over their squared length
    std::uint32_t patch;
  };
  struct Box {
    Vec3 low, high;
    bool isMet(const Vec3& origin, const Vec3& inverse, double reach) const;
  };
  /// Children are next to each other; a leaf holds `count` tiles from `first` on.
  struct Node {
    Box box;
    std::uint32_t first = 0, count = 0;
  };
  struct Meeting {
    double reach;
    std::uint32_t patch = kNone;
  };

  Box boxOf(std::uint32_t first, std::uint32_t count) const;
  void split(std::uint32_t node);
  void meet(const Tile& tile, const Vec3& origin, const Vec3& direction, Meeting& meeting) const;
  Meeting trace(const Vec3& origin, const Vec3& direction, double reach) const;

  std::vector<Tile> tiles_;
  std::vector<Box> bounds_;  // of the tiles, in their order
  std::vector<Node> nodes_;  // the root first
};

}  // namespace fiatlux
