// Paper (8) and (10) on sparse x; see layout_sums.h.
#include "core/scene/layout_sums.h"

#include <cstddef>

namespace fiatlux {

double meanOf(const double* mean, const std::uint32_t* sites, const double* flux, std::uint32_t count) {
  double sum = 0;
  for (std::uint32_t i = 0; i < count; ++i) sum += flux[i] * mean[sites[i]];
  return sum;
}

// Two rows of the upper triangle at a time, so that each site and flux is loaded half as often: a third less
// as Wasm.
template <class Entry>
double varianceOf(const Entry* covariance, std::uint32_t m, const std::uint32_t* sites, const double* flux,
                  std::uint32_t count) {
  double half = 0;
  std::uint32_t i = 0;
  for (; i + 1 < count; i += 2) {
    const std::uint32_t a = sites[i], b = sites[i + 1];
    const Entry *rowA = covariance + std::size_t{a} * m, *rowB = covariance + std::size_t{b} * m;
    double crossedA = 0.5 * flux[i] * rowA[a] + flux[i + 1] * rowA[b], crossedB = 0.5 * flux[i + 1] * rowB[b];
    for (std::uint32_t j = i + 2; j < count; ++j) {
      const std::uint32_t site = sites[j];
      crossedA += flux[j] * rowA[site];
      crossedB += flux[j] * rowB[site];
    }
    half += flux[i] * crossedA;
    half += flux[i + 1] * crossedB;
  }
  if (i < count) half += 0.5 * flux[i] * flux[i] * covariance[std::size_t{sites[i]} * m + sites[i]];
  return 2 * half;
}

template double varianceOf(const float*, std::uint32_t, const std::uint32_t*, const double*, std::uint32_t);
template double varianceOf(const double*, std::uint32_t, const std::uint32_t*, const double*, std::uint32_t);

}  // namespace fiatlux
