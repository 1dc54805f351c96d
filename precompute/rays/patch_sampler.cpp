// Full cells are squares; any other patch is its fragments, chosen by area.
#include "precompute/rays/patch_sampler.h"

#include <cassert>
#include <cmath>

namespace fiatlux {

PatchSampler::PatchSampler(const Room& room, std::uint32_t patch)
    : fragments_(room.fragmentsOf(patch)),
      center_{room.patches.center[patch], room.patches.normal[patch], 0} {
  // Recognise a full cell: flat, in the chart's plane, and as large as the cell.
  const Chart& chart = room.charts[room.chartOfPatch[patch]];
  const double area = fragments_.area();
  fullCell_ = !fragments_.empty() && std::abs(area - chart.cellU * chart.cellV) <= 1e-6 * area;
  for (const AreaSampler::Piece& piece : fragments_.pieces())
    fullCell_ = fullCell_ && dot(piece.normal, chart.normal) > 1 - 1e-10;
  if (fullCell_) {
    cellU_ = chart.cellU * chart.uAxis;
    cellV_ = chart.cellV * chart.vAxis;
    cellNormal_ = fragments_.pieces()[0].normal;
    cellCorner_ = room.patches.center[patch] - 0.5 * (cellU_ + cellV_);
  }
}

PatchPoint PatchSampler::onFragments(double u, double v) const {
  if (fragments_.empty()) return center_;
  const auto [position, normal] = fragments_.at(u, v);
  return {position, normal, 0};
}

std::vector<PatchPoint> PatchSampler::quadrature(std::uint32_t edge) const {
  assert(edge >= 1);
  // Gauss-Legendre nodes and weights on [0, 1].
  static constexpr double kNode4a = 0.06943184420297371, kNode4b = 0.33000947820757187;
  static constexpr double kWeight4a = 0.17392742256872692, kWeight4b = 0.32607257743127307;
  std::vector<double> node(edge), weight(edge, 1.0 / edge);
  for (std::uint32_t i = 0; i < edge; ++i) node[i] = (i + 0.5) / edge;
  if (fullCell_ && edge == 2) node = {kGaussNode, 1 - kGaussNode};
  if (fullCell_ && edge == 4) {
    node = {kNode4a, kNode4b, 1 - kNode4b, 1 - kNode4a};
    weight = {kWeight4a, kWeight4b, kWeight4b, kWeight4a};
  }
  std::vector<PatchPoint> points;
  for (std::uint32_t i = 0; i < edge; ++i) {
    for (std::uint32_t j = 0; j < edge; ++j) {
      points.push_back(at(node[i], node[j]));
      points.back().weight = weight[i] * weight[j];
    }
  }
  return points;
}

}  // namespace fiatlux
