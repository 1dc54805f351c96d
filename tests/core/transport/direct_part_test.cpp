// Direct light apart from all light (direct_part, Quantity::kDirect): its columns, what goals and constraints
// read of it, trials against full evaluations.
#include "core/transport/direct_part.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/candidates/candidate_scene.h"
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

TEST(DirectPart, TrialsOfTheSearchAreFullEvaluations) {
  Scene scene = operatorScene(16, 8);
  ASSERT_TRUE(addDirect(scene));
  PreparedScene prepared(scene);
  Evaluator evaluator(prepared, emergency());
  evaluator.load({0, 3, 6});
  for (std::uint32_t site : {1u, 2u, 4u, 5u, 7u}) {
    Trial best;
    best.evaluation.violation = kUnbounded;
    evaluator.tryMoves(1, &site, 1, best);
    ASSERT_EQ(best.count, 1u);
    const Evaluation full = Evaluator(prepared, emergency()).evaluate({0, site, 6});
    EXPECT_NEAR(best.evaluation.violation, full.violation, 1e-4 * (1 + full.violation));
    EXPECT_NEAR(best.evaluation.goal, full.goal, 1e-4 * full.goal);
  }
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
