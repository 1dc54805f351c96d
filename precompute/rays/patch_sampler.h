// Points on one patch, for rays and for quadrature.
#pragma once

#include <cstdint>
#include <vector>

#include "precompute/rays/area_sampler.h"
#include "precompute/room/room.h"

namespace fiatlux {

/// The first of Gauss-Legendre's two nodes on [0, 1]; the other is as far from 1. Both weigh the same.
inline constexpr double kGaussNode = 0.21132486540518713;

/// A point on a patch with the geometric unit normal there; weight: its share of the patch's area.
struct PatchPoint {
  Vec3 position, normal;
  double weight = 0;
};

/// Prepared once per patch, so that a point costs little however many fragments the patch has.
class PatchSampler {
 public:
  PatchSampler(const Room& room, std::uint32_t patch);

  /// Uniform by area for (u, v) in [0, 1)^2; on a full cell of a flat chart the map is the identity of the
  /// square, so stratified (u, v) give stratified points.
  PatchPoint at(double u, double v) const {
    if (fullCell_) return {cellCorner_ + u * cellU_ + v * cellV_, cellNormal_, 0};
    return onFragments(u, v);
  }

  /// Whether it is a whole cell: then quadrature(2) is Gauss's.
  bool isFullCell() const { return fullCell_; }
  /// Its triangles that have area.
  const AreaSampler& fragments() const { return fragments_; }

  /// edge x edge points whose weights sum to 1: of Gauss-Legendre on full cells where edge is 2 or 4, of
  /// equal strata elsewhere.
  std::vector<PatchPoint> quadrature(std::uint32_t edge) const;

 private:
  PatchPoint onFragments(double u, double v) const;

  bool fullCell_ = false;
  Vec3 cellCorner_, cellU_, cellV_;  // m, of a full cell
  Vec3 cellNormal_;                  // unit
  AreaSampler fragments_;
  PatchPoint center_;  // stands for a patch too thin to have area in its fragments
};

}  // namespace fiatlux
