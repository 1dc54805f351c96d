// How good is a layout, provably? A value that no layout meeting the intentions can beat, by convex
// relaxation (split luminaires), Lagrange multipliers for the constraints, and z_i^2 = z_i moved out of the
// covariance's diagonal. Only dual values are told, never an unconverged primal one; constraints that are not
// convex are let go, which keeps it a bound.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/convex_relaxation.h"
#include "core/diagonal_shift.h"
#include "core/objective.h"

namespace fiatlux {

class OptimumBound {
 public:
  /// `reference` as for Evaluator, so that goals are in the same units. `incumbent`: the best layout known;
  /// the better, the sooner the bound is tight. Precondition: checkIntentions passed. Matrices are copied;
  /// nothing is referred to.
  OptimumBound(PreparedScene& prepared, const Intentions& intentions, const Evaluation& incumbent,
               const Layout* reference = nullptr);

  /// False where no bound is known: without a goal, or with a contrast as goal.
  bool supported() const { return supported_; }

  /// Goes on for about so many Frank-Wolfe steps (O(sites) each; a Newton step counts as 200).
  void advance(std::uint32_t steps);
  bool done() const { return !supported_ || stage_ == Stage::kDone; }

  /// No layout that meets the constraints has an Evaluation::goal below this; -infinity until something is
  /// proved.
  double goal() const { return bound_; }

  /// The best possible is better than `evaluation` by at most this share; nothing while nothing is proved, or
  /// when the evaluation violates a constraint.
  std::optional<double> within(const Evaluation& evaluation) const;

 private:
  enum class Stage : std::uint8_t { kMultipliers, kShift, kPolish, kDone };

  void addGoals(PreparedScene& prepared, const Intentions& intentions, const Layout& reference);
  void addConstraint(PreparedScene& prepared, const Constraint& constraint, Quantity quantity);
  void addSide(ConvexObjective form, double bound);
  ConvexObjective meanForm(PreparedScene& prepared, Quantity quantity, const SurfaceSet& surfaces,
                           double factor) const;
  void addSigma(ConvexObjective& form, PreparedScene& prepared, Quantity quantity, const SurfaceSet& surfaces,
                double weight) const;
  void openRound();
  void closeRound();
  void closeMultipliers();
  void keep(double value);
  double constraintValue(const ConvexObjective& form) const;

  bool supported_ = false, squared_ = false, shiftable_ = false;
  std::uint32_t sites_ = 0;
  double totalFlux_ = 0, squareFlux_ = 0, least_ = 0,
         largest_ = 0;  // lm, lm2, of the luminaires at full dimming
  double high_ = 1;
  ConvexRelaxation relaxation_;
  ConvexObjective objective_;
  std::vector<ConvexObjective> sides_;  // each <= 0
  std::vector<double> multipliers_, bestMultipliers_;
  std::unique_ptr<DiagonalShift> shift_;
  double target_ = 0, bound_ = 0, bestDual_ = 0, pace_ = 1;
  Stage stage_ = Stage::kMultipliers;
  std::uint32_t stepsInRound_ = 0, rounds_ = 0, fruitless_ = 0, shifts_ = 0;
};

}  // namespace fiatlux
