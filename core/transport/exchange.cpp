#include "core/transport/exchange.h"

#include <algorithm>

#include "core/transport/column_block.h"

namespace fiatlux {
namespace {

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

/// out = H in: rows x width of count x width; width is one that paddedColumns() makes.
void multiply(const float* h, std::uint32_t rows, std::uint32_t count, const float* in, std::uint32_t width,
              float* out) {
  if (width == 4) return multiplyWide<4, 8>(h, rows, count, in, out);
  if (width == 8) return multiplyWide<8, 4>(h, rows, count, in, out);
  multiplyWide<kColumnBlock, 2>(h, rows, count, in, out);
}

}  // namespace

ExchangeOperator::ExchangeOperator(const Patches& patches, const ExchangeGroups& groups,
                                   const Exchange& exchange)
    : patches_(patches),
      groups_(groups),
      exchange_(exchange),
      count_(groups.count),
      total_(groups.total),
      interpolation_(patches, groups) {}

std::vector<float> ExchangeOperator::indirect(const std::vector<float>& direct, std::uint32_t columns) const {
  const std::size_t rows = patches_.rows();
  std::vector<float> light(rows * columns), in, out;
  for (std::uint32_t first = 0; first < columns; first += kColumnBlock) {
    const std::uint32_t some = std::min(kColumnBlock, columns - first), width = paddedColumns(some);
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
  // Most groups send nothing where one wall is painted: what H says of the others, side by side.
  std::vector<std::uint32_t> lit, place(count_, kNone);
  for (std::uint32_t d = 0; d < count_; ++d) {
    const float* of = &lumens[std::size_t{d} * columns];
    if (std::all_of(of, of + columns, [](float value) { return value == 0; })) continue;
    place[d] = static_cast<std::uint32_t>(lit.size());
    lit.push_back(d);
  }
  std::vector<float> between;
  for (std::uint32_t c = 0; c < total_; ++c)
    for (const std::uint32_t d : lit) between.push_back(exchange_.means[std::size_t{c} * count_ + d]);

  const auto sources = static_cast<std::uint32_t>(lit.size());
  std::vector<float> light(rows * columns), in, means, out;
  for (std::uint32_t first = 0; first < columns; first += kColumnBlock) {
    const std::uint32_t some = std::min(kColumnBlock, columns - first), width = paddedColumns(some);
    in.assign(std::size_t{sources} * width, 0.0f);
    means.resize(std::size_t{total_} * width);
    out.resize(rows * width);
    for (std::uint32_t i = 0; i < sources; ++i)
      for (std::uint32_t j = 0; j < some; ++j)
        in[std::size_t{i} * width + j] = lumens[std::size_t{lit[i]} * columns + first + j];
    multiply(between.data(), total_, sources, in.data(), width, means.data());
    addRest(place.data(), in.data(), width, out.data(), means.data());
    interpolation_.add(means.data(), width, out.data());
    for (std::uint32_t j = 0; j < some; ++j)
      for (std::size_t p = 0; p < rows; ++p) light[(first + j) * rows + p] = out[p * width + j];
  }
  return light;
}

/// out = R in, and what it has of means over groups taken from `means`; `place`: the row of `in` that is each
/// group's, kNone where it is zero, nullptr where all are in their places.
void ExchangeOperator::addRest(const std::uint32_t* place, const float* in, std::uint32_t width, float* out,
                               float* means) const {
  std::fill(out, out + std::size_t{patches_.rows()} * width, 0.0f);
  withWidth(width, [&](auto fixed) {
    for (std::size_t p = 0; p < patches_.rows(); ++p) {
      if (exchange_.offset[p] == exchange_.offset[p + 1]) continue;
      float* row = out + p * fixed;
      for (std::uint32_t i = exchange_.offset[p]; i < exchange_.offset[p + 1]; ++i) {
        const std::uint32_t d = exchange_.group[i], at = place ? place[d] : d;
        if (at != kNone) addScaled(row, exchange_.rest[i], in + std::size_t{at} * fixed, fixed);
      }
      addScaled(means + std::size_t{groups_.ofRow[p]} * fixed, -interpolation_.shareOf(p), row, fixed);
    }
  });
}

void ExchangeOperator::indirectBlock(const float* direct, std::uint32_t width, float* out) const {
  // First reflected lumens of each patch; receivers reflect nothing.
  std::vector<float> phi(std::size_t{patches_.rows()} * width, 0.0f);
  withWidth(width, [&](auto fixed) {
    for (std::size_t p = 0; p < patches_.count; ++p)
      addScaled(&phi[p * fixed], static_cast<float>(patches_.area[p] * patches_.reflectance[p]),
                direct + p * fixed, fixed);
  });

  // Means over the groups: H W^T phi + R^T of what of phi is not even.
  std::vector<float> sums(std::size_t{total_} * width), sources(sums.size()), means(sums.size());
  interpolation_.reduce(phi.data(), width, sums.data(), sources.data());
  multiply(exchange_.means.data(), total_, count_, sources.data(), width, means.data());
  interpolation_.takeEven(sums.data(), width, phi);
  withWidth(width, [&](auto fixed) {
    for (std::size_t p = 0; p < patches_.count; ++p)
      for (std::uint32_t i = exchange_.offset[p]; i < exchange_.offset[p + 1]; ++i)
        addScaled(&means[std::size_t{exchange_.group[i]} * fixed], exchange_.rest[i], &phi[p * fixed], fixed);
  });

  // Spread over the groups, and what is not smooth: R times the sums.
  addRest(nullptr, sums.data(), width, out, means.data());
  interpolation_.add(means.data(), width, out);
}

}  // namespace fiatlux
