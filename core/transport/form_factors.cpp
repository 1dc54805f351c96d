// F b in three parts: whole clusters by one thin product, how the light leans over each, and nearby every
// patch by itself.
#include "core/transport/form_factors.h"

#include <Eigen/Dense>
#include <algorithm>
#include <type_traits>

#include "core/transport/cluster_product.h"
#include "core/transport/column_block.h"

namespace fiatlux {

namespace {

using RowMatrixF = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using RowMatrixD = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Adds to `out` what rows get beyond U V^T b, 8 x kBlocks columns.
template <std::uint32_t kBlocks>
void correctBlocks(const FormFactors& factors, const float* detail, const float* leaning, float* out) {
  constexpr std::size_t kWidth = 8 * kBlocks;
  const auto columns = [](const float* at, std::uint32_t block) {
    return columns8(at + 8 * std::size_t{block});
  };
  for (std::size_t p = 0; p < factors.rows; ++p) {
    Columns8 sums[kBlocks] = {};
    const float* u = factors.u.data() + p * factors.clusters;
    for (const NearPatch& near : factors.near[p]) {
      const float* from = detail + near.patch * kWidth;
      for (std::uint32_t i = 0; i < kBlocks; ++i) sums[i] += near.factor * columns(from, i);
    }
    for (const ClusterSlope& slope : factors.slopes[p]) {
      const float unit = u[slope.cluster] * (1 / kSlopeUnit);
      const float along = unit * static_cast<float>(slope.u), across = unit * static_cast<float>(slope.v);
      const float* axes = leaning + slope.cluster * 2 * kWidth;
      for (std::uint32_t i = 0; i < kBlocks; ++i)
        sums[i] += along * columns(axes, i) + across * columns(axes + kWidth, i);
    }
    for (std::uint32_t i = 0; i < kBlocks; ++i)
      *reinterpret_cast<Columns8*>(out + p * kWidth + 8 * std::size_t{i}) += sums[i];
  }
}

/// The same of any number of columns.
void correct(const FormFactors& factors, std::uint32_t width, const float* detail, const float* leaning,
             float* out) {
  if (width == 8) return correctBlocks<1>(factors, detail, leaning, out);
  if (width == 16) return correctBlocks<2>(factors, detail, leaning, out);
  if (width == 32) return correctBlocks<4>(factors, detail, leaning, out);
  for (std::size_t p = 0; p < factors.rows; ++p) {
    float* row = out + p * width;
    const auto add = [&](float weight, const float* source) {
      for (std::uint32_t j = 0; j < width; ++j) row[j] += weight * source[j];
    };
    const float* u = factors.u.data() + p * factors.clusters;
    for (const NearPatch& near : factors.near[p]) add(near.factor, detail + std::size_t{near.patch} * width);
    for (const ClusterSlope& slope : factors.slopes[p]) {
      const float unit = u[slope.cluster] / kSlopeUnit;
      const float* axes = leaning + std::size_t{slope.cluster} * 2 * width;
      add(unit * static_cast<float>(slope.u), axes);
      add(unit * static_cast<float>(slope.v), axes + width);
    }
  }
}

/// How b leans over each cluster along its two axes: k x 2 x width.
std::vector<float> leaningOf(const FormFactors& factors, const float* b, std::uint32_t width) {
  std::vector<float> leaning(std::size_t{factors.clusters} * 2 * width, 0.0f);
  if (factors.slopeShare.empty()) return leaning;
  for (std::uint32_t q = 0; q < factors.count; ++q) {
    float* sums = leaning.data() + std::size_t{factors.cluster[q]} * 2 * width;
    const float *share = factors.slopeShare.data() + std::size_t{q} * 2, *row = b + std::size_t{q} * width;
    for (std::uint32_t j = 0; j < width; ++j) {
      sums[j] += share[0] * row[j];
      sums[width + j] += share[1] * row[j];
    }
  }
  return leaning;
}

}  // namespace

void reduce(const FormFactors& factors, const float* e, std::uint32_t width, float* x) {
  RowMatrixD sums = RowMatrixD::Zero(factors.clusters, width);
  for (std::uint32_t q = 0; q < factors.count; ++q) {
    const Eigen::Map<const Eigen::RowVectorXf> row(e + std::size_t{q} * width, width);
    sums.row(factors.cluster[q]) += factors.share[q] * row.cast<double>();
  }
  Eigen::Map<RowMatrixF>(x, factors.clusters, width) = sums.cast<float>();
}

void irradiance(const FormFactors& factors, const float* b, std::uint32_t width, float* out) {
  std::vector<float> x(std::size_t{factors.clusters} * width);
  reduce(factors, b, width, x.data());
  clusterProduct(factors.u.data(), factors.rows, factors.clusters, x.data(), width, out);
  addDetail(factors, b, x.data(), width, out);
}

void addDetail(const FormFactors& factors, const float* b, const float* x, std::uint32_t width, float* out) {
  // What V smears: each patch's difference from its cluster's mean.
  std::vector<float> detail(std::size_t{factors.count} * width);
  for (std::uint32_t q = 0; q < factors.count; ++q) {
    const float* mean = x + std::size_t{factors.cluster[q]} * width;
    for (std::uint32_t j = 0; j < width; ++j) {
      detail[std::size_t{q} * width + j] = b[std::size_t{q} * width + j] - mean[j];
    }
  }
  const std::vector<float> leaning = leaningOf(factors, b, width);
  correct(factors, width, detail.data(), leaning.data(), out);
}

void transposedIrradiance(const FormFactors& factors, const float* w, float* out) {
  constexpr std::integral_constant<std::uint32_t, kColumnBlock> kWidth;
  const std::size_t clusters = factors.clusters;
  std::vector<float> whole(clusters * kWidth, 0.0f), leaning(clusters * 2 * kWidth, 0.0f);
  std::fill(out, out + std::size_t{factors.count} * kWidth, 0.0f);
  addTransposedProduct(factors.u.data(), factors.rows, clusters, w, whole.data());
  for (std::size_t p = 0; p < factors.rows; ++p) {
    const float *row = w + p * kWidth, *u = factors.u.data() + p * clusters;
    if (std::all_of(row, row + kWidth, [](float value) { return value == 0; })) continue;
    for (const NearPatch& near : factors.near[p])
      addScaled(out + std::size_t{near.patch} * kWidth, near.factor, row, kWidth);
    for (const ClusterSlope& slope : factors.slopes[p]) {
      const float unit = u[slope.cluster] / kSlopeUnit;
      float* axes = &leaning[std::size_t{slope.cluster} * 2 * kWidth];
      addScaled(axes, unit * static_cast<float>(slope.u), row, kWidth);
      addScaled(axes + kWidth, unit * static_cast<float>(slope.v), row, kWidth);
    }
  }
  // Near patches count by themselves and no longer in their clusters.
  for (std::size_t q = 0; q < factors.count; ++q)
    addScaled(&whole[std::size_t{factors.cluster[q]} * kWidth], -1.0f, out + q * kWidth, kWidth);
  for (std::size_t q = 0; q < factors.count; ++q) {
    const std::size_t c = factors.cluster[q];
    addScaled(out + q * kWidth, static_cast<float>(factors.share[q]), &whole[c * kWidth], kWidth);
    if (factors.slopeShare.empty()) continue;
    for (const std::size_t axis : {0, 1})
      addScaled(out + q * kWidth, factors.slopeShare[2 * q + axis], &leaning[(2 * c + axis) * kWidth],
                kWidth);
  }
}

}  // namespace fiatlux
