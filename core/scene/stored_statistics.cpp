// C = G^T G for rows G of weighted deviations from the mean, in tiles that stay in a processor's registers.
#include "core/scene/stored_statistics.h"

#include <algorithm>
#include <cmath>

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

SurfaceStatistics storedStatistics(const Patches& patches, const Responses& responses, Quantity quantity,
                                   const std::vector<std::uint32_t>& rows) {
  const std::size_t m = responses.sites, stride = (m + kWide - 1) / kWide * kWide;
  const auto factor = [&](std::uint32_t p) {
    return quantity == Quantity::kExitance ? double{patches.reflectance[p]} : 1.0;
  };
  double area = 0;
  for (const std::uint32_t p : rows) area += patches.area[p];
  SurfaceStatistics result;
  result.mean.assign(m, 0.0);
  for (std::size_t j = 0; j < m; ++j) {
    const float* column = responses.column(static_cast<std::uint32_t>(j));
    for (const std::uint32_t p : rows) result.mean[j] += patches.area[p] / area * factor(p) * column[p];
  }

  std::vector<float> deviations(kChunk * stride);
  std::vector<double> products(stride * stride);
  for (std::size_t first = 0; first < rows.size(); first += kChunk) {
    const std::size_t count = std::min(kChunk, rows.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t p = rows[first + i];
      const double weight = std::sqrt(patches.area[p] / area), scale = factor(p);
      for (std::size_t j = 0; j < m; ++j)
        deviations[i * stride + j] = static_cast<float>(
            weight * (scale * responses.illuminance[j * responses.rows + p] - result.mean[j]));
    }
    addProducts(deviations.data(), count, stride, products.data());
  }
  result.covariance.resize(m * m);
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = i; j < m; ++j)
      result.covariance[i * m + j] = result.covariance[j * m + i] = products[i * stride + j];
  return result;
}

}  // namespace fiatlux
