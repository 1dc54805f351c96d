// The intentions as a convex problem that no layout beats: each goal and each side of a constraint becomes a
// convex form that is never above it. What has no such form is bounded by a constant (the largest sigma) or
// let go (a uniformity), which keeps it a bound.
#pragma once

#include <cstdint>
#include <vector>

#include "core/bound/convex_relaxation.h"
#include "core/search/intentions.h"
#include "core/search/prepared_scene.h"

namespace fiatlux {

/// The luminaires' fluxes at the upper end of the dimming, lm (lm2 for `squares`).
struct FluxRange {
  double total = 0, squares = 0, least = 0, largest = 0;
};

/// A covariance made surely convex by a ridge that Cholesky approves; `ridge` becomes what was added to the
/// diagonal. `covariance` is m x m, row-major.
std::shared_ptr<const std::vector<double>> convexMatrix(std::vector<double> covariance, std::uint32_t m,
                                                        double& ridge);

/// x^T C x is at most this for every layout under the rules (Gilmore and Lawler): each luminaire with the
/// partners that suit it best. C is m x m, row-major, symmetric.
double largestVariance(const std::vector<double>& covariance, const LuminaireRules& rules, std::uint32_t m);

/// weight |form|, form affine: a goal near a target. It is the largest multiplier x form, |multiplier| <=
/// weight.
struct RelaxedAim {
  ConvexObjective form;
  double weight = 0;
};

/// A sigma in the goal, and what it counts a unit.
struct RelaxedSigma {
  Quantity quantity = Quantity::kIlluminance;
  SurfaceSet surfaces;
  double factor = 0;
};

struct RelaxedIntentions {
  /// False where no bound is known: without a goal, with a contrast as goal, or for the most sigma of ties.
  bool supported = false;
  FluxRange flux;
  ConvexObjective goal;  // with the aims never above Evaluation::goal, or above its square where `squared`
  bool squared = false;  // the goal is one sigma to make small, of one dimming
  std::vector<RelaxedSigma> sigmas;    // the goal is goal.linear x + perDimming t + these + the aims
  std::vector<double> covariance;      // where squared: C in the goal's units, m x m
  std::vector<RelaxedAim> aims;        // to be added to `goal`
  std::vector<ConvexObjective> sides;  // each <= 0 for every layout that meets the constraints
};

/// In terms of the prepared scene's candidates: x is a tie's flux, that of each of its luminaires. Goals are
/// measured against their values for `reference`, as in Objective. Precondition: checkIntentions passed.
RelaxedIntentions relaxIntentions(PreparedScene& prepared, const Intentions& intentions,
                                  const Layout& reference);

}  // namespace fiatlux
