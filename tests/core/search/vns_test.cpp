// The search (vns, objective, neighborhood, free_sites) against known optima, its rules, and its promise to
// be a pure function of scene, intentions, start, seed.
#include "core/search/vns.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/search/validate_intentions.h"
#include "tests/core/corridor_scene.h"

namespace fiatlux {
namespace {

using fiatlux::testing::longCorridor;
using fiatlux::testing::smallRoom;

Intentions ask(Statistic statistic, Sense sense, std::uint32_t count, SurfaceSet surfaces = {}) {
  Intentions intentions;
  intentions.luminaires.count = count;
  intentions.goals = {{statistic, sense, 1, std::move(surfaces), {}}};
  return intentions;
}

std::vector<std::uint32_t> sorted(std::vector<std::uint32_t> sites) {
  std::sort(sites.begin(), sites.end());
  return sites;
}

TEST(Vns, MeanGoalsReachTheLargestAndSmallestOfTheRowFromEverySeed) {
  PreparedScene prepared(longCorridor());
  for (const Sense sense : {Sense::kMaximize, Sense::kMinimize}) {
    const Intentions intentions = ask(Statistic::kMean, sense, 6, {2});
    std::vector<double> row = prepared.statistics(Quantity::kIlluminance, {2})->mean;
    std::sort(row.begin(), row.end());
    if (sense == Sense::kMaximize) std::reverse(row.begin(), row.end());
    double best = 0;
    for (int i = 0; i < 6; ++i) best += 1000 * row[i];
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      Vns vns(prepared, intentions, seed);
      vns.advance(25000);
      Evaluator evaluator(prepared, intentions);
      evaluator.load(vns.incumbent().sites);
      EXPECT_NEAR(evaluator.moments()[0].mean, best, 1e-9 * best) << "seed " << seed;
    }
  }
}

TEST(Vns, SlicesOfAnySizeGiveTheSameLayout) {
  PreparedScene prepared(longCorridor());
  Intentions intentions = ask(Statistic::kSigma, Sense::kMinimize, 5);
  intentions.luminaires.flux = {1000, 1000, 2000, 1500, 1000};
  Vns whole(prepared, intentions, 11), sliced(prepared, intentions, 11);
  whole.advance(9000);
  for (std::uint32_t done = 0, slice = 1; done < 9000;
       done += slice, slice = std::min(2 * slice + 1, 9000 - done))
    sliced.advance(std::min(slice, 9000 - done));
  EXPECT_EQ(whole.evaluations(), 9000u);
  EXPECT_EQ(sliced.evaluations(), 9000u);
  EXPECT_EQ(whole.incumbent().sites, sliced.incumbent().sites);
  EXPECT_EQ(whole.evaluation().goal, sliced.evaluation().goal);
}

TEST(Vns, RespectsPinsExclusionsAndDistance) {
  PreparedScene prepared(longCorridor());
  Intentions intentions = ask(Statistic::kMean, Sense::kMaximize, 6, {2});
  intentions.luminaires.pinned = {40, 7};
  for (std::uint32_t site = 240; site < 258; ++site) intentions.luminaires.excluded.push_back(site);
  intentions.luminaires.minDistance = 2.0;
  ASSERT_TRUE(checkIntentions(longCorridor(), intentions));
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Vns vns(prepared, intentions, seed);
    for (int slice = 0; slice < 40; ++slice) {
      vns.advance(200);
      const std::vector<std::uint32_t> sites = vns.incumbent().sites;
      ASSERT_EQ(sites.size(), 6u);
      EXPECT_EQ(sites[0], 40u);
      EXPECT_EQ(sites[1], 7u);
      for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_LT(sites[i], 240u);
        for (std::size_t j = 0; j < i; ++j) EXPECT_GE(prepared.distance(sites[i], sites[j]), 2.0);
      }
    }
  }
}

TEST(Vns, PinnedLuminairesKeepTheirNumbers) {
  PreparedScene prepared(longCorridor());
  Intentions intentions = ask(Statistic::kSigma, Sense::kMinimize, 5, {2});
  intentions.luminaires.flux = {500, 900, 1300, 1700, 2100};
  intentions.luminaires.pinned = {kNone, 40, kNone, kNone, 7};
  ASSERT_TRUE(checkIntentions(longCorridor(), intentions));
  const Layout start{{250, 40, 3, 99, 7}, {}, 1};
  for (const Layout* from : {&start, static_cast<const Layout*>(nullptr)}) {
    Vns vns(prepared, intentions, 3, from);
    if (from) {
      EXPECT_EQ(vns.incumbent().sites, start.sites);
    }
    for (int slice = 0; slice < 30; ++slice) {  // restarts on the way
      vns.advance(2000);
      const std::vector<std::uint32_t> sites = vns.incumbent().sites;
      EXPECT_EQ(sites[1], 40u);
      EXPECT_EQ(sites[4], 7u);
      EXPECT_EQ(std::set<std::uint32_t>(sites.begin(), sites.end()).size(), 5u);
    }
    if (from) {
      EXPECT_NE(vns.incumbent().sites, start.sites);
    }
  }
}

TEST(Vns, FindsTheExhaustiveOptimumOfSmallRooms) {
  PreparedScene prepared(smallRoom());
  Intentions intentions = ask(Statistic::kSigma, Sense::kMinimize, 3, {2});
  for (const Sense sense : {Sense::kMinimize, Sense::kMaximize}) {
    intentions.goals[0].sense = sense;
    for (const bool bounded : {false, true}) {
      intentions.constraints.clear();
      if (bounded) intentions.constraints = {{Statistic::kMean, 40, 60, 1, {2}, {}}};
      Evaluator evaluator(prepared, intentions);
      Evaluation best{1e9, 0, 1};
      for (std::uint32_t a = 0; a < 20; ++a)
        for (std::uint32_t b = a + 1; b < 20; ++b)
          for (std::uint32_t c = b + 1; c < 20; ++c)
            if (const Evaluation e = evaluator.evaluate({a, b, c}); isBetter(e, best)) best = e;
      for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Vns vns(prepared, intentions, seed);
        vns.advance(5000);
        EXPECT_NEAR(vns.evaluation().violation, best.violation, 1e-9);
        EXPECT_NEAR(vns.evaluation().goal, best.goal, 1e-7);
      }
    }
  }
}

TEST(Vns, FindsTheExhaustiveOptimumOfAnAim) {
  PreparedScene prepared(smallRoom());
  Intentions intentions = ask(Statistic::kMean, Sense::kNear, 3, {2});
  for (const double low : {0.4, 1.0})
    for (const double target : {20.0, 45.0, 900.0})
      for (const bool bounded : {false, true}) {
        intentions.luminaires.dimmingLow = low;
        intentions.goals[0].target = target;
        intentions.constraints.clear();
        if (bounded) intentions.constraints = {{Statistic::kMean, 30, 40, 1, {0}, {}}};
        Evaluator evaluator(prepared, intentions);
        Evaluation best{1e9, 0, 1};
        for (std::uint32_t a = 0; a < 20; ++a)
          for (std::uint32_t b = a + 1; b < 20; ++b)
            for (std::uint32_t c = b + 1; c < 20; ++c)
              if (const Evaluation e = evaluator.evaluate({a, b, c}); isBetter(e, best)) best = e;
        Vns vns(prepared, intentions, 5);
        vns.advance(5000);
        EXPECT_NEAR(vns.evaluation().violation, best.violation, 1e-9) << low << " " << target;
        EXPECT_NEAR(vns.evaluation().goal, best.goal, 1e-7) << low << " " << target;
        Evaluator at(prepared, intentions);
        at.load(vns.incumbent().sites);
        EXPECT_NEAR(at.goalValue(0), best.goal, 1e-7) << "an aim is told as the distance that it is";
      }
}

TEST(Vns, StartsFromAGivenLayoutAndNeverReturnsWorse) {
  PreparedScene prepared(longCorridor());
  const Intentions intentions = ask(Statistic::kSigma, Sense::kMinimize, 6);
  const Layout start{{3, 50, 99, 140, 200, 250}, std::vector<double>(6, 1000), 1};
  Vns vns(prepared, intentions, 1, &start);
  EXPECT_EQ(sorted(vns.incumbent().sites), start.sites);
  double last = vns.evaluation().goal;
  for (int slice = 0; slice < 50; ++slice) {
    vns.advance(100);
    EXPECT_LE(vns.evaluation().goal, last);
    last = vns.evaluation().goal;
  }
}

TEST(Vns, KeepsTheBestWhereItStartsAnew) {
  PreparedScene prepared(longCorridor());
  const Intentions intentions = ask(Statistic::kSigma, Sense::kMinimize, 4);
  Vns vns(prepared, intentions, 5);
  Evaluation before = vns.evaluation();
  std::vector<std::uint32_t> sites = vns.incumbent().sites;
  std::uint64_t foundAt = vns.foundAt();
  for (int slice = 0; slice < 300; ++slice) {
    vns.advance(1000);
    ASSERT_FALSE(isBetter(before, vns.evaluation())) << slice;
    if (isBetter(vns.evaluation(), before)) {
      foundAt = vns.foundAt();
      sites = vns.incumbent().sites;
    }
    before = vns.evaluation();
    // What is as good, once more, is no news.
    ASSERT_EQ(vns.foundAt(), foundAt) << slice;
    ASSERT_EQ(vns.incumbent().sites, sites) << slice;
    Evaluator evaluator(prepared, intentions);
    evaluator.load(sites);
    ASSERT_NEAR(evaluator.current().goal, before.goal, 1e-9 * before.goal) << slice;
  }
}

TEST(Vns, TrueMinimumHoldsOnThePatchesWithItsMargin) {
  Scene scene = longCorridor();
  scene.errorBound.assign(4, 0.02f);
  PreparedScene prepared(scene);
  Intentions intentions = ask(Statistic::kMean, Sense::kMinimize, 6, {0});
  intentions.constraints = {{Statistic::kMinimum, 12, kUnbounded, 1, {0}, {}}};
  Vns vns(prepared, intentions, 4);
  vns.advance(20000);
  ASSERT_EQ(vns.evaluation().violation, 0);
  const ExplicitStatistics truth = explicitStatistics(scene, illuminanceOf(scene, vns.incumbent()), {0});
  EXPECT_GE(truth.minimum - 0.02 * truth.mean, 12 * (1 - 1e-5));
}

TEST(Vns, GoldenLayoutIsTheSameOnEveryMachine) {
  PreparedScene prepared(longCorridor());
  Intentions intentions = ask(Statistic::kSigma, Sense::kMinimize, 6, {2});
  intentions.luminaires.flux = {1000, 1150, 1320, 1510, 1730, 1970};
  intentions.constraints = {{Statistic::kMean, 5, 8, 1, {2}, {}}};
  Vns vns(prepared, intentions, 2024);
  vns.advance(3000);
  EXPECT_EQ(vns.incumbent().sites, (std::vector<std::uint32_t>{4, 1, 2, 3, 192, 174}));
}

TEST(Vns, GoldenLayoutOfAnAimIsTheSameOnEveryMachine) {
  PreparedScene prepared(longCorridor());
  Intentions intentions = ask(Statistic::kSigma, Sense::kMinimize, 7);
  Goal aim{Statistic::kMean, Sense::kNear, 10, {2}, {}};
  aim.target = 30;
  intentions.goals.push_back(aim);
  Vns vns(prepared, intentions, 2025);
  vns.advance(40000);  // walks, crossings, and pairs of the best sites
  EXPECT_EQ(vns.incumbent().sites, (std::vector<std::uint32_t>{87, 50, 15, 249, 165, 200, 128}));
}

TEST(Vns, StandsStillWhenNothingCanMove) {
  PreparedScene prepared(smallRoom());
  Intentions intentions = ask(Statistic::kSigma, Sense::kMinimize, 2);
  intentions.luminaires.pinned = {3, 4};
  Vns vns(prepared, intentions, 1);
  vns.advance(1000);
  EXPECT_EQ(vns.incumbent().sites, (std::vector<std::uint32_t>{3, 4}));
  EXPECT_EQ(vns.evaluations(), 0u);
}

}  // namespace
}  // namespace fiatlux
