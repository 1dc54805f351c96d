// Alternating directions and the certificate; see pair_relaxation.h.
#include "core/bound/pair_relaxation.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace fiatlux {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;
using Index = Eigen::Index;
using Eigenvalues = Eigen::SelfAdjointEigenSolver<Matrix>;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kStretch = 1.618;         // of the multipliers' step: below the golden ratio it converges
constexpr double kFactorRounding = 1e-12;  // of the largest entry: what Cholesky must leave over
constexpr double kCloseEnough = 2e-4;      // of the certificate's value
constexpr std::uint32_t kBalanceEvery = 10, kMostNewtonSteps = 40;

enum class Pair : char { kAny, kSame, kApart };

}  // namespace

/// Rows of the constraints: of form k the products with z_i at k m + i, then the trace. The slack of a
/// limited row is what its product may miss 0 by.
struct PairRelaxation::State {
  explicit State(const PairProblem& problem);

  Matrix adjoint(const Vector& y) const;
  Vector products(const Matrix& x) const;
  Matrix gram(const Matrix& g) const;
  void gramOf(std::size_t k, std::size_t l, const Matrix& g, Matrix& result) const;
  Vector clipped(const Vector& y) const { return y.cwiseMax(least).cwiseMin(most); }
  void solveMultipliers();
  void balance(double primal, double dual);
  void beginCertificate();
  bool moveCertificate(const Vector& direction, double slope);
  Matrix leftOver(const Vector& y) const;
  bool approves(const Vector& y) const;

  void setInverse(double inverse);

  Index m, rows;
  std::vector<Vector> a;
  std::vector<double> b, fixed, perInverse;  // b = fixed + perInverse x inverse
  double inverse = -1;
  Vector right, least, most, limited;  // per row; limited: 1 or 0
  std::vector<Pair> pairs;             // m x m
  Eigen::LLT<Matrix> normal;           // of A A^T

  double scale = 1;  // of the cost
  Matrix cost, x, psd, sign;
  Vector y, slackValue, slackCopy;
  double penalty = 10;
  std::uint32_t steps = 0;

  bool certifying = false;
  Matrix kept;  // cost - sign
  Vector inside, certified;
  double barrier = 0, value = -kInfinite, slack = 1;
  std::uint32_t newtonSteps = 0;
};

PairRelaxation::State::State(const PairProblem& problem)
    : m(static_cast<Index>(problem.sites)), rows(static_cast<Index>(problem.forms.size()) * m + 1) {
  right = Vector::Zero(rows);
  right(rows - 1) = problem.count;
  least = Vector::Constant(rows, -kInfinite);
  most = Vector::Constant(rows, kInfinite);
  for (const PairForm& form : problem.forms) {
    const Index from = static_cast<Index>(a.size()) * m;
    a.push_back(Eigen::Map<const Vector>(form.a.data(), m));
    b.push_back(form.fixed);
    fixed.push_back(form.fixed);
    perInverse.push_back(form.inverse);
    least.segment(from, m).setConstant(form.least);
    most.segment(from, m).setConstant(form.most);
  }
  limited = Vector::Zero(rows);
  for (Index r = 0; r < rows; ++r) limited(r) = std::isfinite(least(r)) || std::isfinite(most(r)) ? 1 : 0;
  pairs.assign(static_cast<std::size_t>(m * m), Pair::kAny);
  for (Index i = 0; i < m; ++i) pairs[static_cast<std::size_t>(i * m + i)] = Pair::kSame;
  for (const auto& [i, j] : problem.apart)
    pairs[i * problem.sites + j] = pairs[j * problem.sites + i] = Pair::kApart;
  x = psd = sign = Matrix::Zero(m, m);
  y = slackValue = slackCopy = Vector::Zero(rows);
}

/// Another dimming, and the normal equations of its rows.
void PairRelaxation::State::setInverse(double asked) {
  if (asked == inverse) return;
  inverse = asked;
  for (std::size_t k = 0; k < b.size(); ++k) b[k] = fixed[k] + perInverse[k] * inverse;
  Matrix square = gram(Matrix::Identity(m, m));
  for (Index r = 0; r < rows; ++r) square(r, r) += limited(r) + 1e-9;
  normal.compute(square);
}

/// sum of y_r A_r, where A_r is the symmetric part of e_i (a - b e_i)^T, at last I.
Matrix PairRelaxation::State::adjoint(const Vector& multipliers) const {
  Matrix result = Matrix::Zero(m, m);
  for (std::size_t k = 0; k < a.size(); ++k) {
    const Vector p = multipliers.segment(static_cast<Index>(k) * m, m);
    result.noalias() += 0.5 * p * a[k].transpose();
    result.noalias() += 0.5 * a[k] * p.transpose();
    result.diagonal() -= b[k] * p;
  }
  result.diagonal().array() += multipliers(rows - 1);
  return result;
}

Vector PairRelaxation::State::products(const Matrix& of) const {
  Vector result(rows);
  for (std::size_t k = 0; k < a.size(); ++k)
    result.segment(static_cast<Index>(k) * m, m) = of * a[k] - b[k] * of.diagonal();
  result(rows - 1) = of.trace();
  return result;
}

/// Of all pairs of rows tr(A_r G A_s G), G symmetric.
Matrix PairRelaxation::State::gram(const Matrix& g) const {
  Matrix result(rows, rows);
  for (std::size_t k = 0; k < a.size(); ++k)
    for (std::size_t l = 0; l <= k; ++l) gramOf(k, l, g, result);
  const Matrix square = g * g;
  result.row(rows - 1) = products(square).transpose();
  result.col(rows - 1) = result.row(rows - 1).transpose();
  return result;
}

/// A_r = sym(u v^T) and A_s = sym(s t^T): (u G s)(v G t) / 2 + (u G t)(v G s) / 2.
void PairRelaxation::State::gramOf(std::size_t k, std::size_t l, const Matrix& g, Matrix& result) const {
  const Vector gk = g * a[k], gl = g * a[l];
  const double both = a[k].dot(gl);
  const Index atK = static_cast<Index>(k) * m, atL = static_cast<Index>(l) * m;
  for (Index j = 0; j < m; ++j)
    for (Index i = 0; i < m; ++i) {
      const double unit = g(i, j);
      const double forms = both - b[k] * gl(i) - b[l] * gk(j) + b[k] * b[l] * unit;
      const double crossed = (gk(j) - b[k] * unit) * (gl(i) - b[l] * unit);
      result(atK + i, atL + j) = result(atL + j, atK + i) = 0.5 * (unit * forms + crossed);
    }
}

void PairRelaxation::State::solveMultipliers() {
  Vector wanted = products(cost - psd - sign) + (right - products(x)) / penalty;
  wanted += limited.cwiseProduct(slackCopy - slackValue / penalty);
  y = normal.solve(wanted);
}

/// Neither the primal nor the dual residual may lag behind.
void PairRelaxation::State::balance(double primal, double dual) {
  if (++steps % kBalanceEvery != 0) return;
  if (primal < 0.5 * dual)
    penalty *= 1.25;
  else if (dual < 0.5 * primal)
    penalty /= 1.25;
}

void PairRelaxation::step() {
  State& s = *state_;
  s.certifying = false;
  s.solveMultipliers();
  const Matrix signed_ = s.cost - s.adjoint(s.y) - s.psd - s.x / s.penalty;
  for (Index k = 0; k < s.m * s.m; ++k) {
    const Pair pair = s.pairs[static_cast<std::size_t>(k)];
    const double free = signed_.data()[k];
    s.sign.data()[k] = pair == Pair::kSame ? 0 : pair == Pair::kApart ? free : std::max(0.0, free);
  }
  s.slackCopy = s.limited.cwiseProduct(s.clipped(s.y + s.slackValue / s.penalty));
  s.solveMultipliers();
  const Matrix rest = s.cost - s.adjoint(s.y) - s.sign;
  const Eigenvalues eigen(rest - s.x / s.penalty);
  const Index positive = (eigen.eigenvalues().array() > 0).count();
  const auto vectors = eigen.eigenvectors().rightCols(positive);
  s.psd.noalias() = vectors * eigen.eigenvalues().tail(positive).asDiagonal() * vectors.transpose();
  const Matrix miss = s.psd - rest;
  const Vector slackMiss = s.limited.cwiseProduct(s.y - s.slackCopy);
  s.x += kStretch * s.penalty * miss;
  s.slackValue += kStretch * s.penalty * slackMiss;
  const double primal = (s.products(s.x) - s.right + s.slackValue).norm() / (1 + s.right.norm());
  const double negative = s.x.cwiseMin(0).norm() / (1 + s.x.norm());
  s.balance(std::max(primal, negative), std::sqrt(miss.squaredNorm() + slackMiss.squaredNorm()) / 2);
}

Matrix PairRelaxation::State::leftOver(const Vector& multipliers) const {
  Matrix result = kept - adjoint(multipliers);
  result.diagonal().array() -= kFactorRounding * static_cast<double>(m) * kept.cwiseAbs().maxCoeff();
  return result;
}

bool PairRelaxation::State::approves(const Vector& multipliers) const {
  return Eigen::LLT<Matrix>(leftOver(multipliers)).info() == Eigen::Success;
}

/// The multipliers of the steps, moved strictly inside of what is allowed.
void PairRelaxation::State::beginCertificate() {
  certifying = true;
  newtonSteps = 0;
  kept = cost - sign;
  inside = clipped(y);
  for (Index r = 0; r < rows; ++r) {
    if (limited(r) == 0) continue;
    const double margin = std::min(1e-5, 1e-3 * (most(r) - least(r)));
    inside(r) = std::min(std::max(inside(r), least(r) + margin), most(r) - margin);
  }
  const Eigenvalues eigen(leftOver(inside), Eigen::EigenvaluesOnly);
  const double least_ = eigen.eigenvalues()(0);
  inside(rows - 1) += least_ - 1e-4 * std::fabs(least_) - 1e-9;
  barrier = std::max(1e-9, 0.3 * std::fabs(least_) * right(rows - 1) / static_cast<double>(m));
}

/// Maximises right y + barrier (log det of what is left over + logs of the rows' distances from their
/// limits).
bool PairRelaxation::certify() {
  State& s = *state_;
  if (!s.certifying) s.beginCertificate();
  const Eigen::LLT<Matrix> cholesky(s.leftOver(s.inside));
  if (cholesky.info() != Eigen::Success) return false;
  const double value = s.right.dot(s.inside);
  if (value > s.value) {
    s.value = value;
    s.certified = s.inside;
    s.slack = kInfinite;
    for (Index r = 0; r < s.rows; ++r)
      if (std::isfinite(s.inside(r) > 0 ? s.most(r) : s.least(r)))
        s.slack = std::min(s.slack, (s.inside(r) > 0 ? s.most(r) : s.least(r)) / s.inside(r));
  }
  if (++s.newtonSteps > kMostNewtonSteps ||
      s.barrier * static_cast<double>(s.m) < kCloseEnough * std::fabs(value))
    return false;
  const Matrix inverse = cholesky.solve(Matrix::Identity(s.m, s.m));
  Vector gradient = s.right / s.barrier - s.products(inverse);
  Matrix curvature = s.gram(inverse);
  for (Index r = 0; r < s.rows; ++r) {
    const double above = 1 / (s.inside(r) - s.least(r)), below = 1 / (s.most(r) - s.inside(r));
    gradient(r) += above - below;
    curvature(r, r) += above * above + below * below + 1e-12 * curvature(r, r);
  }
  const Eigen::LLT<Matrix> hessian(curvature);
  if (hessian.info() != Eigen::Success) return false;
  const Vector direction = hessian.solve(gradient);
  return s.moveCertificate(direction, std::sqrt(std::max(0.0, gradient.dot(direction))));
}

/// As far along as Cholesky approves; a long way is not gone to its end.
bool PairRelaxation::State::moveCertificate(const Vector& direction, double decrement) {
  double length = 1;
  for (int cuts = 0; cuts < 40; ++cuts, length *= 0.7) {
    const Vector trial = inside + length * direction;
    if ((trial - least).minCoeff() <= 0 || (most - trial).minCoeff() <= 0 || !approves(trial)) continue;
    inside += (cuts > 0 ? 0.9 * length : length) * direction;
    barrier *= decrement < 1 ? 0.2 : 0.6;
    return true;
  }
  return false;
}

PairRelaxation::PairRelaxation(const PairProblem& problem) : state_(std::make_unique<State>(problem)) {}
PairRelaxation::~PairRelaxation() = default;

void PairRelaxation::setCost(const std::vector<double>& cost, double inverse) {
  State& s = *state_;
  s.setInverse(inverse);
  s.cost = Eigen::Map<const Matrix>(cost.data(), s.m, s.m);
  const double scale = std::max(s.cost.norm(), 1e-300);
  // Limits are of the cost's size.
  s.least *= s.scale / scale;
  s.most *= s.scale / scale;
  s.cost /= scale;
  s.scale = scale;
  s.value = -kInfinite;
  s.certifying = false;
}

double PairRelaxation::bound() const { return state_->value * state_->scale; }
double PairRelaxation::slack() const { return state_->slack; }

std::vector<double> PairRelaxation::drift() const {
  const State& s = *state_;
  std::vector<double> drift(static_cast<std::size_t>(s.m), 0.0);
  for (std::size_t k = 0; k < s.a.size(); ++k)
    for (std::size_t i = 0; i < drift.size(); ++i)
      drift[i] += s.scale * s.perInverse[k] * s.certified(static_cast<Index>(k * drift.size() + i));
  return drift;
}

}  // namespace fiatlux
