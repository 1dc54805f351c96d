// Groups of pairs that exclude each other; see exclusive_groups.h.
#include "core/bound/exclusive_groups.h"

#include <algorithm>

#include "core/search/type_counts.h"

namespace fiatlux {
namespace {

/// Of the candidates that have no group yet, nearest first, all that this one and each other exclude.
std::vector<std::uint32_t> groupAround(const PreparedScene& prepared, double minDistance,
                                       std::uint32_t candidate, const std::vector<char>& isFree) {
  std::vector<std::uint32_t> members = {candidate};
  const auto joins = [&](std::uint32_t other) {
    return isFree[other] && prepared.typeOf(other) == prepared.typeOf(candidate) &&
           std::all_of(members.begin(), members.end(),
                       [&](std::uint32_t member) { return prepared.conflict(other, member, minDistance); });
  };
  const std::uint32_t* near = prepared.nearSites(candidate);
  for (std::uint32_t k = 0; k < prepared.nearCount(); ++k)
    if (joins(near[k])) members.push_back(near[k]);
  return members;
}

}  // namespace

ExclusiveGroups ExclusiveGroups::of(const PreparedScene& prepared, const LuminaireRules& rules) {
  ExclusiveGroups result;
  result.ranges = rangesOf(rules, std::max(1u, typeCountOf(prepared.scene())));
  std::vector<std::uint32_t> pinned;
  for (std::uint32_t i = 0; i < rules.count; ++i) {
    if (!isPinned(rules, i)) continue;
    pinned.push_back(rules.pinned[i]);
    TypeRange& range = result.ranges[prepared.typeOf(rules.pinned[i])];
    if (range.least > 0) --range.least;
    if (range.most > 0 && range.most != kNone) --range.most;
  }
  const std::uint32_t candidates = prepared.candidateCount();
  std::vector<char> isFree(candidates, 1);
  for (std::uint32_t candidate = 0; candidate < candidates; ++candidate) {
    result.type.push_back(prepared.typeOf(candidate));
    for (const std::uint32_t pin : pinned)
      if (prepared.conflict(candidate, pin, rules.minDistance)) isFree[candidate] = 0;
  }
  result.group.assign(candidates, kNone);
  for (std::uint32_t candidate = 0; candidate < candidates; ++candidate) {
    if (!isFree[candidate]) continue;
    for (const std::uint32_t member : groupAround(prepared, rules.minDistance, candidate, isFree)) {
      result.group[member] = result.groupCount;
      isFree[member] = 0;
    }
    ++result.groupCount;
  }
  return result;
}

}  // namespace fiatlux
