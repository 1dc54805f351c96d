// The bound against brute force: never above the optimum of an exhaustive enumeration, and tight where theory
// says so.
#include "core/bound.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/evaluator.h"
#include "tests/core/corridor_scene.h"

namespace fiatlux {
namespace {

using fiatlux::testing::smallRoom;

Evaluation exhaustiveOptimum(PreparedScene& prepared, const Intentions& intentions) {
  Evaluator evaluator(prepared, intentions);
  Evaluation best{1e9, 0, 1};
  const std::uint32_t m = prepared.siteCount();
  for (std::uint32_t a = 0; a < m; ++a)
    for (std::uint32_t b = 0; b < m; ++b)
      for (std::uint32_t c = 0; c < m; ++c) {
        if (a == b || b == c || a == c) continue;
        if (const Evaluation e = evaluator.evaluate({a, b, c}); isBetter(e, best)) best = e;
      }
  return best;
}

double boundOf(PreparedScene& prepared, const Intentions& intentions, const Evaluation& best) {
  OptimumBound bound(prepared, intentions, best);
  for (int slice = 0; slice < 100000 && !bound.done(); ++slice) bound.advance(777);
  EXPECT_TRUE(bound.done());
  return bound.goal();
}

Intentions three(std::vector<Goal> goals, std::vector<Constraint> constraints = {}) {
  Intentions intentions;
  intentions.luminaires.count = 3;
  intentions.goals = std::move(goals);
  intentions.constraints = std::move(constraints);
  return intentions;
}

const Goal kEven{Statistic::kSigma, Sense::kMinimize, 1, {}, {}};
const Goal kDarkWall{Statistic::kMean, Sense::kMinimize, 1, {2}, {}};
const Goal kBrightWall{Statistic::kMean, Sense::kMaximize, 1, {2}, {}};

TEST(Bound, IsNeverAboveTheExhaustiveOptimum) {
  PreparedScene prepared(smallRoom());
  std::vector<Intentions> problems = {
      three({kEven}),
      three({kEven}, {{Statistic::kMean, 45, kUnbounded, 1, {2}, {}}}),
      three({{Statistic::kSigma, Sense::kMaximize, 1, {2}, {}}}),
      three({kDarkWall}, {{Statistic::kChebyshev, 20, kUnbounded, 1.5, {2}, {}}}),
      three({kBrightWall}, {{Statistic::kChebyshev, -kUnbounded, 120, 1, {3}, {}},
                            {Statistic::kSigma, -kUnbounded, 60, 1, {0}, {}}}),
      three({kEven, {Statistic::kMean, Sense::kMaximize, 0.3, {2}, {}}}),
      three({kDarkWall}, {{Statistic::kMinimum, 15, kUnbounded, 1, {0}, {}},
                          {Statistic::kContrast, 0.3, kUnbounded, 1, {2}, {0}}}),
  };
  Intentions power = three({{Statistic::kPower, Sense::kMinimize, 1, {}, {}}},
                           {{Statistic::kChebyshev, 10, kUnbounded, 1, {0}, {}}});
  power.luminaires.dimmingLow = 0.05;
  problems.push_back(power);
  Intentions unequal = three({kEven});
  unequal.luminaires.flux = {500, 1000, 1700};
  problems.push_back(unequal);
  for (std::size_t p = 0; p < problems.size(); ++p) {
    const Evaluation best = exhaustiveOptimum(prepared, problems[p]);
    ASSERT_LT(best.violation, 1e-9) << "problem " << p << " is meant to be feasible";
    const double bound = boundOf(prepared, problems[p], best);
    EXPECT_LE(bound, best.goal + 1e-6 * std::fabs(best.goal)) << "problem " << p;
    EXPECT_GT(bound, best.goal - 1.5 * std::fabs(best.goal)) << "problem " << p << ": not even useful";
  }
}

TEST(Bound, IsExactForMeans) {
  PreparedScene prepared(smallRoom());
  for (const Goal& goal : {kBrightWall, kDarkWall}) {
    const Evaluation best = exhaustiveOptimum(prepared, three({goal}));
    EXPECT_NEAR(boundOf(prepared, three({goal}), best), best.goal, 1e-6 * std::fabs(best.goal));
  }
}

TEST(Bound, SaysHowFarALayoutMayBeFromTheBest) {
  PreparedScene prepared(smallRoom());
  const Evaluation best = exhaustiveOptimum(prepared, three({kEven}));
  OptimumBound bound(prepared, three({kEven}), best);
  while (!bound.done()) bound.advance(1000);
  ASSERT_TRUE(bound.within(best));
  EXPECT_NEAR(*bound.within(best), best.goal / bound.goal() - 1, 1e-9);
  EXPECT_FALSE(bound.within({0.1, best.goal, 1}))
      << "nothing may be said of a layout that breaks its constraints";
}

TEST(Bound, DeclinesWhatItCannotProve) {
  PreparedScene prepared(smallRoom());
  const Intentions contrast = three({{Statistic::kContrast, Sense::kMaximize, 1, {2}, {0}}});
  OptimumBound bound(prepared, contrast, {});
  EXPECT_FALSE(bound.supported());
  EXPECT_TRUE(bound.done());
  EXPECT_FALSE(bound.within({0, -1, 1}));
}

TEST(DiagonalShift, StaysPositiveAndHelpsADiagonalMatrix) {
  // C = diag(1, 2, 3): everything may be moved out.
  DiagonalShift shift(3, {1, 0, 0, 0, 2, 0, 0, 0, 3});
  ASSERT_TRUE(shift.ok());
  for (int step = 0; step < 200 && shift.step({1, 1, 1}); ++step) {
  }
  for (int i = 0; i < 3; ++i) {
    EXPECT_LE(shift.diagonal()[i], i + 1.0);
    EXPECT_GT(shift.diagonal()[i], (i + 1) * 0.99);
  }
}

}  // namespace
}  // namespace fiatlux
