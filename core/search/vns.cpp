// The search; see vns.h.
#include "core/search/vns.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/search/identity.h"
#include "core/search/start_layout.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kShakeReach = 16;     // how far a near shake throws
constexpr double kPenalties[3] = {1, 4, 16};  // goals that a violation of 100 % is worth, in a walk
constexpr std::uint32_t kIdleSteps = 20000;   // steps without a single trial: no site is free to go to
constexpr std::uint32_t kGatherings = 16;     // tried before the best of them is searched
constexpr std::uint32_t kRoundsOnBase = 1;    // rounds in vain before the search restarts elsewhere

std::vector<std::uint32_t> startSites(const PreparedScene& prepared, const LuminaireRules& rules,
                                      const Layout* start, Random& random) {
  return start ? fittedSites(prepared, rules, start->sites) : randomSites(prepared, rules, random);
}

}  // namespace

LuminaireRules tiedRules(const PreparedScene& prepared, const LuminaireRules& rules, const TiedStart& start) {
  LuminaireRules tied = rules;
  tied.pinned.assign(start.ties.begin(), start.ties.begin() + start.pinned);
  tied.excluded.clear();
  std::vector<char> barred(prepared.scene().sites.size(), 0);
  for (const std::uint32_t site : rules.excluded) barred[site] = 1;
  std::vector<std::uint32_t> members;
  for (std::uint32_t tie = 0; tie < prepared.candidateCount(); ++tie) {
    members.clear();
    prepared.appendSites(tie, members);
    const bool isBarred =
        std::any_of(members.begin(), members.end(), [&](std::uint32_t site) { return barred[site] != 0; });
    if (isBarred || prepared.innerDistance(tie) < rules.minDistance) tied.excluded.push_back(tie);
  }
  return tied;
}

Vns::Vns(PreparedScene& prepared, const Intentions& intentions, std::uint64_t seed, const Layout* start,
         const Layout* reference)
    : Vns(prepared, intentions, intentions.luminaires, seed, reference) {
  assert(!prepared.isTied() && !countVaries(intentions.luminaires));
  open(startSites(prepared_, rules_, start, random_));
}

Vns::Vns(PreparedScene& prepared, const Intentions& intentions, std::uint64_t seed, const TiedStart& start,
         const Layout* reference)
    : Vns(prepared, intentions, tiedRules(prepared, intentions.luminaires, start), seed, reference) {
  assert(prepared.isTied());
  open(inSlots(start.ties));
}

Vns::Vns(PreparedScene& prepared, const Intentions& intentions, const LuminaireRules& rules,
         std::uint64_t seed, const Layout* reference)
    : evaluator_(prepared, intentions, reference),
      freeSites_(prepared, rules, static_cast<std::uint32_t>(evaluator_.flux().size())),
      random_(seed),
      prepared_(prepared),
      rules_(rules) {
  areDifferent_ = prepared.waysPerPlace() > 1 && !prepared.isTied();
  for (double flux : evaluator_.flux()) areDifferent_ |= flux != evaluator_.flux()[0];
}

void Vns::open(const std::vector<std::uint32_t>& sites) {
  begin(sites);
  base_ = best_ = evaluator_.sites();
  baseEvaluation_ = bestEvaluation_ = evaluator_.current();
}

/// Of ties: what is pinned in front, nobody in the places that are left.
std::vector<std::uint32_t> Vns::inSlots(std::vector<std::uint32_t> ties) const {
  ties.resize(std::max(ties.size(), evaluator_.flux().size()), prepared_.nobody());
  return ties;
}

/// A layout to search from anew.
std::vector<std::uint32_t> Vns::somewhereElse() {
  std::vector<std::uint32_t> sites = randomSites(prepared_, rules_, random_);
  if (!prepared_.isTied()) return sites;
  return luminairesIn(prepared_, sites) < rules_.count ? best_ : inSlots(std::move(sites));
}

Layout Vns::incumbent() const {
  if (!prepared_.isTied())
    return ofTypesAsked(prepared_.scene(), rules_, {best_, evaluator_.flux(), bestEvaluation_.dimming});
  Layout layout{{}, {}, bestEvaluation_.dimming};
  std::uint32_t tie = 0;
  for (const std::uint32_t candidate : best_) {
    prepared_.appendSites(candidate, layout.sites);
    layout.ties.resize(layout.sites.size(), tie);
    tie += prepared_.weight(candidate) > 0;
  }
  layout.flux.assign(layout.sites.size(), evaluator_.flux()[0]);
  return layout;
}

void Vns::advance(std::uint32_t evaluations) {
  if (freeSites_.movable().empty()) return;
  if (!freeSites_.counts() && prepared_.candidateCount() <= evaluator_.flux().size()) return;
  for (std::uint32_t idle = 0; evaluations > 0 && idle < kIdleSteps;) {
    const std::uint32_t spent = spend(evaluations);
    evaluations -= spent;
    evaluations_ += spent;
    idle = spent > 0 ? 0 : idle + 1;
  }
}

/// Starts a local search.
void Vns::begin(const std::vector<std::uint32_t>& sites) {
  evaluator_.load(sites);
  freeSites_.load(sites);
  enter(0);
}

void Vns::enter(std::size_t neighborhood) {
  neighborhood_ = neighborhood;
  evaluator_.setPenalty(0);
  gathering_ = walking_ = scanning_ = false;
  fruitless_ = 0;
}

/// Goes on with the running scan for at most `limit` > 0 evaluations; returns how many it took.
std::uint32_t Vns::spend(std::uint32_t limit) {
  if (gathering_) return tryGatherings(limit);
  if (!scanning_) openScan();
  const std::uint32_t spent = neighborhoods()[neighborhood_].trySome(here(), scan_, limit);
  if (scan_.position >= scan_.size) closeScan();
  return spent;
}

void Vns::openScan() {
  const std::vector<std::uint32_t>& movable = freeSites_.movable();
  const auto next = std::upper_bound(movable.begin(), movable.end(), scan_.luminaire);
  scan_.luminaire = next == movable.end() ? movable.front() : *next;
  scan_.found = {{}, 0, evaluator_.current()};
  scan_.position = 0;
  scanning_ = true;
  neighborhoods()[neighborhood_].open(here(), scan_);
}

/// Takes the best of the scan, or leaves the neighbourhood when a whole turn found nothing.
void Vns::closeScan() {
  const Neighborhood& at = neighborhoods()[neighborhood_];
  scanning_ = false;
  if (scan_.found.count == 0) {
    if (++fruitless_ >= at.turn(here())) leave();
    return;
  }
  for (std::uint32_t k = 0; k < scan_.found.count; ++k)
    freeSites_.relocate(evaluator_.sites()[scan_.found.moves[k].luminaire], scan_.found.moves[k].site);
  evaluator_.apply(scan_.found);
  fruitless_ = 0;
  keepBest();
  if (at.startsOver) enter(0);
}

void Vns::keepBest() {
  if (!isBetter(evaluator_.current(), bestEvaluation_)) return;
  best_ = evaluator_.sites();
  bestEvaluation_ = evaluator_.current();
  foundAt_ = evaluations_;
  fruitlessRounds_ = 0;
}

/// To the next neighbourhood that is worth while; after the last one the local search has ended.
void Vns::leave() {
  if (walking_) return enter(0);
  for (std::size_t next = neighborhood_ + 1; next < neighborhoods().size(); ++next) {
    const Neighborhood& row = neighborhoods()[next];
    if ((thorough_ || row.afterShakes) && (areDifferent_ || !row.needsDifferent)) return enter(next);
  }
  changeBase();
}

/// After a local search: keep the better layout and the weakest shake, or go to the next one.
void Vns::changeBase() {
  const auto movable = static_cast<std::uint32_t>(freeSites_.movable().size());
  if (isBetter(evaluator_.current(), baseEvaluation_)) {
    base_ = evaluator_.sites();
    baseEvaluation_ = evaluator_.current();
    level_ = roundsOnBase_ = 0;
  } else if (++level_ >= 3 * movable) {
    level_ = 0;
    ++fruitlessRounds_;
    if (++roundsOnBase_ >= kRoundsOnBase) {  // restart, now and then from the incumbent
      roundsOnBase_ = 0;
      base_ = random_.below(2) == 0 ? best_ : somewhereElse();
      begin(base_);
      baseEvaluation_ = evaluator_.current();
      thorough_ = true;
      return;
    }
  }
  shake();
}

/// Levels alternate between near shakes, far shakes and gatherings, of growing strength.
void Vns::shake() {
  if (level_ % 3 == 2) {
    enter(0);
    gathering_ = true;
    gatherings_ = 0;
    return;
  }
  std::vector<std::uint32_t> sites = base_;
  freeSites_.load(sites);
  freeSites_.shake(sites, 1 + level_ / 3, level_ % 3 == 0 ? kShakeReach : 0, random_);
  beginShaken(sites);
}

/// Luminaires thrown together around a site, at several sites: the best of these is worth a local search.
std::uint32_t Vns::tryGatherings(std::uint32_t limit) {
  const auto movable = static_cast<std::uint32_t>(freeSites_.movable().size());
  std::uint32_t spent = 0;
  for (; gatherings_ < kGatherings && spent < limit; ++gatherings_, ++spent) {
    std::vector<std::uint32_t> sites = base_;
    freeSites_.load(sites);
    freeSites_.gather(sites, 2 + random_.below(2 * movable), random_);
    evaluator_.load(sites);
    if (gatherings_ > 0 && !isBetter(evaluator_.current(), gatheredEvaluation_)) continue;
    gathered_ = sites;
    gatheredEvaluation_ = evaluator_.current();
  }
  if (gatherings_ == kGatherings) beginShaken(gathered_);
  return spent;
}

/// A local search from a shaken layout: a quick one, after a walk over broken bounds where there are some.
void Vns::beginShaken(const std::vector<std::uint32_t>& sites) {
  thorough_ = false;
  begin(sites);
  if (!evaluator_.objective().hasConstraints() || baseEvaluation_.violation > 0) return;
  walking_ = true;
  evaluator_.setPenalty(std::abs(baseEvaluation_.goal) * kPenalties[random_.below(3)]);
}

}  // namespace fiatlux
