// Full cells are squares; any other patch is its fragments, chosen by area.
#include "precompute/patch_sampler.h"

#include <algorithm>
#include <cmath>

namespace fiatlux {

PatchSampler::PatchSampler(const Room& room, std::uint32_t patch) {
  double total = 0;
  for (std::uint32_t f = room.fragmentOffset[patch]; f < room.fragmentOffset[patch + 1]; ++f) {
    const auto& [a, b, c] = room.fragments[f].corner;
    const Vec3 normal = cross(b - a, c - a);
    const double area = 0.5 * length(normal);
    if (!(area > 0)) continue;
    pieces_.push_back({a, b - a, c - a, normalized(normal), total, area});
    total += area;
  }
  for (Piece& piece : pieces_) {
    piece.before /= total;
    piece.share /= total;
  }
  if (pieces_.empty()) {  // a patch too thin to have area in its fragments: its centre stands for it
    pieces_.push_back({room.patches.center[patch], {}, {}, room.patches.normal[patch], 0, 1});
  }

  // Recognise a full cell: flat, in the chart's plane, and as large as the cell.
  const Chart& chart = room.charts[room.chartOfPatch[patch]];
  fullCell_ = std::abs(total - chart.cellU * chart.cellV) <= 1e-6 * total;
  for (const Piece& piece : pieces_) fullCell_ = fullCell_ && dot(piece.normal, chart.normal) > 1 - 1e-10;
  if (fullCell_) {
    cellU_ = chart.cellU * chart.uAxis;
    cellV_ = chart.cellV * chart.vAxis;
    cellCorner_ = room.patches.center[patch] - 0.5 * (cellU_ + cellV_);
  }
}

PatchPoint PatchSampler::at(double u, double v) const {
  if (fullCell_) return {cellCorner_ + u * cellU_ + v * cellV_, pieces_[0].normal, 0};
  auto piece = std::upper_bound(pieces_.begin(), pieces_.end(), u, [](double value, const Piece& candidate) {
    return value < candidate.before;
  });
  if (piece != pieces_.begin()) --piece;
  const double root = std::sqrt(std::clamp((u - piece->before) / piece->share, 0.0, 1.0));
  return {piece->corner + (root * (1 - v)) * piece->first + (root * v) * piece->second, piece->normal, 0};
}

std::vector<PatchPoint> PatchSampler::quadrature(std::uint32_t edge) const {
  // Gauss-Legendre nodes and weights on [0, 1].
  static constexpr double kNode2 = 0.21132486540518713, kNode4a = 0.06943184420297371,
                          kNode4b = 0.33000947820757187;
  static constexpr double kWeight4a = 0.17392742256872692, kWeight4b = 0.32607257743127307;
  std::vector<double> node(edge), weight(edge, 1.0 / edge);
  for (std::uint32_t i = 0; i < edge; ++i) node[i] = (i + 0.5) / edge;
  if (fullCell_ && edge == 2) node = {kNode2, 1 - kNode2};
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
