// Figures 6 and 7 of the paper with their borderline cases; see alpha_search.h.
#include "core/alpha/alpha_search.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/alpha/alpha_verdict.h"
#include "core/alpha/guarantees.h"
#include "core/search/start_layout.h"

namespace fiatlux {
namespace {

constexpr double kMet = 1e-9;  // a violation that is none

}  // namespace

const char* regionName(Region region) {
  return region == Region::kOne ? "I" : region == Region::kTwo ? "II" : "III";
}

AlphaSearch::AlphaSearch(PreparedScene& prepared, const Intentions& intentions, const AlphaOptions& options)
    : prepared_(prepared), intentions_(intentions), options_(options) {
  assert(checkAlphaIntentions(prepared.scene(), intentions));
  options_.runs = std::max(options_.runs, 1u);
  reference_ = {spreadSites(prepared, intentions.luminaires), {}, 1};
  openProblem(0);
}

void AlphaSearch::advance(std::uint32_t evaluations) {
  while (evaluations > 0 && !done()) {
    const std::uint32_t slice = std::min(evaluations, left_);
    search_->advance(slice);
    evaluations_ += slice;
    evaluations -= slice;
    left_ -= slice;
    if (left_ == 0) closeRun();
  }
}

/// [E, Phi] <- OptCh(alpha): several runs, the best counts.
void AlphaSearch::openProblem(double alpha) {
  alpha_ = alpha;
  problem_ = chebyshevProblem(intentions_, alpha);
  run_ = 0;
  openRun();
}

void AlphaSearch::openRun() {
  left_ = options_.evaluations;
  const std::uint64_t seed = options_.seed * 1000003 + run_;
  if (run_ > 0 || iterations_.empty()) {
    search_.emplace(prepared_, problem_, seed, nullptr, &reference_);
    return;
  }
  // Start from whichever known layout suits this alpha best: what a larger alpha allowed, a smaller one does
  // too.
  Evaluator evaluator(prepared_, problem_, &reference_);
  const Layout* start = nullptr;
  Evaluation best;
  for (const AlphaIteration& known : iterations_) {
    const Evaluation evaluation = evaluator.evaluate(known.layout.sites);
    if (start && !isBetter(evaluation, best)) continue;
    start = &known.layout;
    best = evaluation;
  }
  search_.emplace(prepared_, problem_, seed, start, &reference_);
}

void AlphaSearch::closeRun() {
  if (run_ == 0 || isBetter(search_->evaluation(), bestEvaluation_)) {
    best_ = search_->incumbent();
    bestEvaluation_ = search_->evaluation();
  }
  if (++run_ < options_.runs) return openRun();
  if (stage_ == Stage::kBound)
    closeBound();
  else
    closeIteration();
}

void AlphaSearch::closeIteration() {
  iterations_.push_back(iterationOf(best_, bestEvaluation_.violation <= kMet));
  const AlphaIteration last = iterations_.back();
  if (stage_ == Stage::kZero)
    afterZero(last);
  else if (stage_ == Stage::kInterval)
    afterInterval(last);
  else
    afterBipartition(last);
}

/// Measures the answer of OptCh, on the true patches too.
AlphaIteration AlphaSearch::iterationOf(const Layout& layout, bool feasible) {
  AlphaIteration result;
  result.alpha = alpha_;
  result.low = low_;
  result.high = high_;
  result.bipartition = stage_ == Stage::kBipartition;
  result.layout = layout;
  bool kept = true, first = true;
  for (const Constraint& c : intentions_.constraints) {
    if (!isGuarantee(c)) continue;
    const Quantity quantity = quantityOf(intentions_, c);
    const Extremes extremes = extremesUnder(prepared_.scene(), quantity, c.surfaces, layout);
    kept = kept && shortfallOf(c, extremes) <= 0;
    if (!first) continue;
    first = false;
    result.minimum = extremes.minimumLow;
    result.maximum = extremes.maximumHigh;
    std::vector<double> flux = layout.flux;
    for (double& lumens : flux) lumens *= layout.dimming;
    const Moments moments = momentsOf(*prepared_.statistics(quantity, c.surfaces), layout.sites.data(),
                                      flux.data(), static_cast<std::uint32_t>(flux.size()));
    result.mean = moments.mean;
    result.sigma = moments.sigma();
  }
  Evaluator evaluator(prepared_, problem_, &reference_);
  evaluator.load(layout.sites);
  result.phi = problem_.goals.size() == 1 ? evaluator.goalValue(0) : evaluator.current().goal;
  result.region = !feasible ? Region::kThree : kept ? Region::kTwo : Region::kOne;
  return result;
}

/// Alpha = 0 asks of the means only what any layout that keeps the bounds has: try it before anything else.
void AlphaSearch::afterZero(const AlphaIteration& last) {
  if (last.region == Region::kThree) return openBound(AlphaOutcome::kNoLayout);
  if (last.region == Region::kTwo) {
    solution_ = 0;
    return conclude(AlphaOutcome::kZeroSuffices);
  }
  lowAt_ = 0;
  stage_ = Stage::kInterval;
  openProblem(high_);
}

/// Figure 7 (a): find (alpha a, alpha b) with a in region I and b in region II.
void AlphaSearch::afterInterval(const AlphaIteration& last) {
  if (last.region == Region::kTwo) {
    highAt_ = iterations_.size() - 1;
    stage_ = Stage::kBipartition;
    if (stops()) {
      solution_ = highAt_;
      return conclude(AlphaOutcome::kFound);
    }
    return openProblem((low_ + high_) / 2);
  }
  if (last.region == Region::kThree) {
    third_ = high_;
    high_ = (low_ + high_) / 2;
  } else {
    lowAt_ = iterations_.size() - 1;
    const double width = high_ - low_;
    low_ = high_;
    high_ += width;
    if (high_ >= third_) high_ = (low_ + third_) / 2;  // region III is known there: do not go back into it
  }
  if (third_ - low_ <= options_.deltaAlpha) return openBound(AlphaOutcome::kTwoEmpty);
  if (iterations_.size() >= options_.iterations) return openBound(AlphaOutcome::kOutOfIterations);
  openProblem(high_);
}

/// Figure 7 (b): halve the interval.
void AlphaSearch::afterBipartition(const AlphaIteration& last) {
  (last.region == Region::kTwo ? highAt_ : lowAt_) = iterations_.size() - 1;
  (last.region == Region::kTwo ? high_ : low_) = last.alpha;
  if (!stops()) return openProblem((low_ + high_) / 2);
  solution_ = highAt_;
  conclude(AlphaOutcome::kFound);
}

bool AlphaSearch::stops() const {
  const double a = iterations_[*lowAt_].phi, b = iterations_[*highAt_].phi;
  const bool flat = options_.deltaPhi > 0 && std::fabs(b - a) <= options_.deltaPhi * std::fabs(b);
  return high_ - low_ <= options_.deltaAlpha || flat || iterations_.size() >= options_.iterations;
}

/// No alpha works: which bound would? The broken guarantee becomes the goal, everything else stays asked.
void AlphaSearch::openBound(AlphaOutcome outcome) {
  outcome_ = outcome;
  stage_ = Stage::kBound;
  broken_ = firstGuarantee();
  double worst = -kUnbounded;
  for (std::size_t c = broken_; c < intentions_.constraints.size(); ++c) {
    const Constraint& constraint = intentions_.constraints[c];
    if (!isGuarantee(constraint)) continue;
    const double shortfall =
        shortfallOf(constraint, extremesUnder(prepared_.scene(), quantityOf(intentions_, constraint),
                                              constraint.surfaces, iterations_.back().layout));
    if (shortfall <= worst) continue;
    worst = shortfall;
    broken_ = c;
  }
  problem_ = intentions_;
  const Constraint& broken = intentions_.constraints[broken_];
  const bool minimum = broken.statistic == Statistic::kMinimum;
  problem_.constraints.erase(problem_.constraints.begin() + static_cast<std::ptrdiff_t>(broken_));
  problem_.goals = {{broken.statistic,
                     minimum ? Sense::kMaximize : Sense::kMinimize,
                     1,
                     broken.surfaces,
                     {},
                     0,
                     quantityOf(intentions_, broken)}};
  run_ = 0;
  openRun();
}

std::size_t AlphaSearch::firstGuarantee() const {
  std::size_t c = 0;
  while (!isGuarantee(intentions_.constraints[c])) ++c;
  return c;
}

void AlphaSearch::closeBound() {
  if (bestEvaluation_.violation <= kMet) {
    fallback_ = best_;
    feasibleBound_ = std::fabs(bestEvaluation_.goal);
  }
  conclude(outcome_);
}

void AlphaSearch::conclude(AlphaOutcome outcome) {
  outcome_ = outcome;
  stage_ = Stage::kDone;
  search_.reset();
  const Constraint& guarantee = intentions_.constraints[solution_ ? firstGuarantee() : broken_];
  verdict_ = alphaVerdict(*this, prepared_.scene(), quantityOf(intentions_, guarantee), guarantee);
}

}  // namespace fiatlux
