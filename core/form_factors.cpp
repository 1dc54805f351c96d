// F b in two parts: whole clusters by one thin product, and nearby what the rays tell about the light within
// them.
#include "core/form_factors.h"

#include <Eigen/Dense>

namespace fiatlux {

namespace {

using RowMatrixF = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using RowMatrixD = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Adds weight x (sum of the hits' rows of `detail`) to `out`, kWidth columns known to the compiler.
template <std::uint32_t kWidth>
void addHits(const std::uint32_t* hits, const std::uint32_t* end, float weight, const float* detail,
             float* out) {
  float sums[kWidth] = {};
  for (; hits < end && *hits != kNone; ++hits) {
    const float* source = detail + std::size_t{*hits} * kWidth;
    for (std::uint32_t j = 0; j < kWidth; ++j) sums[j] += source[j];
  }
  for (std::uint32_t j = 0; j < kWidth; ++j) out[j] += weight * sums[j];
}

void addHits(const std::uint32_t* hits, const std::uint32_t* end, float weight, const float* detail,
             std::uint32_t width, float* out) {
  for (; hits < end && *hits != kNone; ++hits) {
    const float* source = detail + std::size_t{*hits} * width;
    for (std::uint32_t j = 0; j < width; ++j) out[j] += weight * source[j];
  }
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
  for (std::uint32_t p = 0; p < factors.rows; ++p) {
    const std::uint32_t* hits = factors.hits.data() + factors.hitOffset[p];
    const std::uint32_t* end = factors.hits.data() + factors.hitOffset[p + 1];
    float* row = out + std::size_t{p} * width;
    if (width == 16) {
      addHits<16>(hits, end, factors.hitWeight[p], detail.data(), row);
    } else if (width == 8) {
      addHits<8>(hits, end, factors.hitWeight[p], detail.data(), row);
    } else {
      addHits(hits, end, factors.hitWeight[p], detail.data(), width, row);
    }
  }
}

}  // namespace fiatlux
