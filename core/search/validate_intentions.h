// Are these intentions meaningful in this scene? Said once, before any search, in one line for a person.
#pragma once

#include "core/base/result.h"
#include "core/scene/scene.h"
#include "core/search/intentions.h"

namespace fiatlux {

/// Whose goals they are: a person's, or those of a search for the best bound that is feasible, which may be a
/// true minimum or maximum too.
enum class Asking : std::uint8_t { kPerson, kBoundSearch };

/// Done, or the first thing that is wrong with the intentions: what, where, and the cure. Every search and
/// evaluator requires that this passed.
Result<Done> checkIntentions(const Scene& scene, const Intentions& intentions,
                             Asking asking = Asking::kPerson);

/// The same of the luminaires alone: is there room for them in this scene as they are asked for?
Result<Done> checkRules(const Scene& scene, const LuminaireRules& rules);

}  // namespace fiatlux
