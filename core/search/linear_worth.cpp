// Objective::linearize; see linear_worth.h.
#include "core/search/linear_worth.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/search/objective.h"

namespace fiatlux {
namespace {

constexpr double kLeastSigma = 1e-9;    // the root has no slope at 0
constexpr double kHoldingBound = 1e-9;  // of a bound: so near to it the dimming is what it allows

/// A statistic's value, and how it goes.
struct ValueAndSlope {
  double value;
  Slope slope;
};

/// `alpha`: the share of sigma in a Chebyshev bound.
ValueAndSlope slopeOf(Statistic statistic, std::uint32_t set, double alpha, const Moments& moments) {
  if (statistic == Statistic::kMean) return {moments.mean, {set, 1, 0}};
  const double sigma = std::max(moments.sigma(), kLeastSigma);
  if (statistic == Statistic::kSigma) return {sigma, {set, 0, 0.5 / sigma}};
  return {moments.mean + alpha * sigma, {set, 1, 0.5 * alpha / sigma}};
}

Slope scaled(const Slope& slope, double factor) {
  return {slope.set, factor * slope.mean, factor * slope.variance};
}

void add(const Slope& slope, double factor, LinearWorth& worth) {
  worth.slopes[slope.set].mean += factor * slope.mean;
  worth.slopes[slope.set].variance += factor * slope.variance;
}

}  // namespace

void Objective::linearize(const Moments* moments, double dimming, const Prices& prices,
                          LinearWorth& worth) const {
  assert(mayLinearize());
  worth.edges.clear();
  worth.slopes.clear();
  for (std::uint32_t s = 0; s < sets_.size(); ++s) worth.slopes.push_back({s, 0, 0});
  double undimmed = 0;
  for (const Term& term : terms_) {
    const auto [value, slope] = slopeOf(term.statistic, term.set, 0, moments[term.set]);
    if (term.target > 0) {  // |x| = 2 max(0, x) - x
      const double weight = prices.aimShare * term.factor / term.target;
      add(slope, -weight * dimming, worth);
      worth.edges.push_back(
          {scaled(slope, 2 * weight * dimming), 2 * weight * (dimming * value - term.target)});
    } else {
      add(slope, term.factor * dimming, worth);
      undimmed += term.factor * value;
    }
  }
  bool isFree = dimmingLow_ < dimming && dimming < dimmingHigh_;
  for (const Bound& bound : sides_) {
    const bool isLower = bound.side == Side::kLower;
    const auto [value, slope] =
        slopeOf(bound.statistic, bound.set, isLower ? -bound.alpha : bound.alpha, moments[bound.set]);
    // It is broken where even the end of the range does not meet it.
    const double price = (isLower ? -prices.penalty : prices.penalty) * bound.perUnit,
                 end = isLower ? dimmingHigh_ : dimmingLow_;
    worth.edges.push_back({scaled(slope, price * end), price * (end * value - bound.value)});
    if (!isFree || std::fabs(dimming * value - bound.value) > kHoldingBound * std::fabs(bound.value))
      continue;
    add(slope, -undimmed * dimming / value, worth);  // the dimming follows the bound
    isFree = false;
  }
}

}  // namespace fiatlux
