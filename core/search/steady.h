// Steadiness: among layouts that are worth hardly less than the best that was found, the one whose luminaires
// have walked least from where they were seen last.
#pragma once

#include "core/search/intentions.h"
#include "core/search/objective.h"
#include "core/search/prepared_scene.h"

namespace fiatlux {

inline constexpr double kSteadyShare = 0.005;  // of the goal: what steadiness may cost

/// A layout beside what it is worth.
struct Steadied {
  Layout layout;
  Evaluation evaluation;
};

/// `best` with luminaires back where they hung in `before`, one by one or two at once, those first that have
/// gone furthest: no bound is missed by more than in `best`, and the goal is behind it by at most
/// kSteadyShare. Luminaire i of one is luminaire i of the other (identity.h). The same as `best` where
/// luminaires are tied together, differ in flux, or the two layouts in their number. Precondition: `best` is
/// what a search for these intentions, without a reference of its own, has found; both layouts are of the
/// scene's sites.
Steadied steadied(PreparedScene& prepared, const Intentions& intentions, const Layout& best,
                  const Layout& before);

}  // namespace fiatlux
