// Exact common dimming by intervals and breakpoints; see dimming.h.
#include "core/search/dimming.h"

#include <algorithm>
#include <cassert>

namespace fiatlux {
namespace {

double excessAt(const DimmedBound& b, double t) {
  return b.weight * excessOver(b.bound, b.side, b.scaleFree ? b.value : t * b.value);
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

double missedAt(const DimmedGoal& goal, double t) {
  double sum = 0;
  for (std::uint32_t i = 0; i < goal.aimCount; ++i)
    sum += goal.aims[i].weight * distanceFrom(goal.aims[i].target, t * goal.aims[i].value);
  return sum;
}

/// What of the goal depends on t.
double varyingAt(const DimmedGoal& goal, double t) { return goal.slope * t + missedAt(goal, t); }

Evaluation evaluationAt(const DimmedGoal& goal, double violation, double t) {
  const double missed = missedAt(goal, t);
  return {violation, goal.constant + goal.slope * t + missed, t, missed};
}

/// Calls `consider` with every t in (low, high) at which an aim is met: there the goal may have its least
/// value.
template <class Consider>
void visitAims(const DimmedGoal& goal, double low, double high, Consider consider) {
  for (std::uint32_t i = 0; i < goal.aimCount; ++i) {
    if (goal.aims[i].value <= 0) continue;
    const double t = goal.aims[i].target / goal.aims[i].value;
    if (t > low && t < high) consider(t);
  }
}

/// The goal is convex and piecewise linear in t: it is least where an aim is met or at an end.
double bestWithin(const DimmedGoal& goal, double low, double high) {
  if (goal.aimCount == 0) return goal.slope > 0 ? low : high;
  double best = high, least = varyingAt(goal, high);
  const auto consider = [&](double t) {
    const double value = varyingAt(goal, t);
    if (!(value < least)) return;
    least = value;
    best = t;
  };
  consider(low);
  visitAims(goal, low, high, consider);
  return best;
}

/// The violation is convex and piecewise linear in t: its least value is at a breakpoint or at an end.
double leastViolationAt(const DimmedBound* bounds, std::uint32_t count, const DimmedGoal& goal, double low,
                        double high) {
  double best = goal.slope > 0 ? low : high;
  double least = violationAt(bounds, count, best);
  const auto consider = [&](double t) {
    const double violation = violationAt(bounds, count, t);
    if (violation < least || (violation == least && varyingAt(goal, t) < varyingAt(goal, best))) {
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
  visitAims(goal, low, high, consider);
  return best;
}

}  // namespace

double violationAt(const DimmedBound* bounds, std::uint32_t count, double t) {
  double sum = 0;
  for (std::uint32_t i = 0; i < count; ++i) sum += excessAt(bounds[i], t);
  return sum;
}

Evaluation solveDimming(const DimmedBound* bounds, std::uint32_t count, const DimmedGoal& goal, double low,
                        double high) {
  assert(0 <= low && low <= high);
  if (low == high) return evaluationAt(goal, violationAt(bounds, count, low), low);
  double first = low, last = high, scaleFree = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (bounds[i].scaleFree)
      scaleFree += excessAt(bounds[i], 1);
    else
      narrow(bounds[i], first, last);
  }
  if (first <= last) {
    return evaluationAt(goal, scaleFree, bestWithin(goal, first, last));
  }
  const double t = leastViolationAt(bounds, count, goal, low, high);
  return evaluationAt(goal, violationAt(bounds, count, t), t);
}

}  // namespace fiatlux
