// Newton on a log-det barrier; see diagonal_shift.h. The one place of the search that needs a linear algebra
// library.
#include "core/bound/diagonal_shift.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace fiatlux {
namespace {

using Matrix = Eigen::MatrixXd;  // symmetric here, so its column-major order does not matter

constexpr double kSafety = 1e-11;  // of the largest diagonal entry: what Cholesky must leave over

Matrix shiftedMatrix(const std::vector<double>& matrix, const std::vector<double>& diagonal, double safety) {
  const auto m = static_cast<Eigen::Index>(diagonal.size());
  Matrix result = Eigen::Map<const Matrix>(matrix.data(), m, m);
  for (Eigen::Index i = 0; i < m; ++i) result(i, i) -= diagonal[static_cast<std::size_t>(i)] + safety;
  return result;
}

}  // namespace

double convexRidge(const std::vector<double>& covariance, std::uint32_t m) {
  double largest = 0;
  for (std::uint32_t i = 0; i < m; ++i) largest = std::max(largest, covariance[std::size_t{i} * m + i]);
  double ridge = 1e-10 * largest;
  for (; ridge < 10 * m * largest; ridge *= 10) {
    const Eigen::LLT<Matrix> cholesky(
        shiftedMatrix(covariance, std::vector<double>(m, -ridge), kSafety * largest));
    if (cholesky.info() == Eigen::Success) break;
  }
  return ridge;
}

DiagonalShift::DiagonalShift(std::uint32_t m, std::vector<double> matrix)
    : m_(m), matrix_(std::move(matrix)) {
  double trace = 0;
  for (std::uint32_t i = 0; i < m; ++i) {
    scale_ = std::max(scale_, matrix_[std::size_t{i} * m + i]);
    trace += matrix_[std::size_t{i} * m + i];
  }
  const double ridge = convexRidge(matrix_, m);  // a covariance may be singular: begin with a little added
  diagonal_.assign(m, -ridge);
  ok_ = scale_ > 0 && positive(diagonal_);
  floor_ = -2 * ridge;
  barrier_ = trace / m * 0.1;
}

bool DiagonalShift::positive(const std::vector<double>& diagonal) const {
  const Eigen::LLT<Matrix> cholesky(shiftedMatrix(matrix_, diagonal, kSafety * scale_));
  return cholesky.info() == Eigen::Success;
}

bool DiagonalShift::step(const std::vector<double>& weights) {
  if (!ok_ || barrier_ < 1e-10 * scale_) return false;
  const auto m = static_cast<Eigen::Index>(m_);
  const Eigen::LLT<Matrix> cholesky(shiftedMatrix(matrix_, diagonal_, kSafety * scale_));
  const Matrix inverse = cholesky.solve(Matrix::Identity(m, m));
  // Gradient w - barrier diag(M^-1), Hessian -barrier (M^-1 o M^-1).
  Eigen::VectorXd gradient(m), height(m);
  for (Eigen::Index i = 0; i < m; ++i) height(i) = diagonal_[static_cast<std::size_t>(i)] - floor_;
  for (Eigen::Index i = 0; i < m; ++i)
    gradient(i) = weights[static_cast<std::size_t>(i)] / barrier_ - inverse(i, i) + 1 / height(i);
  Matrix curvature = inverse.cwiseProduct(inverse);
  for (Eigen::Index i = 0; i < m; ++i) curvature(i, i) += 1 / (height(i) * height(i));
  const Eigen::LLT<Matrix> hessian(curvature);
  if (hessian.info() != Eigen::Success) return false;
  const Eigen::VectorXd move = hessian.solve(gradient);
  const double decrement = std::sqrt(std::max(0.0, gradient.dot(move)));
  double length = decrement > 0.25 ? 1 / (1 + decrement) : 1;  // damped: stays inside (self-concordance)
  std::vector<double> trial(m_);
  for (int halvings = 0; halvings < 30; ++halvings, length /= 2) {
    bool above = true;
    for (std::uint32_t i = 0; i < m_; ++i) {
      trial[i] = diagonal_[i] + length * move(static_cast<Eigen::Index>(i));
      above = above && trial[i] > floor_;
    }
    if (!above || !positive(trial)) continue;
    diagonal_ = trial;
    if (decrement < 0.5) barrier_ *= 0.2;
    return true;
  }
  barrier_ *= 0.2;
  return true;
}

std::vector<double> DiagonalShift::shifted() const {
  std::vector<double> result = matrix_;
  for (std::uint32_t i = 0; i < m_; ++i) result[std::size_t{i} * m_ + i] -= diagonal_[i];
  return result;
}

}  // namespace fiatlux
