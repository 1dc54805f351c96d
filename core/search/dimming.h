// The common dimming t, solved exactly for a given layout: a statistic that scales with t is t times its
// value at t = 1, so every constraint is an interval of t and the goal is linear in t between the few t at
// which an aim is met. Nothing is searched.
#pragma once

#include <cstdint>

#include "core/search/statistics.h"

namespace fiatlux {

/// One side of a constraint: t value >= bound for Side::kLower, else t value <= bound. A bound that does not
/// scale with the dimming (a ratio) has `scaleFree` set and reads value >= bound, value <= bound.
struct DimmedBound {
  double value = 0;  // of the statistic at t = 1
  double bound = 0;
  Side side = Side::kLower;
  bool scaleFree = false;
  double weight = 1;  // of its excess (missWeightOf)
};

/// A part of the goal that aims: weight x |t value - target| / target.
struct DimmedAim {
  double value = 0;  // of the statistic at t = 1
  double target = 1, weight = 0;
};

/// constant + slope t + the aims.
struct DimmedGoal {
  double slope = 0, constant = 0;
  const DimmedAim* aims = nullptr;
  std::uint32_t aimCount = 0;
};

/// What a layout is worth. Violations are compared before goals; both are better when smaller.
struct Evaluation {
  double violation = 0;  // sum of weight x excessOver
  double goal = 0;       // sum of weight x signed value / reference value
  double dimming = 1;
  double missed = 0;  // what missed aims add to the goal
};

/// Of no layout: any is better.
inline constexpr Evaluation kNothingFound{kUnbounded, kUnbounded, 1};

/// Better by more than the rounding of the sums.
inline bool isBetter(const Evaluation& a, const Evaluation& b) {
  constexpr double kSame = 1e-10;
  if (a.violation < b.violation - kSame) return true;
  if (a.violation > b.violation + kSame) return false;
  return a.goal < b.goal - kSame;
}

/// Violation at a given t: sum of weight x excessOver.
double violationAt(const DimmedBound* bounds, std::uint32_t count, double t);

/// The best t in [low, high], 0 <= low <= high: within the interval that meets all bounds the one that the
/// goal likes best (the brightest when it does not care); the t of least violation, exactly, when that
/// interval is empty. Bounds that are scale-free add the same violation at any t.
Evaluation solveDimming(const DimmedBound* bounds, std::uint32_t count, const DimmedGoal& goal, double low,
                        double high);

}  // namespace fiatlux
