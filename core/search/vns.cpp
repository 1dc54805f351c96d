// The search; see vns.h.
#include "core/search/vns.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/search/identity.h"
#include "core/search/start_layout.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kIdleSteps = 20000;     // steps without a single trial: no site is free to go to
constexpr std::uint32_t kGatherings = 64;       // tried before a walk begins at the best of them
constexpr std::uint32_t kCenters = 512;         // of gatherings of all luminaires
constexpr std::uint32_t kFirstRoom = 4;         // layouts remembered, one more for each walk
constexpr double kCrossShare = 0.3;             // of other work, that much more with each walk
constexpr std::uint32_t kWalksFirst = 2;        // before layouts are crossed
constexpr std::uint32_t kCrossings = 4;         // tried before a local search begins at the best of them
constexpr std::uint32_t kTrialsOfCrossing = 5;  // it takes as long
constexpr std::uint32_t kFarShare = 3;          // one luminaire of so many differs from all that is kept
constexpr std::uint32_t kTrialsOfChild = 14;    // a luminaire, by the steps of a tabu search
constexpr std::uint32_t kMostInVain = 15;       // crossings in a row, until there is another walk
constexpr std::uint32_t kWalksInVain = 6;       // and at least half of all, until the search starts anew
constexpr std::uint32_t kMostMisled = 4;        // times: one walk in sixteen leaves true extremes out then

/// How a search goes about, as suits what its steps are.
struct Pace {
  std::uint32_t trialsPerLuminaire;  // of the first walk
  std::uint32_t longer;              // the next one is longer by one part in so many
  double reheat;                     // of a walk from a good layout
  std::uint32_t
      walksFirstBounded;     // before layouts are crossed where there are bounds, to whose edges they lead
  std::uint32_t worthTurns;  // of "far" in the time of a walk: it may end thoroughly
};
constexpr Pace kSurveying = {100, 16, 0.7, 3, 12}, kTrying = {400, 4, 0.5, 4, 2};

const Pace& paceOf(const Surroundings& at) { return at.maySurvey() ? kSurveying : kTrying; }

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
    const double inner = prepared.innerDistance(tie);
    if (isBarred || inner <= 0 || isTooNear(inner, rules.minDistance)) tied.excluded.push_back(tie);
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
      length_(firstLength()),
      walk_(areDifferent_, evaluator_.objective().hasConstraints(), evaluator_.objective().leadingAimShare()),
      memory_(prepared, evaluator_.flux()) {}

void Vns::open(const std::vector<std::uint32_t>& sites) {
  begin(sites);
  best_ = evaluator_.sites();
  bestEvaluation_ = evaluator_.current();
  if (!evaluator_.lightsPatches()) return;
  relax(true);
  begin(sites);
}

/// Leaves true extremes out, or no longer, from the next begin() on.
void Vns::relax(bool relaxed) {
  relaxed_ = relaxed;
  evaluator_.leaveOutExtremes(relaxed);
}

/// Is the next walk one that leaves true extremes out? Every other one at first.
bool Vns::isRelaxing() const {
  const std::uint32_t every = 1u << std::min(misled_, kMostMisled);
  return evaluator_.lightsPatches() && walks_ % every == 1 % every;
}

/// Of ties: what is pinned in front, nobody in the places that are left.
std::vector<std::uint32_t> Vns::inSlots(std::vector<std::uint32_t> ties) const {
  ties.resize(std::max(ties.size(), evaluator_.flux().size()), prepared_.nobody());
  return ties;
}

std::uint64_t Vns::firstLength() {
  return std::uint64_t{paceOf(here()).trialsPerLuminaire} * freeSites_.movable().size();
}

/// A layout to search from anew.
std::vector<std::uint32_t> Vns::somewhereElse() {
  std::vector<std::uint32_t> sites = randomSites(prepared_, rules_, random_);
  if (!prepared_.isTied()) return sites;
  return luminairesIn(prepared_, sites) < rules_.count ? best_ : inSlots(std::move(sites));
}

Layout Vns::incumbent() const {
  const std::vector<std::uint32_t>& best = isRecordBroken() ? best_ : record_;
  if (!prepared_.isTied())
    return ofTypesAsked(prepared_.scene(), rules_, {best, evaluator_.flux(), evaluation().dimming});
  Layout layout{{}, {}, evaluation().dimming};
  std::uint32_t tie = 0;
  for (const std::uint32_t candidate : best) {
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
  evaluator_.setPrices({});
  gathering_ = choosing_ = walking_ = scanning_ = easing_ = false;
  fruitless_ = 0;
}

/// Goes on with the running scan for at most `limit` > 0 evaluations; returns how many it took.
std::uint32_t Vns::spend(std::uint32_t limit) {
  if (gathering_) return tryGatherings(limit);
  if (choosing_) return tryCrossings(limit);
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
  work_ += scan_.size;
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
  if (relaxed_) return;
  if (!isBetter(evaluator_.current(), bestEvaluation_)) return;
  best_ = evaluator_.sites();
  bestEvaluation_ = evaluator_.current();
  if (isRecordBroken()) foundAt_ = evaluations_;
  walksAtBest_ = walks_;
  foundSince_ = true;
}

/// To the next neighbourhood that is worth while; after the last one the local search has ended.
void Vns::leave() {
  if (relaxed_) {
    walked_ = evaluator_.sites();
    walkedEvaluation_ = evaluator_.current();
    return searchTruly();
  }
  // Where nothing is broken or missed none becomes better at firm prices: it would have been taken before.
  const Evaluation& now = evaluator_.current();
  if (easing_ && (now.violation > 0 || now.missed > 0)) return enter(0);
  for (std::size_t next = neighborhood_ + 1; next < neighborhoods().size(); ++next) {
    const Neighborhood& row = neighborhoods()[next];
    if ((thorough_ || row.afterShakes) && (areDifferent_ || !row.needsDifferent)) return enter(next);
  }
  shake(evaluator_.sites(), now);
}

/// After a local search that led to these: a crossing or the next walk, from the best layout, from a
/// gathering or from anywhere.
void Vns::shake(const std::vector<std::uint32_t>& sites, const Evaluation& evaluation) {
  remember(sites, evaluation);
  if (isCrossingWorthwhile()) return beginCrossing();
  if (isStuck()) return startAnew();
  switch (++walks_ % 3) {
    case 1:
      return beginGatherings();
    case 2:
      return beginWalk(somewhereElse(), 1);
    default:
      return beginWalk(best_, paceOf(here()).reheat);
  }
}

/// Has nothing better been found for long? What is remembered then comes from a few layouts.
bool Vns::isStuck() const {
  return !freeSites_.counts() && walks_ - walksAtBest_ > std::max(kWalksInVain, walks_ / 2);
}

/// From anywhere, with nothing remembered but the record and what the walks have learned of prices.
void Vns::startAnew() {
  if (isRecordBroken()) {
    record_ = best_;
    recordEvaluation_ = bestEvaluation_;
  }
  best_ = somewhereElse();
  begin(best_);
  bestEvaluation_ = evaluator_.current();
  memory_.clear();
  walks_ = walksAtBest_ = inVain_ = 0;
  crossWork_ = otherWork_ = 0;
  length_ = firstLength();
  thorough_ = false;
}

/// Takes what a local search has found, and what it cost; a crossing that found a new incumbent was free.
void Vns::remember(const std::vector<std::uint32_t>& sites, const Evaluation& evaluation) {
  if (freeSites_.counts()) return;
  const bool isKept = memory_.offer(sites, evaluation, kFirstRoom + walks_);
  if (!crossing_) otherWork_ += work_;
  if (crossing_ && !foundSince_) crossWork_ += work_;
  inVain_ = crossing_ && !isKept ? inVain_ + 1 : 0;
  work_ = 0;
  crossing_ = false;
}

bool Vns::isCrossingWorthwhile() {
  const bool bounded = evaluator_.objective().hasConstraints();
  return walks_ >= (bounded ? paceOf(here()).walksFirstBounded : kWalksFirst) && inVain_ < kMostInVain &&
         memory_.hasParents() && freeSites_.movable().size() > 1 &&
         static_cast<double>(crossWork_) < kCrossShare * (1 + walks_) * static_cast<double>(otherWork_);
}

/// Two good layouts put together; where trials are quick, several times, for the best child.
void Vns::beginCrossing() {
  if (!here().maySurvey()) {
    memory_.cross(freeSites_, random_, child_);
    return searchChild(child_);
  }
  choosing_ = true;
  crossed_ = 0;
  childMissing_ = kNone;
}

/// Goes on with them, each of which takes as long as several trials.
std::uint32_t Vns::tryCrossings(std::uint32_t limit) {
  constexpr std::uint32_t trials = kCrossings * kTrialsOfCrossing;
  const std::uint32_t spent = std::min(limit, trials - crossed_), done = crossed_ / kTrialsOfCrossing;
  crossed_ += spent;
  for (std::uint32_t i = done; i < crossed_ / kTrialsOfCrossing; ++i) tryCrossing();
  work_ += spent;
  if (crossed_ == trials) searchChild(child_);
  return spent;
}

/// Keeps the child if it is the best so far. One that is far from all that is kept comes before one that is
/// near, which is worth more but leads back: half of the searches from children ended at what was known.
/// Of those as far counts what they are worth, bounds at the price of the last walk.
void Vns::tryCrossing() {
  memory_.cross(freeSites_, random_, otherChild_);
  const auto movable = static_cast<std::uint32_t>(freeSites_.movable().size());
  const std::uint32_t far = (movable + kFarShare - 1) / kFarShare, distance = memory_.distanceTo(otherChild_);
  const std::uint32_t missing = far - std::min(far, distance);
  if (missing > childMissing_) return;
  const Evaluation evaluation = evaluator_.evaluate(otherChild_);
  const double worth = evaluation.goal + walk_.penalty() * evaluation.violation;
  if (missing == childMissing_ && !(worth < childWorth_)) return;
  childMissing_ = missing;
  childWorth_ = worth;
  child_.swap(otherChild_);
}

/// A few steps of a tabu search from there, where these are possible; else a local search: quick, and at
/// first one that may break bounds and miss aims a little.
void Vns::searchChild(const std::vector<std::uint32_t>& child) {
  thorough_ = false;
  begin(child);
  crossing_ = true;
  foundSince_ = false;
  if (Tabu::isPossible(here())) {
    follow(child);
    walk_.beginTabuNear(kTrialsOfChild * freeSites_.movable().size(), bestEvaluation_.goal);
    return;
  }
  easing_ = !walk_.prices().areFirm();
  evaluator_.setPrices(walk_.prices());
}

/// The first time, all luminaires around each site (or some, where there are very many); later, some of them
/// around random ones.
void Vns::beginGatherings() {
  enter(0);
  gathering_ = true;
  gatherings_ = 0;
  centers_ = walks_ > 1 || freeSites_.counts() ? 0 : std::min(prepared_.candidateCount(), kCenters);
  gathered_ = gatheredNow_ = best_;
  gatheredEvaluation_ = kNothingFound;
  freeSites_.load(gatheredNow_);
}

/// Luminaires thrown together around a site, at several sites: a walk begins at the best of these.
std::uint32_t Vns::tryGatherings(std::uint32_t limit) {
  const auto movable = static_cast<std::uint32_t>(freeSites_.movable().size());
  const std::uint32_t wanted = centers_ > 0 ? centers_ : kGatherings;
  std::uint32_t spent = 0;
  for (; gatherings_ < wanted && spent < limit; ++gatherings_, ++spent) {
    if (centers_ > 0) {
      const std::uint64_t center = std::uint64_t{gatherings_} * prepared_.candidateCount() / centers_;
      freeSites_.gatherAll(gatheredNow_, static_cast<std::uint32_t>(center));
    } else {
      gatheredNow_ = best_;
      freeSites_.load(gatheredNow_);
      freeSites_.gather(gatheredNow_, 2 + random_.below(2 * movable), random_);
    }
    if (evaluator_.tryLayout(gatheredNow_, gatheredEvaluation_)) gathered_ = gatheredNow_;
  }
  work_ += spent;
  if (gatherings_ == wanted) beginWalk(gathered_, paceOf(here()).reheat);
  return spent;
}

void Vns::beginWalk(const std::vector<std::uint32_t>& sites, double heat) {
  relax(isRelaxing());
  begin(sites);
  foundSince_ = false;
  follow(sites);
  if (walks_ % 2 == 1 && Tabu::isPossible(here()))
    walk_.beginTabu(length_, bestEvaluation_.goal);
  else
    walk_.begin(length_, heat, bestEvaluation_.goal);
  length_ += length_ / paceOf(here()).longer;
}

/// Takes the steps of a walk from there on, where the evaluator stands.
void Vns::follow(const std::vector<std::uint32_t>& sites) {
  walking_ = true;
  walked_ = sites;
  walkedEvaluation_ = evaluator_.current();
}

/// Takes the step of a walk, where there is one.
void Vns::closeStep() {
  scanning_ = false;
  work_ += scan_.size;
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
/// paired; none after a crossing, whose steps were the best of many moves.
void Vns::endWalk() {
  if (crossing_) {
    enter(0);
    return shake(walked_, walkedEvaluation_);
  }
  const bool isPaired = freeSites_.counts() || prepared_.isOfTypes();
  const std::uint64_t turn = freeSites_.movable().size() * prepared_.candidateCount();
  thorough_ = !relaxed_ && (isPaired || (foundSince_ && walk_.trials() > paceOf(here()).worthTurns * turn));
  if (relaxed_) return searchTruly();
  begin(walked_);
}

/// A local search with true extremes from what was found without them. That was misleading where it would
/// have been the best layout and is not.
void Vns::searchTruly() {
  const bool wouldBeBest = isBetter(walkedEvaluation_, bestEvaluation_);
  relax(false);
  begin(walked_);
  if (wouldBeBest) {
    if (isBetter(walkedEvaluation_, evaluator_.current()))
      ++misled_;
    else if (misled_ > 0)
      --misled_;
  }
  keepBest();
}

}  // namespace fiatlux
