// The statistics that may be asked of the light: one table (name, unit, what each needs), the one value of
// each from mean, variance and patch extremes, and the convex form of each that the proved bound may use. The
// search, what is shown, the checks, intentions.json, the worker's codes and the relaxation all ask here.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>

#include "core/scene/layout.h"
#include "core/scene/observer.h"

namespace fiatlux {

inline constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// In the order of the table; the worker's codes are these numbers.
enum class Statistic : std::uint8_t {
  kMean,        // mu = a x, paper (8)
  kSigma,       // sigma = sqrt(x^T C x), paper (10)
  kPower,       // total flux of the luminaires, lm, or W of types; no surface
  kChebyshev,   // mu - alpha sigma against a lower bound, mu + alpha sigma against an upper one, paper (14)
  kMinimum,     // over the patches
  kMaximum,     // over the patches
  kUniformity,  // U_o = minimum / mean
  kContrast,    // mean of `surfaces` / mean of `over`
  kUgr,         // unified glare rating of an observer, or of the worst (core/scene/observer.h)
  // Of the grid's points of measuring planes (core/scene/plane_points.h), their mean or the least of them:
  kCylindrical,  // E_z: the mean of the vertical planes of all directions
  kModelling,    // E_z / E_h
  kVertical,     // on a plane that faces a direction
};

enum class Unit : std::uint8_t {
  kLight,  // of the quantity asked for: lx, or lm/m2
  kLux,    // lx, whatever the quantity
  kFlux,   // lm; W where luminaires are of types
  kRatio,  // none: the common dimming does not change it
  kGlare,  // none: the dimming changes its glareRatio as it does the light
};

struct StatisticTraits {
  Statistic statistic;
  const char* name;  // in intentions.json, on the page and wherever a person reads it
  Unit unit;
  bool mayBeGoal;      // of a person; a bound on it may be asked of every statistic
  bool mayBeAimed;     // as a goal, "near" a target too
  bool needsSurfaces;  // it belongs to surfaces, not to the luminaires
  bool needsOver;      // and to a second set that it is compared with
  bool needsAlpha;
  bool needsVariance, needsExtremes;  // what has to be known of its surfaces beside the mean
  bool ofPlanes = false;              // its surfaces are measuring planes, and it may be of their least point

  constexpr bool scaleFree() const { return unit == Unit::kRatio; }
};

// note: extremes need the variance too, which tells most trials apart without a patch in sight.
inline constexpr StatisticTraits kStatistics[] = {
    // statistic, name, unit, goal, aimed, surfaces, over, alpha, variance, extremes
    {Statistic::kMean, "mean", Unit::kLight, true, true, true, false, false, false, false},
    {Statistic::kSigma, "sigma", Unit::kLight, true, false, true, false, false, true, false},
    {Statistic::kPower, "power", Unit::kFlux, true, false, false, false, false, false, false},
    {Statistic::kChebyshev, "chebyshev", Unit::kLight, false, false, true, false, true, true, false},
    {Statistic::kMinimum, "minimum", Unit::kLight, false, false, true, false, false, true, true},
    {Statistic::kMaximum, "maximum", Unit::kLight, false, false, true, false, false, true, true},
    {Statistic::kUniformity, "uniformity", Unit::kRatio, false, false, true, false, false, true, true},
    {Statistic::kContrast, "contrast", Unit::kRatio, true, false, true, true, false, false, false},
    {Statistic::kUgr, "ugr", Unit::kGlare, false, false, false, false, false, false, false},
    {Statistic::kCylindrical, "cylindrical", Unit::kLux, false, false, true, false, false, false, false,
     true},
    {Statistic::kModelling, "modelling", Unit::kRatio, false, false, true, false, false, false, false, true},
    {Statistic::kVertical, "vertical", Unit::kLux, false, false, true, false, false, false, false, true},
};

constexpr const StatisticTraits& traitsOf(Statistic statistic) {
  return kStatistics[static_cast<std::size_t>(statistic)];
}

constexpr bool isInOrder() {
  for (std::size_t i = 0; i < std::size(kStatistics); ++i)
    if (static_cast<std::size_t>(kStatistics[i].statistic) != i) return false;
  return true;
}
static_assert(isInOrder(), "the table is in the order of the enum");

/// "mean", "sigma", ...
constexpr const char* statisticName(Statistic statistic) { return traitsOf(statistic).name; }

/// "lx", "lm/m2", "lm", or "" of a ratio.
const char* unitName(Statistic statistic, Quantity quantity);

// --- The value

/// Mean and variance of one surface set.
struct Moments {
  double mean = 0, variance = 0;

  double sigma() const { return std::sqrt(std::max(0.0, variance)); }
};

/// Least and largest light of one surface set, each with the margin of the stored responses' error bound on
/// either side: the true minimum lies in [minimumLow, minimumHigh], the true maximum in [maximumLow,
/// maximumHigh].
struct Extremes {
  double minimumLow = 0, minimumHigh = 0, maximumLow = 0, maximumHigh = 0;
};

/// What a statistic is read from; only what its traits need has to be there.
struct LightReading {
  const Moments* at = nullptr;         // of its surfaces
  const Moments* over = nullptr;       // of what they are compared with
  const Extremes* extremes = nullptr;  // of its surfaces
  double power = 0;                    // lm, or W of types
  double glareRatio = 0;               // of its observer, or the largest of all
  bool isLeast = false;                // of points: the least of them is asked for, `extremes` has it
};

/// Which bound a value is held against: what is not known exactly counts at its less favourable end.
enum class Side : std::uint8_t { kLower, kUpper };

/// Against darkness every light is an infinite contrast; darkness against darkness is none (NaN).
inline double contrastOf(double mean, double overMean) {
  if (overMean > 0) return mean / overMean;
  return mean > 0 ? kUnbounded : std::numeric_limits<double>::quiet_NaN();
}

/// The value of a statistic, in its unit. `alpha` is read where the traits need it.
inline double valueOf(Statistic statistic, const LightReading& light, Side side, double alpha) {
  const bool lower = side == Side::kLower;
  switch (statistic) {
    case Statistic::kMean:
      return light.at->mean;
    case Statistic::kSigma:
      return light.at->sigma();
    case Statistic::kPower:
      return light.power;
    case Statistic::kChebyshev:
      return light.at->mean + (lower ? -alpha : alpha) * light.at->sigma();
    case Statistic::kMinimum:
      return lower ? light.extremes->minimumLow : light.extremes->minimumHigh;
    case Statistic::kMaximum:
      return lower ? light.extremes->maximumLow : light.extremes->maximumHigh;
    case Statistic::kUniformity: {
      const double least = lower ? light.extremes->minimumLow : light.extremes->minimumHigh;
      return light.at->mean > 0 ? least / light.at->mean : 0;  // a dark surface is not called even
    }
    case Statistic::kContrast:
      return contrastOf(light.at->mean, light.over->mean);
    case Statistic::kUgr:
      return ugrOf(light.glareRatio);
    case Statistic::kCylindrical:
    case Statistic::kModelling:
    case Statistic::kVertical:
      return light.isLeast ? light.extremes->minimumLow : light.at->mean;
  }
  return 0;
}

/// How far a value is inside a finite bound, as a share of it (as it is where the bound is 0); negative where
/// it is not met. What has no value (NaN) misses its bound by all of it.
inline double marginTo(double bound, Side side, double value) {
  const double inside = side == Side::kLower ? value - bound : bound - value;
  if (std::isnan(inside)) return -1;
  return bound != 0 ? inside / std::fabs(bound) : inside;
}

/// How far a value misses a finite bound, likewise: max(0, -marginTo).
inline double excessOver(double bound, Side side, double value) {
  const double excess = side == Side::kLower ? bound - value : value - bound;
  if (excess <= 0) return 0;
  if (std::isnan(excess)) return 1;
  return bound == 0 ? excess : excess / std::fabs(bound);
}

/// What the excess of a statistic counts in the sum of a search. The ratio of a ugr grows by a third a unit,
/// as nothing else that is bounded: fully counted, one that cannot be met would lead to whatever blinds a
/// little less, at the cost of all else.
inline double missWeightOf(Statistic statistic) { return statistic == Statistic::kUgr ? 0.1 : 1; }

/// What a goal "near" a target is worth, 0 at best. Precondition: target > 0.
inline double distanceFrom(double target, double value) { return std::fabs(value - target) / target; }

// --- The relaxation

/// mean mu + sigma sigma + over mu_over + power P + constant, with sigma >= 0: convex in the fluxes.
struct RelaxedForm {
  double mean = 0, sigma = 0, over = 0, power = 0, constant = 0;
};

/// A form that is at most 0 for every layout that meets the bound; nothing where none is known.
std::optional<RelaxedForm> relaxedSide(Statistic statistic, Side side, double bound, double alpha);

/// The statistic's value as such a form; nothing where it has none.
std::optional<RelaxedForm> relaxedValue(Statistic statistic);

}  // namespace fiatlux
