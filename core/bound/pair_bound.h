// What PairRelaxation proves of the goal t (factor x sigma + rest), t the common dimming. Of sigma to be
// small, each cost kappa sigma^2 + rest that is at least D says factor x sigma + D - kappa sigma^2 of layouts
// of that sigma: a parabola. It holds for every dimming, less what its multipliers drift. No goal is below
// the least, over all sigma and t, of the highest of them. Where sigma is to be large, -sigma is never below
// its tangent in sigma^2, -(sigma^2 / s + s) / 2.
#pragma once

#include <cstdint>
#include <vector>

#include "core/bound/pair_goal.h"
#include "core/bound/pair_relaxation.h"

namespace fiatlux {

class PairBound {
 public:
  explicit PairBound(PairGoal goal);

  /// One step of either kind, O(m^3) or more.
  void advance();
  bool done() const { return done_; }
  /// No layout that meets the constraints has a goal below this; -infinity until something is proved.
  double goal() const { return bound_; }

 private:
  /// factor x sigma + rest is at least top + rise sigma - kappa sigma^2, and where 1 / t is larger or smaller
  /// than `inverse` by e, as much more as e x least or most.
  struct Cut {
    double top, rise, kappa, inverse, least, most;
    double at(double inverse, double sigma) const;
  };
  /// Where a goal may be, and the least that it is there.
  struct Cell {
    double goal, inverseLow, inverseHigh, sigmaLow, sigmaHigh;
    bool operator<(const Cell& other) const { return goal > other.goal; }  // the least is ahead in a heap
  };
  void ask(double inverse, double sigma);
  void learn();
  void closeRound();
  double highest(double inverse, double sigma) const;
  void judge(Cell& cell) const;
  Cell lowest() const;
  double largestSigma(double inverse) const;

  PairGoal goal_;
  PairRelaxation relaxation_;
  double bound_, kappa_ = 0, sigma_ = 0, inverse_ = 0;
  std::vector<Cut> cuts_;
  std::uint32_t steps_ = 0, rounds_ = 0, fruitless_ = 0;
  bool certifying_ = false, done_ = false;
};

}  // namespace fiatlux
