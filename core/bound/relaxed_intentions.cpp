// Goals and constraints to convex forms; see relaxed_intentions.h.
#include "core/bound/relaxed_intentions.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/bound/diagonal_shift.h"
#include "core/search/objective.h"

namespace fiatlux {
namespace {

FluxRange fluxRangeOf(const LuminaireRules& rules) {
  FluxRange range;
  range.least = kUnbounded;
  for (std::uint32_t i = 0; i < rules.count; ++i) {
    const double flux = rules.dimmingHigh * fluxOf(rules, i);
    range.total += flux;
    range.squares += flux * flux;
    range.least = std::min(range.least, flux);
    range.largest = std::max(range.largest, flux);
  }
  return range;
}

/// Writes the forms of one problem, goal by goal and constraint by constraint.
class Relaxer {
 public:
  Relaxer(PreparedScene& prepared, const Intentions& intentions)
      : prepared_(prepared), intentions_(intentions), sites_(prepared.siteCount()) {
    result_.flux = fluxRangeOf(intentions.luminaires);
  }

  void addGoals(const Layout& reference) {
    const Objective objective(prepared_, intentions_, reference);
    result_.goal.linear.assign(sites_, 0.0);
    result_.supported = !intentions_.goals.empty();
    for (std::size_t g = 0; g < intentions_.goals.size(); ++g)
      addGoal(intentions_.goals[g], objective.goalFactor(g));
  }

  /// The convex sides of a constraint; a true minimum or maximum is asked of the mean at least.
  void addConstraint(const Constraint& c) {
    const bool lower = std::isfinite(c.lower), upper = std::isfinite(c.upper);
    switch (c.statistic) {
      case Statistic::kMean:
        if (lower) addSide(meanForm(c.surfaces, -1), -c.lower);
        if (upper) addSide(meanForm(c.surfaces, 1), c.upper);
        return;
      case Statistic::kMinimum:
        if (lower) addSide(meanForm(c.surfaces, -1), -c.lower);
        return;
      case Statistic::kMaximum:
        if (upper) addSide(meanForm(c.surfaces, 1), c.upper);
        return;
      case Statistic::kSigma:
        if (upper) addSide(withSigma(meanForm(c.surfaces, 0), c.surfaces, 1), c.upper);
        return;
      case Statistic::kChebyshev:
        if (lower) addSide(withSigma(meanForm(c.surfaces, -1), c.surfaces, c.alpha), -c.lower);
        if (upper) addSide(withSigma(meanForm(c.surfaces, 1), c.surfaces, c.alpha), c.upper);
        return;
      case Statistic::kPower:
        if (lower) addSide(powerForm(-1), -c.lower);
        if (upper) addSide(powerForm(1), c.upper);
        return;
      case Statistic::kContrast:
        if (lower) addSide(sumOf(meanForm(c.surfaces, -1), meanForm(c.over, c.lower)), 0);
        if (upper) addSide(sumOf(meanForm(c.surfaces, 1), meanForm(c.over, -c.upper)), 0);
        return;
      case Statistic::kUniformity:
        return;
    }
  }

  RelaxedIntentions take() { return std::move(result_); }

 private:
  std::vector<double> covarianceOf(const SurfaceSet& surfaces) const {
    return unionStatistics(prepared_.scene(), intentions_.quantity, surfaces).covariance;
  }

  ConvexObjective meanForm(const SurfaceSet& surfaces, double factor) {
    ConvexObjective form;
    form.linear = prepared_.statistics(intentions_.quantity, surfaces)->mean;
    for (double& entry : form.linear) entry *= factor;
    return form;
  }

  /// factor x (lm of all luminaires): what the common dimming leaves of them.
  ConvexObjective powerForm(double factor) const {
    ConvexObjective form;
    form.linear.assign(sites_, 0.0);
    form.perDimming = factor * result_.flux.total / intentions_.luminaires.dimmingHigh;
    return form;
  }

  static ConvexObjective sumOf(ConvexObjective a, const ConvexObjective& b) {
    for (std::size_t j = 0; j < a.linear.size(); ++j) a.linear[j] += b.linear[j];
    return a;
  }

  /// + weight sigma, from below: sqrt(x^T (C + ridge I) x) is above sigma by at most sqrt(ridge x^T x).
  ConvexObjective withSigma(ConvexObjective form, const SurfaceSet& surfaces, double weight) const {
    if (weight == 0) return form;
    double ridge = 0;
    auto matrix = convexMatrix(covarianceOf(surfaces), sites_, ridge);
    form.terms.push_back({std::move(matrix), weight, true});
    form.constant -= weight * std::sqrt(ridge * result_.flux.squares);
    return form;
  }

  void addGoal(const Goal& goal, double factor) {
    ConvexObjective& sum = result_.goal;
    if (goal.statistic == Statistic::kMean) {
      sum = sumOf(std::move(sum), meanForm(goal.surfaces, factor));
    } else if (goal.statistic == Statistic::kPower) {
      sum.perDimming += powerForm(factor).perDimming;
    } else if (goal.statistic == Statistic::kSigma && factor < 0) {
      sum.constant +=
          factor * std::sqrt(largestVariance(covarianceOf(goal.surfaces), intentions_.luminaires, sites_));
    } else if (goal.statistic == Statistic::kSigma && intentions_.goals.size() == 1) {
      // Alone, its square serves as well, and takes the diagonal shift.
      result_.squared = true;
      result_.covariance = covarianceOf(goal.surfaces);
      for (double& entry : result_.covariance) entry *= factor * factor;
      double ridge = 0;
      sum.terms.push_back({convexMatrix(result_.covariance, sites_, ridge), 1, false});
      sum.constant -= ridge * result_.flux.squares;
    } else if (goal.statistic == Statistic::kSigma) {
      sum = withSigma(std::move(sum), goal.surfaces, factor);
    } else {
      result_.supported = false;
    }
  }

  /// form <= bound, scaled so that multipliers are of the goal's size.
  void addSide(ConvexObjective form, double bound) {
    form.constant -= bound;
    double scale = std::fabs(bound);
    if (scale == 0)
      for (double entry : form.linear) scale = std::max(scale, std::fabs(entry) * result_.flux.total);
    if (scale == 0) return;
    form.constant /= scale;
    form.perDimming /= scale;
    for (double& entry : form.linear) entry /= scale;
    for (ConvexTerm& term : form.terms) term.weight /= scale;
    result_.sides.push_back(std::move(form));
  }

  PreparedScene& prepared_;
  const Intentions& intentions_;
  std::uint32_t sites_;
  RelaxedIntentions result_;
};

}  // namespace

std::shared_ptr<const std::vector<double>> convexMatrix(std::vector<double> covariance, std::uint32_t m,
                                                        double& ridge) {
  ridge = convexRidge(covariance, m);
  for (std::uint32_t i = 0; i < m; ++i) covariance[std::size_t{i} * m + i] += ridge;
  return std::make_shared<const std::vector<double>>(std::move(covariance));
}

double largestVariance(const std::vector<double>& covariance, const LuminaireRules& rules, std::uint32_t m) {
  std::vector<char> usable(m, 1);
  for (std::uint32_t site : rules.excluded) usable[site] = 0;
  for (std::uint32_t site : rules.pinned) usable[site] = 0;
  std::vector<double> free;  // fluxes that may hang anywhere, largest first
  for (std::uint32_t i = static_cast<std::uint32_t>(rules.pinned.size()); i < rules.count; ++i)
    free.push_back(fluxOf(rules, i));
  std::sort(free.begin(), free.end(), std::greater<>());
  // What the pinned ones and the best free partners add to site i.
  const auto partnersOf = [&](std::uint32_t i, bool isFree) {
    const double* row = &covariance[std::size_t{i} * m];
    double sum = 0;
    for (std::uint32_t k = 0; k < rules.pinned.size(); ++k)
      if (rules.pinned[k] != i) sum += fluxOf(rules, k) * row[rules.pinned[k]];
    std::vector<double> partners;
    for (std::uint32_t j = 0; j < m; ++j)
      if (usable[j] && j != i) partners.push_back(row[j]);
    std::sort(partners.begin(), partners.end(), std::greater<>());
    // Beside a free one, the k-th largest flux of the others lies between free[k + 1] and free[k].
    for (std::size_t k = 0; k + isFree < free.size(); ++k)
      sum += partners[k] * free[isFree && partners[k] < 0 ? k + 1 : k];
    return sum;
  };
  double total = 0;
  for (std::uint32_t k = 0; k < rules.pinned.size(); ++k) {
    const std::uint32_t i = rules.pinned[k];
    total +=
        fluxOf(rules, k) * (fluxOf(rules, k) * covariance[std::size_t{i} * m + i] + partnersOf(i, false));
  }
  std::vector<double> best;
  for (std::uint32_t i = 0; i < m && !free.empty(); ++i)
    if (usable[i]) best.push_back(free[0] * covariance[std::size_t{i} * m + i] + partnersOf(i, true));
  std::sort(best.begin(), best.end(), std::greater<>());
  for (std::size_t k = 0; k < free.size(); ++k) total += free[k] * best[k];
  return std::max(total, 0.0) * rules.dimmingHigh * rules.dimmingHigh;
}

RelaxedIntentions relaxIntentions(PreparedScene& prepared, const Intentions& intentions,
                                  const Layout& reference) {
  Relaxer relaxer(prepared, intentions);
  relaxer.addGoals(reference);
  for (const Constraint& constraint : intentions.constraints) relaxer.addConstraint(constraint);
  return relaxer.take();
}

}  // namespace fiatlux
