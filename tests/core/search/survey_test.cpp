// A survey of moves against trials of them, one by one: goal and broken bounds at their price, with dimming
// and without; and which intentions may be surveyed.
#include <gtest/gtest.h>

#include <cmath>

#include "core/search/evaluator.h"
#include "core/search/start_layout.h"
#include "tests/core/corridor_scene.h"

namespace fiatlux {
namespace {

using fiatlux::testing::longCorridor;

constexpr double kPenalty = 3;

Goal least(Statistic statistic, const SurfaceSet& surfaces, double weight) {
  return {statistic, Sense::kMinimize, weight, surfaces, {}};
}

/// Sigma and mean wanted, bounds of every kind that a survey knows at edges that random layouts are near to.
Intentions asked() {
  Intentions intentions;
  intentions.luminaires.count = 6;
  intentions.luminaires.flux = {1000, 1500, 1000, 700, 1000, 2000};
  intentions.goals = {least(Statistic::kSigma, {}, 1), least(Statistic::kMean, {2}, 0.5)};
  intentions.constraints = {{Statistic::kMean, 20, 40, 1, {0, 3}, {}},
                            {Statistic::kSigma, -kUnbounded, 15, 1, {1}, {}},
                            {Statistic::kChebyshev, 5, 90, 1.5, {2}, {}}};
  return intentions;
}

/// A random luminaire on random candidates, the first its own, surveyed in a random layout.
struct Surveyed {
  std::uint32_t luminaire;
  std::uint32_t candidates[kSurveyed];
  double worths[kSurveyed];

  Surveyed(PreparedScene& prepared, Evaluator& evaluator, const Intentions& intentions, Random& random) {
    evaluator.load(randomSites(prepared, intentions.luminaires, random));
    luminaire = random.below(6);
    candidates[0] = evaluator.sites()[luminaire];
    for (std::uint32_t k = 1; k < kSurveyed; ++k) candidates[k] = random.below(prepared.candidateCount());
    evaluator.survey(luminaire, candidates, worths);
  }
};

struct Compared {
  std::uint32_t broken = 0, met = 0;  // of the moves
};

/// Moves of random luminaires in random layouts, each surveyed and tried.
Compared compareWithTrials(const Intentions& intentions, const Prices& prices = {kPenalty, 1}) {
  PreparedScene prepared(longCorridor());
  Evaluator evaluator(prepared, intentions);
  EXPECT_TRUE(evaluator.maySurvey());
  evaluator.setPrices(prices);
  Random random(5);
  Compared compared;
  for (int round = 0; round < 40; ++round) {
    const Surveyed surveyed(prepared, evaluator, intentions, random);
    for (std::uint32_t k = 0; k < kSurveyed; ++k) {
      Trial trial;
      trial.evaluation = {kUnbounded, kUnbounded, 1};
      evaluator.tryMoves(surveyed.luminaire, surveyed.candidates + k, 1, trial);
      const double violation = trial.evaluation.violation;
      (violation > 0 ? compared.broken : compared.met) += 1;
      const double worth = prices.worthOf(trial.evaluation);
      // note: where no dimming meets all bounds, the survey does not look for the best one.
      if (intentions.luminaires.dimmingLow == 1 || violation == 0) {
        EXPECT_NEAR(surveyed.worths[k], worth, 1e-9 * std::fabs(worth));
      }
    }
  }
  return compared;
}

TEST(Survey, SaysWhatTrialsSayOneByOne) {
  const Compared compared = compareWithTrials(asked());
  EXPECT_GT(compared.broken, 100u);
  EXPECT_GT(compared.met, 5u);
}

TEST(Survey, FindsTheDimmingThatBoundsAllow) {
  Intentions intentions = asked();
  intentions.luminaires.dimmingLow = 0.2;
  EXPECT_GT(compareWithTrials(intentions).met, 100u);
  for (Goal& goal : intentions.goals) goal.sense = Sense::kMaximize;
  EXPECT_GT(compareWithTrials(intentions).met, 100u);
}

/// Both kinds of value aimed at, where random layouts are on either side of the targets.
Intentions aiming() {
  Intentions intentions = asked();
  Goal mean{Statistic::kMean, Sense::kNear, 10, {2}, {}, 30},
      sigma{Statistic::kSigma, Sense::kNear, 2, {1}, {}, 8};
  intentions.goals.push_back(mean);
  intentions.goals.push_back(sigma);
  return intentions;
}

TEST(Survey, SaysHowFarAimsAreMissed) {
  EXPECT_GT(compareWithTrials(aiming()).broken, 100u);
  EXPECT_GT(compareWithTrials(aiming(), {kPenalty, 0.1}).broken, 100u) << "of which a share counts";
  Intentions free = aiming();
  free.constraints.clear();
  EXPECT_GT(compareWithTrials(free).met, 100u);
}

TEST(Survey, FindsTheDimmingThatMeetsAnAim) {
  Intentions intentions = aiming();
  intentions.luminaires.dimmingLow = 0.2;
  EXPECT_GT(compareWithTrials(intentions).met, 100u);
  intentions.constraints.clear();
  EXPECT_GT(compareWithTrials(intentions, {kPenalty, 0.1}).met, 100u);
}

TEST(Survey, OfPairsSaysWhatTrialsSay) {
  PreparedScene prepared(longCorridor());
  const Intentions intentions = aiming();
  Evaluator evaluator(prepared, intentions);
  const Prices prices{kPenalty, 0.5};
  evaluator.setPrices(prices);
  Random random(6);
  for (int round = 0; round < 40; ++round) {
    evaluator.load(randomSites(prepared, intentions.luminaires, random));
    Move first[kSurveyed], second[kSurveyed];
    for (std::uint32_t k = 0; k < kSurveyed; ++k) {
      const std::uint32_t a = random.below(6), b = (a + 1 + random.below(5)) % 6;
      first[k] = {a, random.below(prepared.candidateCount())};
      second[k] = {b, k % 4 == 0 ? evaluator.sites()[b] : random.below(prepared.candidateCount())};
    }
    double worths[kSurveyed];
    evaluator.surveyPairs(first, second, worths);
    for (std::uint32_t k = 0; k < kSurveyed; ++k) {
      Trial trial;
      trial.evaluation = {kUnbounded, kUnbounded, 1};
      evaluator.tryPair(first[k], second[k], trial);
      const double worth = prices.worthOf(trial.evaluation);
      EXPECT_NEAR(worths[k], worth, 1e-9 * std::fabs(worth));
    }
  }
}

/// Bounds of true extremes that layouts are near to, beside those of asked().
Intentions withExtremes() {
  Intentions intentions = asked();
  intentions.constraints.push_back({Statistic::kMinimum, 6, kUnbounded, 1, {2}, {}});
  intentions.constraints.push_back({Statistic::kMaximum, -kUnbounded, 60, 1, {0}, {}});
  intentions.constraints.push_back({Statistic::kUniformity, 0.4, kUnbounded, 1, {1, 2}, {}});
  return intentions;
}

TEST(Survey, HopesForExtremesThatAreNoWorseThanTheyAreAndOftenTheSame) {
  PreparedScene prepared(longCorridor());
  const Intentions intentions = withExtremes();
  Evaluator evaluator(prepared, intentions);
  ASSERT_TRUE(evaluator.maySurvey());
  const Prices prices{kPenalty, 1};
  evaluator.setPrices(prices);
  Random random(5);
  std::uint32_t exact = 0, all = 0;
  for (int round = 0; round < 40; ++round) {
    const Surveyed surveyed(prepared, evaluator, intentions, random);
    const double* worths = surveyed.worths;
    EXPECT_NEAR(worths[0], prices.worthOf(evaluator.current()), 1e-9 * worths[0]) << "it stands there";
    for (std::uint32_t k = 0; k < kSurveyed; ++k) {
      std::vector<std::uint32_t> sites = evaluator.sites();
      sites[surveyed.luminaire] = surveyed.candidates[k];
      const double worth = prices.worthOf(evaluator.evaluate(sites));
      EXPECT_LE(worths[k], worth + 1e-9 * std::fabs(worth));
      exact += worths[k] > worth - 1e-6 * std::fabs(worth);
      ++all;
    }
  }
  EXPECT_GT(exact, all / 3);
}

TEST(Survey, KnowsOfExtremesThatMayNotBeTooSmallOrTooLarge) {
  PreparedScene prepared(longCorridor());
  Intentions intentions = withExtremes();
  EXPECT_TRUE(Evaluator(prepared, intentions).maySurvey());
  intentions.constraints[3].upper = 30;
  EXPECT_FALSE(Evaluator(prepared, intentions).maySurvey()) << "a minimum that may not be too large";
  intentions.constraints.resize(3);
  intentions.constraints.push_back({Statistic::kContrast, 1, kUnbounded, 1, {2}, {1}});
  EXPECT_FALSE(Evaluator(prepared, intentions).maySurvey());
}

TEST(Survey, IsOfBoundsThatAreNotZeroAndOfCovariances) {
  PreparedScene prepared(longCorridor());
  Intentions intentions = asked();
  intentions.constraints[0].lower = 0;
  EXPECT_FALSE(Evaluator(prepared, intentions).maySurvey()) << "an excess over 0 is not relative to it";
  PreparedScene halls(longCorridor(), VarianceForm::kFactor);
  EXPECT_FALSE(Evaluator(halls, asked()).maySurvey()) << "a factor's variances have no covariance";
}

}  // namespace
}  // namespace fiatlux
