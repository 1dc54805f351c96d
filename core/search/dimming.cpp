// Exact common dimming by intervals and breakpoints; see dimming.h.
#include "core/search/dimming.h"

#include <algorithm>
#include <cassert>

namespace fiatlux {
namespace {

double excessAt(const DimmedBound& b, double t) {
  return excessOver(b.bound, b.side, b.scaleFree ? b.value : t * b.value);
}

/// The part of [low, high] that meets the bound; empty when low > high.
void narrow(const DimmedBound& b, double& low, double& high) {
  const bool lower = b.side == Side::kLower;
  if (b.value == 0) {
    if (lower ? b.bound > 0 : b.bound < 0) high = low - 1;
    return;
  }
  const double edge = b.bound / b.value;
  if ((b.value > 0) == lower)
    low = std::max(low, edge);
  else
    high = std::min(high, edge);
}

/// The violation is convex and piecewise linear in t: its least value is at a breakpoint or at an end.
double leastViolationAt(const DimmedBound* bounds, std::uint32_t count, double goalSlope, double low,
                        double high) {
  double best = goalSlope > 0 ? low : high;
  double least = violationAt(bounds, count, best);
  const auto consider = [&](double t) {
    const double violation = violationAt(bounds, count, t);
    if (violation < least || (violation == least && goalSlope * t < goalSlope * best)) {
      least = violation;
      best = t;
    }
  };
  consider(low);
  consider(high);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (bounds[i].scaleFree || bounds[i].value == 0) continue;
    const double edge = bounds[i].bound / bounds[i].value;
    if (edge > low && edge < high) consider(edge);
  }
  return best;
}

}  // namespace

double violationAt(const DimmedBound* bounds, std::uint32_t count, double t) {
  double sum = 0;
  for (std::uint32_t i = 0; i < count; ++i) sum += excessAt(bounds[i], t);
  return sum;
}

Evaluation solveDimming(const DimmedBound* bounds, std::uint32_t count, double goalSlope, double goalConstant,
                        double low, double high) {
  assert(0 <= low && low <= high);
  if (low == high) return {violationAt(bounds, count, low), goalConstant + goalSlope * low, low};
  double first = low, last = high, scaleFree = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (bounds[i].scaleFree)
      scaleFree += excessAt(bounds[i], 1);
    else
      narrow(bounds[i], first, last);
  }
  if (first <= last) {
    const double t = goalSlope > 0 ? first : last;
    return {scaleFree, goalConstant + goalSlope * t, t};
  }
  const double t = leastViolationAt(bounds, count, goalSlope, low, high);
  return {violationAt(bounds, count, t), goalConstant + goalSlope * t, t};
}

}  // namespace fiatlux
