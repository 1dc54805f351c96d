// Bilinear weights in charts, joined across smooth edges.
#include "precompute/picture/patch_blend.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace fiatlux {
namespace {

constexpr double kSmooth = 0.866;  // cos 30 degrees

using Shares = std::vector<std::pair<std::uint32_t, double>>;

void addShare(Shares& shares, std::uint32_t patch, double share) {
  for (auto& entry : shares)
    if (entry.first == patch) return void(entry.second += share);
  shares.emplace_back(patch, share);
}

/// The mean of what is covered says nothing of a place beside it: it counts where there is nothing else.
void leaveOutCovered(const Patches& patches, Shares& shares) {
  const auto counts = [&](const auto& entry) { return patches.counts(entry.first); };
  if (std::any_of(shares.begin(), shares.end(), counts)) std::erase_if(shares, std::not_fn(counts));
}

void addChart(const Patches& patches, const Chart& chart, const Vec3& point, double factor, Shares& shares) {
  const Vec3 local = point - chart.origin;
  const double x = dot(local, chart.uAxis) / chart.cellU - 0.5,
               y = dot(local, chart.vAxis) / chart.cellV - 0.5;
  // note: corners of cells are met within rounding, and must give equal quarters
  const auto split = [](double at) {
    const double low = std::floor(at), fraction = std::round((at - low) * 4096) / 4096;
    return std::pair{static_cast<std::int64_t>(low), fraction};
  };
  const auto [column, fx] = split(x);
  const auto [row, fy] = split(y);
  Shares own;
  // note: by columns, so that a vertex repeats what its neighbour said, which compresses well
  for (int dc = 0; dc < 2; ++dc)
    for (int dr = 0; dr < 2; ++dr) {
      const std::int64_t r = row + dr, c = column + dc;
      if (r < 0 || c < 0 || r >= chart.rows || c >= chart.columns) continue;
      const std::uint32_t patch = chart.patchOfCell[r * chart.columns + c];
      const double share = (dr ? fy : 1 - fy) * (dc ? fx : 1 - fx);
      if (patch == kNone || share <= 0) continue;
      addShare(own, patch, share);
    }
  leaveOutCovered(patches, own);
  double sum = 0;
  for (const auto& entry : own) sum += entry.second;
  for (const auto& entry : own) addShare(shares, entry.first, factor * entry.second / sum);
}

/// The four largest shares in their order, rounded so that they sum to 255.
PatchBlend rounded(Shares shares) {
  while (shares.size() > 4)
    shares.erase(std::min_element(shares.begin(), shares.end(),
                                  [](const auto& a, const auto& b) { return a.second < b.second; }));
  double sum = 0;
  for (const auto& entry : shares) sum += entry.second;
  PatchBlend blend;
  int left = 255;
  std::size_t largest = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const bool used = i < shares.size();
    blend.patch[i] = used ? shares[i].first : blend.patch[i ? i - 1 : 0];
    blend.share[i] = static_cast<std::uint8_t>(used ? std::lround(255 * shares[i].second / sum) : 0);
    left -= blend.share[i];
    if (blend.share[i] > blend.share[largest]) largest = i;
  }
  blend.share[largest] = static_cast<std::uint8_t>(blend.share[largest] + left);
  return blend;
}

}  // namespace

PatchBlender::PatchBlender(const Room& room) : room_(room) {
  // Find vertices that faces of several charts of one surface meet at.
  std::vector<std::uint32_t> firstChart(2 * room.positions.size(), kNone);
  std::vector<bool> several(room.positions.size(), false);
  const auto eachFace = [&](auto visit) {
    for (const RoomTriangle& triangle : room.triangles) {
      const Vec3 normal =
          normalized(cross(room.positions[triangle.vertex[1]] - room.positions[triangle.vertex[0]],
                           room.positions[triangle.vertex[2]] - room.positions[triangle.vertex[0]]));
      if (triangle.chart != kNone) visit(triangle, triangle.chart, normal, 0);
      if (triangle.backChart != kNone) visit(triangle, triangle.backChart, -normal, 1);
    }
  };
  eachFace([&](const RoomTriangle& triangle, std::uint32_t chart, const Vec3&, int side) {
    for (const std::uint32_t v : triangle.vertex) {
      std::uint32_t& first = firstChart[2 * v + side];
      if (first == kNone) first = chart;
      if (first != chart) several[v] = true;
    }
  });
  eachFace([&](const RoomTriangle& triangle, std::uint32_t chart, const Vec3& normal, int) {
    for (const std::uint32_t v : triangle.vertex)
      if (several[v] && shared_[v].size() < 32) shared_[v].push_back({chart, normal});
  });
}

PatchBlend PatchBlender::inChart(std::uint32_t chart, const Vec3& point) const {
  Shares shares;
  addChart(room_.patches, room_.charts[chart], point, 1, shares);
  if (shares.empty()) {  // outside all cells by more than rounding: the nearest cell answers
    const Chart& c = room_.charts[chart];
    for (const std::uint32_t patch : c.patchOfCell)
      if (patch != kNone) return rounded({{patch, 1.0}});
  }
  return rounded(shares);
}

PatchBlend PatchBlender::atVertex(std::uint32_t v, std::uint32_t chart, const Vec3& normal) const {
  const auto found = shared_.find(v);
  if (found == shared_.end()) return inChart(chart, room_.positions[v]);
  std::vector<std::uint32_t> charts{chart};
  for (const Corner& corner : found->second)
    if (room_.charts[corner.chart].surface == room_.charts[chart].surface &&
        dot(corner.normal, normal) > kSmooth &&
        std::find(charts.begin(), charts.end(), corner.chart) == charts.end())
      charts.push_back(corner.chart);
  std::sort(charts.begin(), charts.end());
  Shares shares;
  for (const std::uint32_t c : charts)
    addChart(room_.patches, room_.charts[c], room_.positions[v], 1.0 / static_cast<double>(charts.size()),
             shares);
  return shares.empty() ? inChart(chart, room_.positions[v]) : rounded(shares);
}

}  // namespace fiatlux
