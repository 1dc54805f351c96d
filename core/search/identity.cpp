// Optimal assignment by shortest augmenting paths; see identity.h.
#include "core/search/identity.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace fiatlux {
namespace {

constexpr std::uint32_t kMostMatched = 250;  // luminaires: more would be felt in every answer
constexpr double kHeld = 1e6;  // m: what a pinned luminaire's own place is worth, or one of its own type

}  // namespace

std::vector<std::uint32_t> leastCostColumns(const std::vector<double>& cost, std::uint32_t rows,
                                            std::uint32_t columns) {
  assert(rows <= columns && cost.size() == std::size_t{rows} * columns);
  // Prices of rows and columns keep every reduced cost at 0 or above; column 0 stands for the row to be
  // matched.
  std::vector<double> rowPrice(rows + 1, 0), columnPrice(columns + 1, 0);
  std::vector<std::uint32_t> rowOf(columns + 1, 0), from(columns + 1, 0);
  for (std::uint32_t row = 1; row <= rows; ++row) {
    rowOf[0] = row;
    std::uint32_t at = 0;
    std::vector<double> least(columns + 1, kUnbounded);
    std::vector<char> seen(columns + 1, 0);
    do {  // Dijkstra to the nearest free column
      seen[at] = 1;
      const std::uint32_t i = rowOf[at];
      double step = kUnbounded;
      std::uint32_t next = 0;
      for (std::uint32_t j = 1; j <= columns; ++j) {
        if (seen[j]) continue;
        const double reduced = cost[std::size_t{i - 1} * columns + j - 1] - rowPrice[i] - columnPrice[j];
        if (reduced < least[j]) {
          least[j] = reduced;
          from[j] = at;
        }
        if (least[j] < step) {
          step = least[j];
          next = j;
        }
      }
      for (std::uint32_t j = 0; j <= columns; ++j)
        if (seen[j]) {
          rowPrice[rowOf[j]] += step;
          columnPrice[j] -= step;
        } else {
          least[j] -= step;
        }
      at = next;
    } while (rowOf[at] != 0);
    for (; at != 0; at = from[at]) rowOf[at] = rowOf[from[at]];
  }
  std::vector<std::uint32_t> result(rows, 0);
  for (std::uint32_t j = 1; j <= columns; ++j)
    if (rowOf[j] > 0) result[rowOf[j] - 1] = j - 1;
  return result;
}

namespace {

std::uint32_t typeAsked(const LuminaireRules& rules, std::uint32_t i) {
  return i < rules.ofType.size() ? rules.ofType[i] : kNone;
}

/// May luminaire i hang there?
bool isOfTypeAsked(const Scene& scene, const LuminaireRules& rules, std::uint32_t i, std::uint32_t site) {
  const std::uint32_t type = typeAsked(rules, i);
  return type == kNone || scene.hangings.empty() || scene.hangings[site].type == type;
}

}  // namespace

Layout ofTypesAsked(const Scene& scene, const LuminaireRules& rules, const Layout& layout) {
  Layout result = layout;
  const auto count = static_cast<std::uint32_t>(layout.sites.size());
  const auto mayTrade = [&](std::uint32_t i) {
    return !isPinned(rules, i) || rules.pinned[i] != result.sites[i];
  };
  for (std::uint32_t i = 0; i < count && i < rules.ofType.size(); ++i) {
    if (isOfTypeAsked(scene, rules, i, result.sites[i]) || !mayTrade(i)) continue;
    // One of the type that is not bound to its number by it.
    for (std::uint32_t k = 0; k < count; ++k) {
      if (!isOfTypeAsked(scene, rules, i, result.sites[k]) || !mayTrade(k)) continue;
      if (typeAsked(rules, k) != kNone && isOfTypeAsked(scene, rules, k, result.sites[k])) continue;
      std::swap(result.sites[i], result.sites[k]);
      if (!result.ties.empty()) std::swap(result.ties[i], result.ties[k]);
      break;
    }
  }
  return result;
}

Layout numberedAs(const Scene& scene, const LuminaireRules& rules, const Layout& layout,
                  const Layout& before) {
  const auto count = static_cast<std::uint32_t>(layout.sites.size());
  const auto kept = std::min(count, static_cast<std::uint32_t>(before.sites.size()));
  if (rules.flux.size() > 1 || count > kMostMatched || kept == 0) return layout;
  std::vector<double> cost;
  for (std::uint32_t i = 0; i < kept; ++i)
    for (std::uint32_t k = 0; k < count; ++k) {
      const bool isHeld = isPinned(rules, i) && rules.pinned[i] == layout.sites[k];
      const Vec3 way = scene.sites[layout.sites[k]].position - scene.sites[before.sites[i]].position;
      const bool isOther = !isOfTypeAsked(scene, rules, i, layout.sites[k]);
      cost.push_back(length(way) - (isHeld ? kHeld : 0) + (isOther ? kHeld : 0));
    }
  std::vector<std::uint32_t> order = leastCostColumns(cost, kept, count);
  std::vector<char> taken(count, 0);
  for (const std::uint32_t k : order) taken[k] = 1;
  for (std::uint32_t k = 0; k < count; ++k)
    if (!taken[k]) order.push_back(k);
  Layout result{{}, {}, layout.dimming};
  for (const std::uint32_t k : order) {
    result.sites.push_back(layout.sites[k]);
    result.flux.push_back(layout.flux[k]);
    if (!layout.ties.empty()) result.ties.push_back(layout.ties[k]);
  }
  return result;
}

}  // namespace fiatlux
