// Free sites and gatherings; see free_sites.h.
#include "core/search/free_sites.h"

#include <algorithm>

namespace fiatlux {
namespace {
constexpr std::uint32_t kNever = 1u << 30;
constexpr std::uint32_t kMostRemembered = 2048;  // candidates of whose conflicts lists are kept
}  // namespace

FreeSites::FreeSites(const PreparedScene& prepared, const LuminaireRules& rules, std::uint32_t slots)
    : prepared_(prepared),
      minDistance_(rules.minDistance),
      counts_(prepared.isTied() && (countVaries(rules) || prepared.lightest() != prepared.heaviest())),
      types_(prepared.scene(), rules),
      least_(rules.count),
      most_(mostOf(rules)),
      excluded_(prepared.candidateCount(), 0),
      blocked_(prepared.candidateCount(), 0) {
  for (std::uint32_t site : rules.excluded) excluded_[site] = 1;
  for (std::uint32_t i = 0; i < slots; ++i)
    if (!isPinned(rules, i)) movable_.push_back(i);
}

void FreeSites::load(const std::vector<std::uint32_t>& sites) {
  for (std::size_t site = 0; site < blocked_.size(); ++site) blocked_[site] = excluded_[site] ? kNever : 0;
  total_ = 0;
  types_.clear();
  for (std::uint32_t site : sites) block(site, +1);
}

void FreeSites::relocate(std::uint32_t from, std::uint32_t to) {
  block(from, -1);
  block(to, +1);
}

void FreeSites::block(std::uint32_t site, int change) {
  total_ += static_cast<std::uint32_t>(change) * prepared_.weight(site);
  types_.add(prepared_.typeOf(site), change * static_cast<int>(prepared_.weight(site)));
  if (minDistance_ <= 0 && (prepared_.isTied() || !prepared_.hasBodies())) {
    if (!prepared_.isTied())
      blocked_[site] += static_cast<std::uint32_t>(change);
    else if (site != prepared_.nobody())
      for (const std::uint32_t other : prepared_.overlapping(site))
        blocked_[other] += static_cast<std::uint32_t>(change);
    return;
  }
  for (const std::uint32_t other : inTheWayOf(site)) blocked_[other] += static_cast<std::uint32_t>(change);
}

/// The sites that may not be taken with this one, which is among them.
const std::vector<std::uint32_t>& FreeSites::inTheWayOf(std::uint32_t site) {
  const bool remembers = blocked_.size() <= kMostRemembered;
  inTheWay_.resize(remembers ? blocked_.size() + 1 : 1);  // nobody too, after all sites
  std::vector<std::uint32_t>& list = inTheWay_[remembers ? site : 0];
  if (remembers && !list.empty()) return list;
  list.clear();
  for (std::uint32_t other = 0; other < blocked_.size(); ++other)
    if (conflict(site, other)) list.push_back(other);
  return list;
}

void FreeSites::nearMoves(std::uint32_t from, std::uint32_t reach, std::vector<std::uint32_t>& out) const {
  if (isNobody(from)) return farMoves(from, out);
  out.clear();
  const std::uint32_t* near = prepared_.nearSites(from);
  for (std::uint32_t k = 0; k < reach && k < prepared_.nearCount(); ++k)
    if (mayMove(from, near[k])) out.push_back(near[k]);
  if (counts_ && mayMove(from, prepared_.nobody())) out.push_back(prepared_.nobody());
}

void FreeSites::farMoves(std::uint32_t from, std::vector<std::uint32_t>& out) const {
  out.clear();
  for (std::uint32_t site = 0; site < blocked_.size(); ++site)
    if (site != from && mayMove(from, site)) out.push_back(site);
}

void FreeSites::anyNearMoves(std::uint32_t from, std::uint32_t reach, Random& random,
                             std::vector<std::uint32_t>& out) const {
  if (!counts_ && !types_.isAsked()) return nearMoves(from, reach, out);
  out.clear();
  const bool nobody = isNobody(from);
  const std::uint32_t* near = nobody ? nullptr : prepared_.nearSites(from);
  for (std::uint32_t k = 0; k < reach && k < prepared_.nearCount(); ++k) {
    const std::uint32_t to = nobody ? random.below(prepared_.candidateCount()) : near[k];
    if (isFree(from, to)) out.push_back(to);
  }
  if (counts_ && !nobody) out.push_back(prepared_.nobody());
}

void FreeSites::drawMoves(std::uint32_t from, std::uint32_t reach, std::uint32_t count, Random& random,
                          std::vector<std::uint32_t>& out) const {
  constexpr std::uint32_t kOneInTenAnywhere = 10;
  out.clear();
  const std::uint32_t near = isNobody(from) ? 0 : std::min(reach, prepared_.nearCount());
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t at = near == 0 ? 0 : random.below(near * kOneInTenAnywhere);
    const bool anywhere = at >= near * (kOneInTenAnywhere - 1);
    const std::uint32_t to = anywhere ? random.below(prepared_.candidateCount() + (counts_ ? 1 : 0))
                                      : prepared_.nearSites(from)[at % near];
    if (to != from && mayMove(from, to)) out.push_back(to);
  }
}

void FreeSites::around(std::uint32_t from, std::uint32_t near, std::uint32_t count, Random& random,
                       std::vector<std::uint32_t>& out) const {
  const std::uint32_t known = std::min(std::min(near, prepared_.nearCount()), count - 1);
  out.resize(count);
  out[0] = from;
  // Where many ways at one place are nearest, any of them and those of places around.
  const std::uint32_t reach = std::min(near * waysPerPlace(), prepared_.nearCount());
  for (std::uint32_t k = 0; k < known; ++k)
    out[1 + k] = prepared_.nearSites(from)[reach > known ? random.below(reach) : k];
  for (std::uint32_t k = 1 + known; k < count; ++k) out[k] = random.below(prepared_.candidateCount());
}

void FreeSites::gather(std::vector<std::uint32_t>& sites, std::uint32_t strength, Random& random) {
  const std::uint32_t center = random.below(prepared_.candidateCount());
  const std::uint32_t* near = prepared_.nearSites(center);
  std::uint32_t next = 0;  // 0: the centre itself, then its neighbours
  for (std::uint32_t k = 0; k < strength && !movable_.empty(); ++k) {
    const std::uint32_t i = randomMovable(random);
    for (; next <= prepared_.nearCount(); ++next) {
      const std::uint32_t to = next == 0 ? center : near[next - 1];
      if (to == sites[i] || !mayMove(sites[i], to)) continue;
      relocate(sites[i], to);
      sites[i] = to;
      break;
    }
  }
}

void FreeSites::gatherAll(std::vector<std::uint32_t>& sites, std::uint32_t center) {
  const std::uint32_t* near = prepared_.nearSites(center);
  std::vector<std::uint32_t> left = movable_;
  for (std::uint32_t next = 0; next <= prepared_.nearCount() && !left.empty(); ++next) {
    const std::uint32_t to = next == 0 ? center : near[next - 1];
    const auto isThere = [&](std::uint32_t i) { return sites[i] == to; };
    const auto mayCome = [&](std::uint32_t i) { return mayMove(sites[i], to); };
    auto taker = std::find_if(left.begin(), left.end(), isThere);
    if (taker == left.end()) taker = std::find_if(left.begin(), left.end(), mayCome);
    if (taker == left.end()) continue;
    if (sites[*taker] != to) relocate(sites[*taker], to);
    sites[*taker] = to;
    left.erase(taker);
  }
}

}  // namespace fiatlux
