// A search for each choice of followers; see near_search.h.
#include "core/search/near_search.h"

#include <algorithm>
#include <utility>

#include "core/search/start_layout.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kNeighbours = 8;  // that followers are chosen from: 70 choices of four
constexpr std::uint32_t kOfEach = 1500;   // evaluations for each choice

/// The luminaires that may follow, nearest to what was moved first.
std::vector<std::uint32_t> neighboursOf(const PreparedScene& prepared, const LuminaireRules& rules,
                                        const Layout& start, const std::vector<std::uint32_t>& moved) {
  const auto isIn = [](const std::vector<std::uint32_t>& list, std::uint32_t value) {
    return std::find(list.begin(), list.end(), value) != list.end();
  };
  std::vector<std::pair<double, std::uint32_t>> others;
  for (std::uint32_t i = 0; i < start.sites.size(); ++i) {
    if (isIn(moved, i) || isIn(rules.pinned, start.sites[i])) continue;
    double away = kUnbounded;
    for (const std::uint32_t m : moved)
      away = std::min(away, prepared.distance(start.sites[i], start.sites[m]));
    others.emplace_back(away, i);
  }
  std::sort(others.begin(), others.end());
  if (others.size() > kNeighbours) others.resize(kNeighbours);
  std::vector<std::uint32_t> result;
  for (const auto& [away, i] : others) result.push_back(i);
  return result;
}

/// Everything stays but these.
Intentions heldBut(const Intentions& intentions, const Layout& start,
                   const std::vector<std::uint32_t>& followers) {
  Intentions held = intentions;
  LuminaireRules& rules = held.luminaires;
  rules.count = static_cast<std::uint32_t>(start.sites.size());
  rules.countHigh = 0;
  rules.pinned = start.sites;
  for (const std::uint32_t i : followers) rules.pinned[i] = kNone;
  return held;
}

/// Do those that stay keep their distance, and is there room for the others?
bool isPossible(const PreparedScene& prepared, const LuminaireRules& rules) {
  for (std::uint32_t i = 0; i < rules.pinned.size(); ++i)
    for (std::uint32_t j = 0; j < i; ++j)
      if (isPinned(rules, i) && isPinned(rules, j) &&
          prepared.conflict(rules.pinned[i], rules.pinned[j], rules.minDistance))
        return false;
  return packSites(prepared, rules).size() >= rules.count;
}

}  // namespace

std::unique_ptr<LayoutSearch> searchNear(PreparedScene& prepared, const Intentions& intentions,
                                         std::uint64_t seed, const Layout& start,
                                         const std::vector<std::uint32_t>& moved) {
  if (intentions.luminaires.arrangement.rule != Rule::kFree ||
      start.sites.size() < intentions.luminaires.count || start.sites.size() > mostOf(intentions.luminaires))
    return nullptr;
  const std::vector<std::uint32_t> neighbours = neighboursOf(prepared, intentions.luminaires, start, moved);
  if (neighbours.empty()) return nullptr;
  // Every choice of so many of the neighbours, as marks in the order of the nearest first.
  std::vector<char> chosen(neighbours.size(), 0);
  std::fill_n(chosen.begin(), std::min<std::size_t>(kMostFollowers, chosen.size()), 1);
  // Goals are scaled as in a search of all luminaires, so that choices can be compared, and with that one.
  const Layout reference{spreadSites(prepared, intentions.luminaires), {}, 1};
  std::unique_ptr<LayoutSearch> best;
  do {
    std::vector<std::uint32_t> followers;
    for (std::size_t k = 0; k < chosen.size(); ++k)
      if (chosen[k]) followers.push_back(neighbours[k]);
    const Intentions held = heldBut(intentions, start, followers);
    if (!isPossible(prepared, held.luminaires)) continue;
    auto search = std::make_unique<LayoutSearch>(prepared, held, seed, &start, &reference);
    search->advance(kOfEach);
    if (!best || isBetter(search->evaluation(), best->evaluation())) best = std::move(search);
  } while (std::prev_permutation(chosen.begin(), chosen.end()));
  return best;
}

}  // namespace fiatlux
