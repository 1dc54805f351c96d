// Rounds of steps and certificates; see pair_bound.h.
#include "core/bound/pair_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fiatlux {
namespace {

constexpr std::uint32_t kFirstSteps = 60, kMoreSteps = 30, kMostRounds = 9, kFruitlessPairRounds = 2;
constexpr double kFruitful = 0.02;   // of the gap that is left
constexpr double kClosed = 1e-5;     // of the goal
constexpr double kMostScaled = 1e3;  // a certificate is scaled up by at most so much
constexpr double kGuess = 0.97;      // of the largest sigma: about where the least one will be
constexpr double kElsewhere = 0.01;  // of sigma: far enough for another parabola
constexpr int kCells = 4096;         // of the range of sigma

}  // namespace

PairBound::PairBound(PairGoal goal)
    : goal_(std::move(goal)), relaxation_(goal_.layouts), bound_(-std::numeric_limits<double>::infinity()) {
  ask(goal_.factor > 0 ? kGuess * largestSigma() : largestSigma());
}

/// Any layout with more is worse than the incumbent, or for a sigma to be large: what the incumbent has at
/// least.
double PairBound::largestSigma() const {
  if (goal_.factor == 0) return 0;
  return std::max(0.0, (goal_.incumbent - goal_.constant - goal_.leastLinear()) / goal_.factor);
}

/// For the cost whose goal does not change with sigma, to first order, at this sigma.
void PairBound::ask(double sigma) {
  const std::size_t m = goal_.layouts.sites;
  sigma_ = sigma;
  kappa_ = sigma > 0 ? goal_.factor / (2 * sigma) : 0;
  std::vector<double> cost(m * m, 0.0);
  for (std::size_t k = 0; k < goal_.square.size(); ++k) cost[k] = kappa_ * goal_.square[k];
  for (std::size_t i = 0; i < m; ++i) cost[i * m + i] += goal_.linear[i];
  relaxation_.setCost(cost);
}

void PairBound::advance() {
  if (done_) return;
  if (!certifying_) {
    relaxation_.step();
    certifying_ = ++steps_ >= kFirstSteps + kMoreSteps * rounds_;
  } else if (!relaxation_.certify()) {
    closeRound();
  }
}

/// The certificate as a parabola; with multipliers scaled up as far as they may be, another one.
void PairBound::learn() {
  const double least = relaxation_.bound();
  const double scaled = goal_.factor > 0 ? std::min(relaxation_.slack(), kMostScaled) : 1;
  if (!std::isfinite(least)) return;
  for (const double c : {1.0, scaled})
    parabolas_.push_back(
        {c * least - (c - 1) * goal_.mostLinear() + goal_.constant + c * kappa_ * goal_.squareConstant,
         c * kappa_});
}

/// The least of the highest parabolas. In each cell the highest of their lower ends counts: they are concave.
PairBound::Lowest PairBound::lowest() const {
  if (parabolas_.empty()) return {bound_, sigma_};
  if (goal_.factor <= 0) {
    const double tangent = goal_.factor == 0 ? 0 : goal_.factor * sigma_ / 2;
    return {parabolas_.back().top + tangent, sigma_};
  }
  Lowest lowest{goal_.incumbent, largestSigma()};
  const double width = largestSigma() / kCells;
  for (int cell = 0; cell < kCells; ++cell) {
    const double left = cell * width, right = left + width;
    double highest = -std::numeric_limits<double>::infinity();
    for (const auto& [top, kappa] : parabolas_)
      highest = std::max(highest, top + std::min(goal_.factor * left - kappa * left * left,
                                                 goal_.factor * right - kappa * right * right));
    if (highest < lowest.goal) lowest = {highest, right};
  }
  return lowest;
}

void PairBound::closeRound() {
  learn();
  const Lowest found = lowest();
  const double before = goal_.incumbent - bound_;
  bound_ = std::max(bound_, found.goal);
  const double gap = goal_.incumbent - bound_;
  fruitless_ = before - gap < kFruitful * before ? fruitless_ + 1 : 0;
  certifying_ = false;
  steps_ = 0;
  done_ = ++rounds_ >= kMostRounds || fruitless_ >= kFruitlessPairRounds ||
          gap <= kClosed * std::fabs(goal_.incumbent);
  if (done_) return;
  double sigma = found.sigma;
  if (goal_.factor < 0 && std::isfinite(bound_))
    sigma = std::max(1e-300, (bound_ - goal_.constant - goal_.leastLinear()) / goal_.factor);
  if (goal_.factor != 0 && std::fabs(sigma - sigma_) > kElsewhere * sigma_) ask(sigma);
}

}  // namespace fiatlux
