// The best of all moves, as linear_worth tells it, against trials of them, one by one; and the steps of a
// tabu search, which keep to the rules and do not go back at once.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/search/evaluator.h"
#include "core/search/start_layout.h"
#include "core/search/tabu.h"
#include "tests/core/corridor_scene.h"

namespace fiatlux {
namespace {

using fiatlux::testing::longCorridor;

constexpr Prices kPrices{3, 0.4};

Intentions asked(std::vector<Goal> goals, std::vector<Constraint> constraints) {
  Intentions intentions;
  intentions.luminaires.count = 6;
  intentions.goals = std::move(goals);
  intentions.constraints = std::move(constraints);
  return intentions;
}

/// In random layouts no move by trial is worth more than the one that is found.
void compareWithTrials(const Intentions& intentions) {
  PreparedScene prepared(longCorridor());
  Evaluator evaluator(prepared, intentions);
  ASSERT_TRUE(evaluator.mayLookAround());
  evaluator.setPrices(kPrices);
  Random random(5);
  const std::vector<std::uint32_t> luminaires = {0, 2, 3, 5};
  for (int round = 0; round < 40; ++round) {
    evaluator.load(randomSites(prepared, intentions.luminaires, random));
    std::vector<float> closed(prepared.candidateCount(), 0);
    for (const std::uint32_t site : evaluator.sites()) closed[site] = kNoMove;
    closed[random.below(prepared.candidateCount())] = kNoMove;
    Trial best;
    best.evaluation = kNothingFound;
    for (const std::uint32_t i : luminaires)
      for (std::uint32_t site = 0; site < prepared.candidateCount(); ++site)
        if (closed[site] == 0) evaluator.tryMoves(i, &site, 1, best);
    Move found;
    ASSERT_TRUE(evaluator.bestMove(luminaires, closed, found));
    EXPECT_EQ(closed[found.site], 0);
    EXPECT_TRUE(std::find(luminaires.begin(), luminaires.end(), found.luminaire) != luminaires.end());
    Trial trial;
    trial.evaluation = kNothingFound;
    evaluator.tryMoves(found.luminaire, &found.site, 1, trial);
    const double worth = kPrices.worthOf(best.evaluation);
    EXPECT_NEAR(kPrices.worthOf(trial.evaluation), worth, 1e-5 * std::fabs(worth));
  }
}

TEST(BestMove, IsTheBestOfAllForOneSigma) {
  compareWithTrials(asked({{Statistic::kSigma, Sense::kMinimize, 1, {}, {}}}, {}));
}

TEST(BestMove, IsTheBestOfAllAmongBoundsAndAimsOfMeans) {
  Goal aim{Statistic::kMean, Sense::kNear, 2, {1}, {}};
  aim.target = 20;
  compareWithTrials(asked({{Statistic::kMean, Sense::kMaximize, 1, {2}, {}}, aim},
                          {{Statistic::kMean, 20, 40, 1, {0, 3}, {}}}));
}

TEST(BestMove, LeadsToLessSpreadUnderBounds) {
  Intentions intentions = asked({{Statistic::kSigma, Sense::kMinimize, 1, {}, {}}},
                                {{Statistic::kMean, 20, kUnbounded, 1, {0, 3}, {}},
                                 {Statistic::kSigma, -kUnbounded, 15, 1, {1}, {}},
                                 {Statistic::kChebyshev, 5, 90, 1.5, {2}, {}}});
  for (const double dimmingLow : {1.0, 0.1}) {
    intentions.luminaires.dimmingLow = dimmingLow;
    PreparedScene prepared(longCorridor());
    Evaluator evaluator(prepared, intentions);
    evaluator.setPrices(kPrices);
    Random random(2);
    std::uint32_t less = 0;
    for (int round = 0; round < 40; ++round) {
      evaluator.load(randomSites(prepared, intentions.luminaires, random));
      std::vector<float> closed(prepared.candidateCount(), 0);
      for (const std::uint32_t site : evaluator.sites()) closed[site] = kNoMove;
      Move found;
      ASSERT_TRUE(evaluator.bestMove({0, 1, 2, 3, 4, 5}, closed, found));
      const double before = kPrices.worthOf(evaluator.current());
      Trial trial;
      trial.moves[0] = found;
      trial.count = 1;
      trial.evaluation = kNothingFound;
      evaluator.apply(trial);
      less += kPrices.worthOf(evaluator.current()) < before;
    }
    EXPECT_GE(less, 39u);
  }
}

TEST(BestMove, IsNoneWhereAllIsClosed) {
  PreparedScene prepared(longCorridor());
  const Intentions intentions = asked({{Statistic::kSigma, Sense::kMinimize, 1, {}, {}}}, {});
  Evaluator evaluator(prepared, intentions);
  evaluator.load({0, 1, 2, 3, 4, 5});
  Move found;
  EXPECT_FALSE(evaluator.bestMove({0, 1}, std::vector<float>(prepared.candidateCount(), kNoMove), found));
}

TEST(Tabu, KeepsToTheRulesAndGoesOn) {
  PreparedScene prepared(longCorridor());
  Intentions intentions = asked({{Statistic::kSigma, Sense::kMinimize, 1, {}, {}}}, {});
  intentions.luminaires.pinned = {3};
  intentions.luminaires.excluded = {7, 8};
  Evaluator evaluator(prepared, intentions);
  FreeSites freeSites(prepared, intentions.luminaires, 6);
  Random random(1);
  const std::vector<std::uint32_t> sites = randomSites(prepared, intentions.luminaires, random);
  evaluator.load(sites);
  freeSites.load(sites);
  const Surroundings here{evaluator, freeSites, random};
  ASSERT_TRUE(Tabu::isPossible(here));
  Tabu tabu;
  std::map<std::uint32_t, int> leftAt;
  for (int step = 0; step < 60; ++step) {
    Scan scan;
    tabu.open(here, scan);
    EXPECT_GT(scan.size, 0u);
    tabu.choose(here, scan);
    ASSERT_EQ(scan.found.count, 1u);
    const auto [i, to] = scan.found.moves[0];
    const std::uint32_t from = evaluator.sites()[i];
    EXPECT_NE(i, 0u);
    EXPECT_TRUE(freeSites.mayMove(from, to));
    EXPECT_TRUE(leftAt.count(to) == 0 || step - leftAt[to] > 3);
    leftAt[from] = step;
    freeSites.relocate(from, to);
    evaluator.apply(scan.found);
  }
}

TEST(Tabu, IsNotPossibleWhereLuminairesDifferOrStandApart) {
  PreparedScene prepared(longCorridor());
  const auto isPossible = [&](const Intentions& intentions) {
    Evaluator evaluator(prepared, intentions);
    FreeSites freeSites(prepared, intentions.luminaires, 6);
    Random random(1);
    return Tabu::isPossible({evaluator, freeSites, random});
  };
  Intentions intentions = asked({{Statistic::kSigma, Sense::kMinimize, 1, {}, {}}}, {});
  EXPECT_TRUE(isPossible(intentions));
  intentions.luminaires.minDistance = 1;
  EXPECT_FALSE(isPossible(intentions));
  intentions.luminaires.minDistance = 0;
  intentions.luminaires.flux = {1000, 1000, 1000, 1000, 1000, 2000};
  EXPECT_FALSE(isPossible(intentions));
}

}  // namespace
}  // namespace fiatlux
