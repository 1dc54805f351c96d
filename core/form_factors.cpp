// F b by the rays themselves: row p collects the exitance of the patch that each of its rays met.
#include "core/form_factors.h"

#include <algorithm>

namespace fiatlux {

namespace {

/// One row of F b for `width` columns known at compile time, so that the sums stay in registers.
template <std::uint32_t kWidth>
void gatherRow(const std::uint32_t* hits, std::uint32_t rays, const float* b, float* out) {
  float sums[kWidth] = {};
  for (std::uint32_t i = 0; i < rays && hits[i] != kNone; ++i) {
    const float* source = b + std::size_t{hits[i]} * kWidth;
    for (std::uint32_t j = 0; j < kWidth; ++j) sums[j] += source[j];
  }
  const float share = 1.0f / static_cast<float>(rays);
  for (std::uint32_t j = 0; j < kWidth; ++j) out[j] = sums[j] * share;
}

void gatherRow(const std::uint32_t* hits, std::uint32_t rays, const float* b, std::uint32_t width,
               float* out) {
  std::fill(out, out + width, 0.0f);
  for (std::uint32_t i = 0; i < rays && hits[i] != kNone; ++i) {
    const float* source = b + std::size_t{hits[i]} * width;
    for (std::uint32_t j = 0; j < width; ++j) out[j] += source[j];
  }
  const float share = 1.0f / static_cast<float>(rays);
  for (std::uint32_t j = 0; j < width; ++j) out[j] *= share;
}

}  // namespace

void gather(const FormFactors& factors, const float* b, std::uint32_t width, std::uint32_t firstRow,
            std::uint32_t lastRow, float* out) {
  for (std::uint32_t p = firstRow; p < lastRow; ++p) {
    // note: lost rays (kNone) sort last, so a row ends at the first of them.
    const std::uint32_t* hits = factors.hits.data() + std::size_t{p} * factors.rays;
    float* row = out + std::size_t{p} * width;
    if (width == 16) {
      gatherRow<16>(hits, factors.rays, b, row);
    } else if (width == 8) {
      gatherRow<8>(hits, factors.rays, b, row);
    } else {
      gatherRow(hits, factors.rays, b, width, row);
    }
  }
}

}  // namespace fiatlux
