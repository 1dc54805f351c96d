// Intentions in terms of occupied sites; see pair_goal.h.
#include "core/bound/pair_goal.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/bound/exclusive_groups.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kMostSites = 420, kMostRows = 1800;  // what a step and its memory can bear

bool applies(const PreparedScene& prepared, const LuminaireRules& rules, const RelaxedIntentions& problem) {
  const bool equal =
      std::all_of(rules.flux.begin(), rules.flux.end(), [&](double flux) { return flux == rules.flux[0]; });
  return problem.supported && !prepared.isTied() && !countVaries(rules) && equal && rules.dimmingLow > 0 &&
         problem.sigmas.size() <= 1;
}

/// t (linear z + constant + inverse / t), once the pinned luminaires are summed up.
struct AffineForm {
  std::vector<double> linear;
  double constant = 0, inverse = 0;
};

/// Sites apart by what may become of them.
class Places {
 public:
  Places(const PreparedScene& prepared, const LuminaireRules& rules, double flux)
      : prepared_(prepared), minDistance_(rules.minDistance), flux_(flux) {
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
    form.inverse = of.constant;
    form.constant = of.perDimming;
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
  double minDistance_, flux_;
  std::vector<std::uint32_t> pinned_, free_;
};

void addForm(PairProblem& layouts, AffineForm form, double least, double most) {
  layouts.forms.push_back({std::move(form.linear), -form.constant, -form.inverse, least, most});
}

/// How many luminaires there are of each kind, in products with each one.
void addNumbers(PairProblem& layouts) {
  const auto numberOf = [&](const std::vector<std::uint32_t>& sites, double number) {
    AffineForm form{std::vector<double>(layouts.sites, 0.0), -number};
    for (const std::uint32_t site : sites) form.linear[site] = 1;
    return form;
  };
  const bool areExact = std::all_of(layouts.kinds.begin(), layouts.kinds.end(),
                                    [](const PairKind& kind) { return kind.least == kind.most; });
  if (!areExact)
    addForm(layouts, {std::vector<double>(layouts.sites, 1.0), -layouts.count}, -kUnbounded, kUnbounded);
  for (const PairKind& kind : layouts.kinds) {
    if (kind.sites.empty()) continue;
    if (kind.least == kind.most) {
      addForm(layouts, numberOf(kind.sites, kind.least), -kUnbounded, kUnbounded);
      continue;
    }
    if (kind.least > 0) addForm(layouts, numberOf(kind.sites, kind.least), 0, kUnbounded);
    if (kind.most < layouts.count) addForm(layouts, numberOf(kind.sites, kind.most), -kUnbounded, 0);
  }
}

/// The types, and what the pinned luminaires leave of their ranges.
std::vector<PairKind> kindsOf(const PreparedScene& prepared, const LuminaireRules& rules,
                              const std::vector<std::uint32_t>& free, double count) {
  const std::vector<TypeRange> ranges = ExclusiveGroups::of(prepared, rules).ranges;
  std::vector<PairKind> kinds(ranges.size());
  for (std::uint32_t i = 0; i < free.size(); ++i) kinds[prepared.typeOf(free[i])].sites.push_back(i);
  double least = 0;
  for (const TypeRange& range : ranges) least += range.least;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    kinds[k].least = ranges[k].least;
    kinds[k].most = std::min<double>(ranges[k].most, count - (least - ranges[k].least));
  }
  if (kinds.size() == 1) kinds[0].least = kinds[0].most = count;
  return kinds;
}

}  // namespace

/// Of each kind the least that it must have, then the least of what is left.
double PairGoal::leastOf(const std::vector<double>& form) const {
  std::vector<std::pair<double, double>> rest;  // what a luminaire adds, and of which kind
  std::vector<double> room;
  double sum = 0, left = layouts.count;
  for (const PairKind& kind : layouts.kinds) {
    std::vector<double> values;
    for (const std::uint32_t site : kind.sites) values.push_back(form[site]);
    std::sort(values.begin(), values.end());
    const std::size_t needed = std::min(values.size(), static_cast<std::size_t>(kind.least));
    for (std::size_t i = 0; i < values.size(); ++i)
      if (i < needed)
        sum += values[i];
      else
        rest.emplace_back(values[i], room.size());
    room.push_back(kind.most - kind.least);
    left -= static_cast<double>(needed);
  }
  std::sort(rest.begin(), rest.end());
  for (const auto& [value, kind] : rest) {
    double& free = room[static_cast<std::size_t>(kind)];
    if (left < 1 || free < 1) continue;
    sum += value;
    --left;
    --free;
  }
  return sum;
}

double PairGoal::mostOf(std::vector<double> form) const {
  for (double& value : form) value = -value;
  return -leastOf(form);
}

std::optional<PairGoal> pairGoalOf(const PreparedScene& prepared, const LuminaireRules& rules,
                                   const RelaxedIntentions& problem) {
  if (!applies(prepared, rules, problem)) return std::nullopt;
  const Places places(prepared, rules, rules.flux[0]);
  const std::size_t m = places.free().size();
  const auto count = static_cast<double>(rules.count - places.pinnedCount());
  if (count < 2 || m > kMostSites) return std::nullopt;

  PairGoal goal;
  goal.inverseLow = 1 / rules.dimmingHigh;
  goal.inverseHigh = 1 / rules.dimmingLow;
  goal.layouts.sites = static_cast<std::uint32_t>(m);
  goal.layouts.count = count;
  goal.layouts.kinds = kindsOf(prepared, rules, places.free(), count);
  addNumbers(goal.layouts);
  if (m * (goal.layouts.forms.size() + problem.aims.size() + problem.sides.size()) > kMostRows)
    return std::nullopt;
  goal.layouts.apart = places.apart();
  // What an aim misses is missed once for each luminaire: each has its share of the weight.
  for (const RelaxedAim& aim : problem.aims)
    addForm(goal.layouts, places.affine(aim.form), -aim.weight / count, aim.weight / count);
  // Of a side the part that is linear: the sigmas in it are not negative.
  for (const ConvexObjective& side : problem.sides)
    addForm(goal.layouts, places.affine(side), -kUnbounded, 0);

  const AffineForm rest = places.affine(problem.goal);
  goal.linear = rest.linear;
  goal.constant = rest.constant;
  if (problem.sigmas.empty()) return goal;
  const RelaxedSigma& sigma = problem.sigmas[0];
  goal.factor = sigma.factor;
  places.square(prepared.exactCovariance(sigma.quantity, sigma.surfaces), goal);
  return goal;
}

}  // namespace fiatlux
