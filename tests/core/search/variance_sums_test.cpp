// The two forms of a variance, covariance and factor (light_factor.h), against each other: of layouts, of
// trials and of ties, whatever is asked.
#include "core/search/variance_sums.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "core/bound/layout_bound.h"
#include "core/search/evaluator.h"
#include "core/search/layout_search.h"
#include "core/search/start_layout.h"
#include "tests/core/corridor_scene.h"

namespace fiatlux {
namespace {

using fiatlux::testing::longCorridor;

constexpr double kClose = 1e-6;

Intentions everyStatistic(std::uint32_t count, Quantity quantity) {
  Intentions intentions;
  intentions.quantity = quantity;
  intentions.luminaires.count = count;
  intentions.goals = {{Statistic::kSigma, Sense::kMinimize, 1, {}, {}},
                      {Statistic::kSigma, Sense::kMaximize, 0.2, {1, 3}, {}},
                      {Statistic::kMean, Sense::kMaximize, 0.5, {2}, {}}};
  intentions.constraints = {{Statistic::kMean, 20, 40, 1, {0, 3}, {}},
                            {Statistic::kSigma, 3, 9, 1, {0}, {}},
                            {Statistic::kChebyshev, 50, 90, 1.5, {2}, {}},
                            {Statistic::kContrast, 2, kUnbounded, 1, {2}, {0}},
                            {Statistic::kMinimum, 30, kUnbounded, 1, {3}, {}},
                            {Statistic::kMaximum, -kUnbounded, 20, 1, {0}, {}},
                            {Statistic::kUniformity, 0.9, kUnbounded, 1, {2}, {}}};
  return intentions;
}

void expectSame(const Evaluation& a, const Evaluation& b) {
  EXPECT_NEAR(a.violation, b.violation, kClose * (1 + std::fabs(b.violation)));
  EXPECT_NEAR(a.goal, b.goal, kClose * (1 + std::fabs(b.goal)));
}

class BothForms : public ::testing::TestWithParam<Quantity> {
 protected:
  PreparedScene covariance{longCorridor(), VarianceForm::kCovariance};
  PreparedScene factor{longCorridor(), VarianceForm::kFactor};
};

TEST_P(BothForms, TellTheSameMeansAndVariances) {
  Random random(3);
  for (const SurfaceSet& surfaces : {SurfaceSet{}, SurfaceSet{0}, SurfaceSet{1, 3}}) {
    const auto full = covariance.statistics(GetParam(), surfaces),
               light = factor.statistics(GetParam(), surfaces);
    ASSERT_TRUE(light->factor && light->covariance.empty());
    ASSERT_FALSE(full->factor || full->covariance.empty());
    for (const std::uint32_t count : {1u, 2u, 7u, 24u, 200u}) {
      const auto sites = randomSites(factor, everyStatistic(count, GetParam()).luminaires, random);
      std::vector<double> flux;
      for (std::uint32_t i = 0; i < count; ++i) flux.push_back(500 + 2000 * random.unit());
      const Moments a = momentsOf(*full, sites.data(), flux.data(), count);
      const Moments b = momentsOf(*light, sites.data(), flux.data(), count);
      EXPECT_NEAR(b.mean, a.mean, kClose * a.mean);
      EXPECT_NEAR(b.sigma(), a.sigma(), kClose * a.sigma());
    }
  }
}

TEST_P(BothForms, JudgeTrialsAlike) {
  const Intentions intentions = everyStatistic(6, GetParam());
  Evaluator a(covariance, intentions), b(factor, intentions);
  Random random(5);
  const auto start = randomSites(factor, intentions.luminaires, random);
  a.load(start), b.load(start);
  for (int step = 0; step < 60; ++step) {
    const std::uint32_t i = random.below(6), other = (i + 1) % 6, to = random.below(factor.candidateCount());
    if (std::count(a.sites().begin(), a.sites().end(), to) > 0) continue;
    Trial move{{}, 0, {1e30, 0, 1}}, moveToo = move, pair = move, pairToo = move;
    a.tryMoves(i, &to, 1, move), b.tryMoves(i, &to, 1, moveToo);
    expectSame(moveToo.evaluation, move.evaluation);
    a.tryPair({i, to}, {other, a.sites()[i]}, pair), b.tryPair({i, to}, {other, a.sites()[i]}, pairToo);
    expectSame(pairToo.evaluation, pair.evaluation);
    a.apply(pair), b.apply(pairToo);
    expectSame(b.current(), a.current());
    expectSame(b.current(), pairToo.evaluation);
  }
}

TEST_P(BothForms, TellTheSameOfTies) {
  Ties ties;
  for (std::uint32_t site = 0; site + 7 < 258; site += 6) ties.members.push_back({site, site + 3, site + 7});
  ties.members.push_back({257});
  const auto a = covariance.tied(ties)->statistics(GetParam(), {0, 2});
  const auto b = factor.tied(ties)->statistics(GetParam(), {0, 2});
  const std::uint32_t nobody = static_cast<std::uint32_t>(ties.members.size());
  const std::vector<std::uint32_t> sites = {4, nobody, 21, nobody - 1};
  const std::vector<double> flux = {1000, 1000, 700, 800};
  const Moments full = momentsOf(*a, sites.data(), flux.data(), 4);
  const Moments light = momentsOf(*b, sites.data(), flux.data(), 4);
  EXPECT_NEAR(light.mean, full.mean, kClose * full.mean);
  EXPECT_NEAR(light.sigma(), full.sigma(), kClose * full.sigma());
}

TEST_P(BothForms, FindLayoutsThatAreWhatTheySay) {
  Intentions intentions = everyStatistic(9, GetParam());
  intentions.constraints.resize(4);
  LayoutSearch search(factor, intentions, 1, nullptr);
  search.advance(2000);
  Evaluator full(covariance, intentions);
  expectSame(full.evaluate(search.incumbent().sites), search.evaluation());
}

INSTANTIATE_TEST_SUITE_P(Of, BothForms, ::testing::Values(Quantity::kIlluminance, Quantity::kExitance));

TEST(VarianceInTurn, OfAFactorIsThatOfEachLayoutByItself) {
  PreparedScene prepared(longCorridor(), VarianceForm::kFactor);
  const auto statistics = prepared.statistics(Quantity::kIlluminance, {});
  VarianceInTurn inTurn(*statistics);
  Random random(11);
  std::vector<std::uint32_t> sites = {3, 40, 77, 120, 200};
  const std::vector<double> flux = {1000, 1500, 400, 2500, 900};
  for (int turn = 0; turn < 600; ++turn) {
    sites[random.below(5)] = random.below(258);  // of one site twice, too
    if (turn % 50 == 0) std::swap(sites[0], sites[4]);
    const std::uint32_t count = 1 + random.below(5);
    const double alone = momentsOf(*statistics, sites.data(), flux.data(), count).variance;
    ASSERT_NEAR(inTurn.of(sites.data(), flux.data(), count), alone, 1e-9 * alone);
  }
}

/// A corridor lit from 2100 places, as candidates are: without covariances.
Scene crowded() {
  Scene scene = longCorridor();
  const std::size_t rows = scene.responses.rows;
  const std::vector<float> columns = scene.responses.illuminance;
  while (scene.sites.size() <= kMostInCovariance) {
    const std::size_t like = scene.sites.size() % 258;
    scene.sites.push_back(scene.sites[like]);
    for (std::size_t p = 0; p < rows; ++p)
      scene.responses.illuminance.push_back(columns[like * rows + p] * (1 + 0.001f * (p % 7)));
  }
  scene.responses.sites = static_cast<std::uint32_t>(scene.sites.size());
  scene.illuminance = meanRows(scene.patches, scene.surfaces.size(), scene.responses, Quantity::kIlluminance);
  return scene;
}

TEST(PreparedScene, MakesFactorsOfManyCandidatesAndNoBoundOfTheirSpread) {
  const Scene scene = crowded();
  PreparedScene prepared(scene), few(longCorridor());
  EXPECT_TRUE(prepared.statistics(Quantity::kIlluminance, {})->factor);
  EXPECT_FALSE(few.statistics(Quantity::kIlluminance, {})->factor);
  Intentions intentions;
  intentions.luminaires.count = 4;
  intentions.goals = {{Statistic::kSigma, Sense::kMinimize, 1, {}, {}}};
  LayoutSearch search(prepared, intentions, 1, nullptr);
  search.advance(10);
  EXPECT_FALSE(LayoutBound(prepared, intentions, search).supported());
  intentions.goals = {{Statistic::kMean, Sense::kMaximize, 1, {0}, {}}};
  intentions.constraints = {{Statistic::kSigma, 0, 1e9, 1, {0}, {}}};
  EXPECT_TRUE(LayoutBound(prepared, intentions, LayoutSearch(prepared, intentions, 1, nullptr)).supported());
}

}  // namespace
}  // namespace fiatlux
