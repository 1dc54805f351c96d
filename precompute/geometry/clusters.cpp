// Blocks of a chart's grid as clusters, and what to do with crumbs when there are too many.
#include "precompute/geometry/clusters.h"

#include <algorithm>
#include <tuple>
#include <vector>

#include "precompute/room/bounds.h"

namespace fiatlux {
namespace {

/// Cluster of each patch for blocks of edge x edge cells; returns their number.
std::uint32_t blockClusters(const Room& room, std::uint32_t edge, std::vector<std::uint32_t>& cluster) {
  cluster.assign(room.patches.count, kNone);
  std::uint32_t k = 0;
  std::vector<std::uint32_t> blocks;
  for (const Chart& chart : room.charts) {
    const std::uint32_t across = (chart.columns + edge - 1) / edge;
    blocks.assign(std::size_t{across} * ((chart.rows + edge - 1) / edge), kNone);
    for (std::uint32_t c = 0; c < chart.patchOfCell.size(); ++c) {
      const std::uint32_t p = chart.patchOfCell[c];
      if (p >= room.patches.count || cluster[p] != kNone) continue;
      std::uint32_t& block = blocks[c / chart.columns / edge * across + c % chart.columns / edge];
      if (block == kNone) block = k++;
      cluster[p] = block;
    }
  }
  return k;
}

/// Joins clusters below half of `full` (m2) with others of their surface and direction that come next on a
/// space-filling curve, until they reach it. Returns the new number of clusters.
std::uint32_t joinSmallClusters(const Room& room, std::uint32_t k, double full,
                                std::vector<std::uint32_t>& cluster) {
  const Patches& patches = room.patches;
  std::vector<double> area(k, 0);
  std::vector<std::uint32_t> sample(k, kNone);
  Bounds bounds;
  for (std::uint32_t p = 0; p < patches.count; ++p) {
    bounds.include(patches.center[p]);
    area[cluster[p]] += patches.area[p];
    if (sample[cluster[p]] == kNone) sample[cluster[p]] = p;
  }
  const double side = std::max(bounds.longestEdge(), 1e-9);
  std::vector<std::tuple<std::uint32_t, int, std::uint32_t, std::uint32_t>>
      small;  // surface, direction, curve, cluster
  std::vector<std::uint32_t> target(k);
  std::uint32_t joined = 0;
  for (std::uint32_t c = 0; c < k; ++c) {
    if (area[c] >= 0.5 * full) {
      target[c] = joined++;
      continue;
    }
    const Vec3 at = (1023 / side) * (patches.center[sample[c]] - bounds.low);
    std::uint32_t curve = 0;
    for (int bit = 9; bit >= 0; --bit)
      for (const double x : {at.x, at.y, at.z})
        curve = curve << 1 | (static_cast<std::uint32_t>(x) >> bit & 1);
    small.emplace_back(patches.surface[sample[c]], dominantDirection(patches.normal[sample[c]]), curve, c);
  }
  std::sort(small.begin(), small.end());
  double sum = 0;
  for (std::size_t i = 0; i < small.size(); ++i) {
    const auto kind = [&](std::size_t j) { return std::pair(std::get<0>(small[j]), std::get<1>(small[j])); };
    const std::uint32_t c = std::get<3>(small[i]);
    target[c] = joined;
    sum += area[c];
    if (i + 1 == small.size() || sum >= 0.5 * full || kind(i + 1) != kind(i)) ++joined, sum = 0;
  }
  for (std::uint32_t& c : cluster) c = target[c];
  return joined;
}

}  // namespace

std::uint32_t assignClusters(Room& room, std::uint32_t edge, std::uint32_t most, bool exact) {
  edge = std::max(edge, 1u);
  std::uint32_t& k = room.patches.clusterCount;
  k = blockClusters(room, edge, room.patches.cluster);
  while (!exact && k > most) {
    const double side = edge * room.patchSize;
    k = joinSmallClusters(room, k, side * side, room.patches.cluster);
    if (k <= most || edge >= 256) break;
    ++edge;
    k = blockClusters(room, edge, room.patches.cluster);
  }
  return edge;
}

}  // namespace fiatlux
