// Rounds of steps and certificates; see pair_bound.h.
#include "core/bound/pair_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace fiatlux {
namespace {

constexpr std::uint32_t kFirstSteps = 60, kMoreSteps = 30, kLongestRound = 9;
constexpr std::uint32_t kMostRounds = 40, kFruitlessPairRounds = 3;
constexpr double kFruitful = 0.02;   // of the gap that is left
constexpr double kClosed = 1e-5;     // of the goal
constexpr double kMostScaled = 1e3;  // a certificate is scaled up by at most so much
constexpr double kGuess = 0.97;      // of the largest sigma: about where the least one will be
constexpr double kElsewhere = 0.01;  // of sigma: far enough for another parabola
constexpr int kCells = 20000;        // that are looked at for the lowest goal

double infinite() { return std::numeric_limits<double>::infinity(); }

}  // namespace

double PairBound::Cut::at(double inverse_, double sigma) const {
  const double further = inverse_ - inverse;
  return top + rise * sigma - kappa * sigma * sigma + further * (further > 0 ? least : most);
}

PairBound::PairBound(PairGoal goal)
    : goal_(std::move(goal)), relaxation_(goal_.layouts), bound_(-infinite()) {
  if (goal_.factor >= 0)
    cuts_.push_back({goal_.constant + goal_.leastOf(goal_.linear), goal_.factor, 0, goal_.inverse, 0, 0});
  const double inverse = std::clamp(goal_.inverse, goal_.inverseLow, goal_.inverseHigh);
  ask(inverse, (goal_.factor > 0 ? kGuess : 1) * largestSigma(inverse));
}

/// Any layout with more is worse than the incumbent, or for a sigma to be large: what the incumbent has at
/// least.
double PairBound::largestSigma(double inverse) const {
  if (goal_.factor == 0) return 0;
  const double known = goal_.factor > 0 || !std::isfinite(bound_) ? goal_.incumbent : bound_;
  return std::max(0.0, (known * inverse - goal_.constant - goal_.leastOf(goal_.linear)) / goal_.factor);
}

/// For the cost whose goal does not change with sigma, to first order, at this sigma.
void PairBound::ask(double inverse, double sigma) {
  const std::size_t m = goal_.layouts.sites;
  inverse_ = inverse;
  sigma_ = sigma > 0 ? sigma : 1;
  kappa_ = goal_.factor / (2 * sigma_);
  std::vector<double> cost(m * m, 0.0);
  for (std::size_t k = 0; k < goal_.square.size(); ++k) cost[k] = kappa_ * goal_.square[k];
  for (std::size_t i = 0; i < m; ++i) cost[i * m + i] += goal_.linear[i];
  relaxation_.setCost(cost, inverse);
}

void PairBound::advance() {
  if (done_) return;
  if (!certifying_) {
    relaxation_.step();
    certifying_ = ++steps_ >= kFirstSteps + kMoreSteps * std::min(rounds_, kLongestRound);
  } else if (!relaxation_.certify()) {
    closeRound();
  }
}

/// The certificate as a cut; with multipliers scaled up as far as they may be, another one.
void PairBound::learn() {
  const double least = relaxation_.bound();
  if (!std::isfinite(least)) return;
  const double drift = goal_.leastOf(relaxation_.drift()), most = goal_.mostOf(relaxation_.drift());
  if (goal_.factor <= 0) {
    const double top = least + goal_.constant + kappa_ * goal_.squareConstant + kappa_ * sigma_ * sigma_;
    cuts_.push_back({top, 0, 0, inverse_, drift, most});
    return;
  }
  for (const double c : {1.0, std::min(relaxation_.slack(), kMostScaled)})
    cuts_.push_back({c * least - (c - 1) * goal_.mostOf(goal_.linear) + goal_.constant +
                         c * kappa_ * goal_.squareConstant,
                     goal_.factor, c * kappa_, inverse_, c * drift, c * most});
}

double PairBound::highest(double inverse, double sigma) const {
  double highest = -infinite();
  for (const Cut& cut : cuts_) highest = std::max(highest, cut.at(inverse, sigma));
  return highest / inverse;
}

/// A cut is concave in 1 / t and sigma, so t times it is least at a corner.
void PairBound::judge(Cell& cell) const {
  cell.goal = -infinite();
  for (const Cut& cut : cuts_) {
    double least = infinite();
    for (const double inverse : {cell.inverseLow, cell.inverseHigh})
      for (const double sigma : {cell.sigmaLow, cell.sigmaHigh})
        least = std::min(least, cut.at(inverse, sigma) / inverse);
    cell.goal = std::max(cell.goal, least);
  }
}

/// The least of the highest cuts: the cell that may hold the least goal is cut in four, over and over.
PairBound::Cell PairBound::lowest() const {
  const double sigma =
      goal_.factor > 0 ? std::max(largestSigma(goal_.inverseLow), largestSigma(goal_.inverseHigh)) : 0;
  std::priority_queue<Cell> cells;
  const auto add = [&](Cell cell) {
    judge(cell);
    cells.push(cell);
  };
  add({0, goal_.inverseLow, goal_.inverseHigh, 0, sigma});
  for (int looked = 0; looked < kCells; looked += 4) {
    const Cell cell = cells.top();
    const double middle = (cell.inverseLow + cell.inverseHigh) / 2,
                 half = (cell.sigmaLow + cell.sigmaHigh) / 2;
    if (highest(middle, half) - cell.goal < kClosed * std::fabs(goal_.incumbent)) break;
    cells.pop();
    if (cell.inverseLow == cell.inverseHigh) {
      add({0, middle, middle, cell.sigmaLow, half});
      add({0, middle, middle, half, cell.sigmaHigh});
      continue;
    }
    for (const auto& [low, high] :
         {std::pair(cell.inverseLow, middle), std::pair(middle, cell.inverseHigh)}) {
      add({0, low, high, cell.sigmaLow, half});
      if (sigma > 0) add({0, low, high, half, cell.sigmaHigh});
    }
  }
  return cells.top();
}

void PairBound::closeRound() {
  learn();
  const Cell found = cuts_.empty() ? Cell{-infinite(), inverse_, inverse_, sigma_, sigma_} : lowest();
  const double before = goal_.incumbent - bound_;
  bound_ = std::max(bound_, std::min(found.goal, goal_.incumbent));
  const double gap = goal_.incumbent - bound_;
  fruitless_ = before - gap < kFruitful * before ? fruitless_ + 1 : 0;
  certifying_ = false;
  steps_ = 0;
  done_ = ++rounds_ >= kMostRounds || fruitless_ >= kFruitlessPairRounds ||
          gap <= kClosed * std::fabs(goal_.incumbent);
  if (done_) return;
  const double inverse = (found.inverseLow + found.inverseHigh) / 2;
  const double sigma = goal_.factor > 0 ? (found.sigmaLow + found.sigmaHigh) / 2 : largestSigma(inverse);
  if (inverse != inverse_ || std::fabs(sigma - sigma_) > kElsewhere * sigma_) ask(inverse, sigma);
}

}  // namespace fiatlux
