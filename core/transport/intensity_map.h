// A luminaire's intensities on a square grid (octahedral map: the sphere folded flat, the half about gamma 0
// inside the diamond |u| + |v| <= 1): a look-up without angles, for millions of directions.
#pragma once

#include <cstddef>
#include <vector>

#include "core/scene/luminaire.h"

namespace fiatlux {

class IntensityMap {
 public:
  /// Sampled at the crossings of kEdge x kEdge cells, a third of a degree apart. `mirrored`: it is the same
  /// on both sides of C0-C180 and of C90-C270, and a quarter is sampled.
  explicit IntensityMap(const Intensity& intensity, bool mirrored = false);

  /// cd along a unit direction in the luminaire's axes; linear within a cell.
  double at(const Vec3& direction) const;
  /// The same in float, of `count` directions by their x, y and z.
  void look(const float* x, const float* y, const float* z, int count, float* candela) const;
  /// lm into all directions whose product with the unit `before`, in the luminaire's axes, is positive.
  double flux(const Vec3& before) const;

 private:
  double sum(int stride, const Vec3* behind) const;
  static constexpr int kEdge = 384;
  static std::size_t index(int row, int column) {
    return static_cast<std::size_t>(row * (kEdge + 1) + column);
  }
  std::vector<float> candela_;  // (kEdge + 1)^2
  double all_ = 0;              // lm into all directions
};

}  // namespace fiatlux
