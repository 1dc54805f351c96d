// Figures 6 and 7 of the paper with their borderline cases; see alpha_search.h.
#include "core/alpha_search.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/start_layout.h"
#include "core/validate_intentions.h"

namespace fiatlux {
namespace {

constexpr double kMet = 1e-9;  // a violation that is none

bool isGuarantee(const Constraint& c) {
  return (c.statistic == Statistic::kMinimum && std::isfinite(c.lower)) ||
         (c.statistic == Statistic::kMaximum && std::isfinite(c.upper));
}

std::string text(double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.4g", value);
  return buffer;
}

const char* unitOf(Quantity quantity) { return quantity == Quantity::kIlluminance ? " lx" : " lm/m2"; }

}  // namespace

const char* regionName(Region region) {
  return region == Region::kOne ? "I" : region == Region::kTwo ? "II" : "III";
}

Result<Done> checkAlphaIntentions(const Scene& scene, const Intentions& intentions) {
  if (auto ok = checkIntentions(scene, intentions); !ok) return ok;
  for (const Constraint& c : intentions.constraints)
    if (isGuarantee(c)) return Done{};
  return Error{
      "there is no guarantee to find an alpha for; add a constraint on \"minimum\" with \"min\", or on "
      "\"maximum\" "
      "with \"max\""};
}

Intentions chebyshevProblem(const Intentions& intentions, double alpha) {
  Intentions problem = intentions;
  problem.constraints.clear();
  for (const Constraint& c : intentions.constraints) {
    if (!isGuarantee(c)) {
      problem.constraints.push_back(c);
      continue;
    }
    const bool minimum = c.statistic == Statistic::kMinimum;
    Constraint replaced{Statistic::kChebyshev, -kUnbounded, kUnbounded, alpha, c.surfaces, {}};
    (minimum ? replaced.lower : replaced.upper) = minimum ? c.lower : c.upper;
    problem.constraints.push_back(replaced);
    // The other side of a guarantee (a minimum from above, say) has no Chebyshev form and stays what it is.
    Constraint rest = c;
    (minimum ? rest.lower : rest.upper) = minimum ? -kUnbounded : kUnbounded;
    if (std::isfinite(rest.lower) || std::isfinite(rest.upper)) problem.constraints.push_back(rest);
  }
  return problem;
}

AlphaSearch::AlphaSearch(PreparedScene& prepared, const Intentions& intentions, const AlphaOptions& options)
    : prepared_(prepared), intentions_(intentions), options_(options) {
  options_.runs = std::max(options_.runs, 1u);
  reference_ = {spreadSites(prepared, intentions.luminaires), {}, 1};
  openProblem(0);
}

void AlphaSearch::advance(std::uint32_t evaluations) {
  while (evaluations > 0 && !done()) {
    const std::uint32_t slice = std::min(evaluations, left_);
    vns_->advance(slice);
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
    vns_.emplace(prepared_, problem_, seed, nullptr, &reference_);
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
  vns_.emplace(prepared_, problem_, seed, start, &reference_);
}

void AlphaSearch::closeRun() {
  if (run_ == 0 || isBetter(vns_->evaluation(), bestEvaluation_)) {
    best_ = vns_->incumbent();
    bestEvaluation_ = vns_->evaluation();
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
  std::vector<double> flux = layout.flux;
  for (double& lumens : flux) lumens *= layout.dimming;
  const auto count = static_cast<std::uint32_t>(flux.size());
  for (const Constraint& c : intentions_.constraints) {
    if (!isGuarantee(c)) continue;
    PatchExtremes patches(prepared_.scene(), intentions_.quantity, c.surfaces);
    patches.load(layout.sites.data(), flux.data(), count);
    const Extremes extremes = patches.current();
    kept = kept && (c.statistic == Statistic::kMinimum ? extremes.minimumLow >= c.lower
                                                       : extremes.maximumHigh <= c.upper);
    if (!first) continue;
    first = false;
    const KernelStatistics& s = *prepared_.statistics(intentions_.quantity, c.surfaces);
    result.mean = meanOf(s.mean.data(), layout.sites.data(), flux.data(), count);
    result.sigma = std::sqrt(std::max(0.0, varianceOf(s.covariance.data(), prepared_.siteCount(),
                                                      layout.sites.data(), flux.data(), count)));
    result.minimum = extremes.minimumLow;
    result.maximum = extremes.maximumHigh;
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
  double worst = -1;
  for (std::size_t c = 0; c < intentions_.constraints.size(); ++c) {
    const Constraint& constraint = intentions_.constraints[c];
    if (!isGuarantee(constraint)) continue;
    const Layout& layout = iterations_.back().layout;
    const ExplicitStatistics light =
        explicitStatistics(prepared_.scene(), illuminanceOf(prepared_.scene(), layout), constraint.surfaces);
    const double excess =
        constraint.statistic == Statistic::kMinimum
            ? (constraint.lower - light.minimum) / std::max(std::fabs(constraint.lower), 1e-12)
            : (light.maximum - constraint.upper) / std::max(std::fabs(constraint.upper), 1e-12);
    if (excess <= worst) continue;
    worst = excess;
    broken_ = c;
  }
  problem_ = intentions_;
  const Constraint& broken = intentions_.constraints[broken_];
  const bool minimum = broken.statistic == Statistic::kMinimum;
  problem_.constraints.erase(problem_.constraints.begin() + static_cast<std::ptrdiff_t>(broken_));
  problem_.goals = {
      {broken.statistic, minimum ? Sense::kMaximize : Sense::kMinimize, 1, broken.surfaces, {}}};
  run_ = 0;
  openRun();
}

void AlphaSearch::closeBound() {
  if (bestEvaluation_.violation <= kMet) {
    fallback_ = best_;
    feasibleBound_ = std::fabs(bestEvaluation_.goal);
  }
  conclude(outcome_);
}

/// "at least 40 lx on every patch of yellow wall"
std::string AlphaSearch::guarantee() const {
  const Constraint& c = intentions_.constraints[broken_];
  const bool minimum = c.statistic == Statistic::kMinimum;
  return std::string(minimum ? "at least " : "at most ") + text(minimum ? c.lower : c.upper) +
         unitOf(intentions_.quantity) + " on every patch of " + surfaceSetName(prepared_.scene(), c.surfaces);
}

void AlphaSearch::conclude(AlphaOutcome outcome) {
  outcome_ = outcome;
  stage_ = Stage::kDone;
  vns_.reset();
  if (solution_) {
    for (broken_ = 0; !isGuarantee(intentions_.constraints[broken_]);) ++broken_;
    const bool minimum = intentions_.constraints[broken_].statistic == Statistic::kMinimum;
    const AlphaIteration& found = iterations_[*solution_];
    const std::string extreme = std::string(minimum ? "the darkest patch has " : "the brightest patch has ") +
                                text(minimum ? found.minimum : found.maximum) + unitOf(intentions_.quantity);
    verdict_ =
        outcome == AlphaOutcome::kZeroSuffices
            ? "The best layout keeps " + guarantee() + " without further care (alpha 0): " + extreme + "."
            : "With alpha = " + text(found.alpha) + ", the smallest found, the layout keeps " + guarantee() +
                  ": " + extreme + ".";
    return;
  }
  verdict_ =
      outcome == AlphaOutcome::kNoLayout
          ? "No layout found can give " + guarantee() + ": even the means fall short."
      : outcome == AlphaOutcome::kTwoEmpty
          ? "No alpha leads to " + guarantee() +
                ": with a small one some patches miss it, with a larger one no layout meets the margin."
          : "Stopped before an alpha was found that keeps " + guarantee() + ".";
  const bool minimum = intentions_.constraints[broken_].statistic == Statistic::kMinimum;
  if (!fallback_) {
    verdict_ += " The other intentions cannot all be met either: relax one of them first.";
    return;
  }
  const double asked =
      minimum ? intentions_.constraints[broken_].lower : intentions_.constraints[broken_].upper;
  const bool direct = minimum ? feasibleBound_ >= asked : feasibleBound_ <= asked;
  verdict_ += direct ? " A search on the patches themselves does find such a layout, with " +
                           text(feasibleBound_) + unitOf(intentions_.quantity) + "."
                     : std::string(" The ") + (minimum ? "largest minimum" : "smallest maximum") +
                           " found feasible is " + text(feasibleBound_) + unitOf(intentions_.quantity) +
                           ": ask for that, or add luminaires or flux.";
}

}  // namespace fiatlux
