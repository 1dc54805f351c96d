// What a person asks of the light: goals and constraints on statistics of surfaces (paper
// sections 2.1, 3.1, 3.4), and the luminaires that may be used. Plain data; evaluation is in evaluator.h.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/scene/layout.h"

namespace fiatlux {

enum class Statistic : std::uint8_t {
  kMean,        // mu = a x, paper (8)
  kSigma,       // sigma = sqrt(x^T C x), paper (10)
  kPower,       // total flux of the luminaires, lm; no surface
  kChebyshev,   // lower bound on mu - alpha sigma, upper bound on mu + alpha sigma, paper (14)
  kMinimum,     // over the patches
  kMaximum,     // over the patches
  kUniformity,  // U_o = minimum / mean
  kContrast,    // mean of `surfaces` / mean of `over`
};

enum class Sense : std::uint8_t { kMinimize, kMaximize };

inline constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// Part of the objective: weight x (signed value / value of the start layout), summed over the goals and
/// minimised.
struct Goal {
  Statistic statistic = Statistic::kSigma;  // mean, sigma, power or contrast
  Sense sense = Sense::kMinimize;
  double weight = 1;
  SurfaceSet surfaces, over;  // `over` for contrast only
};

/// lower <= statistic <= upper; either may be infinite. For kChebyshev: mu - alpha sigma >= lower and
/// mu + alpha sigma <= upper. Violation = sum of max(0, excess) / |bound| (excess itself where the bound is
/// 0).
struct Constraint {
  Statistic statistic = Statistic::kMean;
  double lower = -kUnbounded,
         upper = kUnbounded;  // in the unit of the quantity; a ratio for uniformity, contrast
  double alpha = 1;           // kChebyshev only
  SurfaceSet surfaces, over;
};

/// The luminaires at the search's disposal.
struct LuminaireRules {
  std::uint32_t count = 6;
  std::vector<double> flux = {1000};       // lm: one value for all, or one per luminaire
  double dimmingLow = 1, dimmingHigh = 1;  // range of the common factor t; equal = no dimming
  std::vector<std::uint32_t> pinned;       // sites of luminaires 0..pinned.size()-1, kept where they are
  std::vector<std::uint32_t> excluded;     // sites that stay free
  double minDistance = 0;                  // m, between the centres of any two luminaires
};

struct Intentions {
  LuminaireRules luminaires;
  std::vector<Goal> goals;
  std::vector<Constraint> constraints;
  Quantity quantity = Quantity::kIlluminance;
};

}  // namespace fiatlux
