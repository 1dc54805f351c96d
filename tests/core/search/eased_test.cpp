// Wishes that cannot be met: bounds eased to what a layout reaches, and the goals that then decide.
#include "core/search/eased.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/session/session.h"
#include "tests/core/synthetic_scene.h"

namespace fiatlux {
namespace {

TEST(Eased, OnlyMissedBoundsGiveWayToJustBeyondWhatIsReached) {
  Intentions asked;
  asked.constraints = {{Statistic::kMean, 200, 400, 1, {0}, {}},
                       {Statistic::kMean, 100, 300, 1, {1}, {}},
                       {Statistic::kChebyshev, 50, 80, 1, {2}, {}}};
  // The first is met, the second misses its maximum by a tenth, the third both ends.
  const Intentions eased =
      easedToReach(asked, {{300, 0, 0.2, 0, 0}, {330, 0.1, -0.1, 0, 0.1}, {90, 0.725, -0.6, 0.6, 0.125}});
  EXPECT_EQ(eased.constraints[0].lower, 200);
  EXPECT_EQ(eased.constraints[0].upper, 400);
  EXPECT_EQ(eased.constraints[1].lower, 100);
  EXPECT_NEAR(eased.constraints[1].upper, 330 * 1.01, 1e-9);
  EXPECT_NEAR(eased.constraints[2].lower, 20 * 0.99, 1e-9);
  EXPECT_NEAR(eased.constraints[2].upper, 90 * 1.01, 1e-9);
}

TEST(Eased, WhatCountsAsMetDoesNotGiveWayFurtherThanThat) {
  Intentions asked;
  asked.constraints = {{Statistic::kMean, 200, kUnbounded, 1, {0}, {}},
                       {Statistic::kMean, 0, 300, 1, {1}, {}},
                       {Statistic::kMinimum, 100, kUnbounded, 1, {1}, {}},
                       {Statistic::kMean, 200, kUnbounded, 1, {2}, {}}};
  // By half of what is hardly missed; but true extremes are met or not, and the last is missed by more.
  const Intentions eased = easedToReach(asked, {{199.9, 0.0005, -0.0005, 0.0005, 0},
                                                {300.15, 0.0005, -0.0005, 0, 0.0005},
                                                {99.95, 0.0005, -0.0005, 0.0005, 0},
                                                {199.6, 0.002, -0.002, 0.002, 0}});
  EXPECT_NEAR(eased.constraints[0].lower, 200 * (1 - 0.99e-3), 1e-9);
  EXPECT_NEAR(eased.constraints[1].upper, 300 * (1 + 0.99e-3), 1e-9);
  EXPECT_NEAR(eased.constraints[2].lower, 99.95 * 0.99, 1e-9);
  EXPECT_NEAR(eased.constraints[3].lower, 199.6 * 0.99, 1e-9);
}

TEST(Eased, AmongLayoutsThatMissABoundByHardlyMoreTheGoalDecides) {
  Session session;
  session.adopt(syntheticScene(64, 32));
  Intentions asked;
  asked.luminaires.count = 8;
  asked.goals = {{Statistic::kSigma, Sense::kMinimize, 1, {0}, {}}};
  asked.constraints = {{Statistic::kMean, 1e4, kUnbounded, 1, {0}, {}}};
  ASSERT_TRUE(session.setIntentions(asked));
  ASSERT_TRUE(session.start(1, nullptr));
  EXPECT_EQ(session.settle(0).evaluation.violation, 0);
  session.advance(20000);
  const Shown least = *session.incumbent();
  const SearchProgress settled = session.settle(20000);
  EXPECT_EQ(settled.evaluation.violation, 0) << "of the eased bounds";
  const Shown sensible = *session.incumbent();
  EXPECT_GE(sensible.surfaces[0].mean, 0.989 * least.surfaces[0].mean);
  EXPECT_LT(sensible.goals[0], 0.95 * least.goals[0]);
  EXPECT_GT(sensible.constraints[0].violation, 0.5) << "judged by what was asked";
  // The search knows nothing of it.
  session.advance(1);
  EXPECT_EQ(session.incumbent()->layout.sites, least.layout.sites);
}

}  // namespace
}  // namespace fiatlux
