// The intentions in terms of who holds a luminaire, z in {0, 1}: what PairRelaxation is told of layouts, and
// the goal as t (factor x sigma + rest), t the common dimming and sigma that of full light. What does not
// change with t is 1 / t of it in the brackets.
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
  double inverseLow = 1, inverseHigh = 1;  // range of 1 / t
  double factor = 0;                       // of sigma; 0: there is none
  std::vector<double> square;              // sigma^2 = z square z + squareConstant; m x m, row-major
  double squareConstant = 0;
  std::vector<double> linear;  // rest = linear z + constant + what the aims miss / t
  double constant = 0;
  double incumbent = 0, inverse = 1;  // the goal of the best layout known, and its 1 / t

  /// Least and most of a form among the layouts of so many luminaires of each kind.
  double leastOf(const std::vector<double>& form) const;
  double mostOf(std::vector<double> form) const;
};

/// `problem` as relaxIntentions gives it; `incumbent` and `inverse` are left to the caller. Nothing where it
/// does not apply: ties, several numbers of luminaires, different fluxes, more than one sigma in the goal, a
/// dimming to nothing, too many sites.
std::optional<PairGoal> pairGoalOf(const PreparedScene& prepared, const LuminaireRules& rules,
                                   const RelaxedIntentions& problem);

}  // namespace fiatlux
