// A search for each choice of followers; see near_search.h.
#include "core/search/near_search.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/search/identity.h"
#include "core/search/shown.h"
#include "core/search/start_layout.h"
#include "core/search/steady.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kNeighbours = 24;   // that are asked how much they alone would do
constexpr std::uint32_t kHelpful = 11;      // of them, that followers are chosen from: 330 choices of four
constexpr std::size_t kScouted = 4;         // of them, those first that a search of all luminaires moves
constexpr std::uint32_t kScouting = 20000;  // evaluations of that,
constexpr std::uint32_t kGlance = 1000;     // evaluations for each choice,
constexpr std::uint32_t kLook = 6000;       // and for the best of them:
constexpr std::size_t kLookedAt = 20;
constexpr int kExchanges = 4;          // of one follower for another, each the best of
constexpr std::size_t kExchanged = 6;  // so many that are looked at

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

/// Searches for choices of followers.
class Choices {
 public:
  Choices(PreparedScene& prepared, const Intentions& intentions, std::uint64_t seed, const Layout& start)
      : prepared_(prepared),
        intentions_(intentions),
        seed_(seed),
        start_(start),
        // Goals are scaled as in a search of all luminaires, so that choices can be compared, and with that.
        reference_{spreadSites(prepared, intentions.luminaires), {}, 1} {}

  /// A first look at a choice; null where the rules leave these no room.
  std::unique_ptr<LayoutSearch> glanceAt(const std::vector<std::uint32_t>& followers) const {
    const Intentions held = heldBut(intentions_, start_, followers);
    if (!isPossible(prepared_, held.luminaires)) return nullptr;
    auto search = std::make_unique<LayoutSearch>(prepared_, held, seed_, &start_, &reference_);
    search->advance(kGlance);
    return search;
  }

 private:
  PreparedScene& prepared_;
  const Intentions& intentions_;
  std::uint64_t seed_;
  const Layout& start_;
  Layout reference_;
};

/// An order, unlike isBetter with its tolerance.
bool isAheadOf(const Evaluation& a, const Evaluation& b) {
  return std::pair(a.violation, a.goal) < std::pair(b.violation, b.goal);
}

/// Followers, and the search for how they follow.
struct Choice {
  std::vector<std::uint32_t> followers;
  std::unique_ptr<LayoutSearch> search;
};

/// The first `kept` of them, the best first.
void keepBest(std::vector<Choice>& tried, std::size_t kept) {
  std::stable_sort(tried.begin(), tried.end(), [](const Choice& a, const Choice& b) {
    return isAheadOf(a.search->evaluation(), b.search->evaluation());
  });
  if (tried.size() > kept) tried.resize(kept);
}

void lookAt(std::vector<Choice>& tried) {
  for (Choice& choice : tried) choice.search->advance(kLook);
}

/// Whoever of the neighbours goes elsewhere when all luminaires may, those first that go furthest.
std::vector<std::uint32_t> scouted(PreparedScene& prepared, const Intentions& intentions, std::uint64_t seed,
                                   const Layout& start, const std::vector<std::uint32_t>& neighbours) {
  Intentions asked = intentions;
  asked.luminaires.count = static_cast<std::uint32_t>(start.sites.size());
  asked.luminaires.countHigh = 0;
  asked.luminaires.pinned.resize(start.sites.size(), kNone);
  LayoutSearch search(prepared, asked, seed, &start);
  search.advance(kScouting);
  const Layout found = numberedAs(prepared.scene(), asked.luminaires, search.incumbent(), start);
  const Layout calm = steadied(prepared, asked, found, start).layout;
  const auto way = [&](std::uint32_t i) { return prepared.distance(start.sites[i], calm.sites[i]); };
  std::vector<std::uint32_t> gone;
  for (const std::uint32_t i : neighbours)
    if (start.sites[i] != calm.sites[i]) gone.push_back(i);
  std::stable_sort(gone.begin(), gone.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return way(a) > way(b); });
  if (gone.size() > kScouted) gone.resize(kScouted);
  return gone;
}

/// The `scouts`, and those of the other neighbours that do most on their own, the best first; where all are
/// few, as they come.
std::vector<std::uint32_t> mostHelpful(const Choices& choices, const std::vector<std::uint32_t>& neighbours,
                                       const std::vector<std::uint32_t>& scouts) {
  if (neighbours.size() <= kHelpful) return neighbours;
  std::vector<std::pair<Evaluation, std::uint32_t>> alone;
  const auto isScout = [&](std::uint32_t i) {
    return std::find(scouts.begin(), scouts.end(), i) != scouts.end();
  };
  for (const std::uint32_t i : neighbours)
    if (const auto search = isScout(i) ? nullptr : choices.glanceAt({i}))
      alone.emplace_back(search->evaluation(), i);
  std::stable_sort(alone.begin(), alone.end(),
                   [](const auto& a, const auto& b) { return isAheadOf(a.first, b.first); });
  std::vector<std::uint32_t> result = scouts;
  for (std::size_t k = 0; k < alone.size() && result.size() < kHelpful; ++k)
    result.push_back(alone[k].second);
  return result;
}

/// A glance at every choice of so many of the helpful, those of the first ones first; more than are looked at
/// are kept.
std::vector<Choice> bestOf(const Choices& choices, const std::vector<std::uint32_t>& helpful) {
  std::vector<int> chosen(helpful.size(), 0);
  std::fill_n(chosen.begin(), std::min<std::size_t>(kMostFollowers, chosen.size()), 1);
  std::vector<Choice> best;
  do {
    std::vector<std::uint32_t> followers;
    for (std::size_t k = 0; k < chosen.size(); ++k)
      if (chosen[k]) followers.push_back(helpful[k]);
    if (auto search = choices.glanceAt(followers)) best.push_back({followers, std::move(search)});
    if (best.size() == 2 * kLookedAt) keepBest(best, kLookedAt);
  } while (std::prev_permutation(chosen.begin(), chosen.end()));
  return best;
}

/// One of its followers for another neighbour, as long as that helps.
void exchange(const Choices& choices, const std::vector<std::uint32_t>& neighbours, Choice& best) {
  for (int round = 0; round < kExchanges; ++round) {
    std::vector<Choice> tried;
    for (std::size_t k = 0; k < best.followers.size(); ++k)
      for (const std::uint32_t i : neighbours) {
        std::vector<std::uint32_t> followers = best.followers;
        if (std::find(followers.begin(), followers.end(), i) != followers.end()) continue;
        followers[k] = i;
        if (auto search = choices.glanceAt(followers)) tried.push_back({followers, std::move(search)});
      }
    keepBest(tried, kExchanged);
    lookAt(tried);
    keepBest(tried, 1);
    if (tried.empty() || !isBetter(tried[0].search->evaluation(), best.search->evaluation())) return;
    best = std::move(tried[0]);
  }
}

}  // namespace

std::unique_ptr<LayoutSearch> searchNear(PreparedScene& prepared, const Intentions& intentions,
                                         std::uint64_t seed, const Layout& start,
                                         const std::vector<std::uint32_t>& moved) {
  assert(!start.sites.empty() && checkLayout(prepared.scene(), start));
  if (intentions.luminaires.arrangement.rule != Rule::kFree ||
      start.sites.size() < intentions.luminaires.count || start.sites.size() > mostOf(intentions.luminaires))
    return nullptr;
  const Choices choices(prepared, intentions, seed, start);
  const std::vector<std::uint32_t> neighbours = neighboursOf(prepared, intentions.luminaires, start, moved);
  const std::vector<std::uint32_t> helpful =
      mostHelpful(choices, neighbours, scouted(prepared, intentions, seed, start, neighbours));
  if (helpful.empty()) return nullptr;
  std::vector<Choice> best = bestOf(choices, helpful);
  if (best.empty()) return nullptr;
  keepBest(best, kLookedAt);
  lookAt(best);
  keepBest(best, 1);
  exchange(choices, neighbours, best.front());
  return std::move(best.front().search);
}

}  // namespace fiatlux
