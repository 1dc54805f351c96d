#include "precompute/light/exchange_groups.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <tuple>
#include <vector>

#include "precompute/room/bounds.h"
#include "precompute/room/direction.h"
#include "precompute/room/disjoint_sets.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kBlockEdge = 4;   // cells on a block's edge
constexpr std::uint32_t kLongest = 6;     // of a block on a narrow chart
constexpr std::uint32_t kFewPatches = 6;  // charts below that join others
constexpr double kLift = 0.05;  // of a patch: so high above a surface something stands between cells

/// How many cells of `count` one block takes, so that blocks are even; the other side has `across` cells.
std::uint32_t blocksAlong(std::uint32_t count, std::uint32_t across, std::uint32_t edge) {
  const std::uint32_t longest =
      across >= edge ? edge : std::min(edge * edge / across, edge * kLongest / kBlockEdge);
  return std::max(1u, (count + longest / 2) / longest);
}

std::uint32_t patchesOf(const Chart& chart) {
  return static_cast<std::uint32_t>(
      std::count_if(chart.patchOfCell.begin(), chart.patchOfCell.end(), [](auto p) { return p != kNone; }));
}

/// How much farther a patch spreads along u than along v, in parts of its cell's edges; of a cell's whole, 1.
double aspectOf(std::span<const Fragment> fragments, const Charts::Frame& frame) {
  // Sums of area, and of place and its square along u and v, over triangles.
  double area = 0, first[2] = {}, second[2] = {};
  for (const Fragment& fragment : fragments) {
    const auto& corner = fragment.corner;
    const double twice = length(cross(corner[1] - corner[0], corner[2] - corner[0]));
    area += twice;
    for (const int axis : {0, 1}) {
      double sum = 0, squares = 0;
      for (const Vec3& place : corner) {
        const double at = axis == 0 ? dot(place - fragments[0].corner[0], frame.uAxis) / frame.cellU
                                    : dot(place - fragments[0].corner[0], frame.vAxis) / frame.cellV;
        sum += at, squares += at * at;
      }
      first[axis] += twice * sum / 3;
      second[axis] += twice * (sum * sum + squares) / 12;
    }
  }
  if (!(area > 0)) return 1;
  const auto spread = [&](int axis) { return second[axis] / area - std::pow(first[axis] / area, 2); };
  constexpr double kThin = 1e-6;  // of a cell's edge, squared
  return std::sqrt(std::max(spread(0), kThin) / std::max(spread(1), kThin));
}

/// Rows of one kind (patches or receivers) into groups from `next` on; the new end.
class Grouping {
 public:
  Grouping(const Room& room, std::uint32_t edge, std::vector<std::uint32_t>& group)
      : room_(room), edge_(edge), group_(group) {
    for (const Vec3& center : room.patches.center) bounds_.include(center);
  }

  std::uint32_t assign(bool receivers, std::uint32_t next) {
    std::vector<std::uint32_t> crumbs;
    for (const Chart& chart : room_.charts) {
      if (room_.surfaces[chart.surface].measuring != receivers) continue;
      if (patchesOf(chart) < kFewPatches) {
        for (const std::uint32_t p : chart.patchOfCell)
          if (p != kNone && group_[p] == kNone) group_[p] = 0, crumbs.push_back(p);
      } else {
        next = addBlocks(chart, next);
      }
    }
    return joinCrumbs(crumbs, next);
  }

 private:
  std::uint32_t addBlocks(const Chart& chart, std::uint32_t next) {
    const std::uint32_t across = blocksAlong(chart.columns, chart.rows, edge_);
    const std::uint32_t down = blocksAlong(chart.rows, chart.columns, edge_);
    std::vector<std::uint32_t> blocks(std::size_t{across} * down, kNone);
    for (std::uint32_t cell = 0; cell < chart.patchOfCell.size(); ++cell) {
      const std::uint32_t p = chart.patchOfCell[cell];
      if (p == kNone || group_[p] != kNone) continue;
      const std::uint32_t r = cell / chart.columns * down / chart.rows,
                          c = cell % chart.columns * across / chart.columns;
      std::uint32_t& block = blocks[r * across + c];
      if (block == kNone) block = next++;
      group_[p] = block;
    }
    return next;
  }

  /// Neighbours on a space-filling curve, of one surface and direction, as many as a block has.
  std::uint32_t joinCrumbs(const std::vector<std::uint32_t>& crumbs, std::uint32_t next) {
    using Place = std::tuple<std::uint32_t, int, std::uint64_t, std::uint32_t>;
    std::vector<Place> places;
    for (const std::uint32_t p : crumbs)
      places.emplace_back(room_.patches.surface[p], dominantDirection(room_.patches.normal[p]), curveAt(p),
                          p);
    std::sort(places.begin(), places.end());
    const double full = edge_ * edge_ * room_.patchSize * room_.patchSize;
    const double reach = 1.5 * edge_ * room_.patchSize;
    double area = 0;
    Vec3 start;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto& [surface, direction, curve, p] = places[i];
      const bool alike =
          i > 0 && std::get<0>(places[i - 1]) == surface && std::get<1>(places[i - 1]) == direction;
      if (!alike || area + room_.patches.area[p] > full || length(room_.patches.center[p] - start) > reach) {
        ++next, area = 0;
        start = room_.patches.center[p];
      }
      group_[p] = next - 1;
      area += room_.patches.area[p];
    }
    return next;
  }

  std::uint64_t curveAt(std::uint32_t p) const {
    const Vec3 at = (1023 / std::max(bounds_.longestEdge(), 1e-9)) * (room_.patches.center[p] - bounds_.low);
    std::uint64_t curve = 0;
    for (int bit = 9; bit >= 0; --bit)
      for (const double x : {at.x, at.y, at.z})
        curve = curve << 1 | (static_cast<std::uint32_t>(x) >> bit & 1);
    return curve;
  }

  const Room& room_;
  std::uint32_t edge_;
  std::vector<std::uint32_t>& group_;
  Bounds bounds_;
};

/// Whether something stands between each row and its left or upper neighbour.
std::vector<std::uint8_t> barriersOf(const Room& room, const RayTracer& tracer) {
  const Patches& patches = room.patches;
  std::vector<std::uint8_t> barriers(patches.rows(), 0);
  const double lift = std::max(kLift * room.patchSize, 2 * tracer.offset());
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    const std::uint32_t beside[2] = {patches.left[p], patches.up[p]};
    for (int side = 0; side < 2; ++side) {
      const std::uint32_t q = beside[side];
      if (q == kNone) continue;
      const Vec3 from = patches.center[p] + lift * patches.normal[p],
                 to = patches.center[q] + lift * patches.normal[q];
      if (tracer.isBlocked(from, to))
        barriers[p] |= side == 0 ? ExchangeGroups::kLeftBarrier : ExchangeGroups::kUpBarrier;
    }
  }
  return barriers;
}

/// Whether rows of several charts make up each group.
std::vector<char> joinedOf(const Room& room, const ExchangeGroups& groups) {
  std::vector<std::uint32_t> chart(groups.total, kNone);
  std::vector<char> joined(groups.total, 0);
  for (std::uint32_t p = 0; p < room.patches.rows(); ++p) {
    std::uint32_t& first = chart[groups.ofRow[p]];
    if (first == kNone) first = room.chartOfPatch[p];
    if (first != room.chartOfPatch[p]) joined[groups.ofRow[p]] = 1;
  }
  return joined;
}

/// Splits groups into what hangs together without crossing a barrier, but for joined crumbs, which hang
/// together by being near: one barrier among a hundred leaves would make a hundred groups.
void splitAtBarriers(const Room& room, ExchangeGroups& groups) {
  const Patches& patches = room.patches;
  DisjointSets sets(patches.rows());
  const std::vector<char> joined = joinedOf(room, groups);
  std::vector<char> cut(groups.total, 0);
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    const auto side = [&](std::uint32_t q, std::uint8_t barrier) {
      if (q == kNone || groups.ofRow[p] != groups.ofRow[q] || joined[groups.ofRow[p]]) return;
      if (groups.barriers[p] & barrier)
        cut[groups.ofRow[p]] = 1;
      else
        sets.join(p, q);
    };
    side(patches.left[p], ExchangeGroups::kLeftBarrier);
    side(patches.up[p], ExchangeGroups::kUpBarrier);
  }
  // Groups that no barrier crosses stay whole, whatever their shape.
  std::vector<std::uint32_t> first(groups.total, kNone);
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    const std::uint32_t c = groups.ofRow[p];
    if (cut[c]) continue;
    if (first[c] == kNone) first[c] = p;
    sets.join(first[c], p);
  }
  // Numbered in the order of the old groups, so that neighbours stay neighbours.
  std::vector<std::uint32_t> order(patches.rows());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return groups.ofRow[a] < groups.ofRow[b]; });
  std::vector<std::uint32_t> number(patches.rows(), kNone);
  std::uint32_t next = 0;
  for (const std::uint32_t p : order) {
    std::uint32_t& label = number[sets.find(p)];
    if (label == kNone) label = next++;
    groups.ofRow[p] = label;
    if (p < patches.count) groups.count = next;
  }
  groups.total = next;
}

}  // namespace

Charts chartsOf(const Room& room) {
  Charts charts;
  for (const Chart& chart : room.charts)
    charts.frames.push_back({chart.uAxis, chart.vAxis, chart.cellU, chart.cellV});
  charts.ofRow = room.chartOfPatch;
  for (std::uint32_t p = 0; p < room.patches.rows(); ++p)
    charts.aspect.push_back(
        Charts::aspectStepOf(aspectOf(room.fragmentsOf(p), charts.frames[charts.ofRow[p]])));
  return charts;
}

ExchangeGroups exchangeGroups(const Room& room, const RayTracer& tracer) {
  ExchangeGroups groups;
  groups.barriers = barriersOf(room, tracer);
  for (std::uint32_t edge = kBlockEdge;; ++edge) {
    groups.ofRow.assign(room.patches.rows(), kNone);
    Grouping grouping(room, edge, groups.ofRow);
    groups.count = grouping.assign(false, 0);
    groups.total = grouping.assign(true, groups.count);
    splitAtBarriers(room, groups);
    if (groups.total <= kMostGroups || edge >= 64) return groups;
  }
}

}  // namespace fiatlux
