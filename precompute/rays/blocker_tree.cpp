#include "precompute/rays/blocker_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/vec3.h"
#include "core/scene/patches.h"

namespace fiatlux {
namespace {

/// So many pieces that stand between two places, none a wall: rays must tell.
constexpr std::uint32_t kEnough = 6;
constexpr std::uint32_t kChildren = 8;
/// 2^32 halved pieces leave at most seven children each on the stack.
constexpr std::uint32_t kDeepest = 256;

struct FlatPiece {
  Vec3 corner[4];
  Vec3 normal;
  double low[3], high[3];
  double middle(int axis) const { return low[axis] + high[axis]; }
};

double along(const Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

FlatPiece pieceOf(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  FlatPiece piece{{a, b, c, d}, normalized(cross(b - a, c - a)), {}, {}};
  for (int axis = 0; axis < 3; ++axis) {
    piece.low[axis] = piece.high[axis] = along(a, axis);
    for (const Vec3& corner : piece.corner) {
      piece.low[axis] = std::min(piece.low[axis], along(corner, axis));
      piece.high[axis] = std::max(piece.high[axis], along(corner, axis));
    }
  }
  return piece;
}

bool isSame(const Vec3& a, const Vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

/// Makes `one` both triangles, where they are a flat convex quadrangle.
bool join(FlatPiece& one, const FlatPiece& two, double touch) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const Vec3 &a = one.corner[i], &b = one.corner[(i + 1) % 3], &opposite = one.corner[(i + 2) % 3];
      if (!isSame(a, two.corner[(j + 1) % 3]) || !isSame(b, two.corner[j])) continue;
      const Vec3 ring[4]{a, two.corner[(j + 2) % 3], b, opposite};
      if (std::abs(dot(ring[1] - a, one.normal)) > touch / 4) return false;
      for (int k = 0; k < 4; ++k) {
        const Vec3 in = ring[(k + 1) % 4] - ring[k], out = ring[(k + 2) % 4] - ring[(k + 1) % 4];
        if (!(dot(cross(in, out), one.normal) > 0)) return false;
      }
      one = pieceOf(ring[0], ring[1], ring[2], ring[3]);
      return true;
    }
  }
  return false;
}

}  // namespace

class BlockerTree::Builder {
 public:
  Builder(std::span<const Position> positions, std::span<const Triangle> triangles, BlockerTree& tree)
      : tree_(tree) {
    const auto at = [&](std::uint32_t vertex) {
      const Position& p = positions[vertex];
      return Vec3{p[0], p[1], p[2]};
    };
    bool isTriangle = false;  // the last piece
    for (const Triangle& triangle : triangles) {
      const Vec3 a = at(triangle[0]), b = at(triangle[1]), c = at(triangle[2]);
      const FlatPiece piece = pieceOf(a, b, c, c);
      if (!(length(piece.normal) > 0)) continue;
      if (isTriangle && join(pieces_.back(), piece, tree.touch_)) {
        isTriangle = false;
        continue;
      }
      pieces_.push_back(piece);
      isTriangle = true;
    }
    order_.resize(pieces_.size());
    std::iota(order_.begin(), order_.end(), 0u);
    if (!order_.empty()) addNode({0, static_cast<std::uint32_t>(order_.size())});
  }

 private:
  struct Range {
    std::uint32_t first, last;
    std::uint32_t count() const { return last - first; }
  };

  /// Bounds of a range's pieces, along an axis; of their middles where `middles`.
  std::array<double, 2> extent(const Range& range, int axis, bool middles) const {
    std::array<double, 2> bounds{std::numeric_limits<double>::infinity(),
                                 -std::numeric_limits<double>::infinity()};
    for (std::uint32_t i = range.first; i < range.last; ++i) {
      const FlatPiece& piece = pieces_[order_[i]];
      bounds[0] = std::min(bounds[0], middles ? piece.middle(axis) : piece.low[axis]);
      bounds[1] = std::max(bounds[1], middles ? piece.middle(axis) : piece.high[axis]);
    }
    return bounds;
  }

  /// Halves a range across its longest axis.
  Range halve(Range& range) {
    int longest = 0;
    double most = -1;
    for (int axis = 0; axis < 3; ++axis) {
      const auto [low, high] = extent(range, axis, true);
      if (high - low > most) most = high - low, longest = axis;
    }
    // note: stable, so that every library makes the same tree.
    std::stable_sort(order_.begin() + range.first, order_.begin() + range.last,
                     [&](std::uint32_t a, std::uint32_t b) {
                       return pieces_[a].middle(longest) < pieces_[b].middle(longest);
                     });
    const Range right{range.first + range.count() / 2, range.last};
    range.last = right.first;
    return right;
  }

  std::uint32_t addNode(const Range& all) {
    std::vector<Range> children{all};
    while (children.size() < kChildren) {
      const auto largest =
          std::max_element(children.begin(), children.end(),
                           [](const Range& a, const Range& b) { return a.count() < b.count(); });
      if (largest->count() <= Quads::kCount) break;
      const Range right = halve(*largest);
      children.push_back(right);
    }
    Node node;
    for (std::uint32_t i = 0; i < kChildren; ++i) {
      const Range range = i < children.size() ? children[i] : Range{0, 0};
      for (int axis = 0; axis < 3; ++axis) {
        const auto [low, high] = extent(range, axis, false);
        node.bounds[axis][i] = static_cast<float>(low);
        node.bounds[axis + 3][i] = static_cast<float>(high);
      }
      node.child[i] = kNone;
    }
    const auto index = static_cast<std::uint32_t>(tree_.nodes_.size());
    tree_.nodes_.push_back(node);
    for (std::uint32_t i = 0; i < children.size(); ++i) {
      const std::uint32_t child =
          children[i].count() <= Quads::kCount ? addQuads(children[i]) : addNode(children[i]);
      tree_.nodes_[index].child[i] = child;
    }
    return index;
  }

  std::uint32_t addQuads(const Range& range) {
    Quads quads{};
    for (std::uint32_t lane = 0; lane < range.count(); ++lane) {
      const FlatPiece& piece = pieces_[order_[range.first + lane]];
      for (int axis = 0; axis < 3; ++axis) {
        for (int i = 0; i < 4; ++i)
          quads.corner[i][axis][lane] = static_cast<float>(along(piece.corner[i], axis));
        quads.normal[axis][lane] = static_cast<float>(along(piece.normal, axis));
      }
      quads.height[lane] = static_cast<float>(dot(piece.normal, piece.corner[0]));
    }
    tree_.quads_.push_back(quads);
    return kLeaf | static_cast<std::uint32_t>(tree_.quads_.size() - 1);
  }

  BlockerTree& tree_;
  std::vector<FlatPiece> pieces_;
  std::vector<std::uint32_t> order_;  // pieces, ranges of which are halved
};

BlockerTree::BlockerTree(std::span<const Position> positions, std::span<const Triangle> triangles,
                         float touch)
    : touch_(touch) {
  Builder(positions, triangles, *this);
}

/// add(quads, lane): whether to look on, of what reaches between the two places and is no wall.
template <class Add>
Between BlockerTree::walk(const Place& from, const Place& to, const Add& add) const {
  if (nodes_.empty()) return Between::kNothing;
  const Shaft shaft(from, to, touch_);
  std::uint32_t stack[kDeepest], size = 0;
  bool isFound = false;
  stack[size++] = 0;
  while (size > 0) {
    const std::uint32_t reference = stack[--size];
    if (!(reference & kLeaf)) {
      const Node& node = nodes_[reference];
      for (unsigned lanes = shaft.entered(node.bounds); lanes; lanes &= lanes - 1)
        stack[size++] = node.child[__builtin_ctz(lanes)];
      continue;
    }
    const Quads& quads = quads_[reference & ~kLeaf];
    for (unsigned lanes = shaft.crossed(quads); lanes; lanes &= lanes - 1) {
      const auto lane = static_cast<std::uint32_t>(__builtin_ctz(lanes));
      if (shaft.isCutBy(quads, lane)) return Between::kWall;
      if (!add(quads, lane)) return Between::kUnknown;
      isFound = true;
    }
  }
  return isFound ? Between::kUnknown : Between::kNothing;
}

Between BlockerTree::between(const Place& from, const Place& to) const {
  std::uint32_t found = 0;
  return walk(from, to, [&](const Quads&, std::uint32_t) { return ++found < kEnough; });
}

Between BlockerTree::between(const Place& from, const Place& to, Blockers& found) const {
  found.clear();
  return walk(from, to, [&](const Quads& quads, std::uint32_t lane) {
    found.add(quads, lane, touch_ / 2);
    return !found.isFull();
  });
}

}  // namespace fiatlux
