// A problem of pairs as plain numbers: another thread, with a module of its own, reads them and goes on.
#pragma once

#include <optional>
#include <vector>

#include "core/bound/pair_goal.h"

namespace fiatlux {

std::vector<double> numbersOf(const PairGoal& goal);

/// Nothing where `numbers` are not what numbersOf writes.
std::optional<PairGoal> pairGoalFrom(const std::vector<double>& numbers);

}  // namespace fiatlux
