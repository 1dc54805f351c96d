// Delta evaluation on cached sums; see evaluator.h.
#include "core/search/evaluator.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/search/start_layout.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kBlock = kSurveyStride;
constexpr std::uint32_t kMostDrift = 64;  // layouts that patches are lit for step by step
constexpr double kBeyondGoals = 1e3;      // times the goal: the price of a bound that comes first

/// Candidates in the largest layout: so many may be moved.
std::uint32_t slotsFor(const PreparedScene& prepared, const LuminaireRules& rules) {
  const std::uint32_t most = mostOf(rules);
  if (!prepared.isTied()) return most;
  if (prepared.lightest() == prepared.heaviest()) return most / prepared.lightest();
  std::vector<std::uint32_t> weights;
  for (std::uint32_t c = 0; c < prepared.candidateCount(); ++c) weights.push_back(prepared.weight(c));
  std::sort(weights.begin(), weights.end());
  std::uint32_t slots = 0, total = 0;
  while (slots < weights.size() && total + weights[slots] <= most) total += weights[slots++];
  return slots;
}

Layout referenceLayout(PreparedScene& prepared, const Intentions& intentions, const Layout* reference) {
  if (reference && reference->sites.size() == intentions.luminaires.count) return *reference;
  return {spreadSites(prepared.sites(), intentions.luminaires), {}, 1};
}

}  // namespace

Evaluator::Evaluator(PreparedScene& prepared, const Intentions& intentions, const Layout* reference)
    : prepared_(prepared),
      flux_(fluxesOf(intentions.luminaires, slotsFor(prepared, intentions.luminaires))),
      objective_(prepared, intentions, referenceLayout(prepared, intentions, reference)) {
  for (const double flux : flux_) squares_.push_back(flux * flux);
  const std::size_t count = objective_.sets().size();
  moments_.resize(count);
  sums_.resize(count);
  inTurn_.resize(count);
  patches_.resize(count);
  points_.resize(count);
  trialMoments_.resize(count);
  trialExtremes_.resize(count);
  extremes_.resize(count);
  means_.resize(count * kBlock);
  variances_.resize(count * kBlock);
  least_.resize(count * kBlock);
  most_.resize(count * kBlock);
  bool isFactored = false;
  for (std::size_t s = 0; s < count; ++s) {
    const ObjectiveSet& set = objective_.sets()[s];
    if (set.needsVariance) {
      sums_[s].emplace(*set.statistics);
      inTurn_[s].emplace(*set.statistics);
    }
    if (set.ofPoints) points_[s].emplace(prepared, *set.ofPoints);
    hasPoints_ |= set.ofPoints.has_value();
    if (set.needsExtremes) patches_[s].emplace(prepared.scene(), set.quantity, set.surfaces);
    lightsPatches_ |= set.needsExtremes;
    isFactored |= set.needsVariance && set.statistics->factor;
  }
  maySurvey_ = objective_.maySurvey() && !isFactored;
}

Evaluation Evaluator::evaluate(const std::vector<std::uint32_t>& sites) {
  readMoments(sites);
  readPoints(sites);
  for (std::size_t s = 0; s < moments_.size(); ++s) {
    if (!patches_[s]) continue;
    if (leftOut_) {
      trialExtremes_[s] = Objective::allowedBy(trialMoments_[s]);
      continue;
    }
    light(*patches_[s], sites);
    trialExtremes_[s] = patches_[s]->current();
    if (!sites_.empty()) light(*patches_[s], sites_);
  }
  return objective_.judge(trialMoments_.data(), trialExtremes_.data());
}

bool Evaluator::tryLayout(const std::vector<std::uint32_t>& sites, Evaluation& best) {
  readMoments(sites);
  readPoints(sites);
  if (objective_.needsExtremes()) {
    for (std::size_t s = 0; s < patches_.size(); ++s)
      if (patches_[s]) trialExtremes_[s] = Objective::allowedBy(trialMoments_[s]);
    if (!isBetter(objective_.judge(trialMoments_.data(), trialExtremes_.data()), best)) return false;
    for (std::size_t s = 0; s < patches_.size(); ++s) {
      if (!patches_[s]) continue;
      light(*patches_[s], sites);
      trialExtremes_[s] = patches_[s]->current();
    }
  }
  const Evaluation evaluation = objective_.judge(trialMoments_.data(), trialExtremes_.data());
  if (!isBetter(evaluation, best)) return false;
  best = evaluation;
  return true;
}

/// Moments of any layout, as those of a trial.
void Evaluator::readMoments(const std::vector<std::uint32_t>& sites) {
  assert(sites.size() <= flux_.size());
  const auto count = static_cast<std::uint32_t>(sites.size());
  for (std::size_t s = 0; s < moments_.size(); ++s) {
    const ObjectiveSet& set = objective_.sets()[s];
    trialMoments_[s] = momentsOf(*set.statistics, sites.data(), countedFlux(set), count, false);
    if (inTurn_[s]) trialMoments_[s].variance = inTurn_[s]->of(sites.data(), countedFlux(set), count);
  }
}

/// What the points of planes tell counts as known exactly.
void Evaluator::take(const MeanAndLeast& points, Moments& moments, Extremes& extremes) {
  moments.mean = points.mean;
  extremes.minimumLow = extremes.minimumHigh = points.least;
}

/// Points of planes under any layout, as those of a trial.
void Evaluator::readPoints(const std::vector<std::uint32_t>& sites) {
  if (!hasPoints_) return;
  for (std::size_t s = 0; s < points_.size(); ++s) {
    if (!points_[s]) continue;
    light(*points_[s], sites);
    take(points_[s]->current(), trialMoments_[s], trialExtremes_[s]);
    if (!sites_.empty()) light(*points_[s], sites_);
  }
}

/// Lights patches, or points of planes, by the luminaires of a layout.
template <class Lit>
void Evaluator::light(Lit& lit, const std::vector<std::uint32_t>& sites) {
  changes_.clear();
  for (std::size_t i = 0; i < sites.size(); ++i) addChange(sites[i], flux_[i]);
  litSites_.clear();
  litFlux_.clear();
  for (const FluxChange& change : changes_) {
    litSites_.push_back(change.site);
    litFlux_.push_back(change.flux);
  }
  lit.load(litSites_.data(), litFlux_.data(), static_cast<std::uint32_t>(litSites_.size()));
}

/// A change of a candidate's flux as changes of its sites' fluxes.
void Evaluator::addChange(std::uint32_t candidate, double flux) {
  memberSites_.clear();
  prepared_.appendSites(candidate, memberSites_);
  for (const std::uint32_t site : memberSites_) changes_.push_back({site, flux});
}

/// Changes of candidates as those of their sites: `changes_`, of which it tells the number.
std::uint32_t Evaluator::resolve(const FluxChange* changes, std::uint32_t count) {
  changes_.clear();
  for (std::uint32_t k = 0; k < count; ++k) addChange(changes[k].site, changes[k].flux);
  return static_cast<std::uint32_t>(changes_.size());
}

void Evaluator::load(const std::vector<std::uint32_t>& sites) {
  assert(sites.size() <= flux_.size());
  sites_ = sites;
  const auto count = static_cast<std::uint32_t>(sites_.size());
  for (std::optional<VarianceSums>& sums : sums_)
    if (sums) sums->load(sites_.data(), flux_.data(), count);
  lightPatches();
  refresh();
}

/// Of the layout it stands at.
void Evaluator::lightPatches() {
  if (leftOut_) return;
  for (std::optional<PatchExtremes>& patches : patches_)
    if (patches) light(*patches, sites_);
  appliedSince_ = 0;
}

/// After the first `count` of `changes_`.
void Evaluator::relightPatches(std::uint32_t count) {
  if (leftOut_) return;
  if (++appliedSince_ == kMostDrift) return lightPatches();
  for (std::optional<PatchExtremes>& patches : patches_)
    if (patches) patches->apply(changes_.data(), count);
}

/// Moments, extremes and evaluation of the layout it stands at, from its rows and the light of its patches.
void Evaluator::refresh() {
  const auto count = static_cast<std::uint32_t>(sites_.size());
  for (std::size_t s = 0; s < moments_.size(); ++s) {
    const ObjectiveSet& set = objective_.sets()[s];
    moments_[s].mean = meanOf(set.statistics->mean.data(), sites_.data(), countedFlux(set), count);
    if (sums_[s]) moments_[s].variance = sums_[s]->variance(sites_.data(), flux_.data(), count);
    if (points_[s]) {
      light(*points_[s], sites_);
      take(points_[s]->current(), moments_[s], extremes_[s]);
    }
    if (patches_[s]) extremes_[s] = leftOut_ ? Objective::allowedBy(moments_[s]) : patches_[s]->current();
  }
  current_ = objective_.judge(moments_.data(), extremes_.data());
}

bool Evaluator::prefers(const Evaluation& a, const Evaluation& b) const {
  return prices_.areFirm() ? isBetter(a, b) : prices_.worthOf(a) < prices_.worthOf(b) - 1e-10;
}

/// With true extremes asked for: the trial's evaluation, by hope first and patches last. False when it cannot
/// be better.
bool Evaluator::settleExtremes(const FluxChange* changes, std::uint32_t count, const Evaluation& toBeat,
                               Evaluation& result) {
  const auto judgeWith = [&](auto&& extremesOf) {
    for (std::size_t s = 0; s < patches_.size(); ++s)
      if (patches_[s]) trialExtremes_[s] = extremesOf(s);
    result = objective_.judge(trialMoments_.data(), trialExtremes_.data());
    return prefers(result, toBeat);
  };
  if (hasPoints_) {
    const std::uint32_t n = resolve(changes, count);
    for (std::size_t s = 0; s < points_.size(); ++s)
      if (points_[s]) take(points_[s]->changed(changes_.data(), n), trialMoments_[s], trialExtremes_[s]);
  }
  if (!judgeWith([&](std::size_t s) { return Objective::allowedBy(trialMoments_[s]); })) return false;
  if (leftOut_) return true;
  const std::uint32_t n = resolve(changes, count);
  return judgeWith([&](std::size_t s) { return patches_[s]->hoped(changes_.data(), n); }) &&
         judgeWith([&](std::size_t s) { return patches_[s]->changed(changes_.data(), n); });
}

/// Means and variances with luminaire `i` on each of a block of candidates.
void Evaluator::momentsOfMoves(std::uint32_t i, const std::uint32_t* block, std::uint32_t count) {
  const std::uint32_t from = sites_[i];
  const double flux = flux_[i];
  for (std::size_t s = 0; s < moments_.size(); ++s) {
    const ObjectiveSet& set = objective_.sets()[s];
    movedMeans(set.statistics->mean.data(), moments_[s].mean, from, set.counted(flux), block, count,
               means_.data() + s * kBlock);
    if (sums_[s])
      sums_[s]->moved(moments_[s].variance, from, flux, block, count, variances_.data() + s * kBlock);
  }
}

/// Where bounds come first, they have a price that no goal pays.
Prices Evaluator::surveyPrices() const {
  return prices_.penalty > 0 ? prices_
                             : Prices{kBeyondGoals * (1 + std::fabs(current_.goal)), prices_.aimShare};
}

SurveyedLayouts Evaluator::surveyed() {
  return {means_.data(), variances_.data(), least_.data(), most_.data()};
}

/// What patches say at best, and points exactly, of layout k of a survey.
void Evaluator::hopeFor(std::uint32_t k, const FluxChange* changes, std::uint32_t count) {
  const std::uint32_t n = resolve(changes, count);
  for (std::size_t s = 0, at = k; s < moments_.size(); ++s, at += kSurveyStride) {
    if (points_[s]) {
      const MeanAndLeast points = points_[s]->changed(changes_.data(), n);
      means_[at] = points.mean;
      least_[at] = points.least;
    } else if (patches_[s]) {
      const Extremes hoped = leftOut_ ? Objective::allowedBy({means_[at], variances_[at]})
                                      : patches_[s]->hoped(changes_.data(), n);
      least_[at] = hoped.minimumLow;
      most_[at] = hoped.maximumHigh;
    }
  }
}

/// The same of all that are surveyed for one luminaire.
void Evaluator::hopeForMoves(std::uint32_t i, const std::uint32_t* candidates) {
  if (!objective_.needsExtremes()) return;
  if (!hasPoints_ && !prepared_.isTied() && !leftOut_) {
    for (std::size_t s = 0, at = 0; s < moments_.size(); ++s, at += kSurveyStride)
      if (patches_[s])
        patches_[s]->hopedOfMoves(sites_[i], flux_[i], candidates, kSurveyed, &least_[at], &most_[at]);
    return;
  }
  for (std::uint32_t k = 0; k < kSurveyed; ++k) {
    const FluxChange changes[2] = {{sites_[i], -flux_[i]}, {candidates[k], flux_[i]}};
    hopeFor(k, changes, 2);
  }
}

void Evaluator::survey(std::uint32_t i, const std::uint32_t* candidates, double* worths) {
  momentsOfMoves(i, candidates, kSurveyed);
  hopeForMoves(i, candidates);
  objective_.survey(surveyed(), surveyPrices(), worths);
}

void Evaluator::surveyPairs(const Move* first, const Move* second, double* worths) {
  double flux[2][kSurveyed];
  std::uint32_t from[2][kSurveyed], to[2][kSurveyed];
  for (std::uint32_t k = 0; k < kSurveyed; ++k)
    for (int end = 0; end < 2; ++end) {
      const auto [luminaire, site] = end == 0 ? first[k] : second[k];
      flux[end][k] = flux_[luminaire];
      from[end][k] = sites_[luminaire];
      to[end][k] = site;
    }
  const FluxMoves moves{flux[0], from[0], to[0]}, others{flux[1], from[1], to[1]};
  for (std::size_t s = 0; s < moments_.size(); ++s) {
    const std::vector<double>& mean = objective_.sets()[s].statistics->mean;
    pairedMeans(mean.data(), moments_[s].mean, moves, others, kSurveyed, means_.data() + s * kBlock);
    if (sums_[s])
      sums_[s]->movedPairs(moments_[s].variance, moves, others, kSurveyed, variances_.data() + s * kBlock);
  }
  if (objective_.needsExtremes())
    for (std::uint32_t k = 0; k < kSurveyed; ++k) {
      const FluxChange changes[4] = {{from[0][k], -flux[0][k]},
                                     {to[0][k], flux[0][k]},
                                     {from[1][k], -flux[1][k]},
                                     {to[1][k], flux[1][k]}};
      hopeFor(k, changes, 4);
    }
  objective_.survey(surveyed(), surveyPrices(), worths);
}

void Evaluator::tryMoves(std::uint32_t i, const std::uint32_t* candidates, std::uint32_t count, Trial& best) {
  const std::size_t sets = moments_.size();
  const std::uint32_t from = sites_[i];
  const double flux = flux_[i];
  for (std::uint32_t first = 0; first < count; first += kBlock) {
    const std::uint32_t n = std::min(kBlock, count - first);
    const std::uint32_t* block = candidates + first;
    momentsOfMoves(i, block, n);
    for (std::uint32_t k = 0; k < n; ++k) {
      for (std::size_t s = 0; s < sets; ++s)
        trialMoments_[s] = {means_[s * kBlock + k], variances_[s * kBlock + k]};
      if (objective_.needsExtremes()) {
        const FluxChange changes[2] = {{from, -flux}, {block[k], flux}};
        Evaluation evaluation;
        if (settleExtremes(changes, 2, best.evaluation, evaluation))
          best = {{{i, block[k]}, {}}, 1, evaluation};
        continue;
      }
      // note: made in place; a copy of what was just written would wait for the write.
      const Evaluation evaluation = objective_.judge(trialMoments_.data(), trialExtremes_.data());
      if (prefers(evaluation, best.evaluation)) best = {{{i, block[k]}, {}}, 1, evaluation};
    }
  }
}

std::uint32_t Evaluator::changesOf(const Trial& trial, FluxChange* changes) const {
  std::uint32_t count = 0;
  for (std::uint32_t k = 0; k < trial.count; ++k) {
    const Move& move = trial.moves[k];
    changes[count++] = {sites_[move.luminaire], -flux_[move.luminaire]};
    changes[count++] = {move.site, flux_[move.luminaire]};
  }
  return count;
}

void Evaluator::momentsAfter(const FluxChange* changes, std::uint32_t count) {
  for (std::size_t s = 0; s < moments_.size(); ++s) {
    const ObjectiveSet& set = objective_.sets()[s];
    const std::vector<double>& means = set.statistics->mean;
    double mean = moments_[s].mean;
    for (std::uint32_t k = 0; k < count; ++k) mean += set.counted(changes[k].flux) * means[changes[k].site];
    trialMoments_[s].mean = mean;
    if (sums_[s]) trialMoments_[s].variance = sums_[s]->changed(moments_[s].variance, changes, count);
  }
}

void Evaluator::tryPair(const Move& a, const Move& b, Trial& best) {
  Trial trial{{a, b}, 2, {}};
  FluxChange changes[4];
  const std::uint32_t count = changesOf(trial, changes);
  momentsAfter(changes, count);
  if (objective_.needsExtremes()) {
    if (!settleExtremes(changes, count, best.evaluation, trial.evaluation)) return;
  } else {
    trial.evaluation = objective_.judge(trialMoments_.data(), trialExtremes_.data());
    if (!prefers(trial.evaluation, best.evaluation)) return;
  }
  best = trial;
}

void Evaluator::apply(const Trial& trial) {
  FluxChange changes[4];
  const std::uint32_t n = resolve(changes, changesOf(trial, changes));
  for (std::uint32_t k = 0; k < trial.count; ++k) {
    const auto [i, to] = trial.moves[k];
    for (std::optional<VarianceSums>& sums : sums_)
      if (sums) sums->move(sites_[i], to, flux_[i]);
    sites_[i] = to;
  }
  relightPatches(n);
  refresh();
#ifdef FIATLUX_CHECK_DELTA
  assert(isExact(trial));
#endif
}

/// Do the trial that has just been made, the cached sums and a full evaluation agree?
bool Evaluator::isExact(const Trial& trial) {
  // note: patches are lit in float, step by step; a sigma of nearly 0 is a root of rounding.
  const double tolerance = objective_.needsExtremes() ? 1e-3 : 1e-6;
  const auto same = [&](double a, double b) {
    return a == b || std::fabs(a - b) <= tolerance * (1 + std::fabs(a));
  };
  const Evaluation full = evaluate(sites_);
  const bool isJudged = trial.evaluation.violation < kUnbounded;  // not so the choice of a survey
  const bool isTrialExact = !isJudged || (same(trial.evaluation.violation, full.violation) &&
                                          same(trial.evaluation.goal, full.goal));
  return isTrialExact && same(current_.violation, full.violation) && same(current_.goal, full.goal);
}

}  // namespace fiatlux
