// F b in three parts: whole clusters by one thin product, how the light leans over each, and nearby every
// patch by itself.
#include "core/transport/form_factors.h"

#include <Eigen/Dense>

namespace fiatlux {

namespace {

using RowMatrixF = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using RowMatrixD = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Adds to `out` what rows get beyond U V^T b, `width` columns. kWidth is 0 or width: known to the compiler,
/// a row's sum stays in registers.
template <std::uint32_t kWidth>
void correct(const FormFactors& factors, std::uint32_t width, const float* detail, const float* leaning,
             float* out) {
  const std::uint32_t columns = kWidth == 0 ? width : kWidth;
  for (std::uint32_t p = 0; p < factors.rows; ++p) {
    float sums[kWidth == 0 ? 1 : kWidth] = {};
    float* target = out + std::size_t{p} * columns;
    float* row = kWidth == 0 ? target : sums;
    const auto add = [&](float weight, const float* source) {
      for (std::uint32_t j = 0; j < columns; ++j) row[j] += weight * source[j];
    };
    const float* u = factors.u.data() + std::size_t{p} * factors.clusters;
    for (const NearPatch& near : factors.near[p])
      add(near.factor, detail + std::size_t{near.patch} * columns);
    for (const ClusterSlope& slope : factors.slopes[p]) {
      const float unit = u[slope.cluster] / kSlopeUnit;
      const float* axes = leaning + std::size_t{slope.cluster} * 2 * columns;
      add(unit * static_cast<float>(slope.u), axes);
      add(unit * static_cast<float>(slope.v), axes + columns);
    }
    if constexpr (kWidth != 0) {
      for (std::uint32_t j = 0; j < kWidth; ++j) target[j] += row[j];
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
  Eigen::Map<RowMatrixF>(out, factors.rows, width).noalias() =
      Eigen::Map<const RowMatrixF>(factors.u.data(), factors.rows, factors.clusters) *
      Eigen::Map<const RowMatrixF>(x.data(), factors.clusters, width);

  // What V smears: each patch's difference from its cluster's mean.
  std::vector<float> detail(std::size_t{factors.count} * width);
  for (std::uint32_t q = 0; q < factors.count; ++q) {
    const float* mean = x.data() + std::size_t{factors.cluster[q]} * width;
    for (std::uint32_t j = 0; j < width; ++j) {
      detail[std::size_t{q} * width + j] = b[std::size_t{q} * width + j] - mean[j];
    }
  }
  const std::vector<float> leaning = leaningOf(factors, b, width);
  if (width == 16) {
    correct<16>(factors, width, detail.data(), leaning.data(), out);
  } else if (width == 8) {
    correct<8>(factors, width, detail.data(), leaning.data(), out);
  } else {
    correct<0>(factors, width, detail.data(), leaning.data(), out);
  }
}

}  // namespace fiatlux
