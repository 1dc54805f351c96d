// Layouts kept and crossed; see layout_memory.h.
#include "core/search/layout_memory.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace fiatlux {
namespace {

constexpr std::uint32_t kDirectionSteps = 1001;

using Numbers = std::vector<std::uint32_t>;

/// Luminaires by what `key` says of each, those alike as they stood.
template <class Key>
Numbers orderedBy(Numbers luminaires, Key key) {
  std::vector<std::pair<double, std::uint32_t>> order;
  order.reserve(luminaires.size());
  for (const std::uint32_t i : luminaires)
    order.emplace_back(key(i), static_cast<std::uint32_t>(order.size()));
  std::sort(order.begin(), order.end());
  Numbers sorted;
  sorted.reserve(order.size());
  for (const auto& [value, at] : order) sorted.push_back(luminaires[at]);
  return sorted;
}

/// Some way across a room. Without a sine, which machines round differently.
Vec3 anyDirection(Random& random) {
  const auto component = [&] {
    return static_cast<double>(random.below(2 * kDirectionSteps)) - (kDirectionSteps - 0.5);
  };
  const double x = component(), y = component(), z = component();
  return {x, y, z};
}

/// Those luminaires whose site under `sites` none of `others` has under `otherSites`.
Numbers elsewhere(const Numbers& luminaires, const Numbers& sites, const Numbers& others,
                  const Numbers& otherSites) {
  Numbers result;
  for (const std::uint32_t i : luminaires)
    if (std::none_of(others.begin(), others.end(),
                     [&](std::uint32_t j) { return otherSites[j] == sites[i]; }))
      result.push_back(i);
  return result;
}

}  // namespace

LayoutMemory::LayoutMemory(const PreparedScene& prepared, std::vector<double> flux)
    : prepared_(prepared),
      flux_(std::move(flux)),
      isOneFlux_(std::all_of(flux_.begin(), flux_.end(), [&](double each) { return each == flux_[0]; })) {}

std::vector<std::uint32_t> LayoutMemory::keyOf(Numbers sites) const {
  if (isOneFlux_) std::sort(sites.begin(), sites.end());
  return sites;
}

bool LayoutMemory::holds(const Numbers& sites) const {
  const Numbers key = keyOf(sites);
  return std::any_of(kept_.begin(), kept_.end(), [&](const Kept& kept) { return kept.key == key; });
}

bool LayoutMemory::offer(const Numbers& sites, const Evaluation& evaluation, std::size_t room) {
  Kept offered{sites, keyOf(sites), evaluation};
  if (std::any_of(kept_.begin(), kept_.end(), [&](const Kept& kept) { return kept.key == offered.key; }))
    return false;
  if (kept_.size() < room) {
    kept_.push_back(std::move(offered));
    return true;
  }
  const auto worst = std::max_element(kept_.begin(), kept_.end(), [](const Kept& a, const Kept& b) {
    return isBetter(a.evaluation, b.evaluation);
  });
  if (!isBetter(evaluation, worst->evaluation)) return false;
  *worst = std::move(offered);
  return true;
}

std::vector<std::uint32_t> LayoutMemory::cross(FreeSites& freeSites, Random& random) const {
  assert(hasParents() && freeSites.movable().size() > 1);
  const auto count = static_cast<std::uint32_t>(kept_.size());
  const std::uint32_t first = random.below(count), second = (first + 1 + random.below(count - 1)) % count;
  Numbers child = kept_[first].sites;
  const Numbers& other = kept_[second].sites;

  // Behind the line as many luminaires of each parent, so that their number stays.
  const Vec3 direction = anyDirection(random);
  Numbers members;
  const auto along = [&](std::uint32_t candidate) {
    members.clear();
    prepared_.appendSites(candidate, members);
    double sum = 0;
    for (const std::uint32_t site : members) sum += dot(direction, prepared_.scene().sites[site].position);
    return sum;
  };
  const Numbers& movable = freeSites.movable();
  const Numbers mine = orderedBy(movable, [&](std::uint32_t i) { return along(child[i]); }),
                theirs = orderedBy(movable, [&](std::uint32_t i) { return along(other[i]); });
  const auto cut = 1 + random.below(static_cast<std::uint32_t>(movable.size()) - 1);
  const Numbers leaving(mine.begin() + cut, mine.end()), coming(theirs.begin() + cut, theirs.end());

  // Sites that both have there keep who is on them; the others go to sites of like flux, as far as they can.
  const auto byFlux = [&](Numbers luminaires) {
    return isOneFlux_ ? luminaires
                      : orderedBy(std::move(luminaires), [&](std::uint32_t i) { return flux_[i]; });
  };
  const Numbers movers = byFlux(elsewhere(leaving, child, coming, other)),
                targets = byFlux(elsewhere(coming, other, leaving, child));
  freeSites.load(child);
  for (std::size_t k = 0; k < movers.size(); ++k) {
    const std::uint32_t from = child[movers[k]], to = other[targets[k]];
    if (!freeSites.mayMove(from, to)) continue;
    freeSites.relocate(from, to);
    child[movers[k]] = to;
  }
  return child;
}

}  // namespace fiatlux
