// Luminaires called back; see steady.h.
#include "core/search/steady.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include "core/search/evaluator.h"
#include "core/search/shown.h"

namespace fiatlux {
namespace {

/// A layout under the hand: what it is worth, and how far its luminaires are from where they were.
class Recall {
 public:
  Recall(PreparedScene& prepared, const Intentions& intentions, const Layout& best, const Layout& before)
      : prepared_(prepared),
        rules_(intentions.luminaires),
        evaluator_(prepared, intentions),
        home_(before.sites),
        sites_(best.sites),
        evaluation_(evaluator_.evaluate(best.sites)),
        worst_(evaluation_) {
    worst_.goal += kSteadyShare * std::fabs(evaluation_.goal);
  }

  /// Calls back one luminaire after the other, then two at once, until nobody may come.
  void run() {
    for (bool isCalling = true; isCalling;) {
      isCalling = false;
      const std::vector<std::uint32_t> away = furthestFirst();
      for (const std::uint32_t i : away) isCalling |= tryHome({i});
      if (evaluator_.objective().needsExtremes()) continue;  // pairs would take too long
      for (std::size_t a = 0; a < away.size() && !isCalling; ++a)
        for (std::size_t b = a + 1; b < away.size() && !isCalling; ++b)
          isCalling = tryHome({away[a], away[b]});
    }
  }

  Steadied result(Layout layout) const {
    layout.sites = sites_;
    layout.dimming = evaluation_.dimming;
    return {std::move(layout), evaluation_};
  }

 private:
  double way(std::uint32_t i) const { return prepared_.distance(sites_[i], home_[i]); }

  std::vector<std::uint32_t> furthestFirst() const {
    std::vector<std::uint32_t> away;
    for (std::uint32_t i = 0; i < sites_.size(); ++i)
      if (sites_[i] != home_[i] && !isPinned(rules_, i)) away.push_back(i);
    std::stable_sort(away.begin(), away.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return way(a) > way(b); });
    return away;
  }

  bool tryHome(const std::vector<std::uint32_t>& luminaires) {
    std::vector<std::uint32_t> tried = sites_;
    for (const std::uint32_t i : luminaires) {
      if (tried[i] == home_[i]) return false;
      tried[i] = home_[i];
    }
    for (const std::uint32_t i : luminaires)
      if (!mayHang(tried, i)) return false;
    const Evaluation evaluation = evaluator_.evaluate(tried);
    if (evaluation.violation > worst_.violation || evaluation.goal > worst_.goal) return false;
    sites_ = std::move(tried);
    evaluation_ = evaluation;
    return true;
  }

  /// Is its place free under the rules, and its type what it was?
  bool mayHang(const std::vector<std::uint32_t>& sites, std::uint32_t i) const {
    if (prepared_.typeOf(sites[i]) != prepared_.typeOf(sites_[i])) return false;
    const std::vector<std::uint32_t>& excluded = rules_.excluded;
    if (std::find(excluded.begin(), excluded.end(), sites[i]) != excluded.end()) return false;
    for (std::uint32_t k = 0; k < sites.size(); ++k)
      if (k != i && (sites[k] == sites[i] || prepared_.conflict(sites[k], sites[i], rules_.minDistance)))
        return false;
    return true;
  }

  const PreparedScene& prepared_;
  const LuminaireRules& rules_;
  Evaluator evaluator_;
  const std::vector<std::uint32_t>& home_;
  std::vector<std::uint32_t> sites_;
  Evaluation evaluation_, worst_;  // where it stands; what it may come to
};

}  // namespace

Steadied steadied(PreparedScene& prepared, const Intentions& intentions, const Layout& best,
                  const Layout& before) {
  assert(checkLayout(prepared.scene(), best) && checkLayout(prepared.scene(), before));
  const LuminaireRules& rules = intentions.luminaires;
  Recall recall(prepared, intentions, best, before);
  const bool isFree = rules.arrangement.rule == Rule::kFree && rules.flux.size() == 1;
  if (isFree && best.sites.size() == before.sites.size() && best.sites.size() == mostOf(rules)) recall.run();
  return recall.result(best);
}

}  // namespace fiatlux
