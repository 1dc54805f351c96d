// The search; see vns.h.
#include "core/search/vns.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/search/identity.h"
#include "core/search/start_layout.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kIdleSteps = 20000;         // steps without a single trial: no site is free to go to
constexpr std::uint32_t kGatherings = 64;           // tried before a walk begins at the best of them
constexpr std::uint32_t kTrialsPerLuminaire = 400;  // of the first walk
constexpr std::uint32_t kLonger = 4;                // the next one is longer by one part in so many
constexpr double kReheat = 0.5;                     // of a walk from a good layout
constexpr std::uint32_t kWorthTurns = 2;            // of "far" in the time of a walk: it may end thoroughly

bool areUnlike(const PreparedScene& prepared, const std::vector<double>& flux) {
  return (prepared.waysPerPlace() > 1 && !prepared.isTied()) ||
         std::any_of(flux.begin(), flux.end(), [&](double each) { return each != flux[0]; });
}

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
  thorough_ = start != nullptr;
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
      rules_(rules),
      areDifferent_(areUnlike(prepared, evaluator_.flux())),
      length_(kTrialsPerLuminaire * freeSites_.movable().size()),
      walk_(areDifferent_, evaluator_.objective().hasConstraints()) {}

void Vns::open(const std::vector<std::uint32_t>& sites) {
  begin(sites);
  best_ = evaluator_.sites();
  bestEvaluation_ = evaluator_.current();
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
  const std::uint32_t spent = walking_ ? walk_.trySome(here(), scan_, limit)
                                       : neighborhoods()[neighborhood_].trySome(here(), scan_, limit);
  if (scan_.position >= scan_.size) walking_ ? closeStep() : closeScan();
  return spent;
}

void Vns::openScan() {
  scanning_ = true;
  if (walking_) return walk_.open(here(), scan_);
  const std::vector<std::uint32_t>& movable = freeSites_.movable();
  const auto next = std::upper_bound(movable.begin(), movable.end(), scan_.luminaire);
  scan_.luminaire = next == movable.end() ? movable.front() : *next;
  scan_.found = {{}, 0, evaluator_.current()};
  scan_.position = 0;
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
  take();
  fruitless_ = 0;
  keepBest();
  if (at.startsOver) enter(0);
}

/// Makes the moves that the scan found.
void Vns::take() {
  for (std::uint32_t k = 0; k < scan_.found.count; ++k)
    freeSites_.relocate(evaluator_.sites()[scan_.found.moves[k].luminaire], scan_.found.moves[k].site);
  evaluator_.apply(scan_.found);
}

void Vns::keepBest() {
  if (!isBetter(evaluator_.current(), bestEvaluation_)) return;
  best_ = evaluator_.sites();
  bestEvaluation_ = evaluator_.current();
  foundAt_ = evaluations_;
  foundSince_ = true;
}

/// To the next neighbourhood that is worth while; after the last one the local search has ended.
void Vns::leave() {
  for (std::size_t next = neighborhood_ + 1; next < neighborhoods().size(); ++next) {
    const Neighborhood& row = neighborhoods()[next];
    if ((thorough_ || row.afterShakes) && (areDifferent_ || !row.needsDifferent)) return enter(next);
  }
  shake();
}

/// After a local search: the next walk, from the best layout, from a gathering or from anywhere.
void Vns::shake() {
  switch (++walks_ % 3) {
    case 1:
      enter(0);
      gathering_ = true;
      gatherings_ = 0;
      return;
    case 2:
      return beginWalk(somewhereElse(), 1);
    default:
      return beginWalk(best_, kReheat);
  }
}

/// Luminaires thrown together around a site, at several sites: a walk begins at the best of these.
std::uint32_t Vns::tryGatherings(std::uint32_t limit) {
  const auto movable = static_cast<std::uint32_t>(freeSites_.movable().size());
  std::uint32_t spent = 0;
  for (; gatherings_ < kGatherings && spent < limit; ++gatherings_, ++spent) {
    std::vector<std::uint32_t> sites = best_;
    freeSites_.load(sites);
    freeSites_.gather(sites, 2 + random_.below(2 * movable), random_);
    evaluator_.load(sites);
    if (gatherings_ > 0 && !isBetter(evaluator_.current(), gatheredEvaluation_)) continue;
    gathered_ = sites;
    gatheredEvaluation_ = evaluator_.current();
  }
  if (gatherings_ == kGatherings) beginWalk(gathered_, kReheat);
  return spent;
}

void Vns::beginWalk(const std::vector<std::uint32_t>& sites, double heat) {
  begin(sites);
  walking_ = true;
  foundSince_ = false;
  walked_ = sites;
  walkedEvaluation_ = evaluator_.current();
  walk_.begin(length_, heat, bestEvaluation_.goal);
  length_ += length_ / kLonger;
}

/// Takes the step of a walk, where there is one.
void Vns::closeStep() {
  scanning_ = false;
  if (scan_.found.count > 0) {
    take();
    if (isBetter(evaluator_.current(), walkedEvaluation_)) {
      walked_ = evaluator_.sites();
      walkedEvaluation_ = evaluator_.current();
    }
    keepBest();
  }
  walk_.close(scan_, evaluator_.current());
  if (walk_.isDone()) endWalk();
}

/// A local search from the best layout of a walk: a quick one, unless it is worth more or moves must be
/// paired.
void Vns::endWalk() {
  const bool isPaired = freeSites_.counts() || prepared_.isOfTypes();
  const std::uint64_t turn = freeSites_.movable().size() * prepared_.candidateCount();
  thorough_ = isPaired || (foundSince_ && walk_.trials() > kWorthTurns * turn);
  begin(walked_);
}

}  // namespace fiatlux
