// Counts and ranges; see type_counts.h.
#include "core/search/type_counts.h"

#include <algorithm>

namespace fiatlux {

std::uint32_t typeCountOf(const Scene& scene) {
  std::uint32_t count = 0;
  for (const Hanging& hanging : scene.hangings) count = std::max(count, hanging.type + 1);
  return count;
}

std::vector<TypeRange> rangesOf(const LuminaireRules& rules, std::uint32_t types) {
  std::vector<TypeRange> ranges = rules.types;
  ranges.resize(std::max<std::size_t>(ranges.size(), types));
  std::vector<std::uint32_t> fixed(ranges.size(), 0);
  for (const std::uint32_t type : rules.ofType)
    if (type < fixed.size()) ++fixed[type];
  for (std::size_t t = 0; t < ranges.size(); ++t) ranges[t].least = std::max(ranges[t].least, fixed[t]);
  return ranges;
}

TypeCounts::TypeCounts(const Scene& scene, const LuminaireRules& rules)
    : ranges_(rangesOf(rules, typeCountOf(scene))) {
  const auto saysNothing = [&](const TypeRange& range) {
    return range.least == 0 && range.most >= mostOf(rules);
  };
  if (std::all_of(ranges_.begin(), ranges_.end(), saysNothing)) ranges_.clear();
  clear();
}

bool TypeCounts::areMet() const {
  for (std::size_t t = 0; t < ranges_.size(); ++t)
    if (counts_[t] < ranges_[t].least || counts_[t] > ranges_[t].most) return false;
  return true;
}

bool TypeCounts::allow(const Change* changes, std::uint32_t count) const {
  const auto isAllowed = [&](std::uint32_t type) {
    std::uint32_t after = counts_[type];
    for (std::uint32_t k = 0; k < count; ++k) {
      if (changes[k].toType == type) after += changes[k].to;
      if (changes[k].fromType == type) after -= changes[k].from;
    }
    return after >= ranges_[type].least && after <= ranges_[type].most;
  };
  for (std::uint32_t k = 0; k < count; ++k)
    if (!isAllowed(changes[k].fromType) || !isAllowed(changes[k].toType)) return false;
  return true;
}

bool TypeCounts::allowAlone(std::uint32_t type, std::uint32_t luminaires) const {
  for (std::uint32_t t = 0; t < ranges_.size(); ++t) {
    const std::uint32_t count = t == type ? luminaires : 0;
    if (count < ranges_[t].least || count > ranges_[t].most) return false;
  }
  return true;
}

bool TypeCounts::leaveRoom(std::uint32_t type, std::uint32_t luminaires, std::uint32_t left) const {
  if (!isAsked()) return true;
  if (counts_[type] + luminaires > ranges_[type].most) return false;
  std::uint32_t missing = 0;
  for (std::uint32_t t = 0; t < ranges_.size(); ++t) {
    const std::uint32_t there = counts_[t] + (t == type ? luminaires : 0);
    missing += ranges_[t].least - std::min(there, ranges_[t].least);
  }
  return missing <= left;
}

}  // namespace fiatlux
