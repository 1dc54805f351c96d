// What layouts may take of the candidates, as far as a relaxation's corners can be told: how many of each
// type, and groups within a type no two of which may be there at once, as ways to hang at one place or places
// nearer to each other than the least distance. Types hold whole groups, so that the best corner is found by
// taking the best candidates first (a laminar matroid).
#pragma once

#include <cstdint>
#include <vector>

#include "core/search/intentions.h"
#include "core/search/prepared_scene.h"

namespace fiatlux {

struct ExclusiveGroups {
  std::vector<std::uint32_t> type, group;  // of each candidate
  std::vector<TypeRange> ranges;           // of each type
  std::uint32_t groupCount = 0;            // a layout has at most one of each

  /// What the pinned luminaires leave of it: candidates that they keep away are of no group (kNone).
  static ExclusiveGroups of(const PreparedScene& prepared, const LuminaireRules& rules);
};

}  // namespace fiatlux
