// Covariances in a file: packed, or factored as C = L^T L where few rows of L say it all (smooth light on a
// small surface has a low rank).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/scene_file.h"

namespace fiatlux {

/// A section for the symmetric positive semidefinite m x m matrix C (row-major): kFactored (rank x m floats)
/// where that is smaller than kPacked (m (m + 1) / 2 x 1 floats, upper triangle by rows). The section's error
/// bound e says |x^T C' x - x^T C x| <= e (sum of |x_i| sqrt(C_ii))^2; `tolerance` is what the factorisation
/// may leave of it.
PlainSection encodeCovariance(std::string name, std::span<const double> covariance, std::uint32_t m,
                              double tolerance);

/// The full matrix, m x m, row-major, symmetric. "" or what does not fit.
std::string decodeCovariance(const SceneSection& section, std::span<const std::uint8_t> bytes,
                             std::uint32_t m, std::vector<double>& covariance);

}  // namespace fiatlux
