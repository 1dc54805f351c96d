// A triangle is chosen by u, which is then stretched to serve as its first coordinate.
#include "precompute/rays/area_sampler.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace fiatlux {

AreaSampler::AreaSampler(std::span<const Fragment> triangles) {
  for (const Fragment& triangle : triangles) {
    const auto& [a, b, c] = triangle.corner;
    const Vec3 normal = cross(b - a, c - a);
    const double area = 0.5 * length(normal);
    if (!(area > 0)) continue;
    pieces_.push_back({a, b - a, c - a, normalized(normal), area_, area});
    area_ += area;
  }
  for (Piece& piece : pieces_) {
    piece.before /= area_;
    piece.share /= area_;
  }
}

AreaSampler::Point AreaSampler::at(double u, double v) const {
  assert(!empty());
  auto piece = std::upper_bound(pieces_.begin(), pieces_.end(), u, [](double value, const Piece& candidate) {
    return value < candidate.before;
  });
  if (piece != pieces_.begin()) --piece;
  const double root = std::sqrt(std::clamp((u - piece->before) / piece->share, 0.0, 1.0));
  return {piece->corner + (root * (1 - v)) * piece->first + (root * v) * piece->second, piece->normal};
}

}  // namespace fiatlux
