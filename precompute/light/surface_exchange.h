// Means over surfaces of reflected light (core/scene/light_operator.h): one adjoint solution a surface. With
// a = share of each row in its surface's area,
//   M = A^-1 F^T (I - R F^T)^-1 a,  w = (I - R F^T)^-1 a = a + R F^T w,
// begun with the low-rank answer, as F is reciprocal but for noise, and then repeated.
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/light_operator.h"
#include "core/transport/form_factors.h"
#include "core/transport/low_rank_radiosity.h"
#include "precompute/room/room.h"

namespace fiatlux {

/// All arguments must outlive it.
class SurfaceExchangeRows {
 public:
  SurfaceExchangeRows(const Room& room, const FormFactors& factors, const LowRankRadiosity& lowRank);
  std::uint32_t blocks() const;
  std::uint32_t used(std::uint32_t block) const;
  /// Of surfaces [first, first + used) with first = block x kColumnBlock: patches x used, row-major, 1/m2.
  std::vector<float> solve(std::uint32_t block) const;

 private:
  std::vector<float> weightsOf(std::uint32_t block) const;
  std::vector<float> begin(const std::vector<float>& weights) const;

  const Room& room_;
  const FormFactors& factors_;
  const LowRankRadiosity& lowRank_;
  std::vector<double> area_;  // m2, of what counts of each surface
};

/// All blocks, as a file will hold them.
SurfaceExchange surfaceExchangeOf(const Room& room, const std::vector<std::vector<float>>& blocks);

}  // namespace fiatlux
