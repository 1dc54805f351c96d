// Are these intentions meaningful in this scene? Said once, before any search, in one line for a person.
#pragma once

#include "core/base/result.h"
#include "core/scene/scene.h"
#include "core/search/intentions.h"

namespace fiatlux {

/// Done, or the first thing that is wrong with the intentions: what, where, and the cure. Every search and
/// evaluator requires that this passed.
Result<Done> checkIntentions(const Scene& scene, const Intentions& intentions);

/// "floor", "floor + desk 1", or "all": a surface set as a person reads it.
std::string surfaceSetName(const Scene& scene, const SurfaceSet& surfaces);

}  // namespace fiatlux
