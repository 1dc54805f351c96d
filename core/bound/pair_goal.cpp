// Intentions in terms of occupied sites; see pair_goal.h.
#include "core/bound/pair_goal.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace fiatlux {
namespace {

constexpr std::uint32_t kMostSites = 420, kMostRows = 1800;  // what a step and its memory can bear

bool applies(const PreparedScene& prepared, const LuminaireRules& rules, const RelaxedIntentions& problem) {
  const bool equal =
      std::all_of(rules.flux.begin(), rules.flux.end(), [&](double flux) { return flux == rules.flux[0]; });
  return problem.supported && !prepared.isTied() && !countVaries(rules) && equal &&
         rules.dimmingLow == rules.dimmingHigh && problem.sigmas.size() <= 1;
}

/// A form that is affine in z, once the pinned luminaires are summed up.
struct AffineForm {
  std::vector<double> linear;
  double constant = 0;
};

/// Sites apart by what may become of them.
class Places {
 public:
  Places(const PreparedScene& prepared, const LuminaireRules& rules, double flux)
      : prepared_(prepared), minDistance_(rules.minDistance), flux_(flux), t_(rules.dimmingHigh) {
    for (std::uint32_t i = 0; i < rules.count; ++i)
      if (isPinned(rules, i)) pinned_.push_back(rules.pinned[i]);
    for (std::uint32_t site = 0; site < prepared.candidateCount(); ++site) {
      const bool barred =
          std::count(rules.excluded.begin(), rules.excluded.end(), site) > 0 ||
          std::any_of(pinned_.begin(), pinned_.end(), [&](std::uint32_t pin) { return areApart(site, pin); });
      if (!barred) free_.push_back(site);
    }
  }

  const std::vector<std::uint32_t>& free() const { return free_; }
  std::size_t pinnedCount() const { return pinned_.size(); }

  AffineForm affine(const ConvexObjective& of) const {
    AffineForm form;
    form.constant = of.constant + of.perDimming * t_;
    for (std::uint32_t site : pinned_) form.constant += of.linear[site] * flux_;
    for (std::uint32_t site : free_) form.linear.push_back(of.linear[site] * flux_);
    return form;
  }

  /// x C x for x = flux z.
  void square(const std::vector<double>& covariance, PairGoal& goal) const {
    const std::size_t stride = prepared_.candidateCount(), m = free_.size();
    const auto at = [&](std::uint32_t i, std::uint32_t j) {
      return flux_ * flux_ * covariance[i * stride + j];
    };
    goal.square.resize(m * m);
    for (std::size_t i = 0; i < m; ++i) {
      for (std::size_t j = 0; j < m; ++j) goal.square[i * m + j] = at(free_[i], free_[j]);
      for (std::uint32_t pin : pinned_) goal.square[i * m + i] += 2 * at(free_[i], pin);
    }
    for (std::uint32_t a : pinned_)
      for (std::uint32_t b : pinned_) goal.squareConstant += at(a, b);
  }

  std::vector<std::pair<std::uint32_t, std::uint32_t>> apart() const {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::uint32_t i = 0; i < free_.size(); ++i)
      for (std::uint32_t j = i + 1; j < free_.size(); ++j)
        if (areApart(free_[i], free_[j])) pairs.emplace_back(i, j);
    return pairs;
  }

 private:
  bool areApart(std::uint32_t a, std::uint32_t b) const { return prepared_.conflict(a, b, minDistance_); }

  const PreparedScene& prepared_;
  double minDistance_, flux_, t_;
  std::vector<std::uint32_t> pinned_, free_;
};

void addForm(PairProblem& layouts, AffineForm form, double least, double most) {
  layouts.forms.push_back({std::move(form.linear), -form.constant, least, most});
}

double sumOfFirst(std::vector<double> values, double count, bool isLeast) {
  std::sort(values.begin(), values.end());
  if (!isLeast) std::reverse(values.begin(), values.end());
  const std::size_t taken = std::min(values.size(), static_cast<std::size_t>(count));
  return std::accumulate(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(taken), 0.0);
}

}  // namespace

double PairGoal::leastLinear() const { return sumOfFirst(linear, layouts.count, true); }
double PairGoal::mostLinear() const { return sumOfFirst(linear, layouts.count, false); }

std::optional<PairGoal> pairGoalOf(const PreparedScene& prepared, const LuminaireRules& rules,
                                   const RelaxedIntentions& problem) {
  if (!applies(prepared, rules, problem)) return std::nullopt;
  const Places places(prepared, rules, rules.dimmingHigh * rules.flux[0]);
  const std::size_t m = places.free().size(), forms = 1 + problem.aims.size() + problem.sides.size();
  const auto count = static_cast<double>(rules.count - places.pinnedCount());
  if (count < 2 || m > kMostSites || m * forms > kMostRows) return std::nullopt;

  PairGoal goal;
  goal.layouts.sites = static_cast<std::uint32_t>(m);
  goal.layouts.count = count;
  goal.layouts.apart = places.apart();
  addForm(goal.layouts, {std::vector<double>(m, 1.0), -count}, -kUnbounded, kUnbounded);
  // What an aim misses is missed once for each luminaire: each has its share of the weight.
  for (const RelaxedAim& aim : problem.aims)
    addForm(goal.layouts, places.affine(aim.form), -aim.weight / count, aim.weight / count);
  // Of a side the part that is linear: the sigmas in it are not negative.
  for (const ConvexObjective& side : problem.sides)
    addForm(goal.layouts, places.affine(side), -kUnbounded, 0);

  const AffineForm rest = places.affine(problem.goal);
  goal.linear = rest.linear;
  goal.constant = rest.constant - problem.goal.constant + problem.rest;
  if (problem.sigmas.empty()) return goal;
  const RelaxedSigma& sigma = problem.sigmas[0];
  goal.factor = sigma.factor;
  places.square(prepared.exactCovariance(sigma.quantity, sigma.surfaces), goal);
  return goal;
}

}  // namespace fiatlux
