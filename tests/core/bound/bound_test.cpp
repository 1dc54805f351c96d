// The bound (convex_relaxation, diagonal_shift, exclusive_groups; pair_bound, pair_goal, pair_numbers,
// pair_relaxation) against brute force: never above the optimum of an exhaustive enumeration, and tight where
// theory says so.
#include "core/bound/bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/bound/pair_numbers.h"
#include "core/search/evaluator.h"
#include "core/search/type_counts.h"
#include "core/search/validate_intentions.h"
#include "tests/core/corridor_scene.h"

namespace fiatlux {
namespace {

using fiatlux::testing::boxPlan;
using fiatlux::testing::smallRoom;
using fiatlux::testing::syntheticScene;

/// Whether three luminaires may hang there, luminaire 0 and so on first.
bool isAllowed(const PreparedScene& prepared, const LuminaireRules& rules,
               const std::array<std::uint32_t, 3>& sites) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (isPinned(rules, static_cast<std::uint32_t>(i)) && sites[i] != rules.pinned[i]) return false;
    if (std::count(rules.excluded.begin(), rules.excluded.end(), sites[i]) > 0) return false;
    for (std::size_t k = 0; k < i; ++k)
      if (sites[i] == sites[k] || prepared.distance(sites[i], sites[k]) < rules.minDistance) return false;
  }
  TypeCounts counts(prepared.scene(), rules);
  for (const std::uint32_t site : sites) counts.add(prepared.typeOf(site), 1);
  return counts.areMet();
}

/// The best of all layouts of three luminaires under the rules.
Evaluation exhaustiveOptimum(PreparedScene& prepared, const Intentions& intentions,
                             const Layout* reference = nullptr) {
  Evaluator evaluator(prepared, intentions, reference);
  Evaluation best{1e9, 0, 1};
  const std::uint32_t m = prepared.candidateCount();
  for (std::uint32_t a = 0; a < m; ++a)
    for (std::uint32_t b = 0; b < m; ++b)
      for (std::uint32_t c = 0; c < m; ++c) {
        if (!isAllowed(prepared, intentions.luminaires, {a, b, c})) continue;
        if (const Evaluation e = evaluator.evaluate({a, b, c}); isBetter(e, best)) best = e;
      }
  return best;
}

double boundOf(PreparedScene& prepared, const Intentions& intentions, const Evaluation& best,
               const Layout* reference = nullptr) {
  OptimumBound bound(prepared, intentions, best, reference);
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
Goal wallNear(double target, double weight = 1) {
  return {Statistic::kMean, Sense::kNear, weight, {2}, {}, target};
}
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

/// Rules that leave fewer layouts: by pins, by forbidden sites, by a distance, by all of them.
std::vector<LuminaireRules> narrowRules() {
  LuminaireRules plain;
  plain.count = 3;
  std::vector<LuminaireRules> all(9, plain);
  all[0].pinned = {7};
  all[1].pinned = {0, 19};
  all[2].pinned = {3, 12, 16};  // nothing is left to choose
  all[3].excluded = {0, 1, 2, 5, 6, 7, 10, 11, 15};
  all[4].minDistance = 1.6;  // more than two sites apart
  all[5].pinned = {9};
  all[5].excluded = {0, 4, 8, 14, 18};
  all[5].minDistance = 1.2;
  all[6].flux = {400, 1000, 2500};  // the pinned one is the dimmest
  all[6].pinned = {2};
  all[6].excluded = {10, 11, 12};
  all[7].flux = {2500, 1000, 400};  // the pinned ones are the brightest
  all[7].pinned = {6, 17};
  all[7].dimmingLow = 0.2;
  all[8].flux = {2500, 1000, 400};  // the middle one is pinned
  all[8].pinned = {kNone, 13};
  return all;
}

TEST(Bound, HoldsUnderPinsForbiddenSitesAndDistances) {
  PreparedScene prepared(smallRoom());
  const std::vector<Intentions> problems = {
      three({kEven}),
      three({{Statistic::kSigma, Sense::kMinimize, 1, {2}, {}}}),
      three({{Statistic::kSigma, Sense::kMaximize, 1, {2}, {}}}),
      three({kDarkWall}, {{Statistic::kChebyshev, 5, kUnbounded, 0.5, {0}, {}}}),
      three({kBrightWall}, {{Statistic::kSigma, -kUnbounded, 200, 1, {0}, {}}}),
      three({kEven, {Statistic::kMean, Sense::kMaximize, 0.3, {2}, {}}}),
      three({{Statistic::kPower, Sense::kMinimize, 1, {}, {}}},
            {{Statistic::kMean, 5, kUnbounded, 1, {0}, {}}}),
  };
  std::size_t compared = 0;
  for (const LuminaireRules& rules : narrowRules())
    for (Intentions problem : problems) {
      problem.luminaires = rules;
      SCOPED_TRACE("comparison " + std::to_string(compared));
      ASSERT_TRUE(checkIntentions(prepared.scene(), problem));
      const Evaluation best = exhaustiveOptimum(prepared, problem);
      ASSERT_LT(best.violation, 1e-9) << "it is meant to be feasible";
      const double bound = boundOf(prepared, problem, best);
      EXPECT_LE(bound, best.goal + 1e-6 * std::fabs(best.goal));
      EXPECT_GT(bound, best.goal - 1.5 * std::fabs(best.goal)) << "not even useful";
      ++compared;
    }
  EXPECT_EQ(compared, 63u);
}

TEST(Bound, KnowsWhatPinsAndForbiddenSitesTakeAway) {
  PreparedScene prepared(smallRoom());
  // Nothing is free to move: the only layout is the bound.
  Intentions pinned = three({kDarkWall});
  pinned.luminaires.pinned = {3, 12, 16};
  const Evaluation only = exhaustiveOptimum(prepared, pinned);
  EXPECT_NEAR(boundOf(prepared, pinned, only), only.goal, 1e-6 * std::fabs(only.goal));
  // A mean is bounded exactly, so the loss of the sites nearest to the wall must show.
  const Layout reference{{0, 7, 14}, {}, 1};
  Intentions narrow = three({kBrightWall});
  const double free = exhaustiveOptimum(prepared, narrow, &reference).goal;
  narrow.luminaires.excluded = {15, 16, 17, 18, 19};
  const Evaluation best = exhaustiveOptimum(prepared, narrow, &reference);
  EXPECT_GT(best.goal, 0.9 * free);
  EXPECT_NEAR(boundOf(prepared, narrow, best, &reference), best.goal, 1e-6 * std::fabs(best.goal));
}

TEST(Bound, IsExactForMeans) {
  PreparedScene prepared(smallRoom());
  for (const Goal& goal : {kBrightWall, kDarkWall}) {
    const Evaluation best = exhaustiveOptimum(prepared, three({goal}));
    EXPECT_NEAR(boundOf(prepared, three({goal}), best), best.goal, 1e-6 * std::fabs(best.goal));
  }
}

/// The five sites before the wall are for the first of two types, the other fifteen for the second.
Scene twoTypes() {
  Scene scene = syntheticScene(boxPlan(5, 4), 3);
  for (std::uint32_t site = 0; site < scene.sites.size(); ++site)
    scene.hangings.push_back({site, site < 15 ? 1u : 0u, 0, 1});
  return scene;
}

TEST(Bound, KnowsHowManyOfEachTypeThereAre) {
  const Scene scene = twoTypes();
  PreparedScene prepared(scene);
  for (const Goal& goal : {kBrightWall, kDarkWall, kEven, wallNear(45)}) {
    Intentions asked = three({goal});
    asked.luminaires.types = {{1, 1}, {2, 2}};
    const Evaluation best = exhaustiveOptimum(prepared, asked);
    const double bound = boundOf(prepared, asked, best);
    EXPECT_LE(bound, best.goal + 1e-9);
    if (goal.statistic == Statistic::kMean && goal.sense != Sense::kNear) {
      EXPECT_NEAR(bound, best.goal, 1e-6 * std::fabs(best.goal)) << "a mean is bounded exactly";
    }
  }
}

TEST(Bound, KnowsThatNeighboursKeepTheirDistanceInASum) {
  PreparedScene prepared(smallRoom());
  Intentions apart = three({kBrightWall});
  const Layout reference{{0, 7, 14}, {}, 1};
  const double anywhere =
      boundOf(prepared, apart, exhaustiveOptimum(prepared, apart, &reference), &reference);
  for (const double least : {1.1, 1.6, 2.2}) {
    apart.luminaires.minDistance = least;
    apart.luminaires.dimmingLow = 0.5;
    const Evaluation best = exhaustiveOptimum(prepared, apart, &reference);
    const double bound = boundOf(prepared, apart, best, &reference);
    EXPECT_LE(bound, best.goal + 1e-9) << least;
    EXPECT_GT(bound, anywhere) << least;
  }
}

TEST(Bound, IsNeverAboveTheBestAimAndExactWhereTheTargetIsOutOfReach) {
  PreparedScene prepared(smallRoom());
  std::vector<Intentions> problems = {
      three({wallNear(1)}),
      three({wallNear(45)}),
      three({wallNear(2000, 3)}),
      three({wallNear(60), kEven}),
      three({wallNear(2000), {Statistic::kPower, Sense::kMinimize, 0.2, {}, {}}}),
      three({wallNear(2000)}, {{Statistic::kMean, -kUnbounded, 30, 1, {0}, {}}})};
  problems[3].luminaires.dimmingLow = problems[4].luminaires.dimmingLow = 0.2;
  for (std::size_t p = 0; p < problems.size(); ++p) {
    ASSERT_TRUE(checkIntentions(prepared.scene(), problems[p]));
    const Evaluation best = exhaustiveOptimum(prepared, problems[p]);
    const double bound = boundOf(prepared, problems[p], best);
    EXPECT_LE(bound, best.goal + 1e-9) << "problem " << p;
    EXPECT_GE(bound, 0) << "problem " << p;
    const bool outOfReach = p == 0 || p == 2;
    if (outOfReach) {
      EXPECT_NEAR(bound, best.goal, 1e-6 * best.goal) << "problem " << p;
    }
  }
}

TEST(Bound, AnAimThatIsMetCannotBeBettered) {
  PreparedScene prepared(smallRoom());
  Intentions intentions = three({wallNear(30)});
  intentions.luminaires.dimmingLow = 0.05;
  const Evaluation best = exhaustiveOptimum(prepared, intentions);
  ASSERT_NEAR(best.goal, 0, 1e-12);
  OptimumBound bound(prepared, intentions, best);
  while (!bound.done()) bound.advance(1000);
  EXPECT_EQ(bound.within(best), std::optional<double>(0.0));
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

TEST(Bound, ComesNearWhereLuminairesAreFewAndKeepTheirDistance) {
  PreparedScene prepared(smallRoom());
  Intentions apart = three({wallNear(45), kEven});
  apart.luminaires.minDistance = 1.6;
  const Evaluation best = exhaustiveOptimum(prepared, apart);
  ASSERT_LT(best.violation, 1e-9);
  const double bound = boundOf(prepared, apart, best);
  EXPECT_LE(bound, best.goal * (1 + 1e-6));
  EXPECT_GE(bound, best.goal * 0.98);
}

TEST(Bound, IsNeverAboveTheBestOfFourLuminaires) {
  PreparedScene prepared(smallRoom());
  Intentions even = three({wallNear(60), kEven}), varied = three({{Statistic::kSigma, Sense::kMaximize}});
  even.luminaires.minDistance = 1.1;
  for (Intentions* intentions : {&even, &varied}) {
    intentions->luminaires.count = 4;
    Evaluator evaluator(prepared, *intentions);
    Evaluation best{1e9, 0, 1};
    const std::uint32_t m = prepared.candidateCount();
    const auto areApart = [&](std::uint32_t i, std::uint32_t j) {
      return !prepared.conflict(i, j, intentions->luminaires.minDistance);
    };
    for (std::uint32_t a = 0; a < m; ++a)
      for (std::uint32_t b = a + 1; b < m; ++b)
        for (std::uint32_t c = b + 1; c < m; ++c)
          for (std::uint32_t d = c + 1; d < m; ++d) {
            if (!areApart(a, b) || !areApart(a, c) || !areApart(a, d) || !areApart(b, c) || !areApart(b, d) ||
                !areApart(c, d))
              continue;
            if (const Evaluation e = evaluator.evaluate({a, b, c, d}); isBetter(e, best)) best = e;
          }
    const double bound = boundOf(prepared, *intentions, best);
    EXPECT_LE(bound, best.goal + 1e-6 * std::fabs(best.goal));
    EXPECT_GT(bound, best.goal - 0.1 * std::fabs(best.goal));
  }
}

TEST(Bound, SaysWhatItIsProvedBy) {
  PreparedScene prepared(smallRoom());
  Intentions intentions = three({kEven});
  const Evaluation best = exhaustiveOptimum(prepared, intentions);
  OptimumBound whole(prepared, intentions, best), early(prepared, intentions, best);
  EXPECT_TRUE(early.takePairs());
  EXPECT_FALSE(early.takePairs());
  for (OptimumBound* bound : {&whole, &early})
    while (!bound->done()) bound->advance(1000);
  EXPECT_TRUE(whole.isByPairs());
  EXPECT_FALSE(early.isByPairs());
  EXPECT_GT(whole.goal(), early.goal());
  intentions.luminaires.dimmingLow = 0;
  EXPECT_FALSE(OptimumBound(prepared, intentions, best).takePairs()) << "there may be no light at all";
}

/// Goals and bounds to be met by dimming, for layouts of three.
std::vector<Intentions> toBeDimmed() {
  std::vector<Intentions> problems = {
      three({wallNear(30), kEven}),
      three({wallNear(30), {Statistic::kSigma, Sense::kMinimize, 1, {0}, {}}}),
      three({{Statistic::kMean, Sense::kNear, 10, {0}, {}, 40}, kEven, wallNear(25)}),
      three({{Statistic::kSigma, Sense::kMinimize, 1, {0}, {}}},
            {{Statistic::kMean, 30, kUnbounded, 1, {2}, {}}}),
      three({{Statistic::kSigma, Sense::kMaximize, 1, {2}, {}}, wallNear(30, 2)}),
      three({wallNear(30), kEven}, {{Statistic::kContrast, 1.2, kUnbounded, 1, {2}, {0}}}),
      three({{Statistic::kPower, Sense::kMinimize, 1, {}, {}}, wallNear(30, 3)}),
      three({kEven, {Statistic::kMean, Sense::kMaximize, 3, {2}, {}}},
            {{Statistic::kMean, -kUnbounded, 40, 1, {2}, {}}}),
  };
  for (Intentions& problem : problems) {
    problem.luminaires.dimmingLow = 0.2;
    problem.luminaires.minDistance = 1.1;
  }
  problems[2].luminaires.pinned = {8};
  return problems;
}

TEST(Bound, KnowsOfPairsThatAreDimmed) {
  PreparedScene prepared(smallRoom());
  const std::vector<Intentions> problems = toBeDimmed();
  for (std::size_t p = 0; p < problems.size(); ++p) {
    SCOPED_TRACE("problem " + std::to_string(p));
    const Evaluation best = exhaustiveOptimum(prepared, problems[p]);
    ASSERT_LT(best.violation, 1e-9) << "it is meant to be feasible";
    const double bound = boundOf(prepared, problems[p], best);
    EXPECT_LE(bound, best.goal + 1e-6 * std::fabs(best.goal));
    EXPECT_GT(bound, best.goal - 0.15 * std::fabs(best.goal));
  }
}

TEST(Bound, FindsMultipliersDimmingByDimming) {
  PreparedScene prepared(smallRoom());
  for (const double target : {5, 10, 20}) {
    SCOPED_TRACE(target);
    Intentions asked = three({{Statistic::kMean, Sense::kNear, 10, {2}, {}, target},
                              {Statistic::kMean, Sense::kNear, 0.5, {3}, {}, target / 2},
                              kEven,
                              {Statistic::kMean, Sense::kMinimize, 0.3, {0}, {}}},
                             {{Statistic::kMaximum, -kUnbounded, 12 * target, 1, {2}, {}}});
    asked.luminaires.dimmingLow = 0.02;
    const Evaluation best = exhaustiveOptimum(prepared, asked);
    ASSERT_LT(best.violation, 1e-9) << "it is meant to be feasible";
    OptimumBound bound(prepared, asked, best);
    bound.takePairs();
    while (!bound.done()) bound.advance(1000);
    EXPECT_LE(bound.goal(), best.goal + 1e-6 * best.goal);
    EXPECT_GT(bound.goal(), 0.99 * best.goal);
  }
}

TEST(Bound, KnowsOfPairsOfTypesThatAreDimmed) {
  const Scene scene = twoTypes();
  PreparedScene prepared(scene);
  const std::vector<std::vector<TypeRange>> ranges = {
      {{1, 1}, {2, 2}}, {{0, 1}, {1, 3}}, {{2, kNone}, {0, kNone}}};
  for (std::size_t r = 0; r < ranges.size(); ++r)
    for (Intentions problem : toBeDimmed()) {
      SCOPED_TRACE("ranges " + std::to_string(r));
      problem.luminaires.types = ranges[r];
      const Evaluation best = exhaustiveOptimum(prepared, problem);
      if (best.violation > 1e-9) continue;
      const double bound = boundOf(prepared, problem, best);
      EXPECT_LE(bound, best.goal + 1e-6 * std::fabs(best.goal));
      EXPECT_GT(bound, best.goal - 0.15 * std::fabs(best.goal));
    }
}

TEST(Bound, GoesOnElsewhereByNumbersAlone) {
  PreparedScene prepared(smallRoom());
  Intentions intentions = three({kEven, wallNear(60)}, {{Statistic::kMean, 20, kUnbounded, 1, {0}, {}}});
  intentions.luminaires.minDistance = 1;
  intentions.luminaires.dimmingLow = 0.4;
  const Evaluation best = exhaustiveOptimum(prepared, intentions);
  OptimumBound whole(prepared, intentions, best), early(prepared, intentions, best);
  const std::vector<double> numbers = numbersOf(*early.takePairs());
  const auto read = pairGoalFrom(numbers);
  ASSERT_TRUE(read);
  EXPECT_EQ(numbersOf(*read), numbers);
  PairBound elsewhere(*read);
  while (!elsewhere.done()) elsewhere.advance();
  for (OptimumBound* bound : {&whole, &early})
    while (!bound->done()) bound->advance(1000);
  const double relaxed = early.goal();
  early.provedByPairs(-kUnbounded);
  EXPECT_EQ(early.goal(), relaxed) << "nothing was proved there";
  early.provedByPairs(elsewhere.goal());
  EXPECT_EQ(early.goal(), whole.goal());
  EXPECT_EQ(early.isByPairs(), whole.isByPairs());
  EXPECT_LE(early.goal(), best.goal + 1e-9);
}

TEST(Bound, RefusesNumbersThatAreNoPairs) {
  PreparedScene prepared(smallRoom());
  const Intentions intentions = three({kEven});
  OptimumBound bound(prepared, intentions, exhaustiveOptimum(prepared, intentions));
  std::vector<double> numbers = numbersOf(*bound.takePairs());
  EXPECT_FALSE(pairGoalFrom({}));
  for (const double sites : {-1.0, 0.5, 2.0}) {
    std::vector<double> broken = numbers;
    broken[0] = sites;
    EXPECT_FALSE(pairGoalFrom(broken)) << sites;
  }
  numbers.pop_back();
  EXPECT_FALSE(pairGoalFrom(numbers));
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
