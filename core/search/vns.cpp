// The search; see vns.h.
#include "core/search/vns.h"

#include <algorithm>
#include <cmath>

#include "core/search/start_layout.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kNearReach = 12;      // sites tried around a luminaire in the first neighbourhood
constexpr std::uint32_t kPairReach = 8;       // and around each of two in the last
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

Vns::Vns(PreparedScene& prepared, const Intentions& intentions, std::uint64_t seed, const Layout* start,
         const Layout* reference)
    : evaluator_(prepared, intentions, reference),
      neighborhood_(prepared, intentions.luminaires),
      random_(seed),
      prepared_(prepared),
      rules_(intentions.luminaires) {
  for (double flux : evaluator_.flux()) differentFluxes_ |= flux != evaluator_.flux()[0];
  begin(startSites(prepared, rules_, start, random_));
  base_ = best_ = evaluator_.sites();
  baseEvaluation_ = bestEvaluation_ = evaluator_.current();
}

void Vns::advance(std::uint32_t evaluations) {
  if (neighborhood_.firstMovable() >= rules_.count || prepared_.siteCount() <= rules_.count) return;
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
  neighborhood_.load(sites);
  enter(Phase::kNear);
}

void Vns::enter(Phase phase) {
  phase_ = phase;
  if (phase != Phase::kWalk) evaluator_.setPenalty(0);
  fruitless_ = 0;
  scanning_ = false;
}

/// Goes on with the running scan for at most `limit` > 0 evaluations; returns how many it took.
std::uint32_t Vns::spend(std::uint32_t limit) {
  if (phase_ == Phase::kGather) return tryGatherings(limit);
  if (!scanning_) openScan();
  std::uint32_t spent = 0;
  if (phase_ == Phase::kSwap) {
    spent = trySwaps(limit);
  } else if (phase_ == Phase::kPairs) {
    spent = tryPairs(limit);
  } else {
    spent = std::min(limit, static_cast<std::uint32_t>(candidates_.size()) - position_);
    evaluator_.tryMoves(luminaire_, candidates_.data() + position_, spent, found_);
    position_ += spent;
    if (position_ == candidates_.size()) closeScan();
  }
  return spent;
}

void Vns::openScan() {
  const std::uint32_t first = neighborhood_.firstMovable(), movable = rules_.count - first;
  luminaire_ = luminaire_ + 1 >= rules_.count ? first : std::max(first, luminaire_ + 1);
  found_ = {{}, 0, evaluator_.current()};
  position_ = 0;
  scanning_ = true;
  if (phase_ == Phase::kNear || phase_ == Phase::kWalk) {
    neighborhood_.nearMoves(evaluator_.sites()[luminaire_], kNearReach, candidates_);
  } else if (phase_ == Phase::kFar) {
    neighborhood_.farMoves(evaluator_.sites()[luminaire_], candidates_);
  } else if (phase_ == Phase::kPairs) {
    partner_ = first + random_.below(movable);
    neighborhood_.nearMoves(evaluator_.sites()[luminaire_], kPairReach, candidates_);
    neighborhood_.nearMoves(evaluator_.sites()[partner_], kPairReach, partnerCandidates_);
    if (partner_ == luminaire_) candidates_.clear();
  }
}

/// Takes the best of the scan, or leaves the phase when a whole turn of luminaires found nothing.
void Vns::closeScan() {
  scanning_ = false;
  const std::uint32_t turn = phase_ == Phase::kSwap ? 1 : rules_.count - neighborhood_.firstMovable();
  if (found_.count == 0) {
    if (++fruitless_ >= turn) nextPhase();
    return;
  }
  for (std::uint32_t k = 0; k < found_.count && phase_ != Phase::kSwap; ++k)
    neighborhood_.relocate(evaluator_.sites()[found_.moves[k].luminaire], found_.moves[k].site);
  evaluator_.apply(found_);
  fruitless_ = 0;
  if (isBetter(evaluator_.current(), bestEvaluation_)) {
    best_ = evaluator_.sites();
    bestEvaluation_ = evaluator_.current();
    foundAt_ = evaluations_;
    fruitlessRounds_ = 0;
  }
  if (phase_ == Phase::kPairs) enter(Phase::kNear);
}

void Vns::nextPhase() {
  if (phase_ == Phase::kWalk) return enter(Phase::kNear);
  if (phase_ == Phase::kNear && thorough_) return enter(Phase::kFar);
  if (phase_ != Phase::kSwap && phase_ != Phase::kPairs && differentFluxes_) return enter(Phase::kSwap);
  if (phase_ != Phase::kPairs && thorough_) return enter(Phase::kPairs);
  changeNeighborhood();
}

/// Exchanges of the sites of two luminaires of different flux: one scan over all of them.
std::uint32_t Vns::trySwaps(std::uint32_t limit) {
  const std::uint32_t first = neighborhood_.firstMovable(), movable = rules_.count - first;
  const std::vector<std::uint32_t>& sites = evaluator_.sites();
  std::uint32_t spent = 0;
  for (; position_ < movable * movable && spent < limit; ++position_) {
    const std::uint32_t i = first + position_ / movable, j = first + position_ % movable;
    if (i >= j || evaluator_.flux()[i] == evaluator_.flux()[j]) continue;
    evaluator_.tryPair({i, sites[j]}, {j, sites[i]}, found_);
    ++spent;
  }
  if (position_ == movable * movable) closeScan();
  return spent;
}

/// Two luminaires moved at once, each to a near site.
std::uint32_t Vns::tryPairs(std::uint32_t limit) {
  const auto second = static_cast<std::uint32_t>(partnerCandidates_.size());
  const std::uint32_t total = static_cast<std::uint32_t>(candidates_.size()) * second;
  std::uint32_t spent = 0;
  for (; position_ < total && spent < limit; ++position_) {
    const std::uint32_t a = candidates_[position_ / second], b = partnerCandidates_[position_ % second];
    if (neighborhood_.conflict(a, b)) continue;
    evaluator_.tryPair({luminaire_, a}, {partner_, b}, found_);
    ++spent;
  }
  if (position_ >= total) closeScan();
  return spent;
}

/// After a local search: keep the better layout and the first neighbourhood, or go to the next one.
void Vns::changeNeighborhood() {
  const std::uint32_t movable = rules_.count - neighborhood_.firstMovable();
  if (isBetter(evaluator_.current(), baseEvaluation_)) {
    base_ = evaluator_.sites();
    baseEvaluation_ = evaluator_.current();
    level_ = roundsOnBase_ = 0;
  } else if (++level_ >= 3 * movable) {
    level_ = 0;
    ++fruitlessRounds_;
    if (++roundsOnBase_ >= kRoundsOnBase) {  // restart, now and then from the incumbent
      roundsOnBase_ = 0;
      base_ = random_.below(2) == 0 ? best_ : randomSites(prepared_, rules_, random_);
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
    enter(Phase::kGather);
    position_ = 0;
    return;
  }
  std::vector<std::uint32_t> sites = base_;
  neighborhood_.load(sites);
  neighborhood_.shake(sites, 1 + level_ / 3, level_ % 3 == 0 ? kShakeReach : 0, random_);
  beginShaken(sites);
}

/// Luminaires thrown together around a site, at several sites: the best of these is worth a local search.
std::uint32_t Vns::tryGatherings(std::uint32_t limit) {
  const std::uint32_t movable = rules_.count - neighborhood_.firstMovable();
  std::uint32_t spent = 0;
  for (; position_ < kGatherings && spent < limit; ++position_, ++spent) {
    std::vector<std::uint32_t> sites = base_;
    neighborhood_.load(sites);
    neighborhood_.gather(sites, 2 + random_.below(2 * movable), random_);
    evaluator_.load(sites);
    if (position_ > 0 && !isBetter(evaluator_.current(), gatheredEvaluation_)) continue;
    gathered_ = sites;
    gatheredEvaluation_ = evaluator_.current();
  }
  if (position_ == kGatherings) beginShaken(gathered_);
  return spent;
}

/// A local search from a shaken layout: near moves only, after a walk over broken bounds where there are
/// some.
void Vns::beginShaken(const std::vector<std::uint32_t>& sites) {
  thorough_ = false;
  begin(sites);
  if (!evaluator_.objective().hasConstraints() || baseEvaluation_.violation > 0) return;
  enter(Phase::kWalk);
  evaluator_.setPenalty(std::abs(baseEvaluation_.goal) * kPenalties[random_.below(3)]);
}

}  // namespace fiatlux
