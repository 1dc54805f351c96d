// Covariances in a file: as correlations in fixed point, or factored as C = L^T L where few rows of L say it
// all (smooth light on a small surface has a low rank).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/scene/scene_file.h"

namespace fiatlux {

/// A section for the symmetric positive semidefinite m x m matrix C (row-major).
/// kPacked, m + m (m + 1) / 2 words: the square roots of the diagonal as floats, then the upper triangle of
/// the correlations C_ij / sqrt(C_ii C_jj) by rows, in units of 2^-20, each as its difference to left + up -
/// corner. kFactored, rank x m floats L, where that is smaller: the residual of every variance is at most
/// `tolerance` of it. The section's error bound e says |x^T C' x - x^T C x| <= e (sum of |x_i| sqrt(C_ii))^2.
PlainSection encodeCovariance(std::string name, std::span<const double> covariance, std::uint32_t m,
                              double tolerance);

/// The full matrix, m x m, row-major, symmetric. "" or what does not fit.
std::string decodeCovariance(const SceneSection& section, std::span<const std::uint8_t> bytes,
                             std::uint32_t m, std::vector<double>& covariance);

}  // namespace fiatlux
