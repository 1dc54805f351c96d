// Where no layout meets every bound: the search takes the one that misses them by the least, however it
// hangs. Among those that miss them by hardly more the goals decide; these intentions ask for that.
#pragma once

#include <vector>

#include "core/search/intentions.h"
#include "core/search/shown.h"

namespace fiatlux {

/// A bound that is missed by no more counts as met to a person: of the bound. One of true extremes does not.
inline constexpr double kHardlyMissed = 0.001;

/// What is asked, with every bound that a layout misses eased to what is reached there and a hundredth of
/// that less, so that it is met by that layout; one that counts as met is eased to where it still does, and
/// the others stay. `readings`: of that layout, one a
/// constraint.
Intentions easedToReach(const Intentions& intentions, const std::vector<ConstraintReading>& readings);

}  // namespace fiatlux
