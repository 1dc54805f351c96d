// Sums over a block of columns of a row-major matrix, as many as vectors take: with a width that the compiler
// knows, no loop over it is left.
#pragma once

#include <cstdint>
#include <type_traits>

namespace fiatlux {

/// Columns that are worth a block: each entry of a large matrix is read once for them.
inline constexpr std::uint32_t kColumnBlock = 16;

/// What a block of so many columns is made for, the rest zero: vectors want whole fours.
inline std::uint32_t paddedColumns(std::uint32_t columns) {
  return columns <= 4 ? 4 : columns <= 8 ? 8 : kColumnBlock;
}

/// Calls `work` with the width, as a constant where paddedColumns() makes it.
template <class Work>
void withWidth(std::uint32_t width, const Work& work) {
  if (width == 4) return work(std::integral_constant<std::uint32_t, 4>());
  if (width == 8) return work(std::integral_constant<std::uint32_t, 8>());
  if (width == kColumnBlock) return work(std::integral_constant<std::uint32_t, kColumnBlock>());
  work(width);
}

/// to += weight from, of rows that do not overlap.
template <class Width>
inline void addScaled(float* __restrict to, float weight, const float* __restrict from, Width width) {
  for (std::uint32_t j = 0; j < width; ++j) to[j] += weight * from[j];
}

}  // namespace fiatlux
