// What cannot be meant is refused in one line that names it.
#include "core/search/validate_intentions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/core/corridor_scene.h"

namespace fiatlux {
namespace {

Intentions sound() {
  Intentions intentions;
  intentions.goals = {{Statistic::kSigma, Sense::kMinimize, 1, {0}, {}}};
  intentions.constraints = {{Statistic::kMean, 10, 20, 1, {1, 2}, {}}};
  return intentions;
}

void expectRefusal(const std::function<void(Intentions&)>& spoil, const std::string& part) {
  Intentions intentions = sound();
  spoil(intentions);
  const Result<Done> result = checkIntentions(fiatlux::testing::smallRoom(), intentions);
  ASSERT_FALSE(result) << "expected a refusal about: " << part;
  EXPECT_NE(result.error().message.find(part), std::string::npos) << result.error().message;
  EXPECT_EQ(result.error().message.find('\n'), std::string::npos);
}

TEST(CheckIntentions, AcceptsSoundOnes) {
  EXPECT_TRUE(checkIntentions(fiatlux::testing::smallRoom(), sound()));
}

TEST(CheckIntentions, RefusesImpossibleLuminaires) {
  expectRefusal([](Intentions& i) { i.luminaires.count = 0; }, "count");
  expectRefusal([](Intentions& i) { i.luminaires.count = 21; }, "20 free sites");
  expectRefusal([](Intentions& i) { i.luminaires.flux = {1, 2}; }, "2 fluxes for 6");
  expectRefusal([](Intentions& i) { i.luminaires.flux = {NAN}; }, "flux");
  expectRefusal([](Intentions& i) { i.luminaires.dimmingLow = 0.9, i.luminaires.dimmingHigh = 0.2; },
                "dimming");
  expectRefusal([](Intentions& i) { i.luminaires.pinned = {20}; }, "sites are 0 to 19");
  expectRefusal([](Intentions& i) { i.luminaires.pinned = {3, 3}; }, "pinned twice");
  expectRefusal([](Intentions& i) { i.luminaires.pinned = {3}, i.luminaires.excluded = {3}; },
                "both pinned and excluded");
  expectRefusal(
      [](Intentions& i) {
        i.luminaires.pinned = {3, 4}, i.luminaires.minDistance = 1;
      },
      "0.75 m apart");
  expectRefusal([](Intentions& i) { i.luminaires.minDistance = 3; }, "found room for only");
  expectRefusal([](Intentions& i) { i.luminaires.minDistance = -1; }, "minimum distance");
}

TEST(CheckIntentions, RefusesMeaninglessGoalsAndConstraints) {
  expectRefusal([](Intentions& i) { i.goals[0].statistic = Statistic::kMinimum; }, "cannot be a goal");
  expectRefusal([](Intentions& i) { i.goals[0].weight = -1; }, "weight");
  expectRefusal([](Intentions& i) { i.goals[0].sense = Sense::kNear, i.goals[0].target = 5; },
                "sigma cannot aim");
  expectRefusal([](Intentions& i) { i.goals[0] = {Statistic::kMean, Sense::kNear, 1, {0}, {}, 0}; },
                "target of 0");
  expectRefusal([](Intentions& i) { i.goals[0].surfaces = {9}; }, "surface number 9");
  expectRefusal([](Intentions& i) { i.constraints[0].lower = 30; }, "above the maximum");
  expectRefusal([](Intentions& i) { i.constraints[0].lower = NAN; }, "not a number");
  expectRefusal(
      [](Intentions& i) { i.constraints[0].lower = -kUnbounded, i.constraints[0].upper = kUnbounded; },
      "no bound");
  expectRefusal(
      [](Intentions& i) { i.constraints[0].statistic = Statistic::kChebyshev, i.constraints[0].alpha = -1; },
      "alpha");
}

TEST(CheckIntentions, RefusesTheExitanceOfAMeasuringPlane) {
  Scene scene = fiatlux::testing::smallRoom();
  scene.surfaces[0].measuring = true;
  Intentions intentions = sound();
  EXPECT_TRUE(checkIntentions(scene, intentions));
  intentions.quantity = Quantity::kExitance;
  const Result<Done> result = checkIntentions(scene, intentions);
  ASSERT_FALSE(result);
  EXPECT_NE(result.error().message.find("measuring plane"), std::string::npos);
}

}  // namespace
}  // namespace fiatlux
