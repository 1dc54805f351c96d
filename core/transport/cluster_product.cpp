#include "core/transport/cluster_product.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cstring>

#include "core/transport/column_block.h"

namespace fiatlux {

namespace {

/// Whether eight numbers of each of some rows are all zero (+0).
template <std::uint32_t kRows>
bool areZero(const float* u, std::size_t clusters) {
  using Bits8 = std::int32_t __attribute__((vector_size(32), aligned(4), may_alias));
  Bits8 any = {};
  for (std::uint32_t row = 0; row < kRows; ++row) any |= *reinterpret_cast<const Bits8*>(u + row * clusters);
  std::uint64_t words[4];
  std::memcpy(words, &any, sizeof words);
  return (words[0] | words[1] | words[2] | words[3]) == 0;
}

/// out (kRows x width) = u (kRows x clusters) x (clusters x width), all row-major; width is 8 kBlocks.
template <std::uint32_t kBlocks, std::uint32_t kRows>
void productOfRows(const float* u, std::size_t clusters, const float* x, float* out) {
  Columns8 sums[kRows][kBlocks] = {};
  for (std::size_t c = 0; c < clusters; ++c) {
    while (c % 8 == 0 && c + 8 <= clusters && areZero<kRows>(u + c, clusters)) c += 8;
    if (c == clusters) break;
    for (std::uint32_t i = 0; i < kBlocks; ++i) {
      const Columns8 from = columns8(x + (c * kBlocks + i) * 8);
      for (std::uint32_t row = 0; row < kRows; ++row) sums[row][i] += u[row * clusters + c] * from;
    }
  }
  std::memcpy(out, sums, sizeof sums);
}

/// out (clusters x kColumnBlock) += u^T (clusters x kRows) x (kRows x kColumnBlock): `out`, which is larger
/// than a row of `u` by far, is gone through once for all rows.
template <std::uint32_t kRows>
void addTransposedRows(const float* u, std::size_t clusters, const float* x, float* out) {
  constexpr std::uint32_t kBlocks = kColumnBlock / 8;
  Columns8 from[kRows][kBlocks];
  std::memcpy(from, x, sizeof from);
  for (std::size_t c = 0; c < clusters; ++c) {
    while (c % 8 == 0 && c + 8 <= clusters && areZero<kRows>(u + c, clusters)) c += 8;
    if (c == clusters) break;
    for (std::uint32_t i = 0; i < kBlocks; ++i) {
      Columns8& to = *reinterpret_cast<Columns8*>(out + c * kColumnBlock + 8 * std::size_t{i});
      Columns8 sum = to;
      for (std::uint32_t row = 0; row < kRows; ++row) sum += u[row * clusters + c] * from[row][i];
      to = sum;
    }
  }
}

constexpr std::size_t kMostRows = 4;

/// Of at least kMostRows rows.
template <std::uint32_t kBlocks>
void productInBlocks(const float* u, std::size_t rows, std::size_t clusters, const float* x, float* out) {
  constexpr std::size_t kRows = kBlocks > 2 ? 2 : kMostRows, kWidth = 8 * kBlocks;  // as sums fit registers
  for (std::size_t done = 0; done < rows; done += kRows) {
    const std::size_t p = std::min(done, rows - kRows);  // the last ones overlap those before
    productOfRows<kBlocks, kRows>(u + p * clusters, clusters, x, out + p * kWidth);
  }
}

}  // namespace

void clusterProduct(const float* u, std::size_t rows, std::size_t clusters, const float* x,
                    std::uint32_t width, float* out) {
  if (rows >= kMostRows) {
    if (width == 8) return productInBlocks<1>(u, rows, clusters, x, out);
    if (width == 16) return productInBlocks<2>(u, rows, clusters, x, out);
    if (width == 32) return productInBlocks<4>(u, rows, clusters, x, out);
  }
  using Matrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const auto size = [](std::size_t count) { return static_cast<Eigen::Index>(count); };
  Eigen::Map<Matrix>(out, size(rows), width).noalias() =
      Eigen::Map<const Matrix>(u, size(rows), size(clusters)) *
      Eigen::Map<const Matrix>(x, size(clusters), width);
}

void addTransposedProduct(const float* u, std::size_t rows, std::size_t clusters, const float* x,
                          float* out) {
  std::size_t p = 0;
  for (; p + kMostRows <= rows; p += kMostRows)
    addTransposedRows<kMostRows>(u + p * clusters, clusters, x + p * kColumnBlock, out);
  for (; p < rows; ++p) addTransposedRows<1>(u + p * clusters, clusters, x + p * kColumnBlock, out);
}

}  // namespace fiatlux
