// U x for a block of columns: what rows get from whole clusters. Each number of U is read once and in its
// order (it is the largest of all matrices), and clusters out of sight of four rows in a row are passed over.
#pragma once

#include <cstddef>
#include <cstdint>

namespace fiatlux {

/// Eight columns. note: named, for the compiler makes single floats of loops over them.
using Columns8 = float __attribute__((vector_size(32), aligned(4), may_alias));

inline const Columns8& columns8(const float* at) { return *reinterpret_cast<const Columns8*>(at); }

/// out (rows x width) = u (rows x clusters) x (clusters x width), all row-major.
void clusterProduct(const float* u, std::size_t rows, std::size_t clusters, const float* x,
                    std::uint32_t width, float* out);

/// out (clusters x kColumnBlock) += u^T (clusters x rows) x (rows x kColumnBlock), all row-major.
void addTransposedProduct(const float* u, std::size_t rows, std::size_t clusters, const float* x, float* out);

}  // namespace fiatlux
