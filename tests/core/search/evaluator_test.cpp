// Fast paths (evaluator, kernels, prepared_scene, patch_extremes) against slow ones: quadratic forms against
// the explicit light of every patch, deltas against full sums.
#include "core/search/evaluator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "core/search/shown.h"
#include "core/search/start_layout.h"
#include "core/search/validate_intentions.h"
#include "tests/core/corridor_scene.h"

namespace fiatlux {
namespace {

using fiatlux::testing::longCorridor;
using fiatlux::testing::smallRoom;

Intentions meanAndSigma(std::uint32_t count) {
  Intentions intentions;
  intentions.luminaires.count = count;
  intentions.luminaires.flux = {1000};
  intentions.goals = {{Statistic::kSigma, Sense::kMinimize, 1, {}, {}},
                      {Statistic::kMean, Sense::kMaximize, 0.5, {2}, {}}};
  intentions.constraints = {{Statistic::kMean, 20, 40, 1, {0, 3}, {}},
                            {Statistic::kChebyshev, 5, 90, 1.5, {2}, {}}};
  return intentions;
}

Layout layoutOf(const std::vector<std::uint32_t>& sites, double flux) {
  return {sites, std::vector<double>(sites.size(), flux), 1};
}

TEST(Evaluator, QuadraticFormsEqualExplicitStatisticsOfThePatches) {
  const Scene& scene = longCorridor();
  PreparedScene prepared(scene);
  Evaluator evaluator(prepared, meanAndSigma(6));
  Random random(7);
  for (int trial = 0; trial < 50; ++trial) {
    const auto sites = randomSites(prepared, meanAndSigma(6).luminaires, random);
    evaluator.load(sites);
    const std::vector<float> light = illuminanceOf(scene, layoutOf(sites, 1000));
    for (std::size_t s = 0; s < evaluator.objective().sets().size(); ++s) {
      const ExplicitStatistics truth =
          explicitStatistics(scene, light, evaluator.objective().sets()[s].surfaces);
      EXPECT_NEAR(evaluator.moments()[s].mean, truth.mean, 1e-5 * truth.mean);
      if (evaluator.objective().sets()[s].needsVariance) {
        EXPECT_NEAR(std::sqrt(evaluator.moments()[s].variance), truth.sigma, 1e-4 * truth.sigma);
      }
    }
  }
}

TEST(Evaluator, GlareOfTrialsIsThatOfFullEvaluations) {
  Scene scene = smallRoom();
  for (std::uint32_t o = 0; o < 3; ++o) {
    const std::vector<double> none(scene.responses.sites);
    ObserverRows rows{{"o" + std::to_string(o), {}, {1, 0, 0}}, {}, {}, none, none};
    for (std::uint32_t j = 0; j < scene.responses.sites; ++j) {
      rows.glare.push_back(1e-4 * ((7 * j + 3 * o) % 11));
      rows.background.push_back(1e-3 * (1 + (j + o) % 4));
    }
    scene.observers.push_back(rows);
  }
  PreparedScene prepared(scene);
  Intentions intentions = meanAndSigma(3);
  for (const ObserverRows& rows : scene.observers) intentions.observers.push_back(rows.observer);
  intentions.luminaires.flux = {1000, 1500, 400};
  intentions.constraints = {{Statistic::kUgr, -kUnbounded, 12, 1, {}, {}, kNone},
                            {Statistic::kUgr, -kUnbounded, 9, 1, {}, {}, 1}};
  Evaluator evaluator(prepared, intentions), reference(prepared, intentions);
  Random random(5);
  evaluator.load({0, 7, 19});
  for (int step = 0; step < 50; ++step) {
    const std::uint32_t i = random.below(3), to = random.below(prepared.candidateCount());
    auto sites = evaluator.sites();
    if (std::find(sites.begin(), sites.end(), to) != sites.end()) continue;
    Trial trial{{}, 0, {1e30, 0, 1}}, pair = trial;
    evaluator.tryMoves(i, &to, 1, trial);
    evaluator.tryPair({0, sites[1]}, {1, sites[0]}, pair);
    std::swap(sites[0], sites[1]);
    EXPECT_NEAR(pair.evaluation.violation, reference.evaluate(sites).violation, 1e-9);
    std::swap(sites[0], sites[1]);
    sites[i] = to;
    EXPECT_NEAR(trial.evaluation.violation, reference.evaluate(sites).violation, 1e-9);
    evaluator.apply(trial);
    EXPECT_NEAR(evaluator.current().violation, reference.evaluate(sites).violation, 1e-9);
    const Shown shown = shownOf(prepared, intentions, evaluator.layout());
    EXPECT_NEAR(
        missWeightOf(Statistic::kUgr) * (shown.constraints[0].violation + shown.constraints[1].violation),
        evaluator.current().violation, 1e-9);
  }
}

TEST(Evaluator, DeltaOfAMoveEqualsFullEvaluation) {
  PreparedScene prepared(longCorridor());
  Evaluator evaluator(prepared, meanAndSigma(6)), reference(prepared, meanAndSigma(6));
  Random random(3);
  auto sites = randomSites(prepared, meanAndSigma(6).luminaires, random);
  evaluator.load(sites);
  for (int step = 0; step < 300; ++step) {
    const std::uint32_t i = random.below(6), to = random.below(prepared.candidateCount());
    if (std::find(sites.begin(), sites.end(), to) != sites.end()) continue;
    Trial trial{{}, 0, {1e9, 0, 1}};
    evaluator.tryMoves(i, &to, 1, trial);
    ASSERT_EQ(trial.count, 1u);
    sites[i] = to;
    const Evaluation full = reference.evaluate(sites);
    EXPECT_NEAR(trial.evaluation.goal, full.goal, 1e-9);
    EXPECT_NEAR(trial.evaluation.violation, full.violation, 1e-9);
    evaluator.apply(trial);
    EXPECT_NEAR(evaluator.current().goal, full.goal, 1e-9);
  }
}

TEST(Evaluator, DeltaOfTwoMovesEqualsFullEvaluationWithDifferentFluxes) {
  Intentions intentions = meanAndSigma(4);
  intentions.luminaires.flux = {500, 900, 1300, 2100};
  PreparedScene prepared(longCorridor());
  Evaluator evaluator(prepared, intentions), reference(prepared, intentions);
  evaluator.load({10, 60, 120, 200});
  Trial swapped{{}, 0, {1e9, 0, 1}}, moved = swapped;
  evaluator.tryPair({0, 200}, {3, 10}, swapped);
  evaluator.tryPair({1, 61}, {2, 133}, moved);
  EXPECT_NEAR(swapped.evaluation.goal, reference.evaluate({200, 60, 120, 10}).goal, 1e-9);
  EXPECT_NEAR(moved.evaluation.goal, reference.evaluate({10, 61, 133, 200}).goal, 1e-9);
  evaluator.apply(swapped);
  EXPECT_NEAR(evaluator.current().goal, reference.evaluate({200, 60, 120, 10}).goal, 1e-9);
}

TEST(Evaluator, TrueExtremesEqualThoseOfThePatchesLessTheMargin) {
  Scene scene = smallRoom();
  scene.errorBound.assign(4, 0.01f);
  PreparedScene prepared(scene);
  PatchExtremes extremes(scene, Quantity::kIlluminance, {2, 3});
  const std::vector<std::uint32_t> sites = {3, 11, 17};
  const std::vector<double> flux = {1000, 1000, 1000};
  extremes.load(sites.data(), flux.data(), 3);
  const FluxChange changes[2] = {{11, -1000}, {5, 1000}};
  const Extremes moved = extremes.changed(changes, 2);
  const std::vector<float> light = illuminanceOf(scene, layoutOf({3, 5, 17}, 1000));
  double least = 1e9, largest = -1e9;
  for (std::uint32_t s : {2u, 3u}) {
    const ExplicitStatistics truth = explicitStatistics(scene, light, {s});
    least = std::min(least, truth.minimum - 0.01 * truth.mean);
    largest = std::max(largest, truth.maximum + 0.01 * truth.mean);
  }
  EXPECT_NEAR(moved.minimumLow, least, 1e-3);
  EXPECT_NEAR(moved.maximumHigh, largest, 1e-3);
  EXPECT_GE(extremes.hoped(changes, 2).minimumLow, moved.minimumLow - 1e-9);
  EXPECT_LE(extremes.hoped(changes, 2).maximumHigh, moved.maximumHigh + 1e-9);
}

TEST(Evaluator, ExtremesOfAChangeMadeForGoodAreThoseOfTheLayoutThatItLeadsTo) {
  Scene scene = smallRoom();
  scene.errorBound.assign(4, 0.01f);
  PatchExtremes changed(scene, Quantity::kExitance, {1, 2}), loaded(scene, Quantity::kExitance, {1, 2});
  const std::vector<double> flux = {1000, 1500, 1000};
  const std::vector<std::uint32_t> before = {3, 11, 17}, after = {3, 5, 17};
  changed.load(before.data(), flux.data(), 3);
  const FluxChange changes[2] = {{11, -1500}, {5, 1500}};
  changed.apply(changes, 2);
  loaded.load(after.data(), flux.data(), 3);
  const Extremes is = changed.current(), wanted = loaded.current();
  EXPECT_NEAR(is.minimumLow, wanted.minimumLow, 1e-9);
  EXPECT_NEAR(is.minimumHigh, wanted.minimumHigh, 1e-9);
  EXPECT_NEAR(is.maximumLow, wanted.maximumLow, 1e-9);
  EXPECT_NEAR(is.maximumHigh, wanted.maximumHigh, 1e-9);
}

TEST(Evaluator, WhatManyMovesHopeForIsWhatEachOfThemDoes) {
  Scene scene = smallRoom();
  scene.errorBound.assign(4, 0.01f);
  PatchExtremes extremes(scene, Quantity::kExitance, {1, 2, 3});
  const std::vector<std::uint32_t> sites = {3, 11, 17}, to = {0, 5, 11, 19};
  const std::vector<double> flux = {1000, 1500, 1000};
  extremes.load(sites.data(), flux.data(), 3);
  for (std::uint32_t site = 0; site < scene.sites.size(); ++site) {  // so that there are several witnesses
    const FluxChange changes[2] = {{17, -1000}, {site, 1000}};
    extremes.changed(changes, 2);
  }
  double least[4], most[4];
  extremes.hopedOfMoves(11, 1500, to.data(), 4, least, most);
  for (std::size_t k = 0; k < to.size(); ++k) {
    const FluxChange changes[2] = {{11, -1500}, {to[k], 1500}};
    const Extremes hoped = extremes.hoped(changes, 2), is = extremes.changed(changes, 2);
    EXPECT_NEAR(least[k], hoped.minimumLow, 1e-9);
    EXPECT_NEAR(most[k], hoped.maximumHigh, 1e-9);
    EXPECT_GE(least[k], is.minimumLow - 1e-9);
    EXPECT_LE(most[k], is.maximumHigh + 1e-9);
  }
}

TEST(Evaluator, ExtremesThatAreLeftOutAreTheBestThatMeansAndVariancesAllow) {
  Scene scene = smallRoom();
  PreparedScene prepared(scene);
  Intentions intentions;
  intentions.luminaires.count = 3;
  intentions.luminaires.flux = {1000};
  intentions.luminaires.dimmingLow = 0.2;
  intentions.goals = {{Statistic::kMean, Sense::kMaximize, 1, {2}, {}}};
  const double allowed = 1e-3;  // lx: hardly any light
  intentions.constraints = {{Statistic::kMaximum, 0, allowed, 1, {2}, {}}};
  Evaluator evaluator(prepared, intentions);
  EXPECT_TRUE(evaluator.lightsPatches());
  const std::vector<std::uint32_t> sites = {3, 11, 17};
  evaluator.load(sites);
  const Evaluation truly = evaluator.current();
  evaluator.leaveOutExtremes(true);
  evaluator.load(sites);
  const Evaluation relaxed = evaluator.current();
  EXPECT_LT(relaxed.violation, truly.violation * 0.99);
  const auto [mean, variance] = evaluator.moments()[0];
  EXPECT_NEAR(relaxed.violation, (0.2 * (mean + variance / mean) - allowed) / allowed, 1e-6 * mean / allowed);

  Trial trial{{}, 0, kNothingFound};  // what is tried and made is judged alike
  const std::uint32_t to = 5;
  evaluator.tryMoves(1, &to, 1, trial);
  ASSERT_EQ(trial.count, 1u);
  evaluator.apply(trial);
  EXPECT_NEAR(evaluator.current().violation, trial.evaluation.violation, 1e-6 * mean / allowed);
  EXPECT_NEAR(evaluator.evaluate(evaluator.sites()).violation, trial.evaluation.violation,
              1e-6 * mean / allowed);
  evaluator.leaveOutExtremes(false);
  evaluator.load(sites);
  EXPECT_EQ(evaluator.current().violation, truly.violation);
}

}  // namespace
}  // namespace fiatlux
