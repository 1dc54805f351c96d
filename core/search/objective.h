// Intentions compiled for one scene: from the mean and variance of each surface set that matters (and the
// patch extremes, where true ones are asked for) to violation, goal and dimming.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/search/dimming.h"
#include "core/search/intentions.h"
#include "core/search/linear_worth.h"
#include "core/search/patch_extremes.h"
#include "core/search/prepared_scene.h"

namespace fiatlux {

/// What a row of means is of; all but that of surfaces has nothing else.
enum class RowOf : std::uint8_t {
  kSurfaces,
  kPowers,      // what the candidates draw
  kGlare,       // ObserverRows::glare: of the squares of the fluxes
  kBackground,  // ObserverRows::background
  kPlanes,      // means over the points of measuring planes
};

/// A surface set that the intentions mention, or another row that they need; `needsVariance` and
/// `needsExtremes` say what must be computed of it.
struct ObjectiveSet {
  SurfaceSet surfaces;
  std::shared_ptr<const KernelStatistics> statistics;
  bool needsVariance = false, needsExtremes = false;
  RowOf row = RowOf::kSurfaces;
  std::uint32_t observer = kNone;
  Quantity quantity = Quantity::kIlluminance;  // of surfaces
  std::optional<Constraint> ofPoints = {};     // of planes: what must be known of each point (PlaneValues)

  /// The flux that a luminaire of `flux` lm counts with, negative where it is taken away.
  double counted(double flux) const { return row == RowOf::kGlare ? flux * std::fabs(flux) : flux; }
};

/// What counts while layouts that are not good yet are walked through: goal - (1 - aimShare) x missed +
/// penalty x violation.
struct Prices {
  double penalty = 0;   // of a violation of 100 %; 0: violations come before goals
  double aimShare = 1;  // of what missed aims cost

  bool areFirm() const { return penalty == 0 && aimShare == 1; }
  double worthOf(const Evaluation& evaluation) const {
    return evaluation.goal - (1 - aimShare) * evaluation.missed + penalty * evaluation.violation;
  }
};

/// Layouts that are surveyed at once, and how far the moments of one set stand from those of the next.
inline constexpr std::uint32_t kSurveyed = 20, kSurveyStride = 64;
/// Trials that a survey counts for, as long as it takes.
inline constexpr std::uint32_t kTrialsPerSurvey = 5;
/// What is known of kSurveyed layouts, by sets, kSurveyStride entries from one to the next. `least` and
/// `most` of sets that need extremes only: no less and no more than these is hoped for
/// (PatchExtremes::hoped).
struct SurveyedLayouts {
  double *means, *variances;  // variances become sigmas
  const double *least, *most;
};
/// Surveys of so many layouts.
inline std::uint32_t surveysOf(std::size_t layouts) {
  return static_cast<std::uint32_t>((layouts + kSurveyed - 1) / kSurveyed);
}

class Objective {
 public:
  /// Goals are measured against their values for `reference` (one site a luminaire, never a tie) at the upper
  /// end of the dimming. Precondition: checkIntentions passed, as of a bound search: a true minimum or
  /// maximum is a goal with its margin, unscaled.
  Objective(PreparedScene& prepared, const Intentions& intentions, const Layout& reference);

  const std::vector<ObjectiveSet>& sets() const { return sets_; }
  bool needsExtremes() const { return needsExtremes_; }
  bool hasConstraints() const { return !sides_.empty(); }
  /// The share of what missed aims cost that is enough to lead a search to layouts that miss them little: an
  /// aim that weighs far more than the other goals hardly lets anything move. 1 where none does.
  double leadingAimShare() const { return leadingAimShare_; }

  /// `moments` and `extremes`: one per set (extremes are read only where needed). With hoped-for extremes the
  /// result is a bound: no layout with these moments is better.
  Evaluation judge(const Moments* moments, const Extremes* extremes) const;

  /// May trials be surveyed? Where all goals are of means and sigmas, and all bounds, or of extremes that are
  /// not to be too small or too large.
  bool maySurvey() const { return maySurvey_; }

  /// What kSurveyed layouts are worth at such prices: goal, violation and aims as of judge(), all at
  /// once and in a fraction of the time. Where no dimming meets all bounds it takes an end of the range, not
  /// the best t. Precondition: maySurvey().
  void survey(const SurveyedLayouts& layouts, const Prices& prices, double* worths) const;

  /// May their worth be told to first order? Where an aim holds the dimming it would be told too badly.
  bool mayLinearize() const {
    return maySurvey_ && !needsExtremes_ && !(hasAims_ && dimmingLow_ < dimmingHigh_);
  }
  /// The worth about a layout of these moments, which is dimmed so, at such prices. Precondition:
  /// mayLinearize().
  void linearize(const Moments* moments, double dimming, const Prices& prices, LinearWorth& worth) const;

  /// What mean and variance alone allow: 0 <= minimum <= mean, maximum >= mean + variance / mean
  /// (Bhatia-Davis).
  static Extremes allowedBy(const Moments& moments);

  /// What Evaluation::goal adds per unit of goal g's value: sign x weight / reference value; the weight of an
  /// aim.
  double goalFactor(std::size_t g) const { return terms_[g].factor; }

  /// Value of goal g at dimming t, in its own unit; of an aim the distance from its target.
  double goalValue(std::size_t g, const Moments* moments, const Extremes* extremes, double t) const;

 private:
  struct Bound {  // one finite bound of a constraint
    Statistic statistic;
    std::uint32_t set, over;
    double alpha, value;
    Side side;
    bool scaleFree;
    std::uint32_t observers = 0;  // of a ugr: their glare and background by turns, from `set` on
    bool isLeast = false;         // of points of planes
    double perUnit = 0;           // violation by a unit beyond the value
  };
  struct Term {  // one goal
    Statistic statistic;
    std::uint32_t set, over;
    double factor;  // sign x weight / |reference value|; the weight of an aim
    Side side;      // where the worst of what is not known exactly lies
    bool scaleFree;
    double target;  // above 0: it aims there
  };

  std::uint32_t setOf(PreparedScene& prepared, Quantity quantity, const SurfaceSet& surfaces,
                      bool withVariance);
  std::uint32_t setFor(PreparedScene& prepared, Quantity quantity, const StatisticTraits& traits,
                       const SurfaceSet& surfaces);
  std::uint32_t observerSets(PreparedScene& prepared, std::uint32_t first, std::uint32_t count);
  void addGlare(PreparedScene& prepared, const Constraint& constraint);
  std::uint32_t planeSet(PreparedScene& prepared, const Constraint& constraint);
  void addConstraint(PreparedScene& prepared, const Constraint& asked, Quantity quantity);
  void addGoal(PreparedScene& prepared, const Goal& goal, Quantity quantity);
  void scaleGoals(PreparedScene& prepared, const Intentions& intentions, const Layout& reference);
  double boundedValue(const Bound& bound, const Moments* moments, const Extremes* extremes) const;
  double glareOf(const Bound& bound, const Moments* moments) const;
  bool isSurveyable() const;
  const double* valuesOf(const Term& term, const SurveyedLayouts& layouts) const;
  void surveyGoals(const SurveyedLayouts& layouts, const double* slopes, const double* dimmings,
                   double aimShare, double* worths) const;
  void surveyDimming(const SurveyedLayouts& layouts, const double* slopes, double* dimmings) const;
  void surveyBound(const Bound& bound, const SurveyedLayouts& layouts, double* values) const;
  double termValue(const Term& term, const Moments* moments, const Extremes* extremes) const;

  /// Of the luminaires at full flux: lm, or W of types.
  double powerOf(const Moments* moments) const {
    return powerSet_ == kNone ? totalFlux_ : moments[powerSet_].mean;
  }

  std::vector<ObjectiveSet> sets_;
  std::vector<Bound> sides_;
  std::vector<Term> terms_;
  double totalFlux_ = 0, dimmingLow_ = 1, dimmingHigh_ = 1, leadingAimShare_ = 1;
  bool needsExtremes_ = false, powerVaries_ = false, maySurvey_ = false, hasAims_ = false;
  std::uint32_t powerSet_ = kNone;           // the set that sums powers, where power is asked for and varies
  mutable std::vector<DimmedBound> bounds_;  // scratch, one per side
  mutable std::vector<DimmedAim> aims_;      // scratch, one per aim
};

}  // namespace fiatlux
