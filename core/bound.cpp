// Dual bounds; see bound.h.
#include "core/bound.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/start_layout.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kStepsPerRound = 300, kRounds = 200, kFruitlessRounds = 25;
constexpr std::uint32_t kPolishSteps = 12000, kShifts = 50, kShiftStep = 200, kMostSitesToShift = 600;

/// A covariance made surely convex by a ridge that Cholesky approves; `ridge` becomes what was added to the
/// diagonal.
std::shared_ptr<const std::vector<double>> convexMatrix(std::vector<double> covariance, std::uint32_t m,
                                                        double& ridge) {
  ridge = convexRidge(covariance, m);
  for (std::uint32_t i = 0; i < m; ++i) covariance[std::size_t{i} * m + i] += ridge;
  return std::make_shared<const std::vector<double>>(std::move(covariance));
}

/// x^T C x is at most this for every layout (Gilmore and Lawler): each luminaire with the partners that suit
/// it best.
double largestVariance(const std::vector<double>& covariance, const LuminaireRules& rules, std::uint32_t m) {
  std::vector<double> flux;
  for (std::uint32_t i = 0; i < rules.count; ++i) flux.push_back(fluxOf(rules, i));
  std::sort(flux.begin(), flux.end(), std::greater<>());
  std::vector<char> usable(m, 1);
  for (std::uint32_t site : rules.excluded) usable[site] = 0;
  std::vector<double> best, partners;
  for (std::uint32_t i = 0; i < m; ++i) {
    if (!usable[i]) continue;
    partners.clear();
    for (std::uint32_t j = 0; j < m; ++j)
      if (usable[j] && j != i) partners.push_back(covariance[std::size_t{i} * m + j]);
    std::sort(partners.begin(), partners.end(), std::greater<>());
    double sum = flux[0] * covariance[std::size_t{i} * m + i];
    for (std::size_t k = 0; k + 1 < flux.size(); ++k)
      sum += partners[k] * flux[partners[k] > 0 ? k : flux.size() - 1 - k];
    best.push_back(std::max(sum, 0.0));
  }
  std::sort(best.begin(), best.end(), std::greater<>());
  double total = 0;
  for (std::size_t k = 0; k < flux.size(); ++k) total += flux[k] * best[k];
  return total * rules.dimmingHigh * rules.dimmingHigh;
}

}  // namespace

OptimumBound::OptimumBound(PreparedScene& prepared, const Intentions& intentions, const Evaluation& incumbent,
                           const Layout* reference)
    : sites_(prepared.siteCount()),
      high_(intentions.luminaires.dimmingHigh),
      relaxation_(prepared.siteCount(), intentions.luminaires),
      bound_(-kUnbounded),
      bestDual_(-kUnbounded) {
  const LuminaireRules& rules = intentions.luminaires;
  least_ = kUnbounded;
  for (std::uint32_t i = 0; i < rules.count; ++i) {
    const double flux = high_ * fluxOf(rules, i);
    totalFlux_ += flux;
    squareFlux_ += flux * flux;
    least_ = std::min(least_, flux);
    largest_ = std::max(largest_, flux);
  }
  shiftable_ = rules.dimmingLow == rules.dimmingHigh && sites_ <= kMostSitesToShift;
  const Layout spread{spreadSites(prepared, rules), {}, 1};
  addGoals(prepared, intentions, reference ? *reference : spread);
  if (!supported_) return;
  for (const Constraint& constraint : intentions.constraints)
    addConstraint(prepared, constraint, intentions.quantity);
  multipliers_.assign(sides_.size(), 0.0);
  bestMultipliers_ = multipliers_;
  target_ = squared_ ? incumbent.goal * incumbent.goal : incumbent.goal;
  openRound();
}

ConvexObjective OptimumBound::meanForm(PreparedScene& prepared, Quantity quantity, const SurfaceSet& surfaces,
                                       double factor) const {
  ConvexObjective form;
  form.linear = prepared.statistics(quantity, surfaces)->mean;
  for (double& entry : form.linear) entry *= factor;
  return form;
}

/// + weight sigma, from below: sqrt(x^T (C + ridge I) x) is above sigma by at most sqrt(ridge x^T x).
void OptimumBound::addSigma(ConvexObjective& form, PreparedScene& prepared, Quantity quantity,
                            const SurfaceSet& surfaces, double weight) const {
  double ridge = 0;
  auto matrix = convexMatrix(unionStatistics(prepared.scene(), quantity, surfaces).covariance, sites_, ridge);
  form.terms.push_back({std::move(matrix), weight, true});
  form.constant -= weight * std::sqrt(ridge * squareFlux_);
}

void OptimumBound::addGoals(PreparedScene& prepared, const Intentions& intentions, const Layout& reference) {
  const Objective objective(prepared, intentions, reference);
  objective_.linear.assign(sites_, 0.0);
  supported_ = !intentions.goals.empty();
  const LuminaireRules& rules = intentions.luminaires;
  for (std::size_t g = 0; g < intentions.goals.size(); ++g) {
    const Goal& goal = intentions.goals[g];
    const double factor = objective.goalFactor(g);
    if (goal.statistic == Statistic::kMean) {
      const ConvexObjective mean = meanForm(prepared, intentions.quantity, goal.surfaces, factor);
      for (std::uint32_t j = 0; j < sites_; ++j) objective_.linear[j] += mean.linear[j];
    } else if (goal.statistic == Statistic::kPower) {
      objective_.perDimming += factor * totalFlux_ / high_;
    } else if (goal.statistic == Statistic::kSigma && factor < 0) {
      const std::vector<double> covariance =
          unionStatistics(prepared.scene(), intentions.quantity, goal.surfaces).covariance;
      objective_.constant += factor * std::sqrt(largestVariance(covariance, rules, sites_));
    } else if (goal.statistic == Statistic::kSigma && intentions.goals.size() == 1) {
      // Alone, its square serves as well, and takes the diagonal shift.
      squared_ = true;
      std::vector<double> covariance =
          unionStatistics(prepared.scene(), intentions.quantity, goal.surfaces).covariance;
      for (double& entry : covariance) entry *= factor * factor;
      if (shiftable_) shift_ = std::make_unique<DiagonalShift>(sites_, covariance);
      double ridge = 0;
      objective_.terms.push_back({convexMatrix(std::move(covariance), sites_, ridge), 1, false});
      objective_.constant -= ridge * squareFlux_;
    } else if (goal.statistic == Statistic::kSigma) {
      addSigma(objective_, prepared, intentions.quantity, goal.surfaces, factor);
    } else {
      supported_ = false;
    }
  }
}

/// The convex sides of a constraint; a true minimum or maximum is asked of the mean at least.
void OptimumBound::addConstraint(PreparedScene& prepared, const Constraint& c, Quantity quantity) {
  const bool lower = std::isfinite(c.lower), upper = std::isfinite(c.upper);
  const auto mean = [&](double factor) { return meanForm(prepared, quantity, c.surfaces, factor); };
  switch (c.statistic) {
    case Statistic::kMean:
      if (lower) addSide(mean(-1), -c.lower);
      if (upper) addSide(mean(1), c.upper);
      return;
    case Statistic::kMinimum:
      if (lower) addSide(mean(-1), -c.lower);
      return;
    case Statistic::kMaximum:
      if (upper) addSide(mean(1), c.upper);
      return;
    case Statistic::kSigma:
    case Statistic::kChebyshev:
      for (const bool below : {true, false}) {
        if (below ? !lower || c.statistic == Statistic::kSigma : !upper) continue;
        ConvexObjective form = mean(c.statistic == Statistic::kSigma ? 0 : below ? -1 : 1);
        const double weight = c.statistic == Statistic::kSigma ? 1 : c.alpha;
        if (weight > 0) addSigma(form, prepared, quantity, c.surfaces, weight);
        addSide(std::move(form), below ? -c.lower : c.upper);
      }
      return;
    case Statistic::kPower: {
      ConvexObjective form;
      form.linear.assign(sites_, 0.0);
      form.perDimming = totalFlux_ / high_;
      if (upper) addSide(form, c.upper);
      form.perDimming = -form.perDimming;
      if (lower) addSide(form, -c.lower);
      return;
    }
    case Statistic::kContrast:
      for (const bool below : {true, false}) {
        if (below ? !lower : !upper) continue;
        ConvexObjective form = mean(below ? -1 : 1);
        const ConvexObjective over = meanForm(prepared, quantity, c.over, below ? c.lower : -c.upper);
        for (std::uint32_t j = 0; j < sites_; ++j) form.linear[j] += over.linear[j];
        addSide(std::move(form), 0);
      }
      return;
    case Statistic::kUniformity:
      return;
  }
}

/// form <= bound, scaled so that multipliers are of the goal's size.
void OptimumBound::addSide(ConvexObjective form, double bound) {
  form.constant -= bound;
  double scale = std::fabs(bound);
  if (scale == 0)
    for (double entry : form.linear) scale = std::max(scale, std::fabs(entry) * totalFlux_);
  if (scale == 0) return;
  form.constant /= scale;
  form.perDimming /= scale;
  for (double& entry : form.linear) entry /= scale;
  for (ConvexTerm& term : form.terms) term.weight /= scale;
  sides_.push_back(std::move(form));
}

/// The Lagrangian for the multipliers: goal + sum of multiplier x side, all convex.
void OptimumBound::openRound() {
  ConvexObjective lagrangian = objective_;
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const double multiplier = multipliers_[k];
    if (multiplier <= 0) continue;
    lagrangian.constant += multiplier * sides_[k].constant;
    lagrangian.perDimming += multiplier * sides_[k].perDimming;
    for (std::uint32_t j = 0; j < sites_; ++j) lagrangian.linear[j] += multiplier * sides_[k].linear[j];
    for (ConvexTerm term : sides_[k].terms) {
      term.weight *= multiplier;
      lagrangian.terms.push_back(std::move(term));
    }
  }
  relaxation_.setObjective(std::move(lagrangian));
  stepsInRound_ = 0;
}

void OptimumBound::advance(std::uint32_t steps) {
  while (steps > 0 && !done()) {
    if (stage_ == Stage::kShift) {
      std::vector<double> weights(sites_);
      for (std::uint32_t j = 0; j < sites_; ++j)
        weights[j] = std::max(1e-3, relaxation_.x()[j] / largest_ * (1 - relaxation_.x()[j] / largest_));
      steps -= std::min(steps, kShiftStep);
      if (++shifts_ <= kShifts && shift_->step(weights)) continue;
      // x^T C x = x^T (C - D) x + sum d x^2, and x^2 >= least x on a site in use (<= largest x where d < 0).
      const std::vector<double>& d = shift_->diagonal();
      objective_.constant = 0;
      objective_.terms = {{std::make_shared<const std::vector<double>>(shift_->shifted()), 1, false}};
      for (std::uint32_t j = 0; j < sites_; ++j) objective_.linear[j] = d[j] * (d[j] > 0 ? least_ : largest_);
      multipliers_ = bestMultipliers_;
      stage_ = Stage::kPolish;
      openRound();
      continue;
    }
    --steps;
    const bool moving = relaxation_.step();
    ++stepsInRound_;
    const double gap = relaxation_.value() - relaxation_.bound();
    const bool closed = !moving || gap <= 2e-5 * std::fabs(relaxation_.value());
    if (closed || stepsInRound_ >= (stage_ == Stage::kPolish ? kPolishSteps : kStepsPerRound)) closeRound();
  }
}

void OptimumBound::closeRound() {
  const double dual = relaxation_.bound();
  keep(dual);
  if (stage_ == Stage::kPolish) {
    stage_ = Stage::kDone;
    return;
  }
  if (dual > bestDual_ + 1e-6 * std::fabs(dual)) {
    bestDual_ = dual;
    bestMultipliers_ = multipliers_;
    fruitless_ = 0;
  } else if (++fruitless_ % 5 == 0) {
    pace_ *= 0.5;
  }
  // Polyak: towards the incumbent's value along the broken (and the slack) sides.
  double square = 0;
  std::vector<double> slope(sides_.size());
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    slope[k] = constraintValue(sides_[k]);
    if (slope[k] < 0 && multipliers_[k] <= 0) slope[k] = 0;
    square += slope[k] * slope[k];
  }
  const double short_ = target_ - dual;
  if (square <= 1e-14 || short_ <= 1e-9 * std::fabs(target_) || ++rounds_ >= kRounds ||
      fruitless_ >= kFruitlessRounds)
    return closeMultipliers();
  for (std::size_t k = 0; k < sides_.size(); ++k)
    multipliers_[k] = std::max(0.0, multipliers_[k] + pace_ * short_ / square * slope[k]);
  openRound();
}

void OptimumBound::closeMultipliers() {
  multipliers_ = bestMultipliers_;
  stage_ = shift_ && shift_->ok() ? Stage::kShift : Stage::kPolish;
  if (stage_ == Stage::kPolish) openRound();
}

double OptimumBound::constraintValue(const ConvexObjective& form) const {
  const std::vector<double>& x = relaxation_.x();
  double value = form.constant + form.perDimming * relaxation_.t();
  for (std::uint32_t j = 0; j < sites_; ++j) value += form.linear[j] * x[j];
  for (const ConvexTerm& term : form.terms) {
    double quadratic = 0;
    for (std::uint32_t i = 0; i < sites_; ++i) {
      if (x[i] == 0) continue;
      double sum = 0;
      for (std::uint32_t j = 0; j < sites_; ++j) sum += (*term.matrix)[std::size_t{i} * sites_ + j] * x[j];
      quadratic += x[i] * sum;
    }
    value += term.weight * std::sqrt(std::max(0.0, quadratic));
  }
  return value;
}

/// A proved value of the objective becomes one of the goal, less the rounding of the sums.
void OptimumBound::keep(double dual) {
  const double safe = dual - 1e-9 * std::fabs(dual);
  const double goal = !squared_ ? safe : safe > 0 ? std::sqrt(safe) : 0;
  bound_ = std::max(bound_, goal);
}

std::optional<double> OptimumBound::within(const Evaluation& evaluation) const {
  if (!supported_ || evaluation.violation > 1e-9 || !std::isfinite(bound_)) return std::nullopt;
  if (bound_ == 0 || (bound_ > 0) != (evaluation.goal > 0)) return std::nullopt;
  return std::max(0.0, evaluation.goal - bound_) / std::fabs(bound_);
}

}  // namespace fiatlux
