// (I - R U V^T)^-1 = I - Y V^T, applied as e + R U (I - V^T R U)^-1 V^T e: two thin products and one k x k
// solve. The core is summed and factorised in double, where cancellation decides; the n x k products run in
// float.
#include "core/transport/low_rank_radiosity.h"

#include <Eigen/Dense>
#include <cmath>

#include "core/transport/cluster_product.h"

namespace fiatlux {

namespace {
using RowMatrixF = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using RowMatrixD = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using RowMapF = Eigen::Map<RowMatrixF>;
using ConstRowMapF = Eigen::Map<const RowMatrixF>;
}  // namespace

struct LowRankRadiosity::Parts {
  const FormFactors* factors;
  std::vector<float> reflectance;  // n
  Eigen::PartialPivLU<RowMatrixD> core;
};

LowRankRadiosity::LowRankRadiosity(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
LowRankRadiosity::LowRankRadiosity(LowRankRadiosity&&) noexcept = default;
LowRankRadiosity& LowRankRadiosity::operator=(LowRankRadiosity&&) noexcept = default;
LowRankRadiosity::~LowRankRadiosity() = default;

Result<LowRankRadiosity> LowRankRadiosity::factorize(const FormFactors& factors, const Patches& patches) {
  const std::uint32_t n = factors.count, k = factors.clusters;
  auto parts = std::make_unique<Parts>();
  parts->factors = &factors;
  parts->reflectance.assign(patches.reflectance.begin(), patches.reflectance.begin() + n);

  // I - V^T R U, row by row of U.
  RowMatrixD core = RowMatrixD::Identity(k, k);
  for (std::uint32_t q = 0; q < n; ++q) {
    const Eigen::Map<const Eigen::RowVectorXf> row(factors.u.data() + std::size_t{q} * k, k);
    core.row(factors.cluster[q]) -= factors.share[q] * double{patches.reflectance[q]} * row.cast<double>();
  }
  parts->core.compute(core);
  const double worst = k > 0 ? parts->core.matrixLU().diagonal().cwiseAbs().minCoeff() : 1;
  if (!(worst > 1e-9)) {
    return Error{
        "the radiosity system is singular: a closed group of surfaces reflects all light; lower its "
        "reflectance"};
  }
  return LowRankRadiosity(std::move(parts));
}

/// (I - V^T R U)^-1 V^T e, which is V^T b: k x width.
std::vector<float> LowRankRadiosity::clusterMeans(const float* e, std::uint32_t width) const {
  const std::uint32_t k = parts_->factors->clusters;
  std::vector<float> x(std::size_t{k} * width);
  reduce(*parts_->factors, e, width, x.data());
  const RowMatrixD reduced = ConstRowMapF(x.data(), k, width).cast<double>();
  RowMapF(x.data(), k, width) = parts_->core.solve(reduced).cast<float>();
  return x;
}

/// b = e + R gathered; `b` may be `gathered`.
void LowRankRadiosity::reflect(const float* e, std::uint32_t width, const float* gathered, float* b) const {
  for (std::size_t q = 0, at = 0; q < parts_->factors->count; ++q)
    for (std::uint32_t j = 0; j < width; ++j, ++at) b[at] = e[at] + parts_->reflectance[q] * gathered[at];
}

void LowRankRadiosity::solve(const float* e, std::uint32_t width, float* b) const {
  const FormFactors& factors = *parts_->factors;
  const std::vector<float> means = clusterMeans(e, width);
  clusterProduct(factors.u.data(), factors.count, factors.clusters, means.data(), width, b);
  reflect(e, width, b, b);
}

void LowRankRadiosity::solve(const float* e, std::uint32_t width, float* b, float* gathered) const {
  const FormFactors& factors = *parts_->factors;
  const std::vector<float> means = clusterMeans(e, width);
  clusterProduct(factors.u.data(), factors.rows, factors.clusters, means.data(), width, gathered);
  reflect(e, width, gathered, b);
  addDetail(factors, b, means.data(), width, gathered);
}

std::vector<double> LowRankRadiosity::coreInverse() const {
  const Eigen::Index k = parts_->factors->clusters;
  std::vector<double> inverse(k * k);
  Eigen::Map<RowMatrixD>(inverse.data(), k, k) = parts_->core.inverse();
  return inverse;
}

std::vector<float> LowRankRadiosity::y() const {
  const FormFactors& factors = *parts_->factors;
  const std::uint32_t n = factors.count, k = factors.clusters;
  const std::vector<double> inverse = coreInverse();
  const RowMatrixF right = Eigen::Map<const RowMatrixD>(inverse.data(), k, k).cast<float>();
  std::vector<float> result(std::size_t{n} * k);
  RowMapF y(result.data(), n, k);
  y.noalias() = ConstRowMapF(factors.u.data(), n, k) * right;
  for (std::uint32_t q = 0; q < n; ++q) y.row(q) *= -parts_->reflectance[q];
  return result;
}

}  // namespace fiatlux
