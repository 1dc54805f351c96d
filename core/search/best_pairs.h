// A neighbourhood of the local search: two luminaires at once, each to one of the few sites that are best for
// it alone, wherever these lie. What one does to a bound the other may mend, so a site is chosen at the price
// of broken bounds that the last walk has learned. Where trials may be surveyed.
#pragma once

#include <cstdint>

#include "core/search/neighborhood.h"

namespace fiatlux {

/// A scan of all pairs; of none before a walk, or beside one that it would take long for.
void openBestPairs(const Surroundings& at, Scan& scan);
/// As of a row (neighborhood.h).
std::uint32_t tryBestPairs(const Surroundings& at, Scan& scan, std::uint32_t limit);

}  // namespace fiatlux
