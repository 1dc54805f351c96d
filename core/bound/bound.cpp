// The dual ascent; see bound.h.
#include "core/bound/bound.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/search/start_layout.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kStepsPerRound = 300, kRounds = 200, kFruitlessRounds = 25;
constexpr std::uint32_t kFruitlessAtDimming = 8;  // before another one is tried
constexpr int kHalvings = 40;
constexpr double kSameDimming = 1e-3;   // share
constexpr double kLeastDimming = 1e-3;  // of the most: below it is as good as dark
constexpr std::uint32_t kPolishSteps = 12000, kShifts = 50, kShiftStep = 200, kMostSitesToShift = 600;
constexpr std::uint32_t kPairStep = 1000;
constexpr double kRounding = 1e-9;

std::vector<double> weightsOf(const PreparedScene& prepared) {
  std::vector<double> weights;
  for (std::uint32_t c = 0; c < prepared.candidateCount(); ++c) weights.push_back(prepared.weight(c));
  return weights;
}

}  // namespace

OptimumBound::OptimumBound(PreparedScene& prepared, const Intentions& intentions, const Evaluation& incumbent,
                           const Layout* reference)
    : OptimumBound(
          prepared, intentions,
          ConvexRelaxation(ExclusiveGroups::of(prepared, intentions.luminaires), intentions.luminaires),
          incumbent, reference) {}

OptimumBound::OptimumBound(PreparedScene& prepared, const Intentions& intentions,
                           const LuminaireRules& tiedRules, const Evaluation& incumbent,
                           const Layout* reference)
    : OptimumBound(prepared, intentions, ConvexRelaxation(weightsOf(prepared), tiedRules), incumbent,
                   reference) {}

OptimumBound::OptimumBound(PreparedScene& prepared, const Intentions& intentions, ConvexRelaxation relaxation,
                           const Evaluation& incumbent, const Layout* reference)
    : sites_(prepared.candidateCount()),
      relaxation_(std::move(relaxation)),
      bound_(-kUnbounded),
      bestDual_(-kUnbounded) {
  const LuminaireRules& rules = intentions.luminaires;
  problem_ = relaxIntentions(prepared, intentions,
                             reference ? *reference : Layout{spreadSites(prepared.sites(), rules), {}, 1});
  if (!problem_.supported) return;
  if (problem_.squared && sites_ <= kMostSitesToShift)
    shift_ = std::make_unique<DiagonalShift>(sites_, problem_.covariance);
  dimmingLow_ = rules.dimmingLow;
  dimmingHigh_ = rules.dimmingHigh;
  if (isDimmed()) relaxation_.setDimming(std::clamp(incumbent.dimming, leastDimming(), dimmingHigh_));
  multipliers_.assign(problem_.sides.size() + problem_.aims.size(), 0.0);
  bestMultipliers_ = multipliers_;
  if (std::isfinite(incumbent.goal)) pairGoal_ = pairGoalOf(prepared, rules, problem_);
  if (pairGoal_) {
    pairGoal_->incumbent = incumbent.goal;
    pairGoal_->inverse = 1 / incumbent.dimming;
  }
  target_ = problem_.squared ? incumbent.goal * incumbent.goal : incumbent.goal;
  openRound();
}

OptimumBound::Multiplied OptimumBound::multiplied(std::size_t k) const {
  if (k < problem_.sides.size()) return {problem_.sides[k], 0, kUnbounded};
  const RelaxedAim& aim = problem_.aims[k - problem_.sides.size()];
  return {aim.form, -aim.weight, aim.weight};
}

/// The Lagrangian for the multipliers: goal + sum of multiplier x form, all convex.
void OptimumBound::openRound() {
  ConvexObjective lagrangian = problem_.goal;
  for (std::size_t k = 0; k < multipliers_.size(); ++k) {
    const double multiplier = multipliers_[k];
    if (multiplier == 0) continue;
    const ConvexObjective& form = multiplied(k).form;
    lagrangian.constant += multiplier * form.constant;
    lagrangian.perDimming += multiplier * form.perDimming;
    for (std::uint32_t j = 0; j < sites_; ++j) lagrangian.linear[j] += multiplier * form.linear[j];
    for (ConvexTerm term : form.terms) {
      term.weight *= multiplier;
      lagrangian.terms.push_back(std::move(term));
    }
  }
  constant_ = lagrangian.constant;
  relaxation_.setObjective(std::move(lagrangian));
  stepsInRound_ = 0;
}

void OptimumBound::advance(std::uint32_t steps) {
  while (steps > 0 && !done()) {
    if (stage_ == Stage::kShift) {
      steps -= std::min(steps, kShiftStep);
      moveDiagonal();
      continue;
    }
    if (stage_ == Stage::kPairs) {
      steps -= std::min(steps, kPairStep);
      advancePairs();
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

/// Moves more of the diagonal out where the relaxed layout is split; once that gains nothing, the objective
/// becomes the shifted one.
void OptimumBound::moveDiagonal() {
  std::vector<double> weights(sites_);
  for (std::uint32_t j = 0; j < sites_; ++j)
    weights[j] = std::max(
        1e-3, relaxation_.x()[j] / problem_.flux.largest * (1 - relaxation_.x()[j] / problem_.flux.largest));
  if (++shifts_ <= kShifts && shift_->step(weights)) return;
  // x^T C x = x^T (C - D) x + sum d x^2, and x^2 >= least x on a site in use (<= largest x where d < 0).
  const std::vector<double>& d = shift_->diagonal();
  problem_.goal.constant = 0;
  problem_.goal.terms = {{std::make_shared<const std::vector<double>>(shift_->shifted()), 1, false}};
  for (std::uint32_t j = 0; j < sites_; ++j)
    problem_.goal.linear[j] = d[j] * (d[j] > 0 ? problem_.flux.least : problem_.flux.largest);
  multipliers_ = bestMultipliers_;
  stage_ = Stage::kPolish;
  openRound();
}

void OptimumBound::closeRound() {
  const double dual = relaxation_.bound();
  isDimmed() ? keepLine(dual) : keep(dual);
  if (stage_ == Stage::kPolish) {
    stage_ = pairGoal_ ? Stage::kPairs : Stage::kDone;
    return;
  }
  if (dual > bestDual_ + 1e-6 * std::fabs(dual)) {
    bestDual_ = dual;
    bestMultipliers_ = multipliers_;
    fruitless_ = 0;
  } else if (++fruitless_ % 5 == 0) {
    pace_ *= 0.5;
  }
  // Polyak: towards the incumbent's value along the broken (and the slack) sides, and the aims that are
  // missed.
  double square = 0;
  std::vector<double> slope(multipliers_.size());
  for (std::size_t k = 0; k < slope.size(); ++k) {
    const auto [form, least, largest] = multiplied(k);
    slope[k] = constraintValue(form);
    if (slope[k] < 0 ? multipliers_[k] <= least : multipliers_[k] >= largest) slope[k] = 0;
    square += slope[k] * slope[k];
  }
  const double short_ = target_ - dual;
  const bool ends = square <= 1e-14 || short_ <= 1e-9 * std::fabs(target_) || ++rounds_ >= kRounds;
  if ((ends || fruitless_ >= kFruitlessAtDimming) && rounds_ < kRounds && goToLowest()) return openRound();
  if (ends || fruitless_ >= kFruitlessRounds) return closeMultipliers();
  for (std::size_t k = 0; k < slope.size(); ++k) {
    const double moved = multipliers_[k] + pace_ * short_ / square * slope[k];
    multipliers_[k] = std::clamp(moved, multiplied(k).least, multiplied(k).largest);
  }
  openRound();
}

/// The Lagrangian but for its constant is as large as the light.
void OptimumBound::keepLine(double dual) {
  if (!std::isfinite(dual)) return;
  lines_.push_back({constant_, (dual - constant_) / relaxation_.t()});
  keep(lowest().goal);
}

/// Of the highest lines one falls and one rises, or one is the least at an end of the range: no goal is below
/// where they cross, or there.
OptimumBound::Lowest OptimumBound::lowest() const {
  const auto highest = [&](double t) {
    return *std::max_element(lines_.begin(), lines_.end(),
                             [t](const Line& a, const Line& b) { return a.at(t) < b.at(t); });
  };
  double low = dimmingLow_, high = dimmingHigh_;
  Line falling = highest(low), rising = highest(high);
  if (falling.slope >= 0) return {falling.at(low), low};
  if (rising.slope <= 0) return {rising.at(high), high};
  for (int halving = 0; halving < kHalvings; ++halving) {
    const double middle = (low + high) / 2;
    const Line line = highest(middle);
    (line.slope < 0 ? low : high) = middle;
    (line.slope < 0 ? falling : rising) = line;
  }
  const double t = (falling.constant - rising.constant) / (rising.slope - falling.slope);
  return {falling.at(t), t};
}

double OptimumBound::leastDimming() const { return std::max(dimmingLow_, kLeastDimming * dimmingHigh_); }

/// To the dimming where least is proved, unless it was there: the multipliers go along.
bool OptimumBound::goToLowest() {
  if (!isDimmed() || lines_.empty()) return false;
  const double t = std::max(lowest().dimming, leastDimming());
  if (std::fabs(t - relaxation_.t()) < kSameDimming * t) return false;
  relaxation_.setDimming(t);
  multipliers_ = bestMultipliers_;
  bestDual_ = -kUnbounded;
  pace_ = 0.5;
  fruitless_ = 0;
  return true;
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

void OptimumBound::advancePairs() {
  if (pairGoal_) pairs_ = std::make_unique<PairBound>(std::move(*takePairs()));
  pairs_->advance();
  provedByPairs(pairs_->goal());
  if (pairs_->done()) stage_ = Stage::kDone;
}

/// A proved value of the objective becomes one of the goal.
void OptimumBound::keep(double dual) {
  const double safe = dual - kRounding * std::fabs(dual);
  keepGoal(!problem_.squared ? dual : safe > 0 ? std::sqrt(safe) : 0);
}

void OptimumBound::provedByPairs(double goal) {
  if (keepGoal(goal)) isByPairs_ = true;
}

/// Less the rounding of the sums. Is it better than what was known?
bool OptimumBound::keepGoal(double goal) {
  const double safe = goal - kRounding * std::fabs(goal);
  if (!std::isfinite(goal) || safe <= bound_) return false;
  bound_ = safe;
  return true;
}

std::optional<double> OptimumBound::within(const Evaluation& evaluation) const {
  if (!problem_.supported || evaluation.violation > 1e-9 || !std::isfinite(bound_)) return std::nullopt;
  if (!isBetter({0, bound_, 1}, evaluation)) return 0;  // an aim that is met, say
  if (bound_ == 0 || (bound_ > 0) != (evaluation.goal > 0)) return std::nullopt;
  return std::max(0.0, evaluation.goal - bound_) / std::fabs(bound_);
}

}  // namespace fiatlux
