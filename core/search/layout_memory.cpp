// Layouts kept and crossed; see layout_memory.h.
#include "core/search/layout_memory.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace fiatlux {
namespace {

constexpr std::uint32_t kDirectionSteps = 1001;

using Numbers = std::vector<std::uint32_t>;

/// Of each candidate its sites' positions, added.
std::vector<Vec3> positionsOf(const PreparedScene& prepared) {
  std::vector<Vec3> positions(prepared.candidateCount(), Vec3{0, 0, 0});
  std::vector<std::uint32_t> members;
  for (std::uint32_t candidate = 0; candidate < positions.size(); ++candidate) {
    members.clear();
    prepared.appendSites(candidate, members);
    for (const std::uint32_t site : members) positions[candidate] += prepared.scene().sites[site].position;
  }
  return positions;
}

/// Some way across a room. Without a sine, which machines round differently.
Vec3 anyDirection(Random& random) {
  const auto component = [&] {
    return static_cast<double>(random.below(2 * kDirectionSteps)) - (kDirectionSteps - 0.5);
  };
  const double x = component(), y = component(), z = component();
  return {x, y, z};
}

}  // namespace

LayoutMemory::LayoutMemory(const PreparedScene& prepared, std::vector<double> flux)
    : flux_(std::move(flux)),
      isOneFlux_(std::all_of(flux_.begin(), flux_.end(), [&](double each) { return each == flux_[0]; })),
      positions_(positionsOf(prepared)),
      fluxOn_(prepared.candidateCount(), 0) {}

std::vector<std::uint32_t> LayoutMemory::keyOf(Numbers sites) const {
  if (isOneFlux_) std::sort(sites.begin(), sites.end());
  return sites;
}

std::uint32_t LayoutMemory::distanceTo(const Numbers& sites) {
  const std::size_t count = sites.size();
  for (std::size_t i = 0; i < count; ++i) fluxOn_[sites[i]] = flux_[i];
  std::uint32_t most = 0;
  for (const Kept& kept : kept_) {
    std::uint32_t alike = 0;
    for (std::size_t i = 0; i < count; ++i) alike += fluxOn_[kept.sites[i]] == flux_[i] ? 1 : 0;
    most = std::max(most, alike);
  }
  for (const std::uint32_t site : sites) fluxOn_[site] = 0;
  return static_cast<std::uint32_t>(count) - most;
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

/// Luminaires by what `key` says of each, those alike as they stood.
template <class Key>
void LayoutMemory::orderBy(Key key, Numbers& luminaires) {
  order_.clear();
  for (const std::uint32_t i : luminaires)
    order_.push_back({key(i), static_cast<std::uint32_t>(order_.size()), i});
  std::sort(order_.begin(), order_.end());
  for (std::size_t k = 0; k < order_.size(); ++k) luminaires[k] = order_[k].luminaire;
}

/// Out of `luminaires` those whose site under `sites` none of `others` has under `otherSites`.
void LayoutMemory::takeElsewhere(const Numbers& luminaires, const Numbers& sites, const Numbers& others,
                                 const Numbers& otherSites, Numbers& out) {
  out.clear();
  for (const std::uint32_t i : luminaires)
    if (std::none_of(others.begin(), others.end(),
                     [&](std::uint32_t j) { return otherSites[j] == sites[i]; }))
      out.push_back(i);
}

void LayoutMemory::cross(FreeSites& freeSites, Random& random, Numbers& child) {
  assert(hasParents() && freeSites.movable().size() > 1);
  const auto count = static_cast<std::uint32_t>(kept_.size());
  const std::uint32_t first = random.below(count), second = (first + 1 + random.below(count - 1)) % count;
  child = kept_[first].sites;
  const Numbers& other = kept_[second].sites;

  // Behind the line as many luminaires of each parent, so that their number stays.
  const Vec3 direction = anyDirection(random);
  leaving_ = coming_ = freeSites.movable();
  orderBy([&](std::uint32_t i) { return dot(direction, positions_[child[i]]); }, leaving_);
  orderBy([&](std::uint32_t i) { return dot(direction, positions_[other[i]]); }, coming_);
  const auto cut = 1 + random.below(static_cast<std::uint32_t>(leaving_.size()) - 1);
  leaving_.erase(leaving_.begin(), leaving_.begin() + cut);
  coming_.erase(coming_.begin(), coming_.begin() + cut);

  // Sites that both have there keep who is on them; the others go to sites of like flux, as far as they can.
  takeElsewhere(leaving_, child, coming_, other, movers_);
  takeElsewhere(coming_, other, leaving_, child, targets_);
  if (!isOneFlux_)
    for (Numbers* luminaires : {&movers_, &targets_})
      orderBy([&](std::uint32_t i) { return flux_[i]; }, *luminaires);
  freeSites.load(child);
  for (std::size_t k = 0; k < movers_.size(); ++k) {
    const std::uint32_t from = child[movers_[k]], to = other[targets_[k]];
    if (!freeSites.mayMove(from, to)) continue;
    freeSites.relocate(from, to);
    child[movers_[k]] = to;
  }
}

}  // namespace fiatlux
