// C = G^T G for rows G of weighted deviations from the mean, in tiles that stay in a processor's registers.
#include "core/scene/stored_statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace fiatlux {
namespace {

constexpr std::size_t kTall = 4, kWide = 8, kChunk = 128;  // of a tile of C; rows of G at a time

/// Adds the products of `count` rows of G (row-major, `stride` a whole number of kWide) to the tiles of C
/// (stride x stride) that touch its upper triangle.
void addProducts(const float* g, std::size_t count, std::size_t stride, double* c) {
  for (std::size_t i = 0; i < stride; i += kTall)
    for (std::size_t j = i / kWide * kWide; j < stride; j += kWide) {
      float tile[kTall][kWide] = {};
      for (std::size_t row = 0; row < count; ++row) {
        const float *a = g + row * stride + i, *b = g + row * stride + j;
        for (std::size_t y = 0; y < kTall; ++y)
          for (std::size_t x = 0; x < kWide; ++x) tile[y][x] += a[y] * b[x];
      }
      for (std::size_t y = 0; y < kTall; ++y)
        for (std::size_t x = 0; x < kWide; ++x) c[(i + y) * stride + j + x] += double{tile[y][x]};
    }
}

}  // namespace

std::vector<std::vector<std::uint32_t>> rowsOfSurfaces(const Patches& patches, std::uint32_t surfaces) {
  std::vector<std::vector<std::uint32_t>> rows(surfaces);
  for (std::uint32_t p = 0; p < patches.rows(); ++p)
    if (patches.counts(p)) rows[patches.surface[p]].push_back(p);
  return rows;
}

StatisticsInTurn::StatisticsInTurn(const Patches& patches, const Responses& responses, Quantity quantity,
                                   std::vector<std::uint32_t> rows)
    : patches_(patches),
      responses_(responses),
      quantity_(quantity),
      rows_(std::move(rows)),
      stride_((responses.sites + kWide - 1) / kWide * kWide) {
  const std::size_t m = responses.sites;
  for (const std::uint32_t p : rows_) area_ += patches.area[p];
  statistics_.mean.assign(m, 0.0);
  for (std::size_t j = 0; j < m; ++j) {
    const float* column = responses.column(static_cast<std::uint32_t>(j));
    for (const std::uint32_t p : rows_)
      statistics_.mean[j] += patches.area[p] / area_ * factor(p) * column[p];
  }
  deviations_.resize(kChunk * stride_);
  products_.resize(stride_ * stride_);
}

double StatisticsInTurn::factor(std::uint32_t row) const {
  return quantity_ == Quantity::kExitance ? double{patches_.reflectance[row]} : 1.0;
}

bool StatisticsInTurn::advance(std::size_t count) {
  for (const std::size_t before = taken_; taken_ < rows_.size() && taken_ - before < count;)
    addChunk(std::min(kChunk, rows_.size() - taken_));
  return taken_ == rows_.size();
}

void StatisticsInTurn::addChunk(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t p = rows_[taken_ + i];
    const double weight = std::sqrt(patches_.area[p] / area_), scale = factor(p);
    for (std::size_t j = 0; j < responses_.sites; ++j)
      deviations_[i * stride_ + j] = static_cast<float>(
          weight * (scale * responses_.illuminance[j * responses_.rows + p] - statistics_.mean[j]));
  }
  addProducts(deviations_.data(), count, stride_, products_.data());
  taken_ += count;
}

SurfaceStatistics StatisticsInTurn::take() {
  assert(taken_ == rows_.size());
  const std::size_t m = responses_.sites;
  statistics_.covariance.resize(m * m);
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = i; j < m; ++j)
      statistics_.covariance[i * m + j] = statistics_.covariance[j * m + i] = products_[i * stride_ + j];
  return std::move(statistics_);
}

SurfaceStatistics storedStatistics(const Patches& patches, const Responses& responses, Quantity quantity,
                                   const std::vector<std::uint32_t>& rows) {
  StatisticsInTurn statistics(patches, responses, quantity, rows);
  (void)statistics.advance(rows.size());
  return statistics.take();
}

}  // namespace fiatlux
