// Each region and borderline case of the alpha-search on two-patch walls whose answer can be read off, and
// what is said of it (alpha_verdict).
#include "core/alpha/alpha_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "tests/core/corridor_scene.h"

namespace fiatlux {
namespace {

/// One wall of two patches; each site gives the two a pair of illuminances at 1 lm. Sigma is half their
/// difference.
Scene wall(const std::vector<std::pair<float, float>>& sites) {
  Scene scene;
  scene.patches.count = 2;
  scene.patches.area = {1, 1};
  scene.patches.reflectance = {0.5f, 0.5f};
  scene.patches.surface = {0, 0};
  scene.surfaces = {{"wall", 2, 0.5, 2, false, 0}};
  scene.sites.resize(sites.size());
  for (std::size_t j = 0; j < sites.size(); ++j) scene.sites[j].position = {static_cast<double>(j), 0, 0};
  scene.responses = {2, static_cast<std::uint32_t>(sites.size()), {}};
  for (const auto& [dark, bright] : sites) {
    scene.responses.illuminance.push_back(dark);
    scene.responses.illuminance.push_back(bright);
  }
  fiatlux::testing::addStatistics(scene);
  return scene;
}

Intentions dimWallWithMinimum(double minimum) {
  Intentions intentions;
  intentions.luminaires.count = 1;
  intentions.luminaires.flux = {1};
  intentions.goals = {{Statistic::kMean, Sense::kMinimize, 1, {0}, {}}};
  intentions.constraints = {{Statistic::kMinimum, minimum, kUnbounded, 1, {0}, {}}};
  return intentions;
}

AlphaSearch solved(PreparedScene& prepared, const Intentions& intentions) {
  AlphaOptions options;
  options.evaluations = 500;
  AlphaSearch search(prepared, intentions, options);
  for (int slice = 0; slice < 100000 && !search.done(); ++slice) search.advance(700);
  EXPECT_TRUE(search.done());
  return search;
}

TEST(AlphaSearch, FindsTheSmallestAlphaToWithinTheInterval) {
  const Scene scene = wall({{0, 20}, {12, 16}, {30, 40}});
  PreparedScene prepared(
      scene);  // site 0: 10 - 10 alpha >= 8 up to alpha = 0.2; then site 1, with minimum 12
  const AlphaSearch search = solved(prepared, dimWallWithMinimum(8));
  ASSERT_EQ(search.outcome(), AlphaOutcome::kFound);
  EXPECT_GT(search.solution()->alpha, 0.2);
  EXPECT_LE(search.solution()->alpha, 0.2101);
  EXPECT_EQ(search.solution()->layout.sites[0], 1u);
  EXPECT_NEAR(search.solution()->mean, 14, 1e-9);
  EXPECT_NEAR(search.solution()->sigma, 2, 1e-5);
  EXPECT_NEAR(search.solution()->minimum, 12, 1e-5);
  EXPECT_NEAR(search.solution()->phi, 14, 1e-9);
  EXPECT_EQ(search.iterations()[0].region, Region::kOne);
  EXPECT_EQ(search.iterations()[1].region, Region::kTwo);
  EXPECT_NE(search.verdict().find("at least 8 lx on every patch of wall"), std::string::npos)
      << search.verdict();
}

TEST(AlphaSearch, RegionOneEmpty) {
  const Scene scene = wall({{10, 10}, {2, 60}});
  PreparedScene prepared(scene);
  const AlphaSearch search = solved(prepared, dimWallWithMinimum(5));
  EXPECT_EQ(search.outcome(), AlphaOutcome::kZeroSuffices);
  EXPECT_EQ(search.iterations().size(), 1u);
  EXPECT_EQ(search.solution()->alpha, 0);
}

TEST(AlphaSearch, RegionTwoEmptyNamesTheFeasibleBound) {
  const Scene scene = wall({{0, 20}, {3, 9}});
  PreparedScene prepared(scene);  // no site has 5 on both patches; the best minimum is 3
  const AlphaSearch search = solved(prepared, dimWallWithMinimum(5));
  EXPECT_EQ(search.outcome(), AlphaOutcome::kTwoEmpty);
  EXPECT_EQ(search.solution(), nullptr);
  ASSERT_TRUE(search.fallback());
  EXPECT_NEAR(search.feasibleBound(), 3, 1e-5);
  EXPECT_EQ(search.fallback()->sites[0], 1u);
}

TEST(AlphaSearch, RegionThreeFromTheStart) {
  const Scene scene = wall({{0, 20}, {3, 9}});
  PreparedScene prepared(scene);
  const AlphaSearch search = solved(prepared, dimWallWithMinimum(100));
  EXPECT_EQ(search.outcome(), AlphaOutcome::kNoLayout);
  EXPECT_EQ(search.iterations().size(), 1u);
  EXPECT_EQ(search.iterations()[0].region, Region::kThree);
  EXPECT_NEAR(search.feasibleBound(), 3, 1e-5);
}

TEST(AlphaSearch, SaysWhenTheOtherIntentionsCannotBeMetAnyway) {
  const Scene scene = wall({{0, 20}, {3, 9}});
  PreparedScene prepared(scene);
  Intentions intentions = dimWallWithMinimum(5);
  intentions.constraints.push_back({Statistic::kMean, 500, kUnbounded, 1, {0}, {}});
  const AlphaSearch search = solved(prepared, intentions);
  EXPECT_EQ(search.outcome(), AlphaOutcome::kNoLayout);
  EXPECT_FALSE(search.fallback());
  EXPECT_NE(search.verdict().find("relax one of them"), std::string::npos);
}

TEST(AlphaSearch, GuaranteedMaximumUsesTheUpperSide) {
  const Scene scene = wall({{0, 20}, {8, 10}, {1, 2}});
  PreparedScene prepared(scene);  // brightest wall without a patch above 12: site 1
  Intentions intentions = dimWallWithMinimum(0);
  intentions.goals[0].sense = Sense::kMaximize;
  intentions.constraints = {{Statistic::kMaximum, -kUnbounded, 12, 1, {0}, {}}};
  const AlphaSearch search = solved(prepared, intentions);
  ASSERT_EQ(search.outcome(), AlphaOutcome::kFound);  // site 0 passes while 10 + 10 alpha <= 12
  EXPECT_NEAR(search.solution()->alpha, 0.2, 0.0101);
  EXPECT_EQ(search.solution()->layout.sites[0], 1u);
}

TEST(AlphaSearch, SlicesDoNotChangeItsPathAndItsAnswerHoldsOnThePatches) {
  const Scene& scene = fiatlux::testing::longCorridor();
  PreparedScene prepared(scene);
  Intentions intentions;
  intentions.luminaires.flux = {3000};
  intentions.goals = {{Statistic::kMean, Sense::kMinimize, 1, {0}, {}}};
  intentions.constraints = {{Statistic::kMinimum, 15, kUnbounded, 1, {0}, {}}};
  AlphaOptions options;
  options.evaluations = 3000;
  AlphaSearch whole(prepared, intentions, options), sliced(prepared, intentions, options);
  whole.advance(1u << 30);
  while (!sliced.done()) sliced.advance(777);
  ASSERT_TRUE(whole.solution()) << whole.verdict();
  ASSERT_EQ(whole.iterations().size(), sliced.iterations().size());
  for (std::size_t i = 0; i < whole.iterations().size(); ++i) {
    EXPECT_EQ(whole.iterations()[i].alpha, sliced.iterations()[i].alpha);
    EXPECT_EQ(whole.iterations()[i].layout.sites, sliced.iterations()[i].layout.sites);
  }
  const ExplicitStatistics light =
      explicitStatistics(scene, illuminanceOf(scene, whole.solution()->layout), {0});
  EXPECT_GE(light.minimum, 15 * (1 - 1e-6));
}

TEST(AlphaSearch, TellsOfTheGuaranteeThatItsOwnQuantityBreaksMost) {
  // Exitance: the dark wall (rho 0.1) misses its minimum by far, though in lux it would be the bright one.
  Scene scene = wall({{10, 20}, {30, 9}});
  scene.surfaces = {{"white wall", 1, 0.9, 1, false, 0}, {"dark wall", 1, 0.1, 1, false, 0}};
  scene.patches.surface = {0, 1};
  scene.patches.reflectance = {0.9f, 0.1f};
  fiatlux::testing::addStatistics(scene);
  PreparedScene prepared(scene);
  Intentions intentions = dimWallWithMinimum(0);
  intentions.quantity = Quantity::kExitance;
  intentions.goals = {{Statistic::kMean, Sense::kMaximize, 1, {}, {}}};
  intentions.constraints = {{Statistic::kMinimum, 28, kUnbounded, 1, {0}, {}},  // at best 27, at 30 lx
                            {Statistic::kMinimum, 8, kUnbounded, 1, {1}, {}}};  // at best 2, at 20 lx
  const AlphaSearch search = solved(prepared, intentions);
  EXPECT_EQ(search.outcome(), AlphaOutcome::kNoLayout);
  EXPECT_NE(search.verdict().find("at least 8 lm/m2 on every patch of dark wall"), std::string::npos)
      << search.verdict();
}

}  // namespace
}  // namespace fiatlux
