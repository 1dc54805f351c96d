// Mean and variance of the light of a layout, paper (8) and (10) on the few sites that shine: the one place
// that sums them, in full; core/search/kernels.h knows how they change. Plain loops over plain arrays, double
// sums, one fixed order: the same bits natively and as Wasm.
#pragma once

#include <cstdint>

// Small and never inlined, because V8 compiles a Wasm function well only from its second call on.
#if defined(__GNUC__) || defined(__clang__)
#define FIATLUX_KERNEL __attribute__((noinline))
#else
#define FIATLUX_KERNEL
#endif

namespace fiatlux {

/// mu = a x, paper (8): N loads.
FIATLUX_KERNEL double meanOf(const double* mean, const std::uint32_t* sites, const double* flux,
                             std::uint32_t count);

/// sigma^2 = x^T C x, paper (10); C row-major m x m, symmetric, as the search keeps it (float) or as it is
/// stored: N (N + 1) / 2 loads.
template <class Entry>
FIATLUX_KERNEL double varianceOf(const Entry* covariance, std::uint32_t m, const std::uint32_t* sites,
                                 const double* flux, std::uint32_t count);

extern template double varianceOf(const float*, std::uint32_t, const std::uint32_t*, const double*,
                                  std::uint32_t);
extern template double varianceOf(const double*, std::uint32_t, const std::uint32_t*, const double*,
                                  std::uint32_t);

}  // namespace fiatlux
