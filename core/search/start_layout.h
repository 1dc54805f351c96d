// Layouts to begin from: spread evenly, at random, or a given one fitted to new rules. All keep pinned
// luminaires where they are, leave excluded sites free and respect the minimum distance. Sites are candidates
// of the prepared scene, of which ties count as many luminaires as they have; the rules' sites are, too.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/random.h"
#include "core/search/intentions.h"
#include "core/search/prepared_scene.h"

namespace fiatlux {

/// Luminaires of a layout.
std::uint32_t luminairesIn(const PreparedScene& prepared, const std::vector<std::uint32_t>& sites);

/// Room for `rules.count` luminaires, found by trying many orders of the sites; the longest packing found, so
/// a result shorter than `rules.count` means that there is (almost certainly) no room. Deterministic.
std::vector<std::uint32_t> packSites(const PreparedScene& prepared, const LuminaireRules& rules);

/// A fixed layout that depends on nothing but scene and rules: free sites at even steps of their numbering.
std::vector<std::uint32_t> spreadSites(const PreparedScene& prepared, const LuminaireRules& rules);

/// A random layout.
std::vector<std::uint32_t> randomSites(const PreparedScene& prepared, const LuminaireRules& rules,
                                       Random& random);

/// `given` as far as the rules allow: pinned luminaires on their sites, the others on its other sites in
/// order; what is missing is filled from `spreadSites`' order, what is too many is dropped from the end, and
/// no more than it has or must have. Where all of `given` is allowed and its pinned luminaires hang where
/// they are pinned, it is the result.
std::vector<std::uint32_t> fittedSites(const PreparedScene& prepared, const LuminaireRules& rules,
                                       const std::vector<std::uint32_t>& given);

/// The sites of `rules.pinned`, each held by the luminaire that hangs there in `given`, or else by the first
/// one that holds none: for LuminaireRules::pinned.
std::vector<std::uint32_t> pinsAsIn(const LuminaireRules& rules, const std::vector<std::uint32_t>& given);

}  // namespace fiatlux
