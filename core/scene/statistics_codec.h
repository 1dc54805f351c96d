// Statistics of a surface in a file, as what they differ from those of the stored responses by.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace fiatlux {

/// Fine enough that sigma holds to 1e-4 where the spread of six luminaires together is a tenth of what each
/// has.
inline constexpr double kCorrelationUnit = 0x1p-18;

/// The error bound e of what is decoded: |x^T C' x - x^T C x| <= e (sum of |x_i| sqrt(C_ii))^2. Means and
/// standard deviations are those of the encoder to the precision of a float.
float statisticsErrorBound();

/// Where the statistics are expected to be those of the stored responses: corrected as those of another
/// quantity on the same surface were, times `factor` (the reflectance; covariances times its square).
SurfaceStatistics expectedStatistics(SurfaceStatistics stored, const SurfaceStatistics& otherStored,
                                     const SurfaceStatistics& otherTrue, double factor);

/// m means, m standard deviations, then the upper triangle of the correlations in units of
/// kCorrelationUnit, each as its difference to what is expected. Needs finite values, means >= 0; they become
/// what the decoder will yield.
std::vector<std::uint8_t> encodeStatistics(SurfaceStatistics& statistics, const SurfaceStatistics& expected);

/// The inverse. "" or what does not fit: means are in 0..`brightest`.
std::string decodeStatistics(std::span<const std::uint8_t> bytes, const SurfaceStatistics& expected,
                             double brightest, SurfaceStatistics& statistics);

}  // namespace fiatlux
