// Searches side by side; see layout_search.h.
#include "core/search/layout_search.h"

#include <algorithm>
#include <cassert>

#include "core/search/identity.h"
#include "core/search/type_counts.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kFirstTurn = 400;  // evaluations of each entrant in the first round

/// The pinned luminaires get the numbers that they are pinned by; the others follow as they are.
Layout numbered(const Layout& layout, const LuminaireRules& rules) {
  const auto count = static_cast<std::uint32_t>(layout.sites.size());
  std::vector<std::uint32_t> order(count, kNone), rest;
  std::vector<char> placed(count, 0);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!isPinned(rules, i)) continue;
    const auto at = std::find(layout.sites.begin(), layout.sites.end(), rules.pinned[i]);
    if (at == layout.sites.end()) continue;
    order[i] = static_cast<std::uint32_t>(at - layout.sites.begin());
    placed[order[i]] = 1;
  }
  if (layout.ties.empty()) return layout;  // of sites: it has them already
  Layout result{{}, {}, layout.dimming};
  std::uint32_t next = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    while (order[i] == kNone && placed[next]) ++next;
    const std::uint32_t from = order[i] == kNone ? next++ : order[i];
    result.sites.push_back(layout.sites[from]);
    result.flux.push_back(layout.flux[from]);
    result.ties.push_back(layout.ties[from]);
  }
  return result;
}

bool isAhead(const Evaluation& a, const Evaluation& b) {
  return a.violation < b.violation || (a.violation == b.violation && a.goal < b.goal);
}

}  // namespace

LayoutSearch::LayoutSearch(PreparedScene& prepared, const Intentions& intentions, std::uint64_t seed,
                           const Layout* start, const Layout* reference, Entering entering)
    : scene_(prepared.scene()), rules_(intentions.luminaires) {
  assert(!prepared.isTied());
  if (rules_.arrangement.rule == Rule::kField) {
    fields_.emplace(prepared, intentions, reference);
    return;
  }
  missing_ = std::make_unique<Missing>(Missing{prepared, intentions, seed, reference, {}});
  const std::vector<std::uint32_t> given = start ? start->sites : std::vector<std::uint32_t>{};
  const bool ofSites = rules_.arrangement.rule == Rule::kFree && !countVaries(rules_);
  if (ofSites && typeCountOf(scene_) > 1) addStarts(given, true);
  if (!ofSites) addStarts(given, false);
  if (ofSites && missing_->starts.empty()) {
    missing_.reset();
    free_.emplace(prepared, intentions, seed, start, reference);
    return;
  }
  if (ofSites) enter({nullptr, std::make_unique<Vns>(prepared, intentions, seed, start, reference)});
  assert(!missing_->starts.empty());
  while (entering == Entering::kAtOnce && !enterNext()) continue;
}

/// What is to be searched: the layouts of all ties, where types are not only wanted alone, and of each
/// type's.
void LayoutSearch::addStarts(const std::vector<std::uint32_t>& given, bool onlyAlone) {
  std::vector<Ties> all = tiesUnder(missing_->prepared.grid(), rules_), alone;
  for (const Ties& ties : all)
    for (Ties& each : tiesOfEachType(scene_, ties, rules_)) alone.push_back(std::move(each));
  if (onlyAlone) all.clear();
  for (Ties& each : alone) all.push_back(std::move(each));
  for (const Ties& ties : all)
    for (TiedStart& from : startsOf(scene_, ties, rules_, given))
      missing_->starts.emplace_back(ties, std::move(from));
}

void LayoutSearch::enter(Entrant entrant) {
  ranking_.push_back(static_cast<std::uint32_t>(entrants_.size()));
  entrants_.push_back(std::move(entrant));
}

bool LayoutSearch::enterNext() {
  if (!missing_) return true;
  const auto& [ties, from] = missing_->starts[missing_->next++];
  Entrant entrant{missing_->prepared.tied(ties), nullptr};
  entrant.search = std::make_unique<Vns>(*entrant.scene, missing_->intentions,
                                         missing_->seed + entrants_.size(), from, missing_->reference);
  enter(std::move(entrant));
  if (missing_->next < missing_->starts.size()) return false;
  missing_.reset();
  begin();
  return true;
}

void LayoutSearch::begin() {
  std::stable_sort(ranking_.begin(), ranking_.end(), [&](std::uint32_t a, std::uint32_t b) {
    return isAhead(entrants_[a].search->evaluation(), entrants_[b].search->evaluation());
  });
  running_ = static_cast<std::uint32_t>(entrants_.size());
  left_ = perTurn_ = kFirstTurn;
  best_ = best().incumbent();
  bestEvaluation_ = best().evaluation();
}

void LayoutSearch::advance(std::uint32_t evaluations) {
  if (free_) return free_->advance(evaluations);
  if (fields_) return fields_->advance(evaluations);
  while (!enterNext()) continue;
  while (evaluations > 0) {
    Vns& search = *entrants_[ranking_[turn_]].search;
    const std::uint32_t slice = std::min(evaluations, left_);
    const std::uint64_t before = search.evaluations();
    search.advance(slice);
    evaluations_ += search.evaluations() - before;
    evaluations -= slice;
    left_ -= slice;
    if (left_ == 0) closeTurn();
  }
}

/// The next entrant's turn; after the last one of a round the better half goes on, for twice as long.
void LayoutSearch::closeTurn() {
  const Vns& search = *entrants_[ranking_[turn_]].search;
  if (isBetter(search.evaluation(), bestEvaluation_)) {
    foundAt_ = foundAt();
    best_ = search.incumbent();
    bestEvaluation_ = search.evaluation();
  }
  if (++turn_ == running_) {
    std::stable_sort(ranking_.begin(), ranking_.begin() + running_, [&](std::uint32_t a, std::uint32_t b) {
      return isAhead(entrants_[a].search->evaluation(), entrants_[b].search->evaluation());
    });
    const bool begin = running_ == 1;
    running_ = begin ? static_cast<std::uint32_t>(entrants_.size()) : (running_ + 1) / 2;
    perTurn_ = begin ? kFirstTurn : 2 * perTurn_;
    turn_ = 0;
  }
  left_ = perTurn_;
}

Layout LayoutSearch::incumbent() const {
  if (free_) return free_->incumbent();
  if (fields_) return ofTypesAsked(scene_, rules_, numbered(fields_->incumbent(), rules_));
  const Vns& search = *entrants_[ranking_[turn_]].search;
  Layout layout =
      numbered(isBetter(search.evaluation(), bestEvaluation_) ? search.incumbent() : best_, rules_);
  if (rules_.arrangement.rule == Rule::kFree) layout.ties.clear();
  return ofTypesAsked(scene_, rules_, layout);
}

const Evaluation& LayoutSearch::evaluation() const {
  if (free_) return free_->evaluation();
  if (fields_) return fields_->evaluation();
  const Evaluation& running = entrants_[ranking_[turn_]].search->evaluation();
  return isBetter(running, bestEvaluation_) ? running : bestEvaluation_;
}

std::uint64_t LayoutSearch::evaluations() const {
  return free_ ? free_->evaluations() : fields_ ? fields_->evaluations() : evaluations_;
}

std::uint64_t LayoutSearch::foundAt() const {
  if (free_) return free_->foundAt();
  if (fields_) return fields_->foundAt();
  const Vns& search = *entrants_[ranking_[turn_]].search;
  if (!isBetter(search.evaluation(), bestEvaluation_)) return foundAt_;
  return evaluations_ - (search.evaluations() - search.foundAt());
}

}  // namespace fiatlux
