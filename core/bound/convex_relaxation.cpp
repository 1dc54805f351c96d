// Frank-Wolfe on split luminaires; see convex_relaxation.h.
#include "core/bound/convex_relaxation.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace fiatlux {
namespace {

constexpr int kExchanges = 6;        // after a step
constexpr double kLeastRoom = 1e-6;  // of a luminaire, for more in a group

double dotOf(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

double termValue(const ConvexTerm& term, double quadratic) {
  const double q = std::max(0.0, quadratic);
  return term.weight * (term.root ? std::sqrt(q) : q);
}

}  // namespace

ConvexRelaxation::ConvexRelaxation(ExclusiveGroups groups, const LuminaireRules& rules)
    : sites_(static_cast<std::uint32_t>(groups.group.size())),
      groups_(std::move(groups)),
      usable_(sites_, 1),
      low_(rules.dimmingLow),
      high_(rules.dimmingHigh),
      x_(sites_, 0.0) {
  for (std::uint32_t site : rules.excluded) usable_[site] = 0;
  for (std::uint32_t site = 0; site < sites_; ++site)
    if (groups_.group[site] == kNone) usable_[site] = 0;
  for (std::uint32_t i = 0; i < rules.count; ++i) {
    if (isPinned(rules, i)) {
      pinned_.emplace_back(rules.pinned[i], fluxOf(rules, i));
      usable_[rules.pinned[i]] = 0;
    } else {
      fluxes_.push_back(fluxOf(rules, i));
    }
  }
  std::sort(fluxes_.begin(), fluxes_.end(), std::greater<>());
  t_ = high_;
  double total = 0, free = 0;
  for (double flux : fluxes_) total += flux;
  for (char usable : usable_) free += usable;
  for (std::uint32_t j = 0; j < sites_; ++j)
    if (usable_[j]) x_[j] = high_ * total / free;  // the centre of the hull
  for (const auto& [site, flux] : pinned_) x_[site] = high_ * flux;
}

ConvexRelaxation::ConvexRelaxation(std::vector<double> weights, const LuminaireRules& rules)
    : sites_(static_cast<std::uint32_t>(weights.size())),
      fluxes_{rules.flux[0]},
      usable_(sites_, 1),
      weights_(std::move(weights)),
      least_(rules.count),
      most_(mostOf(rules)),
      low_(rules.dimmingLow),
      high_(rules.dimmingHigh),
      x_(sites_, 0.0) {
  for (std::uint32_t tie : rules.excluded) usable_[tie] = 0;
  for (std::uint32_t tie : rules.pinned) {
    pinned_.emplace_back(tie, fluxes_[0]);
    usable_[tie] = 0;
    least_ = std::max(0.0, least_ - weights_[tie]);
    most_ -= weights_[tie];
  }
  t_ = high_;
  double free = 0;
  for (std::uint32_t j = 0; j < sites_; ++j)
    if (usable_[j]) free += weights_[j];
  const double share = free > 0 ? std::min(1.0, (least_ + most_) / (2 * free)) : 0;
  for (std::uint32_t j = 0; j < sites_; ++j)
    if (usable_[j]) x_[j] = high_ * share * fluxes_[0];
  for (const auto& [tie, flux] : pinned_) x_[tie] = high_ * flux;
}

void ConvexRelaxation::setObjective(ConvexObjective objective) {
  objective_ = std::move(objective);
  bound_ = -kUnbounded;
  refreshProducts();
}

void ConvexRelaxation::setDimming(double dimming) {
  for (double& x : x_) x *= dimming / t_;
  t_ = low_ = high_ = dimming;
  setObjective(std::move(objective_));
}

/// M x anew, so that rounding does not pile up.
void ConvexRelaxation::refreshProducts() {
  products_.assign(objective_.terms.size(), std::vector<double>(sites_, 0.0));
  quadratics_.assign(objective_.terms.size(), 0.0);
  for (std::size_t k = 0; k < objective_.terms.size(); ++k) {
    const double* matrix = objective_.terms[k].matrix->data();
    for (std::uint32_t i = 0; i < sites_; ++i) {
      if (x_[i] == 0) continue;
      const double* row = matrix + std::size_t{i} * sites_;
      for (std::uint32_t j = 0; j < sites_; ++j) products_[k][j] += x_[i] * row[j];
    }
    quadratics_[k] = dotOf(x_, products_[k]);
  }
}

void ConvexRelaxation::takeSites(const std::vector<double>& gradient, Corner& corner) const {
  if (fluxes_.empty()) return;
  const bool isOneFlux = fluxes_.front() == fluxes_.back();
  // Of each group the best candidate, where the groups hold: among luminaires of one flux.
  std::vector<std::uint32_t> order, best(groups_.groupCount, kNone);
  for (std::uint32_t j = 0; j < sites_; ++j) {
    if (!usable_[j]) continue;
    if (!isOneFlux) order.push_back(j);
    std::uint32_t& known = best[groups_.group[j]];
    if (known == kNone || gradient[j] < gradient[known]) known = j;
  }
  if (isOneFlux)
    for (const std::uint32_t j : best)
      if (j != kNone) order.push_back(j);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return gradient[a] < gradient[b] || (gradient[a] == gradient[b] && a < b);
  });
  if (isOneFlux) return takeTypes(order, corner);
  const std::size_t count = std::min(fluxes_.size(), order.size());
  for (std::size_t i = 0; i < count; ++i) corner.x.emplace_back(order[i], fluxes_[i]);
}

/// The first of `order`, all of one flux: of each type as many as there must be, then any.
void ConvexRelaxation::takeTypes(const std::vector<std::uint32_t>& order, Corner& corner) const {
  std::vector<char> isTaken(sites_, 0);
  std::vector<std::uint32_t> ofType(groups_.ranges.size(), 0);
  std::size_t left = fluxes_.size();
  for (const bool isLeast : {true, false})
    for (const std::uint32_t j : order) {
      if (left == 0) return;
      const std::uint32_t type = groups_.type[j];
      const TypeRange& range = groups_.ranges[type];
      if (isTaken[j] || ofType[type] >= (isLeast ? range.least : range.most)) continue;
      isTaken[j] = 1;
      ++ofType[type];
      --left;
      corner.x.emplace_back(j, fluxes_[0]);
    }
}

/// A knapsack whose last tie may be split: those of least gradient a luminaire, to the least count and beyond
/// while that gains.
void ConvexRelaxation::takeTies(const std::vector<double>& gradient, Corner& corner) const {
  std::vector<std::uint32_t> order;
  for (std::uint32_t j = 0; j < sites_; ++j)
    if (usable_[j]) order.push_back(j);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    const double perA = gradient[a] / weights_[a], perB = gradient[b] / weights_[b];
    return perA < perB || (perA == perB && a < b);
  });
  double taken = 0;
  for (const std::uint32_t j : order) {
    const double wanted = gradient[j] < 0 ? most_ : least_;
    if (taken >= wanted) break;
    const double share = std::min(1.0, (wanted - taken) / weights_[j]);
    corner.x.emplace_back(j, share * fluxes_[0]);
    taken += share * weights_[j];
  }
}

/// The layout and dimming that a linear objective likes best: the largest flux on the smallest entry, and so
/// on.
ConvexRelaxation::Corner ConvexRelaxation::bestCorner(const std::vector<double>& gradient,
                                                      double perDimming) const {
  Corner corner;
  corner.x = pinned_;
  if (weights_.empty())
    takeSites(gradient, corner);
  else
    takeTies(gradient, corner);
  double value = perDimming;
  for (const auto& [site, flux] : corner.x) value += flux * gradient[site];
  corner.t = value < 0 ? high_ : low_;
  for (auto& [site, flux] : corner.x) flux *= corner.t;
  return corner;
}

std::vector<double> ConvexRelaxation::gradient() const {
  std::vector<double> gradient = objective_.linear;
  for (std::size_t k = 0; k < objective_.terms.size(); ++k) {
    const ConvexTerm& term = objective_.terms[k];
    const double factor =
        term.root ? (quadratics_[k] > 0 ? term.weight / std::sqrt(quadratics_[k]) : 0) : 2 * term.weight;
    for (std::uint32_t j = 0; j < sites_; ++j) gradient[j] += factor * products_[k][j];
  }
  return gradient;
}

bool ConvexRelaxation::step() {
  const std::vector<double> gradient = this->gradient();
  value_ = objective_.constant + objective_.perDimming * t_ + dotOf(objective_.linear, x_);
  for (std::size_t k = 0; k < objective_.terms.size(); ++k)
    value_ += termValue(objective_.terms[k], quadratics_[k]);
  const Corner corner = bestCorner(gradient, objective_.perDimming);
  double gap = dotOf(gradient, x_) + objective_.perDimming * (t_ - corner.t);
  for (const auto& [site, flux] : corner.x) gap -= gradient[site] * flux;
  bound_ = std::max(bound_, value_ - std::max(0.0, gap));
  if (gap <= 1e-9 * (std::fabs(value_) + 1e-300)) return false;

  // Along d = corner - x: the quadratics need s^T M x and s^T M s, N rows of each matrix.
  std::vector<double> crossed(objective_.terms.size(), 0.0), squares(objective_.terms.size(), 0.0);
  for (std::size_t k = 0; k < objective_.terms.size(); ++k) {
    const double* matrix = objective_.terms[k].matrix->data();
    for (const auto& [site, flux] : corner.x) {
      crossed[k] += flux * products_[k][site];
      for (const auto& [other, otherFlux] : corner.x)
        squares[k] += flux * otherFlux * matrix[std::size_t{site} * sites_ + other];
    }
  }
  double slope = objective_.perDimming * (corner.t - t_) - dotOf(objective_.linear, x_);
  for (const auto& [site, flux] : corner.x) slope += objective_.linear[site] * flux;
  const double gamma = lineSearch(crossed, squares, slope);
  for (double& x : x_) x *= 1 - gamma;
  for (const auto& [site, flux] : corner.x) x_[site] += gamma * flux;
  t_ += gamma * (corner.t - t_);
  for (std::size_t k = 0; k < objective_.terms.size(); ++k) {
    const double* matrix = objective_.terms[k].matrix->data();
    for (double& product : products_[k]) product *= 1 - gamma;
    for (const auto& [site, flux] : corner.x) {
      const double* row = matrix + std::size_t{site} * sites_;
      for (std::uint32_t j = 0; j < sites_; ++j) products_[k][j] += gamma * flux * row[j];
    }
    quadratics_[k] = dotOf(x_, products_[k]);
  }
  for (int k = 0; k < kExchanges && exchange(); ++k) continue;
  return true;
}

/// Of one type, some of what hangs where it is worst goes where it is best, as far as that gains: steps
/// towards corners alone take long to leave a site. False where nothing can.
bool ConvexRelaxation::exchange() {
  if (!weights_.empty() || fluxes_.empty() || fluxes_.front() != fluxes_.back()) return false;
  const double most = t_ * fluxes_[0];
  const std::vector<double> gradient = this->gradient();
  std::vector<double> held(groups_.groupCount, 0.0);
  std::vector<std::uint32_t> worstOfType(groups_.ranges.size(), kNone),
      worstOfGroup(groups_.groupCount, kNone);
  for (std::uint32_t j = 0; j < sites_; ++j) {
    if (!usable_[j]) continue;
    held[groups_.group[j]] += x_[j];
    if (x_[j] <= 0) continue;
    for (std::uint32_t* worst : {&worstOfType[groups_.type[j]], &worstOfGroup[groups_.group[j]]})
      if (*worst == kNone || gradient[j] > gradient[*worst]) *worst = j;
  }
  Exchange best;
  for (std::uint32_t j = 0; j < sites_; ++j) {
    if (!usable_[j]) continue;
    const std::uint32_t group = groups_.group[j];
    const double room = most - held[group];
    const bool hasRoom = room > kLeastRoom * most;
    const std::uint32_t from = hasRoom ? worstOfType[groups_.type[j]] : worstOfGroup[group];
    if (from == kNone || !(gradient[from] - gradient[j] > best.gain)) continue;
    const double within = groups_.group[from] == group ? most - x_[j] : room;
    best = {from, j, std::min(x_[from], within), gradient[from] - gradient[j]};
  }
  if (!(best.gain > 0) || !(best.amount > 0)) return false;
  move(best);
  return true;
}

/// The best share of an exchange, by an exact line search.
void ConvexRelaxation::move(const Exchange& exchange) {
  const auto [from, to, amount, gain] = exchange;
  std::vector<double> crossed, squares;
  for (std::size_t k = 0; k < objective_.terms.size(); ++k) {
    const std::vector<double>& matrix = *objective_.terms[k].matrix;
    const auto at = [&](std::uint32_t i, std::uint32_t j) { return matrix[std::size_t{i} * sites_ + j]; };
    const double along = amount * (products_[k][to] - products_[k][from]);
    crossed.push_back(quadratics_[k] + along);
    squares.push_back(quadratics_[k] + 2 * along +
                      amount * amount * (at(to, to) - 2 * at(to, from) + at(from, from)));
  }
  const double slope = amount * (objective_.linear[to] - objective_.linear[from]);
  const double moved = amount * lineSearch(crossed, squares, slope);
  x_[from] = std::max(0.0, x_[from] - moved);
  x_[to] += moved;
  for (std::size_t k = 0; k < objective_.terms.size(); ++k) {
    const double* matrix = objective_.terms[k].matrix->data();
    const double *off = matrix + std::size_t{from} * sites_, *on = matrix + std::size_t{to} * sites_;
    for (std::uint32_t j = 0; j < sites_; ++j) products_[k][j] += moved * (on[j] - off[j]);
    quadratics_[k] = dotOf(x_, products_[k]);
  }
}

/// The gamma in [0, 1] that minimises the objective along the step, by bisection of its rising derivative.
double ConvexRelaxation::lineSearch(const std::vector<double>& crossed, const std::vector<double>& squares,
                                    double slope) const {
  const auto derivative = [&](double gamma) {
    double sum = slope;
    for (std::size_t k = 0; k < objective_.terms.size(); ++k) {
      const ConvexTerm& term = objective_.terms[k];
      const double b = crossed[k] - quadratics_[k], a = squares[k] - 2 * crossed[k] + quadratics_[k];
      const double rise = 2 * (b + gamma * a);
      const double q = std::max(1e-300, quadratics_[k] + 2 * gamma * b + gamma * gamma * a);
      sum += term.weight * (term.root ? rise / (2 * std::sqrt(q)) : rise);
    }
    return sum;
  };
  if (derivative(1) <= 0) return 1;
  double low = 0, high = 1;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    (derivative(middle) > 0 ? high : low) = middle;
  }
  return (low + high) / 2;
}

}  // namespace fiatlux
