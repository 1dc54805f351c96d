// The intentions in terms of who holds a luminaire, z in {0, 1}: what PairRelaxation is told of layouts, and
// the goal as factor x sigma + rest.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/bound/pair_relaxation.h"
#include "core/bound/relaxed_intentions.h"
#include "core/search/prepared_scene.h"

namespace fiatlux {

/// Over the m sites that are free to take a luminaire; pinned ones are summed up in the constants. Aims are
/// forms of `layouts`.
struct PairGoal {
  PairProblem layouts;
  double factor = 0;           // of sigma; 0: there is none
  std::vector<double> square;  // sigma^2 = z square z + squareConstant; m x m, row-major
  double squareConstant = 0;
  std::vector<double> linear;  // rest = linear z + constant + what the aims miss
  double constant = 0;
  double incumbent = 0;  // the goal of the best layout known

  /// Of all layouts under the rules.
  double leastLinear() const;
  double mostLinear() const;
};

/// `problem` as relaxIntentions gives it; its `incumbent` is left to the caller. Nothing where it does not
/// apply: ties, several numbers of luminaires, different fluxes, a range of the dimming, more than one sigma
/// in the goal, too many sites.
std::optional<PairGoal> pairGoalOf(const PreparedScene& prepared, const LuminaireRules& rules,
                                   const RelaxedIntentions& problem);

}  // namespace fiatlux
