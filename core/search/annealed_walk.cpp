// Steps, temperature and penalty; see annealed_walk.h.
#include "core/search/annealed_walk.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fiatlux {
namespace {

constexpr std::uint32_t kSitesPerStep = 4;
constexpr std::uint32_t kWalkReach = 16;                // near sites that a step chooses among
constexpr std::uint32_t kStepsPerSwap = 5;              // one in so many changes places instead
constexpr double kTakenFirst = 0.6;                     // share of steps that a hot walk takes at first
constexpr double kFollow = 0.05, kFollowSurveys = 0.1;  // of what is measured and led, a step
constexpr double kFirstTemperature = 0.01;              // of the goal, before it is led
constexpr double kFirstPenalty = 4;                     // likewise, of a violation of 100 %
constexpr double kLeastPenalty = 0.1, kLargestPenalty = 1e6;
constexpr double kFirstAim = 1.0 / 30;  // of what a missed aim costs in the end
constexpr double kAimRise = 3.4;        // in a walk: the logarithm of 1 / kFirstAim
constexpr double kLeastGoal = 1e-3;     // a goal near 0 is no scale

/// About exponentially distributed, of mean 1: its density halves from step to step. Without a logarithm,
/// which machines round differently.
double exponential(Random& random) {
  std::uint32_t bits = random.next();
  int halvings = 0;
  for (; halvings < 16 && bits < 0x80000000u; ++halvings) bits <<= 1;
  return (halvings + (bits & 0x7fffffffu) * 0x1p-31) / 1.5;
}

constexpr std::uint32_t kChances = 2048;

/// Draws of it, made beforehand; a survey reads some in a row.
const auto kChance = [] {
  std::array<float, kChances + kSurveyed> draws{};
  Random random(1);
  for (float& draw : draws) draw = static_cast<float>(exponential(random));
  return draws;
}();

}  // namespace

void AnnealedWalk::begin(std::uint64_t trials, double heat, double goal) {
  trials_ = trials;
  done_ = 0;
  byTabu_ = false;
  heat_ = heat;
  scale_ = std::max(std::fabs(goal), kLeastGoal);
  temperature_ = kFirstTemperature * heat * scale_;
  if (bounded_ && penalty_ == 0) penalty_ = kFirstPenalty * scale_;
  taken_ = kTakenFirst * heat;
  aimShare_ = kFirstAim * lastAimShare_;
}

void AnnealedWalk::beginTabu(std::uint64_t trials, double goal) {
  begin(trials, 1, goal);
  byTabu_ = true;
  tabu_.clear();
}

void AnnealedWalk::beginTabuNear(std::uint64_t trials, double goal) {
  beginTabu(trials, goal);
  aimShare_ = lastAimShare_;
}

void AnnealedWalk::open(const Surroundings& at, Scan& scan) {
  at.evaluator.setPrices({penalty_, aimShare_});
  const FreeSites& freeSites = at.freeSites;
  follow_ = at.maySurvey() ? kFollowSurveys : kFollow;
  scan.position = 0;
  scan.isSurvey = false;
  if (byTabu_) return tabu_.open(at, scan);
  scan.luminaire = freeSites.randomMovable(at.random);
  const bool isSwap = swaps_ && at.random.below(kStepsPerSwap) == 0 && openSwap(at, scan);
  scan.isSurvey = !isSwap && at.maySurvey();
  const std::uint32_t from = at.evaluator.sites()[scan.luminaire];
  if (scan.isSurvey) {
    freeSites.around(from, kWalkReach, kSurveyed, at.random, scan.candidates);
    scan.found = {{}, 0, kNothingFound};
    scan.size = kTrialsPerSurvey;
    return;
  }
  Evaluation worst = at.evaluator.current();
  worst.goal += temperature_ * exponential(at.random);
  scan.found = {{}, 0, worst};
  if (isSwap) return;
  freeSites.drawMoves(from, kWalkReach * freeSites.waysPerPlace(), kSitesPerStep, at.random, scan.candidates);
  scan.size = static_cast<std::uint32_t>(scan.candidates.size());
}

/// Two luminaires change places: the only trial of the step.
bool AnnealedWalk::openSwap(const Surroundings& at, Scan& scan) const {
  const std::vector<std::uint32_t>& sites = at.evaluator.sites();
  scan.partner = at.freeSites.randomMovable(at.random);
  const std::uint32_t to = at.freeSites.exchanged(sites[scan.luminaire], sites[scan.partner]),
                      partnerTo = at.freeSites.exchanged(sites[scan.partner], sites[scan.luminaire]);
  if (scan.partner == scan.luminaire || to == kNone || partnerTo == kNone) return false;
  if (!at.freeSites.mayExchange(sites[scan.luminaire], to, sites[scan.partner], partnerTo)) return false;
  scan.candidates.clear();
  scan.partnerCandidates = {to, partnerTo};
  scan.size = 1;
  return true;
}

/// Takes a site as warmth would: whichever has the least worth less a chance of the size of the temperature.
/// The luminaire's own is one of them.
void AnnealedWalk::survey(const Surroundings& at, Scan& scan) const {
  double worths[kSurveyed];
  at.evaluator.survey(scan.luminaire, scan.candidates.data(), worths);
  const float* chance = kChance.data() + at.random.below(kChances);
  const std::uint32_t from = scan.candidates[0];
  std::uint32_t best = 0;
  double least = worths[0] - temperature_ * chance[0];
  for (std::uint32_t k = 1; k < kSurveyed; ++k) {
    const double worth = worths[k] - temperature_ * chance[k];
    if (!(worth < least) || !at.freeSites.mayMove(from, scan.candidates[k])) continue;
    least = worth;
    best = k;
  }
  if (best == 0) return;
  scan.found.moves[0] = {scan.luminaire, scan.candidates[best]};
  scan.found.count = 1;  // note: judged when it is made; nothing depends on it before
}

std::uint32_t AnnealedWalk::trySome(const Surroundings& at, Scan& scan, std::uint32_t limit) {
  const std::uint32_t tried = std::min(limit, scan.size - scan.position);
  if (byTabu_) {
    if (tried > 0 && scan.position + tried == scan.size) tabu_.choose(at, scan);
  } else if (scan.isSurvey) {
    if (tried > 0 && scan.position + tried == scan.size) survey(at, scan);
  } else if (scan.candidates.empty() && tried > 0)
    at.evaluator.tryPair({scan.luminaire, scan.partnerCandidates[0]},
                         {scan.partner, scan.partnerCandidates[1]}, scan.found);
  else
    at.evaluator.tryMoves(scan.luminaire, scan.candidates.data() + scan.position, tried, scan.found);
  scan.position += tried;
  return tried;
}

void AnnealedWalk::close(const Scan& scan, const Evaluation& current) {
  done_ += std::max(scan.size, 1u);
  taken_ += follow_ * ((scan.found.count > 0 ? 1.0 : 0.0) - taken_);
  const double left = 1 - static_cast<double>(done_) / static_cast<double>(trials_);
  const double wanted = kTakenFirst * heat_ * left;
  temperature_ *= taken_ > wanted ? 1 - follow_ : 1 + follow_;
  const double part = static_cast<double>(std::max(scan.size, 1u)) / static_cast<double>(trials_);
  aimShare_ = std::min(lastAimShare_, aimShare_ * (1 + kAimRise * part));
  if (!bounded_) return;
  penalty_ *= current.violation > 0 ? 1 + follow_ : 1 - follow_;
  penalty_ = std::clamp(penalty_, kLeastPenalty * scale_, kLargestPenalty * scale_);
}

}  // namespace fiatlux
