#include "core/transport/tile_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/transport/patch_tiles.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kLeaf = 4;
constexpr std::uint32_t kStack = 128;   // halving 2^32 tiles leaves 64 on it
constexpr double kTouching = 2e-3;      // m
constexpr double kNoDirection = 1e-18;  // of a direction's part, so that its inverse is finite
constexpr double kThick = 1e-6;         // m, by which boxes are larger

double along(const Vec3& v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

Vec3 least(const Vec3& a, const Vec3& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}

Vec3 most(const Vec3& a, const Vec3& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

double inverseOf(double part) {
  return 1 / (std::abs(part) < kNoDirection ? std::copysign(kNoDirection, part) : part);
}

}  // namespace

TileTree::TileTree(const Scene& scene) {
  const Patches& patches = scene.patches;
  const std::vector<PatchTile> shapes = patchTiles(patches, scene.lightOperator->charts);
  for (std::uint32_t p = 0; p < patches.count; ++p) {
    const PatchTile& shape = shapes[p];
    const Vec3 u = 0.5 * shape.edgeU, v = 0.5 * shape.edgeV;
    tiles_.push_back(
        {patches.center[p], normalized(cross(u, v)), (1 / dot(u, u)) * u, (1 / dot(v, v)) * v, p});
    const Vec3 half{std::abs(u.x) + std::abs(v.x) + kThick, std::abs(u.y) + std::abs(v.y) + kThick,
                    std::abs(u.z) + std::abs(v.z) + kThick};
    bounds_.push_back({patches.center[p] - half, patches.center[p] + half});
  }
  if (tiles_.empty()) return;
  nodes_.push_back({boxOf(0, patches.count), 0, patches.count});
  split(0);
}

TileTree::Box TileTree::boxOf(std::uint32_t first, std::uint32_t count) const {
  Box box = bounds_[first];
  for (std::uint32_t i = first; i < first + count; ++i) {
    box.low = least(box.low, bounds_[i].low);
    box.high = most(box.high, bounds_[i].high);
  }
  return box;
}

/// In halves along the longest side, down to the leaves.
void TileTree::split(std::uint32_t node) {
  const auto [box, first, count] = nodes_[node];
  if (count <= kLeaf) return;
  const Vec3 size = box.high - box.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), first);
  // note: no two are equal, so the order is the same with every library.
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const double x = along(tiles_[a].center, axis), y = along(tiles_[b].center, axis);
    return x != y ? x < y : tiles_[a].patch < tiles_[b].patch;
  });
  std::vector<Tile> tiles;
  std::vector<Box> bounds;
  for (const std::uint32_t i : order) {
    tiles.push_back(tiles_[i]);
    bounds.push_back(bounds_[i]);
  }
  std::copy(tiles.begin(), tiles.end(), tiles_.begin() + first);
  std::copy(bounds.begin(), bounds.end(), bounds_.begin() + first);
  const auto child = static_cast<std::uint32_t>(nodes_.size());
  const std::uint32_t half = count / 2;
  nodes_.push_back({boxOf(first, half), first, half});
  nodes_.push_back({boxOf(first + half, count - half), first + half, count - half});
  nodes_[node].first = child;
  nodes_[node].count = 0;
  split(child);
  split(child + 1);
}

bool TileTree::Box::isMet(const Vec3& origin, const Vec3& inverse, double reach) const {
  double enter = 0, leave = reach;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (along(low, axis) - along(origin, axis)) * along(inverse, axis),
                 b = (along(high, axis) - along(origin, axis)) * along(inverse, axis);
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter <= leave;
}

void TileTree::meet(const Tile& tile, const Vec3& origin, const Vec3& direction, Meeting& meeting) const {
  const double slope = dot(direction, tile.normal);
  if (slope == 0) return;
  const double distance = dot(tile.center - origin, tile.normal) / slope;
  if (!(distance > 0) || distance > meeting.reach) return;
  const Vec3 on = origin + distance * direction - tile.center;
  if (std::abs(dot(on, tile.u)) > 1 || std::abs(dot(on, tile.v)) > 1) return;
  if (distance < meeting.reach || tile.patch < meeting.patch) meeting = {distance, tile.patch};
}

TileTree::Meeting TileTree::trace(const Vec3& origin, const Vec3& direction, double reach) const {
  const Vec3 inverse{inverseOf(direction.x), inverseOf(direction.y), inverseOf(direction.z)};
  Meeting meeting{reach};
  std::uint32_t stack[kStack], size = 0;
  if (!nodes_.empty()) stack[size++] = 0;
  while (size > 0) {
    const Node& node = nodes_[stack[--size]];
    if (!node.box.isMet(origin, inverse, meeting.reach)) continue;
    if (node.count == 0) {
      stack[size++] = node.first;
      stack[size++] = node.first + 1;
      continue;
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
      meet(tiles_[i], origin, direction, meeting);
  }
  return meeting;
}

std::uint32_t TileTree::firstMet(const Vec3& origin, const Vec3& direction, double reach) const {
  return trace(origin, direction, reach).patch;
}

bool TileTree::isBlocked(const Vec3& from, const Vec3& to) const {
  const Vec3 way = to - from;
  const double distance = length(way);
  if (distance <= 2 * kTouching) return false;
  const Vec3 unit = (1 / distance) * way;
  return trace(from + kTouching * unit, unit, distance - 2 * kTouching).patch != kNone;
}

}  // namespace fiatlux
