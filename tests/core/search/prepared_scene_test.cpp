// Means without variances: what is prepared of surface sets whose variance nobody asks for.
#include "core/search/prepared_scene.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/search/evaluator.h"
#include "tests/core/synthetic_scene.h"

namespace fiatlux {
namespace {

class OfCandidates : public ::testing::TestWithParam<Quantity> {
 protected:
  /// Its covariances are made of its light.
  static Scene sceneOfCandidates() {
    Scene scene = syntheticScene(32, 16);
    for (auto* leaves : {&scene.illuminance, &scene.exitance})
      for (SurfaceStatistics& leaf : *leaves) leaf.covariance.clear();
    return scene;
  }
  const Scene scene = sceneOfCandidates();
};

TEST_P(OfCandidates, MeansAloneAreThoseThatHaveVariances) {
  PreparedScene prepared(scene), whole(scene);
  for (const SurfaceSet& surfaces : {SurfaceSet{}, SurfaceSet{0}, SurfaceSet{1}}) {
    const auto means = prepared.statistics(GetParam(), surfaces, false);
    const auto full = whole.statistics(GetParam(), surfaces);
    EXPECT_FALSE(means->hasVariance());
    EXPECT_TRUE(full->hasVariance());
    EXPECT_EQ(means->mean, full->mean);
    EXPECT_EQ(prepared.statistics(GetParam(), surfaces, false), means);
  }
}

TEST_P(OfCandidates, VariancesTakeThePlaceOfMeansAlone) {
  PreparedScene prepared(scene);
  const auto means = prepared.statistics(GetParam(), {0}, false);
  EXPECT_FALSE(prepared.prepare(GetParam(), {0}, 1));
  while (!prepared.prepare(GetParam(), {0}, 1)) continue;
  const auto full = prepared.statistics(GetParam(), {0});
  EXPECT_TRUE(full->hasVariance());
  EXPECT_EQ(full->mean, means->mean);
  EXPECT_EQ(prepared.statistics(GetParam(), {0}, false), full);
}

TEST_P(OfCandidates, TiesHaveNoVarianceThatNobodyAsksFor) {
  PreparedScene prepared(scene);
  Ties ties;
  ties.members = {{0, 3}, {5}, {6, 9, 12}};
  const auto tied = prepared.tied(ties);
  const auto means = tied->statistics(GetParam(), {0}, false);
  EXPECT_FALSE(means->hasVariance());
  const auto full = tied->statistics(GetParam(), {0});
  EXPECT_TRUE(full->hasVariance());
  EXPECT_EQ(means->mean, full->mean);
}

/// Whatever asks for a set first, whoever needs its variance has it.
TEST_P(OfCandidates, ASetOfWhichMoreIsAskedLaterHasItsVariance) {
  Intentions intentions;
  intentions.quantity = GetParam();
  intentions.luminaires.count = 3;
  intentions.goals = {{Statistic::kContrast, Sense::kMaximize, 1, {0}, {1}},
                      {Statistic::kMean, Sense::kMaximize, 1, {0}, {}},
                      {Statistic::kSigma, Sense::kMinimize, 1, {0}, {}}};
  intentions.constraints = {{Statistic::kChebyshev, 1, kUnbounded, 0.5, {1}, {}}};
  PreparedScene prepared(scene), whole(scene);
  for (const SurfaceSet& surfaces : {SurfaceSet{0}, SurfaceSet{1}})
    (void)whole.statistics(GetParam(), surfaces);
  Evaluator evaluator(prepared, intentions), known(whole, intentions);
  for (std::uint32_t first = 0; first + 6 < 16; ++first) {
    const std::vector<std::uint32_t> sites = {first, first + 2, first + 6};
    const Evaluation a = evaluator.evaluate(sites), b = known.evaluate(sites);
    EXPECT_EQ(a.goal, b.goal);
    EXPECT_EQ(a.violation, b.violation);
    EXPECT_GT(std::abs(a.goal), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Of, OfCandidates, ::testing::Values(Quantity::kIlluminance, Quantity::kExitance));

}  // namespace
}  // namespace fiatlux
