// How good is a layout, provably? A value that no layout meeting the intentions can beat, by convex
// relaxation (relaxed_intentions.h), Lagrange multipliers for the constraints, dimming by dimming, and
// z_i^2 = z_i moved out of the covariance's diagonal; then, where that applies, by what pairs of luminaires
// may do (pair_bound.h). Only dual values are told, never an unconverged primal one.
#pragma once

#include <cassert>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/bound/convex_relaxation.h"
#include "core/bound/diagonal_shift.h"
#include "core/bound/pair_bound.h"
#include "core/bound/relaxed_intentions.h"
#include "core/search/objective.h"

namespace fiatlux {

class OptimumBound {
 public:
  /// `reference` as for Evaluator, so that goals are in the same units. `incumbent`: the best layout known;
  /// the better, the sooner the bound is tight. Precondition: checkIntentions passed. Matrices are copied;
  /// nothing is referred to.
  OptimumBound(PreparedScene& prepared, const Intentions& intentions, const Evaluation& incumbent,
               const Layout* reference = nullptr);
  /// Of layouts of ties: `prepared` is of them, and `tiedRules` are the intentions' in their terms (vns.h).
  OptimumBound(PreparedScene& prepared, const Intentions& intentions, const LuminaireRules& tiedRules,
               const Evaluation& incumbent, const Layout* reference = nullptr);

  /// False where no bound is known: without a goal, or with a contrast as goal.
  bool supported() const { return problem_.supported; }

  /// Goes on for about so many Frank-Wolfe steps (O(sites) each; a step that factors matrices counts as
  /// 200 or 1000).
  void advance(std::uint32_t steps);
  bool done() const { return !problem_.supported || stage_ == Stage::kDone; }

  /// No layout that meets the constraints has an Evaluation::goal below this; -infinity until something is
  /// proved.
  double goal() const { return bound_; }

  /// Takes away the last and longest stage, PairBound's, to be gone through elsewhere; nothing where there is
  /// none. Precondition: advance() has not come to it.
  std::optional<PairGoal> takePairs() {
    assert(!pairs_);
    return std::exchange(pairGoal_, std::nullopt);
  }
  /// Takes what PairBound has proved of them there; goal() stays the best that is known.
  void provedByPairs(double goal);
  /// Was goal() proved by pairs of luminaires?
  bool isByPairs() const { return isByPairs_; }

  /// The best possible is better than `evaluation` by at most this share of the bound; nothing while nothing
  /// is proved, or when the evaluation violates a constraint.
  std::optional<double> within(const Evaluation& evaluation) const;

 private:
  OptimumBound(PreparedScene& prepared, const Intentions& intentions, ConvexRelaxation relaxation,
               const Evaluation& incumbent, const Layout* reference);

  enum class Stage : std::uint8_t { kMultipliers, kShift, kPolish, kPairs, kDone };

  /// A form that a multiplier stands before, and what the multiplier may be.
  struct Multiplied {
    const ConvexObjective& form;
    double least, largest;
  };
  Multiplied multiplied(std::size_t k) const;
  /// No goal is below constant + slope t: what multipliers prove for one dimming, they prove so for all.
  struct Line {
    double constant, slope;
    double at(double t) const { return constant + slope * t; }
  };
  struct Lowest {
    double goal, dimming;
  };
  bool isDimmed() const { return dimmingLow_ < dimmingHigh_; }
  double leastDimming() const;
  Lowest lowest() const;
  void keepLine(double dual);
  bool goToLowest();
  void openRound();
  void moveDiagonal();
  void closeRound();
  void closeMultipliers();
  void advancePairs();
  void keep(double value);
  bool keepGoal(double goal);
  double constraintValue(const ConvexObjective& form) const;

  std::uint32_t sites_ = 0;
  RelaxedIntentions problem_;
  ConvexRelaxation relaxation_;
  std::vector<double> multipliers_, bestMultipliers_;  // of the sides, then of the aims
  std::unique_ptr<DiagonalShift> shift_;
  std::optional<PairGoal> pairGoal_;  // until its bound is begun
  std::unique_ptr<PairBound> pairs_;
  bool isByPairs_ = false;
  double target_ = 0, bound_ = 0, bestDual_ = 0, pace_ = 1;
  double dimmingLow_ = 1, dimmingHigh_ = 1, constant_ = 0;  // constant_: of the Lagrangian
  std::vector<Line> lines_;                                 // where there is a range of the dimming
  Stage stage_ = Stage::kMultipliers;
  std::uint32_t stepsInRound_ = 0, rounds_ = 0, fruitless_ = 0, shifts_ = 0;
};

}  // namespace fiatlux
