#include "core/transport/exchange.h"

#include <Eigen/Dense>
#include <algorithm>

namespace fiatlux {
namespace {

constexpr std::uint32_t kTogether = 16;  // columns: each entry of H is read once for them

/// kRows rows from `first` on of out = H in; both row-major, kWidth columns. As many sums as a processor adds
/// at a time.
template <int kWidth, int kRows>
void multiplyRows(const float* h, std::uint32_t first, std::uint32_t count, const float* in, float* out) {
  h += std::size_t{first} * count;
  float sums[kRows][kWidth] = {};
  for (std::uint32_t d = 0; d < count; ++d)
    for (int r = 0; r < kRows; ++r) {
      const float weight = h[std::size_t(r) * count + d];
      for (int j = 0; j < kWidth; ++j) sums[r][j] += weight * in[std::size_t{d} * kWidth + j];
    }
  std::copy(&sums[0][0], &sums[0][0] + kRows * kWidth, out + std::size_t{first} * kWidth);
}

template <int kWidth, int kRows>
void multiplyWide(const float* h, std::uint32_t rows, std::uint32_t count, const float* in, float* out) {
  std::uint32_t first = 0;
  for (; first + kRows <= rows; first += kRows) multiplyRows<kWidth, kRows>(h, first, count, in, out);
  for (; first < rows; ++first) multiplyRows<kWidth, 1>(h, first, count, in, out);
}

/// out = H in: rows x width of count x width; width is one that padded() makes.
void multiply(const float* h, std::uint32_t rows, std::uint32_t count, const float* in, std::uint32_t width,
              float* out) {
  if (width == 4) return multiplyWide<4, 8>(h, rows, count, in, out);
  if (width == 8) return multiplyWide<8, 4>(h, rows, count, in, out);
  multiplyWide<kTogether, 2>(h, rows, count, in, out);
}

/// Columns that are made for so many, the rest zero: vectors want whole fours.
std::uint32_t padded(std::uint32_t columns) { return columns <= 4 ? 4 : columns <= 8 ? 8 : kTogether; }

using GroupMatrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

}  // namespace

ExchangeOperator::ExchangeOperator(const Patches& patches, const ExchangeGroups& groups,
                                   const Exchange& exchange)
    : patches_(patches),
      exchange_(exchange),
      count_(groups.count),
      total_(groups.total),
      interpolation_(patches, groups) {}

std::vector<float> ExchangeOperator::indirect(const std::vector<float>& direct, std::uint32_t columns) const {
  const std::size_t rows = patches_.rows();
  std::vector<float> light(rows * columns), in, out;
  for (std::uint32_t first = 0; first < columns; first += kTogether) {
    const std::uint32_t some = std::min(kTogether, columns - first), width = padded(some);
    in.assign(rows * width, 0.0f);
    out.resize(rows * width);
    for (std::uint32_t j = 0; j < some; ++j)
      for (std::size_t p = 0; p < rows; ++p) in[p * width + j] = direct[(first + j) * rows + p];
    indirectBlock(in.data(), width, out.data());
    for (std::uint32_t j = 0; j < some; ++j)
      for (std::size_t p = 0; p < rows; ++p) light[(first + j) * rows + p] = out[p * width + j];
  }
  return light;
}

std::vector<float> ExchangeOperator::spread(const std::vector<float>& lumens, std::uint32_t columns) const {
  const std::size_t rows = patches_.rows();
  std::vector<float> means(std::size_t{total_} * columns), spread(rows * columns), light(rows * columns);
  Eigen::Map<GroupMatrix>(means.data(), total_, columns).noalias() =
      Eigen::Map<const GroupMatrix>(exchange_.means.data(), total_, count_) *
      Eigen::Map<const GroupMatrix>(lumens.data(), count_, columns);
  interpolation_.apply(means.data(), columns, spread.data());
  for (std::size_t p = 0; p < rows; ++p) {
    float* row = &spread[p * columns];
    for (std::uint32_t i = exchange_.offset[p]; i < exchange_.offset[p + 1]; ++i) {
      const float* source = &lumens[std::size_t{exchange_.group[i]} * columns];
      for (std::uint32_t j = 0; j < columns; ++j) row[j] += exchange_.rest[i] * source[j];
    }
    for (std::uint32_t j = 0; j < columns; ++j) light[j * rows + p] = row[j];
  }
  return light;
}

void ExchangeOperator::indirectBlock(const float* direct, std::uint32_t width, float* out) const {
  // First reflected lumens of each patch; receivers reflect nothing.
  std::vector<float> phi(std::size_t{patches_.rows()} * width, 0.0f);
  for (std::uint32_t p = 0; p < patches_.count; ++p) {
    const auto weight = static_cast<float>(patches_.area[p] * patches_.reflectance[p]);
    for (std::uint32_t j = 0; j < width; ++j)
      phi[std::size_t{p} * width + j] = weight * direct[std::size_t{p} * width + j];
  }

  // Means over the groups: H W^T phi + R^T phi.
  std::vector<float> sums(std::size_t{total_} * width), sources(sums.size()), means(sums.size());
  interpolation_.reduce(phi.data(), width, sums.data(), sources.data());
  multiply(exchange_.means.data(), total_, count_, sources.data(), width, means.data());
  for (std::uint32_t p = 0; p < patches_.count; ++p)
    for (std::uint32_t i = exchange_.offset[p]; i < exchange_.offset[p + 1]; ++i) {
      float* mean = &means[std::size_t{exchange_.group[i]} * width];
      for (std::uint32_t j = 0; j < width; ++j)
        mean[j] += exchange_.rest[i] * phi[std::size_t{p} * width + j];
    }

  // Spread over the groups, and what is not smooth: R times the sums.
  interpolation_.apply(means.data(), width, out);
  for (std::uint32_t p = 0; p < patches_.rows(); ++p)
    for (std::uint32_t i = exchange_.offset[p]; i < exchange_.offset[p + 1]; ++i) {
      const float* sum = &sums[std::size_t{exchange_.group[i]} * width];
      for (std::uint32_t j = 0; j < width; ++j) out[std::size_t{p} * width + j] += exchange_.rest[i] * sum[j];
    }
}

}  // namespace fiatlux
