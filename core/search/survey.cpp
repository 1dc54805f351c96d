// Objective::survey: trials judged side by side, statistic by statistic, so that a compiler makes vector code
// of every loop. Only + - * / and roots, each rounded alike everywhere: the same bits natively and as Wasm.
#include <cassert>
#include <cmath>

#include "core/search/objective.h"

namespace fiatlux {
namespace {

bool isOfMoments(Statistic statistic) {
  return statistic == Statistic::kMean || statistic == Statistic::kSigma ||
         statistic == Statistic::kChebyshev;
}

/// out = mean + share sigma, or one of the two.
void mix(Statistic statistic, const double* mean, double share, const double* sigma, double* __restrict out) {
  if (statistic == Statistic::kChebyshev)
    for (std::uint32_t k = 0; k < kSurveyed; ++k) out[k] = mean[k] + share * sigma[k];
  else
    for (std::uint32_t k = 0; k < kSurveyed; ++k) out[k] = statistic == Statistic::kMean ? mean[k] : sigma[k];
}

double clamped(double value, double low, double high) {
  const double atLeast = value > low ? value : low;
  return atLeast < high ? atLeast : high;
}

}  // namespace

const double* Objective::valuesOf(const Term& term, const double* means, const double* sigmas) const {
  return (term.statistic == Statistic::kMean ? means : sigmas) + std::size_t{term.set} * kSurveyStride;
}

bool Objective::isSurveyable() const {
  if (needsExtremes_) return false;
  for (const Term& term : terms_)
    if (!isOfMoments(term.statistic)) return false;
  for (const Bound& bound : sides_)
    if (!isOfMoments(bound.statistic) || bound.value == 0) return false;
  return true;
}

void Objective::surveyBound(const Bound& bound, const double* means, const double* sigmas,
                            double* values) const {
  const std::size_t at = std::size_t{bound.set} * kSurveyStride;
  mix(bound.statistic, means + at, bound.side == Side::kLower ? -bound.alpha : bound.alpha, sigmas + at,
      values);
}

/// What the goals add up to, each layout at its dimming: the linear ones and a share of the aims.
void Objective::surveyGoals(const double* means, const double* sigmas, const double* slopes,
                            const double* dimmings, double aimShare, double* __restrict worths) const {
  for (std::uint32_t k = 0; k < kSurveyed; ++k) worths[k] = dimmings[k] * slopes[k];
  for (const Term& term : terms_) {
    if (!(term.target > 0)) continue;
    const double* value = valuesOf(term, means, sigmas);
    const double target = term.target, weight = aimShare * term.factor / target;
    for (std::uint32_t k = 0; k < kSurveyed; ++k)
      worths[k] += weight * std::fabs(dimmings[k] * value[k] - target);
  }
}

/// Of each layout the dimming that its goals like best within the bounds: at an end, or where an aim is met.
void Objective::surveyDimming(const double* means, const double* sigmas, const double* slopes,
                              double* __restrict dimmings) const {
  double first[kSurveyed], last[kSurveyed], values[kSurveyed];
  for (std::uint32_t k = 0; k < kSurveyed; ++k) first[k] = dimmingLow_;
  for (std::uint32_t k = 0; k < kSurveyed; ++k) last[k] = dimmingHigh_;
  for (const Bound& bound : sides_) {
    surveyBound(bound, means, sigmas, values);
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
    surveyGoals(means, sigmas, slopes, tried, 1, worths);
    for (std::uint32_t k = 0; k < kSurveyed; ++k) dimmings[k] = worths[k] < least[k] ? tried[k] : dimmings[k];
    for (std::uint32_t k = 0; k < kSurveyed; ++k) least[k] = worths[k] < least[k] ? worths[k] : least[k];
  };
  for (std::uint32_t k = 0; k < kSurveyed; ++k) dimmings[k] = last[k];
  surveyGoals(means, sigmas, slopes, dimmings, 1, least);
  for (std::uint32_t k = 0; k < kSurveyed; ++k) tried[k] = first[k];
  consider();
  for (const Term& term : terms_) {
    if (!(term.target > 0)) continue;
    const double* value = valuesOf(term, means, sigmas);
    for (std::uint32_t k = 0; k < kSurveyed; ++k)
      tried[k] = clamped(term.target / value[k], first[k], last[k]);
    consider();
  }
}

void Objective::survey(const double* means, double* variances, const Prices& prices,
                       double* __restrict worths) const {
  assert(maySurvey_);
  for (std::size_t s = 0; s < sets_.size(); ++s) {
    if (!sets_[s].needsVariance) continue;
    double* variance = variances + s * kSurveyStride;
    for (std::uint32_t k = 0; k < kSurveyed; ++k)
      variance[k] = std::sqrt(variance[k] > 0 ? variance[k] : 0.0);
  }
  const double* sigmas = variances;
  double slopes[kSurveyed], dimmings[kSurveyed];
  for (std::uint32_t k = 0; k < kSurveyed; ++k) slopes[k] = 0;
  for (const Term& term : terms_) {
    if (term.target > 0) continue;
    const double* value = valuesOf(term, means, sigmas);
    const double factor = term.factor;
    for (std::uint32_t k = 0; k < kSurveyed; ++k) slopes[k] += factor * value[k];
  }
  if (dimmingLow_ == dimmingHigh_)
    for (std::uint32_t k = 0; k < kSurveyed; ++k) dimmings[k] = dimmingHigh_;
  else
    surveyDimming(means, sigmas, slopes, dimmings);
  surveyGoals(means, sigmas, slopes, dimmings, prices.aimShare, worths);
  for (const Bound& bound : sides_) {
    double values[kSurveyed];
    surveyBound(bound, means, sigmas, values);
    const double price =
        bound.side == Side::kLower ? prices.penalty * bound.perUnit : -prices.penalty * bound.perUnit;
    const double edge = bound.value;
    for (std::uint32_t k = 0; k < kSurveyed; ++k) {
      const double cost = price * (edge - dimmings[k] * values[k]);
      worths[k] += cost > 0 ? cost : 0.0;
    }
  }
}

}  // namespace fiatlux
