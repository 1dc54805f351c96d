// Objective::survey: trials judged side by side, statistic by statistic, so that a compiler makes vector code
// of every loop. Only + - * / and roots, each rounded alike everywhere: the same bits natively and as Wasm.
#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/search/objective.h"

namespace fiatlux {
namespace {

bool isOfMoments(Statistic statistic) {
  return statistic == Statistic::kMean || statistic == Statistic::kSigma ||
         statistic == Statistic::kChebyshev;
}

/// Of extremes on the side that is hoped for alone (PatchExtremes::hoped).
bool isSurveyed(Statistic statistic, Side side) {
  switch (statistic) {
    case Statistic::kMaximum:
      return side == Side::kUpper;
    case Statistic::kMinimum:
    case Statistic::kUniformity:
    case Statistic::kCylindrical:
    case Statistic::kModelling:
    case Statistic::kVertical:
      return side == Side::kLower;
    default:
      return isOfMoments(statistic);
  }
}

double clamped(double value, double low, double high) {
  const double atLeast = value > low ? value : low;
  return atLeast < high ? atLeast : high;
}

}  // namespace

const double* Objective::valuesOf(const Term& term, const SurveyedLayouts& layouts) const {
  const double* values = term.statistic == Statistic::kMean ? layouts.means : layouts.variances;
  return values + std::size_t{term.set} * kSurveyStride;
}

bool Objective::isSurveyable() const {
  for (const Term& term : terms_)
    if (!isOfMoments(term.statistic)) return false;
  for (const Bound& bound : sides_)
    if (!isSurveyed(bound.statistic, bound.side) || bound.value == 0) return false;
  return true;
}

void Objective::surveyBound(const Bound& bound, const SurveyedLayouts& layouts,
                            double* __restrict values) const {
  const std::size_t at = std::size_t{bound.set} * kSurveyStride;
  const double *mean = layouts.means + at, *sigma = layouts.variances + at;
  const double *least = layouts.least + at, *most = layouts.most + at;
  const auto copy = [&](const double* row) { std::copy_n(row, kSurveyed, values); };
  switch (bound.statistic) {
    case Statistic::kSigma:
      return copy(sigma);
    case Statistic::kChebyshev: {
      const double share = bound.side == Side::kLower ? -bound.alpha : bound.alpha;
      for (std::uint32_t k = 0; k < kSurveyed; ++k) values[k] = mean[k] + share * sigma[k];
      return;
    }
    case Statistic::kMinimum:
      return copy(least);
    case Statistic::kMaximum:
      return copy(most);
    case Statistic::kUniformity:
      for (std::uint32_t k = 0; k < kSurveyed; ++k) values[k] = mean[k] > 0 ? least[k] / mean[k] : 0.0;
      return;
    default:  // a mean, or light at points
      return copy(bound.isLeast ? least : mean);
  }
}

/// What the goals add up to, each layout at its dimming: the linear ones and a share of the aims.
void Objective::surveyGoals(const SurveyedLayouts& layouts, const double* slopes, const double* dimmings,
                            double aimShare, double* __restrict worths) const {
  for (std::uint32_t k = 0; k < kSurveyed; ++k) worths[k] = dimmings[k] * slopes[k];
  for (const Term& term : terms_) {
    if (!(term.target > 0)) continue;
    const double* value = valuesOf(term, layouts);
    const double target = term.target, weight = aimShare * term.factor / target;
    for (std::uint32_t k = 0; k < kSurveyed; ++k)
      worths[k] += weight * std::fabs(dimmings[k] * value[k] - target);
  }
}

/// Of each layout the dimming that its goals like best within the bounds: at an end, or where an aim is met.
void Objective::surveyDimming(const SurveyedLayouts& layouts, const double* slopes,
                              double* __restrict dimmings) const {
  double first[kSurveyed], last[kSurveyed], values[kSurveyed];
  for (std::uint32_t k = 0; k < kSurveyed; ++k) first[k] = dimmingLow_;
  for (std::uint32_t k = 0; k < kSurveyed; ++k) last[k] = dimmingHigh_;
  for (const Bound& bound : sides_) {
    if (bound.scaleFree) continue;
    surveyBound(bound, layouts, values);
    for (std::uint32_t k = 0; k < kSurveyed; ++k) values[k] = bound.value / values[k];
    if (bound.side == Side::kLower)
      for (std::uint32_t k = 0; k < kSurveyed; ++k) first[k] = values[k] > first[k] ? values[k] : first[k];
    else
      for (std::uint32_t k = 0; k < kSurveyed; ++k) last[k] = values[k] < last[k] ? values[k] : last[k];
  }
  const double low = dimmingLow_, high = dimmingHigh_;
  for (std::uint32_t k = 0; k < kSurveyed; ++k) first[k] = clamped(first[k], low, high);
  for (std::uint32_t k = 0; k < kSurveyed; ++k) last[k] = clamped(last[k], low, high);
  if (!hasAims_) {
    for (std::uint32_t k = 0; k < kSurveyed; ++k) dimmings[k] = slopes[k] > 0 ? first[k] : last[k];
    return;
  }
  double least[kSurveyed], tried[kSurveyed], worths[kSurveyed];
  const auto consider = [&] {
    surveyGoals(layouts, slopes, tried, 1, worths);
    for (std::uint32_t k = 0; k < kSurveyed; ++k) dimmings[k] = worths[k] < least[k] ? tried[k] : dimmings[k];
    for (std::uint32_t k = 0; k < kSurveyed; ++k) least[k] = worths[k] < least[k] ? worths[k] : least[k];
  };
  for (std::uint32_t k = 0; k < kSurveyed; ++k) dimmings[k] = last[k];
  surveyGoals(layouts, slopes, dimmings, 1, least);
  for (std::uint32_t k = 0; k < kSurveyed; ++k) tried[k] = first[k];
  consider();
  for (const Term& term : terms_) {
    if (!(term.target > 0)) continue;
    const double* value = valuesOf(term, layouts);
    for (std::uint32_t k = 0; k < kSurveyed; ++k)
      tried[k] = clamped(term.target / value[k], first[k], last[k]);
    consider();
  }
}

void Objective::survey(const SurveyedLayouts& layouts, const Prices& prices,
                       double* __restrict worths) const {
  assert(maySurvey_);
  for (std::size_t s = 0; s < sets_.size(); ++s) {
    if (!sets_[s].needsVariance) continue;
    double* variance = layouts.variances + s * kSurveyStride;
    for (std::uint32_t k = 0; k < kSurveyed; ++k)
      variance[k] = std::sqrt(variance[k] > 0 ? variance[k] : 0.0);
  }
  double slopes[kSurveyed], dimmings[kSurveyed];
  for (std::uint32_t k = 0; k < kSurveyed; ++k) slopes[k] = 0;
  for (const Term& term : terms_) {
    if (term.target > 0) continue;
    const double* value = valuesOf(term, layouts);
    const double factor = term.factor;
    for (std::uint32_t k = 0; k < kSurveyed; ++k) slopes[k] += factor * value[k];
  }
  if (dimmingLow_ == dimmingHigh_)
    for (std::uint32_t k = 0; k < kSurveyed; ++k) dimmings[k] = dimmingHigh_;
  else
    surveyDimming(layouts, slopes, dimmings);
  surveyGoals(layouts, slopes, dimmings, prices.aimShare, worths);
  for (const Bound& bound : sides_) {
    double values[kSurveyed];
    surveyBound(bound, layouts, values);
    if (!bound.scaleFree)
      for (std::uint32_t k = 0; k < kSurveyed; ++k) values[k] *= dimmings[k];
    const double price =
        bound.side == Side::kLower ? prices.penalty * bound.perUnit : -prices.penalty * bound.perUnit;
    const double edge = bound.value;
    for (std::uint32_t k = 0; k < kSurveyed; ++k) {
      const double cost = price * (edge - values[k]);
      worths[k] += cost > 0 ? cost : 0.0;
    }
  }
}

}  // namespace fiatlux
