// What stands between two places of a room: a tree of boxes, eight children a node, over its flat pieces.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "precompute/rays/blockers.h"
#include "precompute/rays/shaft.h"

namespace fiatlux {

/// Immutable once built.
class BlockerTree {
 public:
  using Triangle = std::array<std::uint32_t, 3>;  // indices into the positions
  using Position = std::array<float, 3>;          // m, around the tracer's centre

  /// `touch`, m: what reaches between two places by less is not there. Two triangles in a row that make a
  /// convex flat quadrangle are one.
  BlockerTree(std::span<const Position> positions, std::span<const Triangle> triangles, float touch);

  Between between(const Place& from, const Place& to) const;
  /// The same, and where that is unknown, `found` is all that may stand there; full where it is too much for
  /// that.
  Between between(const Place& from, const Place& to, Blockers& found) const;

 private:
  struct alignas(64) Node {
    float bounds[6][8];      // low x, y, z, high x, y, z
    std::uint32_t child[8];  // a node, or kLeaf and quads
  };
  static constexpr std::uint32_t kLeaf = 1u << 31;

  class Builder;

  template <class Add>
  Between walk(const Place& from, const Place& to, const Add& add) const;

  float touch_;
  std::vector<Node> nodes_;  // the root first; empty without quads
  std::vector<Quads> quads_;
};

}  // namespace fiatlux
