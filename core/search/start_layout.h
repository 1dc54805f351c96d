// Layouts to begin from: spread evenly, at random, or a given one fitted to new rules. All keep pinned
// luminaires where they are, leave excluded sites free and respect the minimum distance.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/random.h"
#include "core/search/intentions.h"
#include "core/search/prepared_scene.h"

namespace fiatlux {

/// Room for `rules.count` luminaires, found by trying many orders of the sites; the longest packing found, so
/// a result shorter than `rules.count` means that there is (almost certainly) no room. Deterministic.
std::vector<std::uint32_t> packSites(const PreparedScene& prepared, const LuminaireRules& rules);

/// A fixed layout that depends on nothing but scene and rules: free sites at even steps of their numbering.
std::vector<std::uint32_t> spreadSites(const PreparedScene& prepared, const LuminaireRules& rules);

/// A random layout.
std::vector<std::uint32_t> randomSites(const PreparedScene& prepared, const LuminaireRules& rules,
                                       Random& random);

/// `given` as far as the rules allow: pins first, then its sites in order; what is missing is filled from
/// `spreadSites`' order, what is too many is dropped from the end.
std::vector<std::uint32_t> fittedSites(const PreparedScene& prepared, const LuminaireRules& rules,
                                       const std::vector<std::uint32_t>& given);

}  // namespace fiatlux
