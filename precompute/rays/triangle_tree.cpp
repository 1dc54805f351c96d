// Built from the top: a node's largest range of triangles is split until there are eight. Traversed one ray
// at a time, the nearest child first; edges are tested in Pluecker coordinates around the ray's origin, where
// two triangles that share an edge compute the same number, so that no ray slips between them.
#include "precompute/rays/triangle_tree.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/scene/patches.h"

namespace fiatlux {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();
constexpr std::uint32_t kBins = 16;
/// Wide levels that follow the heuristic; below, ranges are halved, so that the tree is never deep.
constexpr std::uint32_t kFreeDepth = 16;
/// kFreeDepth levels and those of 2^32 halved triangles leave at most seven children each on the stack.
constexpr std::uint32_t kStack = 256;
/// A node's far side is moved out by the roundings of its slab test (Ize, Robust BVH ray traversal, 2013).
constexpr float kOutwards = 1.0000004f;
/// A triangle reaches so far beyond its edges, in parts of itself: at a corner each edge has a rounding of
/// its own.
constexpr float kSlack = 0x1p-20f;
/// The least component of a direction, so that its inverse is finite.
constexpr float kLeastDirection = 1e-18f;

struct Box {
  float low[3]{kFar, kFar, kFar}, high[3]{-kFar, -kFar, -kFar};
  void include(const Box& other) {
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], other.low[axis]);
      high[axis] = std::max(high[axis], other.high[axis]);
    }
  }
  float halfArea() const {
    const float x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
    return x >= 0 ? x * y + y * z + z * x : 0;
  }
  /// Twice the centre.
  float middle(int axis) const { return low[axis] + high[axis]; }
};

/// Triangles [first, last) of the order, and the box around them.
struct Range {
  std::uint32_t first, last;
  Box box;
  std::uint32_t count() const { return last - first; }
};

/// Where to cut a range: triangles whose bin along `axis` is below `bin` go left.
struct Cut {
  int axis = -1;  // -1: nowhere
  std::uint32_t bin = 0;
  float cost = kFar;
  float low = 0, scale = 0;  // bin = (middle - low) * scale
  std::uint32_t binOf(const Box& box) const {
    return std::min(kBins - 1, static_cast<std::uint32_t>((box.middle(axis) - low) * scale));
  }
};

/// What a range costs: blocks of triangles that a ray through its box is tested against.
float costOf(const Box& box, std::uint32_t count) {
  return box.halfArea() * static_cast<float>((count + 7) / 8 * 8 + count);
}

}  // namespace

class TriangleTree::Builder {
 public:
  Builder(std::span<const Position> positions, std::span<const Triangle> triangles, TriangleTree& tree)
      : positions_(positions), triangles_(triangles), tree_(tree) {
    boxes_.resize(triangles.size());
    order_.resize(triangles.size());
    std::iota(order_.begin(), order_.end(), 0u);
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (const std::uint32_t vertex : triangles[t]) {
        Box point;
        for (int axis = 0; axis < 3; ++axis)
          point.low[axis] = point.high[axis] = positions[vertex][static_cast<std::size_t>(axis)];
        boxes_[t].include(point);
      }
  }

  void build() {
    const auto count = static_cast<std::uint32_t>(order_.size());
    if (count > 0) addNode(rangeOf(0, count), 0);
  }

 private:
  Range rangeOf(std::uint32_t first, std::uint32_t last) const {
    Range range{first, last, {}};
    for (std::uint32_t i = first; i < last; ++i) range.box.include(boxes_[order_[i]]);
    return range;
  }

  Cut bestCutAlong(int axis, const Range& range) const {
    float low = kFar, high = -kFar;
    for (std::uint32_t i = range.first; i < range.last; ++i) {
      const float middle = boxes_[order_[i]].middle(axis);
      low = std::min(low, middle);
      high = std::max(high, middle);
    }
    Cut cut{axis, 0, kFar, low, static_cast<float>(kBins) / (high - low)};
    if (!(high > low) || !std::isfinite(cut.scale)) return {};
    Box box[kBins];
    std::uint32_t count[kBins]{};
    for (std::uint32_t i = range.first; i < range.last; ++i) {
      const Box& each = boxes_[order_[i]];
      const std::uint32_t bin = cut.binOf(each);
      box[bin].include(each);
      ++count[bin];
    }
    float costFromRight[kBins]{};
    Box right;
    for (std::uint32_t bin = kBins - 1, sum = 0; bin > 0; --bin) {
      right.include(box[bin]);
      costFromRight[bin] = costOf(right, sum += count[bin]);
    }
    Box left;
    for (std::uint32_t bin = 1, sum = 0; bin < kBins; ++bin) {
      left.include(box[bin - 1]);
      sum += count[bin - 1];
      const float cost = costOf(left, sum) + costFromRight[bin];
      if (sum > 0 && sum < range.count() && cost < cut.cost) cut.cost = cost, cut.bin = bin;
    }
    return cut;
  }

  /// Splits a range in two where rays meet least, or in halves where that is told or nothing can be told.
  std::array<Range, 2> split(const Range& range, bool halve) {
    const auto first = order_.begin() + range.first, last = order_.begin() + range.last;
    Cut best;
    for (int axis = 0; axis < 3 && !halve; ++axis) {
      const Cut cut = bestCutAlong(axis, range);
      if (cut.cost < best.cost) best = cut;
    }
    auto middle = first + range.count() / 2;
    if (best.axis >= 0) {
      // note: stable, for which triangle comes first must not depend on the library's partition.
      middle = std::stable_partition(first, last,
                                     [&](std::uint32_t t) { return best.binOf(boxes_[t]) < best.bin; });
    }
    const auto at = static_cast<std::uint32_t>(middle - order_.begin());
    return {rangeOf(range.first, at), rangeOf(at, range.last)};
  }

  std::uint32_t addNode(const Range& all, std::uint32_t depth) {
    const bool halve = depth >= kFreeDepth;
    std::vector<Range> children{all};
    while (children.size() < kWidth) {
      // The child to split: the one with most to gain.
      std::size_t largest = kWidth;
      float most = -1;
      for (std::size_t i = 0; i < children.size(); ++i) {
        if (children[i].count() <= kLeaf) continue;
        const float gain = halve ? static_cast<float>(children[i].count()) : children[i].box.halfArea();
        if (gain > most) most = gain, largest = i;
      }
      if (largest == kWidth) break;
      const auto [left, right] = split(children[largest], halve);
      children[largest] = left;
      children.push_back(right);
    }
    const auto index = static_cast<std::uint32_t>(tree_.nodes_.size());
    Node node;
    for (std::uint32_t i = 0; i < kWidth; ++i) {
      const Box box = i < children.size() ? children[i].box : Box{};
      for (int axis = 0; axis < 3; ++axis) node.bounds[axis][i] = box.low[axis];
      for (int axis = 0; axis < 3; ++axis) node.bounds[3 + axis][i] = box.high[axis];
      node.child[i] = kNone;
    }
    tree_.nodes_.push_back(node);
    for (std::uint32_t i = 0; i < children.size(); ++i) {
      const std::uint32_t child =
          children[i].count() <= kWidth ? addBlock(children[i]) : addNode(children[i], depth + 1);
      tree_.nodes_[index].child[i] = child;
    }
    return index;
  }

  std::uint32_t addBlock(const Range& range) {
    Block block{};
    block.count = range.count();
    std::sort(order_.begin() + range.first, order_.begin() + range.last);
    for (std::uint32_t lane = 0; lane < range.count(); ++lane) {
      const std::uint32_t t = order_[range.first + lane];
      block.triangle[lane] = t;
      for (std::size_t corner = 0; corner < 3; ++corner)
        for (std::size_t axis = 0; axis < 3; ++axis)
          block.corner[corner][axis][lane] = positions_[triangles_[t][corner]][axis];
    }
    tree_.blocks_.push_back(block);
    return kBlock | static_cast<std::uint32_t>(tree_.blocks_.size() - 1);
  }

  static constexpr std::uint32_t kLeaf = 4;  // a child of at most so many triangles is split no further

  std::span<const Position> positions_;
  std::span<const Triangle> triangles_;
  TriangleTree& tree_;
  std::vector<Box> boxes_;            // by triangle
  std::vector<std::uint32_t> order_;  // triangles, ranges of which are split
};

Result<TriangleTree> TriangleTree::build(std::span<const Position> positions,
                                         std::span<const Triangle> triangles) {
  TriangleTree tree;
  Builder(positions, triangles, tree).build();
  return tree;
}

/// One ray, each number eight times; `row`: which of a node's bounds it meets first, by axis.
struct TriangleTree::Ray {
  Float8 origin[3], direction[3], inverse[3];
  std::uint32_t row[3];

  Ray(const RayPacket& rays, std::uint32_t lane) {
    const float o[3]{rays.originX[lane], rays.originY[lane], rays.originZ[lane]};
    const float d[3]{rays.directionX[lane], rays.directionY[lane], rays.directionZ[lane]};
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      origin[axis] = all8(o[axis]);
      direction[axis] = all8(d[axis]);
      const float safe =
          std::abs(d[axis]) < kLeastDirection ? std::copysign(kLeastDirection, d[axis]) : d[axis];
      inverse[axis] = all8(1 / safe);
      row[axis] = std::signbit(d[axis]) ? axis + 3 : axis;
    }
  }
};

/// The nearest so far, or how far to look.
struct TriangleTree::Hit {
  float distance;
  std::uint32_t triangle = kNone;
};

namespace {

/// Eight rays and eight triangles, lane by lane: where each ray meets its triangle, in lengths of its
/// direction. `v`: corners of the triangles as seen from the rays' origins, [corner][axis]. Lanes that are
/// not met are 0.
Float8 meetings(const Float8 (&v)[3][3], const Float8 (&direction)[3]) {
  // On which side of each edge the ray passes: the volume that it spans with the edge.
  Float8 side[3];
  for (int edge = 0; edge < 3; ++edge) {
    const Float8 *a = v[edge], *b = v[(edge + 2) % 3];
    const Float8 ex = b[0] - a[0], ey = b[1] - a[1], ez = b[2] - a[2];
    const Float8 sx = b[0] + a[0], sy = b[1] + a[1], sz = b[2] + a[2];
    side[edge] = (sy * ez - sz * ey) * direction[0] + (sz * ex - sx * ez) * direction[1] +
                 (sx * ey - sy * ex) * direction[2];
  }
  const Float8 least = min8(side[0], min8(side[1], side[2])), most = max8(side[0], max8(side[1], side[2]));
  const Float8 none = all8(0), sum = side[0] + side[1] + side[2];
  const Float8 slack = max8(sum, -sum) * kSlack;
  const Mask8 inside = (least >= -slack) | (most <= slack);
  if (bitsOf(inside) == 0) return none;

  // Where it meets the triangle's plane.
  const Float8 ax = v[1][0] - v[0][0], ay = v[1][1] - v[0][1], az = v[1][2] - v[0][2];
  const Float8 bx = v[2][0] - v[0][0], by = v[2][1] - v[0][1], bz = v[2][2] - v[0][2];
  const Float8 nx = ay * bz - az * by, ny = az * bx - ax * bz, nz = ax * by - ay * bx;
  const Float8 slope = nx * direction[0] + ny * direction[1] + nz * direction[2];
  const Float8 distance = (nx * v[0][0] + ny * v[0][1] + nz * v[0][2]) / slope;
  const Mask8 met = inside & (slope != none) & (distance > none);
  return met ? distance : none;
}

}  // namespace

bool TriangleTree::meetBlock(const Block& block, const Ray& ray, Hit& hit) const {
  Float8 v[3][3];
  for (int corner = 0; corner < 3; ++corner)
    for (int axis = 0; axis < 3; ++axis)
      v[corner][axis] = load8(block.corner[corner][axis]) - ray.origin[axis];
  const Float8 distance = meetings(v, ray.direction);
  unsigned lanes = bitsOf((distance > all8(0)) & (distance <= all8(hit.distance)));
  const bool met = lanes != 0;
  for (; lanes; lanes &= lanes - 1) {
    const auto lane = static_cast<std::uint32_t>(__builtin_ctz(lanes));
    const float at = distance[lane];
    if (at < hit.distance || block.triangle[lane] < hit.triangle) hit = {at, block.triangle[lane]};
  }
  return met;
}

/// What is still to be looked into, and where a ray enters it.
struct TriangleTree::Open {
  float distance;
  std::uint32_t reference;
};

/// Puts the children that `lanes` names on the stack, where `sorted` the nearest on top; returns its new
/// size.
std::uint32_t TriangleTree::push(unsigned lanes, const Node& node, Float8 enter, bool sorted, Open* stack,
                                 std::uint32_t size) {
  const std::uint32_t bottom = size;
  assert(size + kWidth <= kStack);
  for (; lanes; lanes &= lanes - 1) {
    const auto lane = static_cast<std::uint32_t>(__builtin_ctz(lanes));
    const Open child{enter[lane], node.child[lane]};
    std::uint32_t at = size++;
    for (; sorted && at > bottom && stack[at - 1].distance < child.distance; --at) stack[at] = stack[at - 1];
    stack[at] = child;
  }
  return size;
}

/// kAny: any hit will do. `first`: the block to begin with, kNone where there is none; then where it was met.
template <bool kAny>
void TriangleTree::trace(const Ray& ray, std::uint32_t& first, Hit& hit) const {
  if (kAny && first != kNone && meetBlock(blocks_[first], ray, hit)) return;
  Open stack[kStack];
  std::uint32_t size = 0;
  if (!nodes_.empty()) stack[size++] = {0, 0};
  while (size > 0) {
    const Open open = stack[--size];
    if (open.distance > hit.distance) continue;
    if (open.reference & kBlock) {
      const std::uint32_t block = open.reference & ~kBlock;
      if (meetBlock(blocks_[block], ray, hit) && kAny) {
        first = block;
        return;
      }
      continue;
    }
    const Node& node = nodes_[open.reference];
    Float8 enter = all8(0), leave = all8(hit.distance);
    for (int axis = 0; axis < 3; ++axis) {
      const std::uint32_t row = ray.row[axis], other = row < 3 ? row + 3 : row - 3;
      enter = max8((load8(node.bounds[row]) - ray.origin[axis]) * ray.inverse[axis], enter);
      leave = min8((load8(node.bounds[other]) - ray.origin[axis]) * ray.inverse[axis] * kOutwards, leave);
    }
    size = push(bitsOf(enter <= leave), node, enter, !kAny, stack, size);
  }
}

void TriangleTree::intersect(const RayPacket& rays, HitPacket& hits) const {
  std::uint32_t none = kNone;
  for (std::uint32_t i = 0; i < rays.count; ++i) {
    Hit hit{rays.reach[i]};
    trace<false>(Ray(rays, i), none, hit);
    hits.triangle[i] = hit.triangle;
    hits.distance[i] = hit.distance;
  }
}

/// Rays of one packet, and what holds for all of them.
struct TriangleTree::Beam {
  Float8 origin[3], direction[3], reach;  // a ray a lane
  unsigned lanes;                         // that are rays
  float farthest = 0;                     // the longest reach
  /// One axis: whether all rays go up it, down it, or some each; bounds of their origins, inverse directions
  /// and of all that they pass.
  struct Axis {
    bool up, down;
    Float8 nearOrigin, farOrigin, leastInverse, mostInverse, low, high;
  } axes[3];

  explicit Beam(const RayPacket& rays) : lanes((1u << rays.count) - 1) {
    const float* const origins[]{rays.originX, rays.originY, rays.originZ};
    const float* const directions[]{rays.directionX, rays.directionY, rays.directionZ};
    reach = load8(rays.reach);
    for (std::uint32_t i = 0; i < rays.count; ++i) farthest = std::max(farthest, rays.reach[i]);
    for (int axis = 0; axis < 3; ++axis) {
      origin[axis] = load8(origins[axis]);
      direction[axis] = load8(directions[axis]);
      float o[2]{kFar, -kFar}, inverse[2]{kFar, -kFar}, passed[2]{kFar, -kFar};
      const auto include = [](float(&bounds)[2], float value) {
        bounds[0] = std::min(bounds[0], value);
        bounds[1] = std::max(bounds[1], value);
      };
      for (std::uint32_t i = 0; i < rays.count; ++i) {
        const float from = origins[axis][i], along = directions[axis][i];
        include(o, from);
        include(inverse,
                1 / (std::abs(along) < kLeastDirection ? std::copysign(kLeastDirection, along) : along));
        include(passed, from);
        include(passed, from + rays.reach[i] * along);
      }
      const bool up = inverse[0] > 0, down = inverse[1] < 0;
      const float margin = kOutwards - 1;
      axes[axis] = {up,
                    down,
                    all8(down ? o[0] : o[1]),
                    all8(down ? o[1] : o[0]),
                    all8(inverse[0]),
                    all8(inverse[1]),
                    all8(passed[0] - margin * std::abs(passed[0])),
                    all8(passed[1] + margin * std::abs(passed[1]))};
    }
  }

  /// Which of a node's boxes any of the rays may enter.
  unsigned entered(const Node& node) const {
    Float8 enter = all8(0), leave = all8(farthest);
    Mask8 passed = Mask8{} - 1;
    for (int axis = 0; axis < 3; ++axis) {
      const Axis& a = axes[axis];
      const Float8 low = load8(node.bounds[axis]), high = load8(node.bounds[axis + 3]);
      passed &= (low <= a.high) & (high >= a.low);
      if (!a.up && !a.down) continue;
      const Float8 to = (a.up ? low : high) - a.nearOrigin, past = (a.up ? high : low) - a.farOrigin;
      enter = max8(min8(to * a.leastInverse, to * a.mostInverse), enter);
      leave = min8(max8(past * a.leastInverse, past * a.mostInverse) * kOutwards, leave);
    }
    return bitsOf(passed & (enter <= leave));
  }
};

void TriangleTree::traceBeam(const Beam& beam, unsigned& blocked) const {
  Open stack[kStack];
  std::uint32_t size = 0;
  if (!nodes_.empty()) stack[size++] = {0, 0};
  while (size > 0) {
    const std::uint32_t reference = stack[--size].reference;
    if (!(reference & kBlock)) {
      const Node& node = nodes_[reference];
      size = push(beam.entered(node), node, all8(0), false, stack, size);
      continue;
    }
    const Block& block = blocks_[reference & ~kBlock];
    for (std::uint32_t t = 0; t < block.count; ++t) {
      Float8 v[3][3];
      for (int corner = 0; corner < 3; ++corner)
        for (int axis = 0; axis < 3; ++axis)
          v[corner][axis] = all8(block.corner[corner][axis][t]) - beam.origin[axis];
      const Float8 distance = meetings(v, beam.direction);
      blocked |= bitsOf((distance > all8(0)) & (distance <= beam.reach)) & beam.lanes;
      if (blocked == beam.lanes) return;
    }
  }
}

void TriangleTree::occluded(const RayPacket& rays, bool* blocked, bool coherent) const {
  if (coherent) {
    unsigned lanes = 0;
    traceBeam(Beam(rays), lanes);
    for (std::uint32_t i = 0; i < rays.count; ++i) blocked[i] = lanes >> i & 1;
    return;
  }
  // What stopped one ray of a packet most likely stops the next.
  std::uint32_t last = kNone;
  for (std::uint32_t i = 0; i < rays.count; ++i) {
    Hit hit{rays.reach[i]};
    trace<true>(Ray(rays, i), last, hit);
    blocked[i] = hit.triangle != kNone;
  }
}

}  // namespace fiatlux
