// Guarantees on true patches, and their Chebyshev form.
#include "core/alpha/guarantees.h"

#include <gtest/gtest.h>

#include "core/search/validate_intentions.h"
#include "tests/core/corridor_scene.h"

namespace fiatlux {
namespace {

using fiatlux::testing::smallRoom;

Intentions asking(std::vector<Constraint> constraints) {
  Intentions intentions;
  intentions.luminaires.count = 2;
  intentions.constraints = std::move(constraints);
  return intentions;
}

TEST(Guarantees, AreMinimaFromBelowAndMaximaFromAbove) {
  EXPECT_TRUE(isGuarantee({Statistic::kMinimum, 3, kUnbounded, 1, {}, {}}));
  EXPECT_TRUE(isGuarantee({Statistic::kMaximum, -kUnbounded, 3, 1, {}, {}}));
  EXPECT_FALSE(isGuarantee({Statistic::kMinimum, -kUnbounded, 3, 1, {}, {}}));
  EXPECT_FALSE(isGuarantee({Statistic::kMaximum, 3, kUnbounded, 1, {}, {}}));
  EXPECT_FALSE(isGuarantee({Statistic::kMean, 3, 4, 1, {}, {}}));
}

TEST(Guarantees, AnAlphaNeedsOne) {
  EXPECT_FALSE(checkAlphaIntentions(smallRoom(), asking({{Statistic::kMean, 3, 4, 1, {}, {}}})));
  EXPECT_TRUE(checkAlphaIntentions(smallRoom(), asking({{Statistic::kMinimum, 3, 4, 1, {}, {}}})));
  Intentions aiming = asking({{Statistic::kMinimum, 3, 4, 1, {}, {}}});
  aiming.goals = {{Statistic::kMean, Sense::kNear, 1, {0}, {}, 50}};
  ASSERT_TRUE(checkIntentions(smallRoom(), aiming));
  const Result<Done> refused = checkAlphaIntentions(smallRoom(), aiming);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("near a target"), std::string::npos);
}

TEST(Guarantees, BecomeChebyshevAndLeaveTheirOtherSide) {
  const Intentions problem = chebyshevProblem(
      asking({{Statistic::kMean, 1, 2, 1, {0}, {}}, {Statistic::kMinimum, 3, 4, 1, {2}, {}}}), 1.5);
  ASSERT_EQ(problem.constraints.size(), 3u);
  EXPECT_EQ(problem.constraints[0].statistic, Statistic::kMean);
  EXPECT_EQ(problem.constraints[1].statistic, Statistic::kChebyshev);
  EXPECT_EQ(problem.constraints[1].alpha, 1.5);
  EXPECT_EQ(problem.constraints[1].lower, 3);
  EXPECT_EQ(problem.constraints[1].upper, kUnbounded);
  EXPECT_EQ(problem.constraints[2].statistic, Statistic::kMinimum);
  EXPECT_EQ(problem.constraints[2].lower, -kUnbounded);
  EXPECT_EQ(problem.constraints[2].upper, 4);
}

TEST(Guarantees, TheShortfallIsOfTheTruePatchesInTheirQuantity) {
  const Scene& scene = smallRoom();
  const Layout layout{{3, 11}, {1000, 2000}, 0.5};
  const ExplicitStatistics light = explicitStatistics(scene, illuminanceOf(scene, layout), {2});
  const Extremes lux = extremesUnder(scene, Quantity::kIlluminance, {2}, layout);
  EXPECT_NEAR(lux.minimumLow, light.minimum, 1e-5 * light.minimum);
  EXPECT_NEAR(lux.maximumHigh, light.maximum, 1e-5 * light.maximum);
  // The yellow wall reflects half.
  const Extremes reflected = extremesUnder(scene, Quantity::kExitance, {2}, layout);
  EXPECT_NEAR(reflected.minimumLow, 0.5 * light.minimum, 1e-5 * light.minimum);
  const double low = lux.minimumLow, high = lux.maximumHigh;
  EXPECT_NEAR(shortfallOf({Statistic::kMinimum, 2 * low, kUnbounded, 1, {2}, {}}, lux), 0.5, 1e-12);
  EXPECT_LE(shortfallOf({Statistic::kMinimum, low, kUnbounded, 1, {2}, {}}, lux), 0);
  EXPECT_NEAR(shortfallOf({Statistic::kMaximum, -kUnbounded, high / 2, 1, {2}, {}}, lux), 1, 1e-12);
}

}  // namespace
}  // namespace fiatlux
