// Form factors by ray casting: F ~ U V^T, and F itself through the rays that were cast for U.
// Paper equations (1) and (3), section 2.4.
#pragma once

#include <cstdint>
#include <vector>

#include "core/patches.h"

namespace fiatlux {

/// From every row of a room (n patches, then receivers) `rays` cosine-distributed rays, each with the patch
/// it met. F_pq = share of p's rays that met q. The share of lost rays (back faces, openings) is simply
/// missing from a row.
struct FormFactors {
  std::uint32_t rows = 0;      // patches and receivers
  std::uint32_t count = 0;     // n, columns of F
  std::uint32_t clusters = 0;  // k
  std::uint32_t rays = 0;
  std::vector<std::uint32_t>
      hits;              // rows x rays, row-major; kNone = lost. A row's hits are sorted: equal ids adjacent.
  std::vector<float> u;  // n x k, row-major: U_pc = sum of F_pq over q in cluster c
};

/// out (rows x width) = F b for b (n x width), both row-major: irradiance that arrives from exitances b.
/// Rows [firstRow, lastRow) only, so that callers may share the work among threads.
void gather(const FormFactors& factors, const float* b, std::uint32_t width, std::uint32_t firstRow,
            std::uint32_t lastRow, float* out);

}  // namespace fiatlux
