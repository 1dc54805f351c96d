// Goals and constraints to convex forms; see relaxed_intentions.h.
#include "core/bound/relaxed_intentions.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "core/bound/diagonal_shift.h"
#include "core/search/objective.h"

namespace fiatlux {
namespace {

FluxRange fluxRangeOf(const LuminaireRules& rules) {
  FluxRange range;
  range.least = kUnbounded;
  for (std::uint32_t i = 0; i < mostOf(rules); ++i) {
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
      : prepared_(prepared), intentions_(intentions), sites_(prepared.candidateCount()) {
    result_.flux = fluxRangeOf(intentions.luminaires);
  }

  void addGoals(const Layout& reference) {
    const Objective objective(prepared_, intentions_, reference);
    result_.goal.linear.assign(sites_, 0.0);
    result_.supported = !intentions_.goals.empty();
    for (std::size_t g = 0; g < intentions_.goals.size(); ++g)
      addGoal(intentions_.goals[g], objective.goalFactor(g));
  }

  /// The sides of a constraint that have a convex form.
  void addConstraint(const Constraint& c) {
    if (std::isfinite(c.lower)) addSide(c, Side::kLower, c.lower);
    if (std::isfinite(c.upper)) addSide(c, Side::kUpper, c.upper);
  }

  RelaxedIntentions take() { return std::move(result_); }

 private:
  /// A surface set, and of which light.
  struct LitSet {
    Quantity quantity;
    const SurfaceSet& surfaces;
  };
  template <class Intention>
  LitSet setOf(const Intention& of) const {
    return {quantityOf(intentions_, of), of.surfaces};
  }
  template <class Intention>
  LitSet overOf(const Intention& of) const {
    return {quantityOf(intentions_, of), of.over};
  }

  /// Of more candidates none are made; bounds then do without what they say.
  bool hasCovariances() const {
    return std::max<std::size_t>(sites_, prepared_.scene().sites.size()) <= kMostInCovariance;
  }

  std::vector<double> covarianceOf(const LitSet& set) const {
    return prepared_.exactCovariance(set.quantity, set.surfaces);
  }

  void addMean(ConvexObjective& to, const LitSet& set, double factor) const {
    const auto statistics = prepared_.statistics(set.quantity, set.surfaces, false);
    for (std::uint32_t j = 0; j < sites_; ++j) to.linear[j] += factor * statistics->mean[j];
  }

  /// + weight sigma, from below: sqrt(x^T (C + ridge I) x) is above sigma by at most sqrt(ridge x^T x).
  void addSigma(ConvexObjective& to, const LitSet& set, double weight) const {
    if (!hasCovariances()) return;  // at least 0
    double ridge = 0;
    auto matrix = convexMatrix(covarianceOf(set), sites_, ridge);
    to.terms.push_back({std::move(matrix), weight, true});
    to.constant -= weight * std::sqrt(ridge * result_.flux.squares);
  }

  void addPower(ConvexObjective& to, double factor) const {
    const auto powers = prepared_.powers();
    for (std::uint32_t j = 0; j < sites_; ++j) to.linear[j] += factor * powers->mean[j];
  }

  /// + factor x the part of a form that is linear in x and t. Power is what the common dimming leaves of the
  /// fluxes.
  template <class Intention>
  void addLinear(ConvexObjective& to, const RelaxedForm& form, const Intention& of, double factor) const {
    if (form.mean != 0) addMean(to, setOf(of), factor * form.mean);
    if (form.over != 0) addMean(to, overOf(of), factor * form.over);
    const bool isEqual = !prepared_.isTied() && prepared_.scene().hangings.empty();
    if (isEqual)
      to.perDimming += factor * form.power * result_.flux.total / intentions_.luminaires.dimmingHigh;
    else if (form.power != 0)
      addPower(to, factor * form.power);
    to.constant += factor * form.constant;
  }

  /// The goal's value times `factor`, or what is never above that.
  void addGoal(const Goal& goal, double factor) {
    const std::optional<RelaxedForm> form = relaxedValue(goal.statistic);
    if (!form) {
      result_.supported = false;
      return;
    }
    if (goal.sense == Sense::kNear) return addAim(goal, *form, factor);
    addLinear(result_.goal, *form, goal, factor);
    if (form->sigma == 0) return;
    const LitSet set = setOf(goal);
    result_.sigmas.push_back({set.quantity, set.surfaces, factor * form->sigma});
    addSigmaGoal(set, factor * form->sigma);
  }

  /// weight |value / target - 1|. Precondition: the value is linear.
  void addAim(const Goal& goal, const RelaxedForm& value, double weight) {
    RelaxedAim aim;
    aim.weight = weight;
    aim.form.linear.assign(sites_, 0.0);
    addLinear(aim.form, value, goal, 1 / goal.target);
    aim.form.constant -= 1;
    result_.aims.push_back(std::move(aim));
  }

  void addSigmaGoal(const LitSet& set, double factor) {
    if (!hasCovariances() || (factor < 0 && prepared_.isTied())) {
      result_.supported = false;
      return;
    }
    if (factor < 0) {
      result_.goal.constant +=
          factor * std::sqrt(largestVariance(covarianceOf(set), intentions_.luminaires, sites_));
      return;
    }
    const LuminaireRules& rules = intentions_.luminaires;
    if (intentions_.goals.size() > 1 || rules.dimmingLow < rules.dimmingHigh)
      return addSigma(result_.goal, set, factor);
    // Alone, its square serves as well, and takes the diagonal shift.
    result_.squared = true;
    result_.covariance = covarianceOf(set);
    for (double& entry : result_.covariance) entry *= factor * factor;
    double ridge = 0;
    result_.goal.terms.push_back({convexMatrix(result_.covariance, sites_, ridge), 1, false});
    result_.goal.constant -= ridge * result_.flux.squares;
  }

  /// What a side says, scaled so that multipliers are of the goal's size.
  void addSide(const Constraint& c, Side side, double bound) {
    const std::optional<RelaxedForm> asked = relaxedSide(c.statistic, side, bound, c.alpha);
    if (!asked || c.onGrid) return;  // note: a grid's mean is not its surface's
    ConvexObjective form;
    form.linear.assign(sites_, 0.0);
    addLinear(form, *asked, c, 1);
    if (asked->sigma != 0) addSigma(form, setOf(c), asked->sigma);
    double scale = std::fabs(asked->constant);
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

namespace {

/// A luminaire on its site: one term of x.
struct Placed {
  std::uint32_t site;
  double flux;
};

/// For each site, what the luminaires around one there add at most: the pinned ones and the best free
/// partners.
class Partners {
 public:
  Partners(const std::vector<double>& covariance, const LuminaireRules& rules, std::uint32_t m)
      : covariance_(covariance), m_(m), usable_(m, 1) {
    for (std::uint32_t site : rules.excluded) usable_[site] = 0;
    for (std::uint32_t i = 0; i < rules.count; ++i)
      if (isPinned(rules, i)) {
        usable_[rules.pinned[i]] = 0;
        pinned_.push_back({rules.pinned[i], fluxOf(rules, i)});
      } else {
        free_.push_back(fluxOf(rules, i));
      }
    std::sort(free_.begin(), free_.end(), std::greater<>());
  }

  const std::vector<Placed>& pinned() const { return pinned_; }
  const std::vector<double>& free() const { return free_; }  // fluxes that may hang anywhere, largest first
  bool usable(std::uint32_t site) const { return usable_[site] != 0; }

  double sumAt(std::uint32_t i, bool isFree) const {
    const double* row = &covariance_[std::size_t{i} * m_];
    double sum = 0;
    for (const Placed& pin : pinned_)
      if (pin.site != i) sum += pin.flux * row[pin.site];
    std::vector<double> partners;
    for (std::uint32_t j = 0; j < m_; ++j)
      if (usable_[j] && j != i) partners.push_back(row[j]);
    std::sort(partners.begin(), partners.end(), std::greater<>());
    // Beside a free one, the k-th largest flux of the others lies between free[k + 1] and free[k].
    for (std::size_t k = 0; k + isFree < free_.size(); ++k)
      sum += partners[k] * free_[isFree && partners[k] < 0 ? k + 1 : k];
    return sum;
  }

 private:
  const std::vector<double>& covariance_;
  std::uint32_t m_;
  std::vector<char> usable_;
  std::vector<Placed> pinned_;
  std::vector<double> free_;
};

}  // namespace

double largestVariance(const std::vector<double>& covariance, const LuminaireRules& rules, std::uint32_t m) {
  const Partners partners(covariance, rules, m);
  const std::vector<double>& free = partners.free();
  double total = 0;
  for (const Placed& pin : partners.pinned())
    total += pin.flux *
             (pin.flux * covariance[std::size_t{pin.site} * m + pin.site] + partners.sumAt(pin.site, false));
  std::vector<double> best;
  for (std::uint32_t i = 0; i < m && !free.empty(); ++i)
    if (partners.usable(i))
      best.push_back(free[0] * covariance[std::size_t{i} * m + i] + partners.sumAt(i, true));
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
