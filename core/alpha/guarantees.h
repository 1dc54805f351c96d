// Guarantees: that every patch of a surface set keeps a bound. Their Chebyshev form, equation (15) of the
// paper, and what the true patches of a layout say of them.
#pragma once

#include "core/base/result.h"
#include "core/scene/scene.h"
#include "core/search/intentions.h"
#include "core/search/patch_extremes.h"

namespace fiatlux {

/// A true minimum bounded from below, or a true maximum bounded from above.
bool isGuarantee(const Constraint& constraint);

/// checkIntentions, that there is a guarantee to find an alpha for, and that no goal is near a target: how
/// its value moves with alpha says nothing.
Result<Done> checkAlphaIntentions(const Scene& scene, const Intentions& intentions);

/// The Chebyshev problem of the paper: each guaranteed minimum and maximum replaced by mu -/+ alpha sigma.
Intentions chebyshevProblem(const Intentions& intentions, double alpha);

/// By how much a guarantee is broken, as a share of its bound; at most 0 where it is kept with its margin.
double shortfallOf(const Constraint& guarantee, const Extremes& extremes);

}  // namespace fiatlux
