// Direct light apart from all light (direct_part, Quantity::kDirect): its columns, what goals and constraints
// read of it, trials against full evaluations.
#include "core/transport/direct_part.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/candidates/candidate_scene.h"
#include "core/scene/calculation_grid.h"
#include "core/scene/zones.h"
#include "core/search/evaluator.h"
#include "core/search/shown.h"
#include "core/session/session.h"
#include "core/transport/photometric_light.h"
#include "tests/core/operator_scene.h"

namespace fiatlux {
namespace {

/// Even light on the floor; the plane gets enough direct light on average, and on every patch.
Intentions emergency() {
  Intentions intentions;
  intentions.luminaires.count = 3;
  intentions.luminaires.flux = {400};
  intentions.goals = {{Statistic::kSigma, Sense::kMinimize, 1, {0}, {}}};
  intentions.constraints = {{Statistic::kMean, 20, kUnbounded, 1, {2}, {}, kNone, Quantity::kDirect},
                            {Statistic::kMinimum, 5, kUnbounded, 1, {0, 2}, {}, kNone, Quantity::kDirect},
                            {Statistic::kMean, 40, kUnbounded, 1, {2}, {}}};
  return intentions;
}

TEST(DirectPart, ItsColumnsAreThoseOfTheQuadrature) {
  Scene scene = operatorScene(16, 8);
  ASSERT_TRUE(addDirect(scene));
  const std::vector<float> exact = PhotometricLight(scene).direct({{3, lambertianOn(scene.sites[3])}});
  for (std::uint32_t p = 0; p < scene.patches.rows(); ++p)
    EXPECT_NEAR(scene.direct->responses.column(3)[p], exact[p], 0.01 * exact[p] + 1e-5) << p;
}

TEST(DirectPart, ReadingsAreThoseOfItsPatches) {
  Session session;
  session.adopt(operatorScene(16, 8));
  Intentions intentions = emergency();
  ASSERT_TRUE(session.setIntentions(intentions));
  const Layout layout{{1, 4, 6}, {400, 400, 400}, 0.5};
  Shown shown = *session.show(layout);
  const Scene& scene = *session.scene();
  const ExplicitStatistics plane = explicitStatistics(scene, shown.direct, {2});
  EXPECT_GT(plane.mean, 0);
  EXPECT_NEAR(shown.constraints[0].value, plane.mean, 1e-5 * plane.mean);
  EXPECT_NEAR(shown.constraints[1].value, explicitStatistics(scene, shown.direct, {0, 2}).minimum,
              1e-5 * plane.mean);
  EXPECT_NEAR(shown.constraints[2].value, shown.surfaces[2].mean, 1e-5 * shown.surfaces[2].mean);

  // As the quantity of all that is asked, it is all that is shown.
  intentions.quantity = Quantity::kDirect;
  ASSERT_TRUE(session.setIntentions(intentions));
  const Shown direct = *session.show(layout);
  EXPECT_EQ(direct.illuminance, shown.direct);
  EXPECT_NEAR(direct.surfaces[2].mean, plane.mean, 1e-5 * plane.mean);
  EXPECT_EQ(direct.constraints[0].value, direct.constraints[2].value);
  EXPECT_LT(checkStatistics(scene, Quantity::kDirect, direct).largestDifference, 1e-5);
}

/// One luminaire of three is tried on other sites.
void expectTrialsAreFullEvaluations(const Scene& scene, const Intentions& intentions) {
  PreparedScene prepared(scene);
  Evaluator evaluator(prepared, intentions);
  evaluator.load({0, 3, 6});
  for (std::uint32_t site : {1u, 2u, 4u, 5u, 7u}) {
    Trial best;
    best.evaluation.violation = kUnbounded;
    evaluator.tryMoves(1, &site, 1, best);
    ASSERT_EQ(best.count, 1u);
    const Evaluation full = Evaluator(prepared, intentions).evaluate({0, site, 6});
    EXPECT_NEAR(best.evaluation.violation, full.violation, 1e-4 * (1 + full.violation));
    EXPECT_NEAR(best.evaluation.goal, full.goal, 1e-4 * full.goal);
  }
}

TEST(DirectPart, TrialsOfTheSearchAreFullEvaluations) {
  Scene scene = operatorScene(16, 8);
  ASSERT_TRUE(addDirect(scene));
  expectTrialsAreFullEvaluations(scene, emergency());
}

/// Escape light on a part of the plane, and even light on its grid.
Intentions onGrids(const Scene& scene) {
  Zone route{"route", 2, {}};
  for (std::uint32_t p = scene.patches.count; p < scene.patches.rows(); ++p)
    if (scene.patches.surface[p] == 2 && scene.patches.center[p].x < 1.1) route.rows.push_back(p);
  const auto zone = static_cast<std::uint32_t>(scene.surfaces.size() - scene.zones.size());
  Intentions intentions;
  intentions.luminaires.count = 3;
  intentions.luminaires.flux = {400};
  intentions.zones = {route};
  intentions.goals = {{Statistic::kSigma, Sense::kMinimize, 1, {0}, {}}};
  const auto add = [&](Statistic statistic, double least, std::uint32_t surface, Quantity quantity) {
    intentions.constraints.push_back({statistic, least, kUnbounded, 1, {surface}, {}, kNone, quantity});
    intentions.constraints.back().onGrid = true;
  };
  add(Statistic::kMinimum, 5, zone, Quantity::kDirect);
  add(Statistic::kMean, 30, 2, Quantity::kIlluminance);
  add(Statistic::kUniformity, 0.6, 2, Quantity::kIlluminance);
  return intentions;
}

TEST(DirectPart, IsReadOnTheGridOfATaskArea) {
  Session session;
  session.adopt(operatorScene(16, 8));
  const Intentions intentions = onGrids(*session.scene());
  ASSERT_TRUE(session.setIntentions(intentions));
  const Shown shown = *session.show({{1, 4, 6}, {400, 400, 400}, 0.5});
  const Scene& scene = *session.scene();
  const auto readingOf = [&](const std::vector<float>& light, std::uint32_t surface) {
    for (const GridReading& reading : readGrids(scene, light))
      if (reading.surface == surface) return reading;
    return GridReading{};
  };
  const GridReading route = readingOf(shown.direct, intentions.constraints[0].surfaces[0]);
  const GridReading plane = readingOf(shown.illuminance, 2);
  ASSERT_GT(route.points, 0u);
  EXPECT_LT(route.least, readingOf(shown.illuminance, route.surface).least);
  EXPECT_NEAR(shown.constraints[0].value, route.least, 1e-4 * route.least);
  EXPECT_NEAR(shown.constraints[1].value, plane.mean, 1e-4 * plane.mean);
  EXPECT_NEAR(shown.constraints[2].value, plane.uniformity(), 1e-4);
  EXPECT_EQ(session.gridsOf(shown.illuminance).size(), readGrids(scene, shown.illuminance).size());

  Intentions wrong = intentions;
  wrong.constraints[0].statistic = Statistic::kMaximum;
  EXPECT_THAT(session.setIntentions(wrong).error().message, ::testing::HasSubstr("a grid tells"));
}

TEST(DirectPart, TrialsOnGridsAreFullEvaluations) {
  Scene scene = operatorScene(16, 8);
  ASSERT_TRUE(addDirect(scene));
  const Intentions intentions = onGrids(scene);
  ASSERT_TRUE(takeZones(scene, intentions.zones));
  expectTrialsAreFullEvaluations(scene, intentions);
}

TEST(DirectPart, CandidatesKeepTheirOwn) {
  const Scene room = operatorScene(12, 3);
  PhotometricType square;
  square.luminous.length = square.luminous.width = 0.5;
  square.flux = 1;
  square.beam = 2;
  square.candela = lambertianOn(room.sites[1]).intensity;
  const CandidateType type{square, 2000};
  Result<CandidateScene> making = CandidateScene::begin(room, {type}, {{1, 0, 0, 0, {}}});
  ASSERT_TRUE(making);
  while (!making->advance(8)) continue;
  DirectLight direct = making->directLight();
  Scene scene = making->finish(Quantity::kIlluminance);
  scene.direct = std::move(direct);
  Intentions intentions = emergency();
  intentions.luminaires.count = 1;
  intentions.luminaires.flux = {1};
  PreparedScene prepared(scene);
  const Shown shown = shownOf(prepared, intentions, {{0}, {1}, 1});
  EXPECT_GT(shown.constraints[0].value, 0);
  EXPECT_LT(shown.constraints[0].value, shown.constraints[2].value);
}

TEST(DirectPart, FaultsAreNamedWithTheirCure) {
  Session session;
  session.adopt(syntheticScene(16, 8));
  const auto refusal = [&](const Intentions& asked) { return session.setIntentions(asked).error().message; };
  EXPECT_THAT(refusal(emergency()), ::testing::HasSubstr("constraint 1 (mean): this room's file"));
  Intentions whole;
  whole.quantity = Quantity::kDirect;
  EXPECT_THAT(refusal(whole), ::testing::HasSubstr("without --no-exchange"));
  Intentions power;
  power.constraints = {{Statistic::kPower, 0, 9, 1, {}, {}, kNone, Quantity::kDirect}};
  EXPECT_THAT(refusal(power), ::testing::HasSubstr("power is of no quantity"));
}

}  // namespace
}  // namespace fiatlux
