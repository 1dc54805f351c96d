// What PairRelaxation proves of the goal. Of a goal factor x sigma + rest with sigma to be small, each cost
// kappa sigma^2 + rest that is at least D says factor x sigma + D - kappa sigma^2 of layouts of that sigma: a
// parabola. No goal is below the least, over all sigma, of the highest of them. Where sigma is to be large,
// -sigma is never below its tangent in sigma^2, -(sigma^2 / s + s) / 2.
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
  struct Parabola {
    double top, kappa;  // the rest is at least top - kappa sigma^2
  };
  /// A goal that layouts may have, and at which sigma.
  struct Lowest {
    double goal, sigma;
  };
  void ask(double sigma);
  void learn();
  void closeRound();
  Lowest lowest() const;
  double largestSigma() const;

  PairGoal goal_;
  PairRelaxation relaxation_;
  double bound_, kappa_ = 0, sigma_ = 0;
  std::vector<Parabola> parabolas_;
  std::uint32_t steps_ = 0, rounds_ = 0, fruitless_ = 0;
  bool certifying_ = false, done_ = false;
};

}  // namespace fiatlux
