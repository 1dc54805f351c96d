// Bounds that a layout reaches; see eased.h.
#include "core/search/eased.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace fiatlux {
namespace {

constexpr double kHardly = 0.01;  // of what is reached: so much more may be missed for the goals' sake
constexpr double kSurely = 0.99;  // a bound reached to the last digit may be read as missed

/// What is reached of a bound that is missed by `excess` (excessOver), and a little less, towards `side`.
/// `mayBeHardlyMissed`: what misses it by kHardlyMissed counts as met.
double easedBound(double bound, double excess, Side side, bool mayBeHardlyMissed) {
  if (mayBeHardlyMissed && bound != 0 && excess <= kHardlyMissed) {
    const double slack = std::max(excess, kSurely * kHardlyMissed) * std::fabs(bound);
    return side == Side::kLower ? bound - slack : bound + slack;
  }
  const double miss = bound == 0 ? excess : excess * std::fabs(bound);
  const double reached = side == Side::kLower ? bound - miss : bound + miss;
  const double slack = kHardly * std::fabs(reached);
  return side == Side::kLower ? reached - slack : reached + slack;
}

}  // namespace

Intentions easedToReach(const Intentions& intentions, const std::vector<ConstraintReading>& readings) {
  assert(readings.size() == intentions.constraints.size());
  Intentions eased = intentions;
  for (std::size_t c = 0; c < readings.size(); ++c) {
    Constraint& constraint = eased.constraints[c];
    const auto [below, above] = std::pair(readings[c].below, readings[c].above);
    const bool mayBe = !traitsOf(constraint.statistic).needsExtremes;
    if (below > 0) constraint.lower = easedBound(constraint.lower, below, Side::kLower, mayBe);
    if (above > 0 && constraint.statistic == Statistic::kUgr)
      constraint.upper = ugrOf(easedBound(ratioOf(constraint.upper), above, Side::kUpper, mayBe));
    else if (above > 0)
      constraint.upper = easedBound(constraint.upper, above, Side::kUpper, mayBe);
  }
  return eased;
}

}  // namespace fiatlux
