// What an alpha-search found, in a sentence or two for a designer.
#pragma once

#include <string>

#include "core/alpha/alpha_search.h"
#include "core/search/intentions.h"

namespace fiatlux {

/// `guarantee`: the one that is told of; where no alpha works, the one whose feasible bound was looked for.
/// Precondition: the search is done.
std::string alphaVerdict(const AlphaSearch& search, const Scene& scene, Quantity quantity,
                         const Constraint& guarantee);

}  // namespace fiatlux
