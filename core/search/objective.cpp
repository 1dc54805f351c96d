// Compiled intentions; see objective.h.
#include "core/search/objective.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/search/plane_values.h"
#include "core/search/validate_intentions.h"

namespace fiatlux {
namespace {

constexpr double kBeyondAll = 1e30;  // an infinite ratio in a sum of goals, which stays a number
constexpr double kLeadingAim = 3;    // times as weighty as all other goals: so much leads a search to an aim

double leadingShareOf(const std::vector<Goal>& goals) {
  double heaviestAim = 0, others = 0;
  for (const Goal& goal : goals) {
    if (goal.sense == Sense::kNear)
      heaviestAim = std::max(heaviestAim, goal.weight);
    else
      others += goal.weight;
  }
  return others > 0 && heaviestAim > kLeadingAim * others ? kLeadingAim * others / heaviestAim : 1;
}

/// What a ratio adds to the goal; one without a value is the worst, for ratios are 0 or more.
double worthOf(double ratio, double factor) {
  if (std::isnan(ratio)) return factor > 0 ? factor * kBeyondAll : 0;
  return factor * std::min(ratio, kBeyondAll);
}

}  // namespace

Objective::Objective(PreparedScene& prepared, const Intentions& intentions, const Layout& reference)
    : dimmingLow_(intentions.luminaires.dimmingLow),
      dimmingHigh_(intentions.luminaires.dimmingHigh),
      leadingAimShare_(leadingShareOf(intentions.goals)),
      powerVaries_(countVaries(intentions.luminaires) || !prepared.scene().hangings.empty()) {
  assert(checkIntentions(prepared.scene(), intentions, Asking::kBoundSearch));
  for (double flux : fluxesOf(intentions.luminaires)) totalFlux_ += flux;
  for (const Goal& goal : intentions.goals) addGoal(prepared, goal, quantityOf(intentions, goal));
  for (const Constraint& constraint : intentions.constraints)
    addConstraint(prepared, constraint, quantityOf(intentions, constraint));
  bounds_.resize(sides_.size());
  scaleGoals(prepared, intentions, reference);
  maySurvey_ = isSurveyable();
}

std::uint32_t Objective::setOf(PreparedScene& prepared, Quantity quantity, const SurfaceSet& surfaces,
                               bool withVariance) {
  const auto isSame = [&](const ObjectiveSet& set) {
    return set.row == RowOf::kSurfaces && set.quantity == quantity && set.surfaces == surfaces;
  };
  const auto s = static_cast<std::uint32_t>(std::find_if(sets_.begin(), sets_.end(), isSame) - sets_.begin());
  if (s == sets_.size())
    sets_.push_back({surfaces, nullptr, false, false, RowOf::kSurfaces, kNone, quantity});
  ObjectiveSet& set = sets_[s];
  if (!set.statistics || (withVariance && !set.needsVariance))
    set.statistics = prepared.statistics(quantity, surfaces, withVariance);
  set.needsVariance |= withVariance;
  return s;
}

std::uint32_t Objective::setFor(PreparedScene& prepared, Quantity quantity, const StatisticTraits& traits,
                                const SurfaceSet& surfaces) {
  if (!traits.needsSurfaces) {
    if (powerVaries_ && powerSet_ == kNone) {
      powerSet_ = static_cast<std::uint32_t>(sets_.size());
      sets_.push_back({{}, prepared.powers(), false, false, RowOf::kPowers});
    }
    return 0;
  }
  const std::uint32_t s = setOf(prepared, quantity, surfaces, traits.needsVariance);
  sets_[s].needsExtremes |= traits.needsExtremes;
  needsExtremes_ |= traits.needsExtremes;
  return s;
}

/// Where the glare and background of `count` observers from `first` on stand, by turns.
std::uint32_t Objective::observerSets(PreparedScene& prepared, std::uint32_t first, std::uint32_t count) {
  const auto isThere = [&](std::size_t at) {
    for (std::uint32_t k = 0; k < count; ++k, at += 2)
      if (at >= sets_.size() || sets_[at].row != RowOf::kGlare || sets_[at].observer != first + k)
        return false;
    return true;
  };
  for (std::uint32_t s = 0; s < sets_.size(); ++s)
    if (isThere(s)) return s;
  const auto begin = static_cast<std::uint32_t>(sets_.size());
  for (std::uint32_t o = first; o < first + count; ++o) {
    sets_.push_back({{}, prepared.seenBy(o, true), false, false, RowOf::kGlare, o});
    sets_.push_back({{}, prepared.seenBy(o, false), false, false, RowOf::kBackground, o});
  }
  return begin;
}

/// As a bound on the glare ratio, which the dimming scales (core/scene/observer.h).
void Objective::addGlare(PreparedScene& prepared, const Constraint& c) {
  const auto all = static_cast<std::uint32_t>(prepared.scene().observers.size());
  const bool worst = c.observer == kNone;
  const std::uint32_t first = worst ? 0 : c.observer, count = worst ? all : 1;
  assert(first + count <= all);
  sides_.push_back({Statistic::kUgr, observerSets(prepared, first, count), 0, 0, ratioOf(c.upper),
                    Side::kUpper, false, count});
}

/// The mean of its points is a sum of what each luminaire does there, but for a ratio.
std::uint32_t Objective::planeSet(PreparedScene& prepared, const Constraint& c) {
  ObjectiveSet set{{}, prepared.rowOf(meanOfPoints(prepared, c)), false, false, RowOf::kPlanes};
  if (c.isLeast || c.statistic == Statistic::kModelling || (c.onGrid && c.statistic != Statistic::kMean)) {
    set.ofPoints = c;
    needsExtremes_ = true;
  }
  sets_.push_back(std::move(set));
  return static_cast<std::uint32_t>(sets_.size() - 1);
}

void Objective::addConstraint(PreparedScene& prepared, const Constraint& asked, Quantity quantity) {
  if (asked.statistic == Statistic::kUgr) return addGlare(prepared, asked);
  const StatisticTraits& traits = traitsOf(asked.statistic);
  Constraint c = asked;
  c.quantity = quantity;
  Bound bound{c.statistic,
              isOfPoints(c) ? planeSet(prepared, c) : setFor(prepared, quantity, traits, c.surfaces),
              0,
              c.alpha,
              0,
              Side::kLower,
              traits.scaleFree(),
              0,
              c.isLeast};
  if (traits.needsOver) bound.over = setOf(prepared, quantity, c.over, false);
  for (const Side side : {Side::kLower, Side::kUpper}) {
    bound.side = side;
    bound.value = side == Side::kLower ? c.lower : c.upper;
    bound.perUnit = 1 / std::fabs(bound.value);
    if (std::isfinite(bound.value)) sides_.push_back(bound);
  }
}

void Objective::addGoal(PreparedScene& prepared, const Goal& goal, Quantity quantity) {
  const StatisticTraits& traits = traitsOf(goal.statistic);
  const bool most = goal.sense == Sense::kMaximize, near = goal.sense == Sense::kNear;
  Term term{goal.statistic,
            setFor(prepared, quantity, traits, goal.surfaces),
            0,
            most ? -goal.weight : goal.weight,
            most ? Side::kLower : Side::kUpper,
            traits.scaleFree(),
            near ? goal.target : 0};
  if (near) aims_.emplace_back();
  hasAims_ |= near;
  if (traits.needsOver) term.over = setOf(prepared, quantity, goal.over, false);
  terms_.push_back(term);
}

void Objective::scaleGoals(PreparedScene& prepared, const Intentions& intentions, const Layout& reference) {
  const auto count = static_cast<std::uint32_t>(reference.sites.size());
  const std::vector<double> flux = fluxesOf(intentions.luminaires, count);
  PreparedScene& sites = prepared.sites();
  std::vector<Moments> moments;
  for (std::uint32_t s = 0; s < sets_.size(); ++s) {
    const bool ofSurfaces = sets_[s].row == RowOf::kSurfaces;
    if (!ofSurfaces && s != powerSet_) {  // note: no goal reads what observers see
      moments.emplace_back();
      continue;
    }
    const bool hasVariance = sets_[s].needsVariance;
    const auto statistics =
        ofSurfaces ? sites.statistics(sets_[s].quantity, sets_[s].surfaces, hasVariance) : sites.powers();
    moments.push_back(momentsOf(*statistics, reference.sites.data(), flux.data(), count, hasVariance));
  }
  const std::vector<Extremes> none(sets_.size());
  for (Term& term : terms_) {
    if (traitsOf(term.statistic).needsExtremes || term.target > 0) continue;
    double value = termValue(term, moments.data(), none.data());
    if (!term.scaleFree) value *= dimmingHigh_;
    if (value > 1e-12 && std::isfinite(value)) term.factor /= value;
  }
}

double Objective::termValue(const Term& term, const Moments* moments, const Extremes* extremes) const {
  return valueOf(term.statistic,
                 {moments + term.set, moments + term.over, extremes + term.set, powerOf(moments)}, term.side,
                 0);
}

/// The largest glare ratio of its observers.
double Objective::glareOf(const Bound& bound, const Moments* moments) const {
  double largest = 0;
  for (const Moments *seen = moments + bound.set, *end = seen + 2 * bound.observers; seen != end; seen += 2)
    largest = std::max(largest, glareRatio({seen[0].mean, seen[1].mean}));
  return largest;
}

double Objective::boundedValue(const Bound& bound, const Moments* moments, const Extremes* extremes) const {
  if (bound.observers > 0) return glareOf(bound, moments);
  return valueOf(
      bound.statistic,
      {moments + bound.set, moments + bound.over, extremes + bound.set, powerOf(moments), 0, bound.isLeast},
      bound.side, bound.alpha);
}

Evaluation Objective::judge(const Moments* moments, const Extremes* extremes) const {
  double slope = 0, constant = 0;
  std::uint32_t aims = 0;
  for (const Term& term : terms_) {
    const double value = termValue(term, moments, extremes);
    if (term.target > 0)
      aims_[aims++] = {value, term.target, term.factor};
    else if (term.scaleFree)
      constant += worthOf(value, term.factor);
    else
      slope += term.factor * value;
  }
  // The usual trial has nothing to solve; a call saved is a tenth of it.
  if (sides_.empty() && aims == 0 && dimmingLow_ == dimmingHigh_)
    return {0, constant + slope * dimmingLow_, dimmingLow_};
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const Bound& bound = sides_[i];
    bounds_[i] = {boundedValue(bound, moments, extremes), bound.value, bound.side, bound.scaleFree,
                  missWeightOf(bound.statistic)};
  }
  return solveDimming(bounds_.data(), static_cast<std::uint32_t>(bounds_.size()),
                      {slope, constant, aims_.data(), aims}, dimmingLow_, dimmingHigh_);
}

Extremes Objective::allowedBy(const Moments& moments) {
  const double mean = std::max(moments.mean, 0.0);
  const double spread = mean > 0 ? std::max(0.0, moments.variance) / mean : 0;
  return {mean, 0, kUnbounded, mean + spread};
}

double Objective::goalValue(std::size_t g, const Moments* moments, const Extremes* extremes, double t) const {
  const double value = termValue(terms_[g], moments, extremes);
  if (terms_[g].target > 0) return distanceFrom(terms_[g].target, t * value);
  return terms_[g].scaleFree ? value : t * value;
}

}  // namespace fiatlux
