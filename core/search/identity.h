// Which luminaire is which: a new layout is matched to the one that was shown, so that each walks to a place
// near by and keeps its number, and all together the shortest way (optimal assignment; Kuhn 1955, Munkres
// 1957).
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/scene.h"
#include "core/search/intentions.h"

namespace fiatlux {

/// For each of `rows` rows its own column, so that the sum of costs is least. `cost`: rows x columns,
/// row-major, finite; rows <= columns. O(rows^2 columns).
std::vector<std::uint32_t> leastCostColumns(const std::vector<double>& cost, std::uint32_t rows,
                                            std::uint32_t columns);

/// The layout with its luminaires in another order: those of `before` keep their numbers, as many as there
/// are, and walk the shortest way; a pinned one is where it is pinned. Of luminaires with fluxes of their own
/// each keeps its number anyway.
Layout numberedAs(const Scene& scene, const LuminaireRules& rules, const Layout& layout,
                  const Layout& before);

/// The layout with some luminaires having changed numbers, so that each is of the type that it must be
/// (LuminaireRules::ofType), as far as there are enough of it; pinned ones keep theirs.
Layout ofTypesAsked(const Scene& scene, const LuminaireRules& rules, const Layout& layout);

}  // namespace fiatlux
