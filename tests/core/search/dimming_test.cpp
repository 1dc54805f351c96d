// The exact dimming against a fine scan, and the cases whose answer is plain.
#include "core/search/dimming.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"

namespace fiatlux {
namespace {

TEST(Dimming, TakesTheEndOfTheIntervalThatTheGoalPrefers) {
  const DimmedBound bounds[2] = {{100, 30, Side::kLower, false},
                                 {200, 120, Side::kUpper, false}};  // 0.3 <= t <= 0.6
  EXPECT_DOUBLE_EQ(solveDimming(bounds, 2, {1, 0}, 0.1, 1).dimming, 0.3);
  EXPECT_DOUBLE_EQ(solveDimming(bounds, 2, {-1, 0}, 0.1, 1).dimming, 0.6);
  EXPECT_DOUBLE_EQ(solveDimming(bounds, 2, {0, 0}, 0.1, 1).dimming, 0.6);
  EXPECT_EQ(solveDimming(bounds, 2, {1, 0}, 0.1, 1).violation, 0);
}

TEST(Dimming, EmptyIntervalTakesTheLeastViolation) {
  // At least 80 of 100 t (t >= 0.8), at most 50 of 100 t (t <= 0.5): excess shares fall by 1/80, rise by 1/50
  // a unit.
  const DimmedBound bounds[2] = {{100, 80, Side::kLower, false}, {100, 50, Side::kUpper, false}};
  const Evaluation evaluation = solveDimming(bounds, 2, {1, 0}, 0.1, 1);
  EXPECT_DOUBLE_EQ(evaluation.dimming, 0.5);
  EXPECT_NEAR(evaluation.violation, 30.0 / 80, 1e-12);
}

TEST(Dimming, RatiosViolateAlikeAtAnyDimming) {
  const DimmedBound bounds[2] = {{0.4, 0.5, Side::kLower, true}, {100, 30, Side::kLower, false}};
  const Evaluation evaluation = solveDimming(bounds, 2, {1, 0}, 0.1, 1);
  EXPECT_DOUBLE_EQ(evaluation.dimming, 0.3);
  EXPECT_NEAR(evaluation.violation, 0.2, 1e-12);
}

TEST(Dimming, MeetsAnAimExactlyWhereTheBoundsAllowIt) {
  const DimmedAim aim[1] = {{800, 500, 1}};
  const DimmedBound bounds[1] = {{800, 400, Side::kUpper, false}};
  EXPECT_DOUBLE_EQ(solveDimming(nullptr, 0, {0, 0, aim, 1}, 0.1, 1).dimming, 0.625);
  EXPECT_NEAR(solveDimming(nullptr, 0, {0, 0, aim, 1}, 0.1, 1).goal, 0, 1e-15);
  EXPECT_DOUBLE_EQ(solveDimming(nullptr, 0, {0, 0, aim, 1}, 0.8, 1).dimming, 0.8);
  EXPECT_DOUBLE_EQ(solveDimming(bounds, 1, {0, 0, aim, 1}, 0.1, 1).dimming, 0.5);
  EXPECT_DOUBLE_EQ(solveDimming(bounds, 1, {0, 0, aim, 1}, 0.1, 1).goal, 0.2);
  EXPECT_DOUBLE_EQ(solveDimming(nullptr, 0, {0, 0, aim, 1}, 1, 1).goal, 0.6);
}

TEST(Dimming, EqualsAFineScanOnRandomProblems) {
  Random random(5);
  for (int problem = 0; problem < 300; ++problem) {
    DimmedBound bounds[4];
    for (DimmedBound& b : bounds)
      b = {200 * random.unit() - 40, 100 * random.unit() - 5,
           random.below(2) == 0 ? Side::kLower : Side::kUpper, random.below(5) == 0};
    DimmedAim aims[3];
    for (DimmedAim& aim : aims) aim = {200 * random.unit(), 1 + 100 * random.unit(), random.unit()};
    const double slope = 2 * random.unit() - 1;
    const DimmedGoal goal{slope, 0, aims, random.below(4)};
    const Evaluation exact = solveDimming(bounds, 4, goal, 0.1, 1);
    const auto goalAt = [&](double t) {
      double sum = slope * t;
      for (std::uint32_t i = 0; i < goal.aimCount; ++i)
        sum += aims[i].weight * std::fabs(t * aims[i].value - aims[i].target) / aims[i].target;
      return sum;
    };
    for (int step = 0; step <= 2000; ++step) {
      const double t = 0.1 + 0.9 * step / 2000;
      const double violation = violationAt(bounds, 4, t);
      EXPECT_LE(exact.violation, violation + 1e-12);
      if (exact.violation == 0 && violation == 0) {
        EXPECT_LE(exact.goal, goalAt(t) + 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace fiatlux
