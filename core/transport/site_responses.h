// Light of every patch for sources given by their direct light D, all interreflections included:
//   b = (I - Y V^T) e, e = rho D;   refined by steps along d = (I - Y V^T)(e - (I - R F) b), each made
//   conjugate to those before it and as long as leaves least unsettled;   g = D + F b.
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/patches.h"
#include "core/transport/form_factors.h"
#include "core/transport/low_rank_radiosity.h"

namespace fiatlux {

/// Sources solved together: the form factors, larger than any cache, are read once for them all.
inline constexpr std::uint32_t kBlockWidth = 32;

/// Columns that so many sources are made up to with zeros, for which products of a known width are kept.
inline std::uint32_t paddedSources(std::uint32_t sources) {
  return sources <= 8 ? 8 : sources <= 16 ? 16 : kBlockWidth;
}

/// One block of sources, `width` columns (those of paddedSources() are the fastest). All matrices row-major.
struct ResponseBlock {
  std::uint32_t width = 0;
  std::vector<float> direct;  // in: rows x width, lx
  std::vector<float>
      emission;  // in, may be empty: n x width, lm/m2 that patches themselves emit (furnace tests)
  std::vector<float> radiosity;   // out: n x width, lm/m2: reflected light and emission
  std::vector<float> irradiance;  // out: rows x width, lx: direct light and everything reflected
  std::vector<double> residuals;  // out: (refinement steps + 1) x width: |e - (I - R F) b| / |e|, weighted by
                                  // area, before each step and after the last; 0 for a dark column
};

/// Solves the block with `refine` refinement steps, or fewer where every residual is below `tolerance`
/// already. Residuals never grow. A step costs one gather F d, and the memory of five blocks until the end.
void solveResponses(const FormFactors& factors, const Patches& patches, const LowRankRadiosity& lowRank,
                    std::uint32_t refine, double tolerance, ResponseBlock& block);

}  // namespace fiatlux
