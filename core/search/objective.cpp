// Compiled intentions; see objective.h.
#include "core/search/objective.h"

#include <algorithm>
#include <cmath>

namespace fiatlux {
namespace {

double sigmaOf(const Moments& moments) { return std::sqrt(std::max(0.0, moments.variance)); }

double ratio(double part, double whole) {
  if (whole > 0) return part / whole;
  return part > 0 ? 1e30 : 0;  // against darkness every light is a contrast
}

}  // namespace

Objective::Objective(PreparedScene& prepared, const Intentions& intentions, const Layout& reference)
    : dimmingLow_(intentions.luminaires.dimmingLow), dimmingHigh_(intentions.luminaires.dimmingHigh) {
  for (std::uint32_t i = 0; i < intentions.luminaires.count; ++i)
    totalFlux_ += fluxOf(intentions.luminaires, i);
  for (const Goal& goal : intentions.goals) addGoal(prepared, goal, intentions.quantity);
  for (const Constraint& constraint : intentions.constraints)
    addConstraint(prepared, constraint, intentions.quantity);
  bounds_.resize(sides_.size());
  scaleGoals(intentions, reference);
}

std::uint32_t Objective::setOf(PreparedScene& prepared, Quantity quantity, const SurfaceSet& surfaces) {
  for (std::uint32_t s = 0; s < sets_.size(); ++s)
    if (sets_[s].surfaces == surfaces) return s;
  sets_.push_back({surfaces, prepared.statistics(quantity, surfaces), false, false});
  return static_cast<std::uint32_t>(sets_.size() - 1);
}

void Objective::addConstraint(PreparedScene& prepared, const Constraint& c, Quantity quantity) {
  Side side{c.statistic, 0, 0, c.alpha, 0, true, false};
  if (c.statistic != Statistic::kPower) side.set = setOf(prepared, quantity, c.surfaces);
  if (c.statistic == Statistic::kContrast) side.over = setOf(prepared, quantity, c.over);
  side.scaleFree = c.statistic == Statistic::kContrast || c.statistic == Statistic::kUniformity;
  const bool extremes = c.statistic == Statistic::kMinimum || c.statistic == Statistic::kMaximum ||
                        c.statistic == Statistic::kUniformity;
  if (extremes) sets_[side.set].needsExtremes = needsExtremes_ = true;
  if (c.statistic == Statistic::kSigma || c.statistic == Statistic::kChebyshev || extremes)
    sets_[side.set].needsVariance = true;
  for (const bool lower : {true, false}) {
    side.bound = lower ? c.lower : c.upper;
    side.lower = lower;
    if (std::isfinite(side.bound)) sides_.push_back(side);
  }
}

void Objective::addGoal(PreparedScene& prepared, const Goal& goal, Quantity quantity) {
  Term term{goal.statistic, 0, 0, goal.sense == Sense::kMinimize ? goal.weight : -goal.weight};
  if (goal.statistic != Statistic::kPower) term.set = setOf(prepared, quantity, goal.surfaces);
  if (goal.statistic == Statistic::kContrast) term.over = setOf(prepared, quantity, goal.over);
  const bool extremes = goal.statistic == Statistic::kMinimum || goal.statistic == Statistic::kMaximum;
  if (extremes) sets_[term.set].needsExtremes = needsExtremes_ = true;
  if (goal.statistic == Statistic::kSigma || extremes) sets_[term.set].needsVariance = true;
  terms_.push_back(term);
}

void Objective::scaleGoals(const Intentions& intentions, const Layout& reference) {
  std::vector<double> flux;
  for (std::uint32_t i = 0; i < intentions.luminaires.count; ++i)
    flux.push_back(fluxOf(intentions.luminaires, i));
  std::vector<Moments> moments;
  for (const ObjectiveSet& set : sets_) {
    const KernelStatistics& s = *set.statistics;
    const auto count = static_cast<std::uint32_t>(flux.size()), m = static_cast<std::uint32_t>(s.mean.size());
    moments.push_back({meanOf(s.mean.data(), reference.sites.data(), flux.data(), count),
                       varianceOf(s.covariance.data(), m, reference.sites.data(), flux.data(), count)});
  }
  for (Term& term : terms_) {
    if (term.statistic == Statistic::kMinimum || term.statistic == Statistic::kMaximum) continue;
    double value = termValue(term, moments.data(), nullptr);
    if (term.statistic != Statistic::kContrast) value *= dimmingHigh_;
    if (value > 1e-12) term.factor /= value;
  }
}

double Objective::termValue(const Term& term, const Moments* moments, const Extremes* extremes) const {
  switch (term.statistic) {
    case Statistic::kMinimum:
      return extremes[term.set].minimumLow;
    case Statistic::kMaximum:
      return extremes[term.set].maximumHigh;
    case Statistic::kSigma:
      return sigmaOf(moments[term.set]);
    case Statistic::kPower:
      return totalFlux_;
    case Statistic::kContrast:
      return ratio(moments[term.set].mean, moments[term.over].mean);
    default:
      return moments[term.set].mean;
  }
}

double Objective::sideValue(const Side& side, const Moments* moments, const Extremes* extremes) const {
  const Moments& at = moments[side.set];
  switch (side.statistic) {
    case Statistic::kMean:
      return at.mean;
    case Statistic::kSigma:
      return sigmaOf(at);
    case Statistic::kPower:
      return totalFlux_;
    case Statistic::kChebyshev:
      return at.mean + (side.lower ? -side.alpha : side.alpha) * sigmaOf(at);
    case Statistic::kMinimum:
      return side.lower ? extremes[side.set].minimumLow : extremes[side.set].minimumHigh;
    case Statistic::kMaximum:
      return side.lower ? extremes[side.set].maximumLow : extremes[side.set].maximumHigh;
    case Statistic::kUniformity:
      return ratio(side.lower ? extremes[side.set].minimumLow : extremes[side.set].minimumHigh, at.mean);
    case Statistic::kContrast:
      return ratio(at.mean, moments[side.over].mean);
  }
  return 0;
}

Evaluation Objective::judge(const Moments* moments, const Extremes* extremes) const {
  double slope = 0, constant = 0;
  for (const Term& term : terms_) {
    const double part = term.factor * termValue(term, moments, extremes);
    (term.statistic == Statistic::kContrast ? constant : slope) += part;
  }
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const Side& side = sides_[i];
    bounds_[i] = {sideValue(side, moments, extremes), side.bound, side.lower, side.scaleFree};
  }
  return solveDimming(bounds_.data(), static_cast<std::uint32_t>(bounds_.size()), slope, constant,
                      dimmingLow_, dimmingHigh_);
}

Extremes Objective::allowedBy(const Moments& moments) {
  const double mean = std::max(moments.mean, 0.0);
  const double spread = mean > 0 ? std::max(0.0, moments.variance) / mean : 0;
  return {mean, 0, kUnbounded, mean + spread};
}

double Objective::goalValue(std::size_t g, const Moments* moments, const Extremes* extremes, double t) const {
  const double value = termValue(terms_[g], moments, extremes);
  return terms_[g].statistic == Statistic::kContrast ? value : t * value;
}

}  // namespace fiatlux
