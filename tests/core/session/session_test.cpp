// The order of things in a sitting, and readings of a layout (shown) against explicit values of its patches.
#include "core/session/session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/core/corridor_scene.h"
#include "tests/core/synthetic_scene.h"

namespace fiatlux {
namespace {

using ::testing::HasSubstr;

Intentions evenLight() {
  Intentions intentions;
  intentions.luminaires.count = 3;
  intentions.goals = {{Statistic::kSigma, Sense::kMinimize, 1, {}, {}}};
  return intentions;
}

TEST(Session, SaysWhatIsMissing) {
  Session session;
  EXPECT_THAT(session.finish().error().message, HasSubstr("no scene file"));
  EXPECT_THAT(session.setIntentions(evenLight()).error().message, HasSubstr("no scene"));
  session.adopt(syntheticScene(16, 8));
  EXPECT_THAT(session.start(1, nullptr).error().message, HasSubstr("nothing is asked"));
  EXPECT_THAT(session.incumbent().error().message, HasSubstr("no search"));
  EXPECT_EQ(session.advance(100).evaluations, 0u);
}

TEST(Session, CandidatesHaveTheGridsAndObserversOfTheirRoom) {
  Session room, hung;
  room.adopt(syntheticScene(16, 8));
  hung.adopt(syntheticScene(16, 4), &room);
  EXPECT_EQ(hung.observers(), room.observers());
  EXPECT_EQ(hung.grids(), room.grids());
  const auto before = room.observers();
  room.adopt(syntheticScene(16, 8));
  EXPECT_NE(room.observers(), before);  // another room is looked at anew
}

TEST(Session, LooksForRoomAlsoWhileSomethingElseIsAsked) {
  Session session;
  LuminaireRules rules;
  rules.count = 3;
  EXPECT_FALSE(session.hasRoom(rules));
  session.adopt(syntheticScene(16, 8));
  EXPECT_TRUE(session.hasRoom(rules));
  ASSERT_TRUE(session.setIntentions(evenLight()));
  rules.count = 9;
  EXPECT_FALSE(session.hasRoom(rules));
  EXPECT_TRUE(session.start(1, nullptr));
}

TEST(Session, WhatIsTriedAsideKeepsTheNumbersOfWhoHangs) {
  Session session;
  session.adopt(fiatlux::testing::longCorridor());
  Intentions rows = evenLight();
  rows.luminaires.count = 6;
  rows.goals[0].surfaces = {0};
  ASSERT_TRUE(session.setIntentions(rows));
  rows.luminaires.arrangement.rule = Rule::kRows;
  const auto found = [&](const Layout* start) {
    EXPECT_TRUE(session.startAside(rows, 1, start, 5000));
    for (;;)
      if (const auto tried = session.advanceAside(1000); *tried) return (*tried)->layout.sites;
  };
  Layout hanging{found(nullptr), std::vector<double>(6, 1000), 1};
  // The same by steps without evaluations.
  ASSERT_TRUE(session.startAside(rows, 1, nullptr, 5000));
  EXPECT_FALSE(session.enterAside());
  while (!session.enterAside()) continue;
  const auto rest = session.advanceAside(5000);
  ASSERT_TRUE(*rest);
  EXPECT_EQ((*rest)->layout.sites, hanging.sites);
  EXPECT_TRUE(session.enterAside());
  std::reverse(hanging.sites.begin(), hanging.sites.end());
  const std::vector<std::uint32_t> sites = found(&hanging);
  ASSERT_TRUE(std::is_permutation(sites.begin(), sites.end(), hanging.sites.begin()));
  EXPECT_EQ(sites, hanging.sites);
}

TEST(Session, IntentionsThatCannotBeLeaveTheOldOnes) {
  Session session;
  session.adopt(syntheticScene(16, 8));
  ASSERT_TRUE(session.setIntentions(evenLight()));
  ASSERT_TRUE(session.start(1, nullptr));
  Intentions wrong = evenLight();
  wrong.goals[0].surfaces = {99};
  EXPECT_FALSE(session.setIntentions(wrong));
  EXPECT_EQ(session.intentions().goals[0].surfaces.size(), 0u);
  EXPECT_EQ(session.advance(100).evaluations, 100u);
}

TEST(Session, ThePathDoesNotDependOnTheSlices) {
  Session whole, sliced;
  for (Session* session : {&whole, &sliced}) {
    session->adopt(syntheticScene(32, 16));
    ASSERT_TRUE(session->setIntentions(evenLight()));
    ASSERT_TRUE(session->start(5, nullptr));
  }
  const SearchProgress once = whole.advance(3000);
  for (int i = 0; i < 30; ++i) sliced.advance(100);
  const SearchProgress often = sliced.advance(0);
  EXPECT_EQ(once.evaluations, often.evaluations);
  EXPECT_EQ(once.foundAt, often.foundAt);
  EXPECT_EQ(once.evaluation.goal, often.evaluation.goal);
  EXPECT_EQ(whole.incumbent()->layout.sites, sliced.incumbent()->layout.sites);
}

TEST(Session, WhatASearchNeedsCanBePreparedInSlices) {
  Session whole, sliced;
  for (Session* session : {&whole, &sliced}) {
    Scene scene = syntheticScene(32, 16);
    for (auto* leaves : {&scene.illuminance, &scene.exitance})
      for (SurfaceStatistics& leaf : *leaves) leaf.covariance.clear();  // as of candidates
    session->adopt(std::move(scene));
    Intentions intentions = evenLight();
    intentions.constraints = {{Statistic::kContrast, 0.1, kUnbounded, 0, {0}, {1}}};
    ASSERT_TRUE(session->setIntentions(intentions));
  }
  int slices = 0;
  while (!sliced.prepareSearch(1)) ++slices;
  EXPECT_GT(slices, 2);
  EXPECT_TRUE(sliced.prepareSearch(1));
  for (Session* session : {&whole, &sliced}) ASSERT_TRUE(session->start(5, nullptr));
  EXPECT_EQ(whole.advance(3000).evaluation.goal, sliced.advance(3000).evaluation.goal);
  EXPECT_EQ(whole.incumbent()->layout.sites, sliced.incumbent()->layout.sites);
}

TEST(Session, NothingIsPreparedOfWhatIsAskedForItsMeanAlone) {
  Session session;
  Scene scene = syntheticScene(32, 16);
  for (auto* leaves : {&scene.illuminance, &scene.exitance})
    for (SurfaceStatistics& leaf : *leaves) leaf.covariance.clear();  // as of candidates
  session.adopt(std::move(scene));
  Intentions intentions = evenLight();
  intentions.goals = {{Statistic::kMean, Sense::kMaximize, 1, {0}, {}}};
  intentions.constraints = {{Statistic::kContrast, 0.1, kUnbounded, 0, {0}, {1}}};
  ASSERT_TRUE(session.setIntentions(intentions));
  EXPECT_TRUE(session.prepareSearch(1));
  ASSERT_TRUE(session.start(5, nullptr));
  EXPECT_GT(session.advance(3000).evaluations, 0u);
  EXPECT_EQ(session.incumbent()->layout.sites.size(), 3u);
}

TEST(Session, ReadingsAreThoseOfThePatches) {
  for (Quantity quantity : {Quantity::kIlluminance, Quantity::kExitance}) {
    Session session;
    session.adopt(syntheticScene(32, 16));
    Intentions intentions = evenLight();
    intentions.quantity = quantity;
    ASSERT_TRUE(session.setIntentions(intentions));
    const Layout layout{{2, 9, 14}, {1000, 500, 2000}, 0.8};
    const Shown shown = *session.show(layout);
    std::vector<float> values = shown.illuminance;
    if (quantity == Quantity::kExitance)
      for (std::size_t p = 0; p < values.size(); ++p) values[p] *= session.scene()->patches.reflectance[p];
    for (std::uint32_t s = 0; s < shown.surfaces.size(); ++s) {
      const bool all = s == session.scene()->surfaces.size();
      if (!all && quantity == Quantity::kExitance && session.scene()->surfaces[s].measuring) continue;
      const ExplicitStatistics truth =
          explicitStatistics(*session.scene(), values, all ? SurfaceSet{} : SurfaceSet{s});
      EXPECT_NEAR(shown.surfaces[s].mean, truth.mean, 1e-5 * truth.mean);
      EXPECT_NEAR(shown.surfaces[s].sigma, truth.sigma, 1e-4 * truth.mean);
      EXPECT_NEAR(shown.surfaces[s].minimum, truth.minimum, 1e-5 * truth.mean);
      EXPECT_NEAR(shown.surfaces[s].maximum, truth.maximum, 1e-5 * truth.maximum);
    }
    const StatisticsCheck check = checkStatistics(*session.scene(), quantity, shown);
    EXPECT_LT(check.largestDifference, 1e-4);
  }
}

TEST(Session, ConstraintsAreReadInTheirOwnUnits) {
  Session session;
  session.adopt(syntheticScene(32, 16));
  const Layout layout{{2, 9, 14}, {1000, 1000, 1000}, 1};
  Intentions intentions = evenLight();
  ASSERT_TRUE(session.setIntentions(intentions));
  const SurfaceReading floor = session.show(layout)->surfaces[0], wall = session.show(layout)->surfaces[1];
  intentions.constraints = {{Statistic::kMean, 2 * floor.mean, kUnbounded, 1, {0}, {}},
                            {Statistic::kChebyshev, floor.mean, 10 * floor.mean, 2, {0}, {}},
                            {Statistic::kMaximum, -kUnbounded, floor.maximum * 4, 1, {0}, {}},
                            {Statistic::kUniformity, 0.01, kUnbounded, 1, {0}, {}},
                            {Statistic::kContrast, 0, kUnbounded, 1, {0}, {1}},
                            {Statistic::kPower, -kUnbounded, 1500, 1, {}, {}}};
  ASSERT_TRUE(session.setIntentions(intentions)) << session.setIntentions(intentions).error().message;
  const Shown shown = *session.show(layout);
  EXPECT_NEAR(shown.constraints[0].value, floor.mean, 1e-6 * floor.mean);
  EXPECT_NEAR(shown.constraints[0].violation, 0.5, 1e-6);
  EXPECT_NEAR(shown.constraints[0].margin, -0.5, 1e-6);
  EXPECT_NEAR(shown.constraints[1].value, floor.mean - 2 * floor.sigma, 1e-4 * floor.mean);
  EXPECT_NEAR(shown.constraints[2].value, floor.maximum, 1e-5 * floor.maximum);
  EXPECT_EQ(shown.constraints[2].violation, 0);
  EXPECT_NEAR(shown.constraints[3].value, floor.minimum / floor.mean, 1e-5);
  EXPECT_NEAR(shown.constraints[4].value, floor.mean / wall.mean, 1e-6);
  EXPECT_NEAR(shown.constraints[5].violation, 1, 1e-9);
}

TEST(Session, APinnedLuminaireKeepsItsNumber) {
  Session session;
  session.adopt(syntheticScene(32, 16));
  Intentions intentions = evenLight();
  intentions.luminaires.pinned = {14};
  intentions.constraints = {{Statistic::kMinimum, 1, kUnbounded, 1, {0}, {}}};
  const Layout held{{2, 9, 14}, {1000, 1000, 1000}, 1};
  ASSERT_TRUE(session.setIntentions(intentions));
  ASSERT_TRUE(session.start(1, &held));
  session.advance(3000);
  EXPECT_EQ(session.incumbent()->layout.sites[2], 14u);
  ASSERT_TRUE(session.setIntentions(intentions));
  ASSERT_TRUE(session.startAlpha(1, &held));
  while (!session.alpha()->done()) session.alpha()->advance(10000);
  for (const AlphaIteration& iteration : session.alpha()->iterations())
    EXPECT_EQ(iteration.layout.sites[2], 14u);
  ASSERT_TRUE(session.setIntentions(intentions));
  ASSERT_TRUE(session.start(1, nullptr));
  EXPECT_EQ(session.incumbent()->layout.sites[0], 14u) << "without a layout the first one is pinned";
}

TEST(Session, RefusesLayoutsThatCannotBe) {
  Session session;
  session.adopt(syntheticScene(16, 8));
  ASSERT_TRUE(session.setIntentions(evenLight()));
  const auto refusal = [&](const Layout& layout) { return session.show(layout).error().message; };
  EXPECT_THAT(refusal({{8}, {1000}, 1}), HasSubstr("no site 8"));
  EXPECT_THAT(refusal({{1, 1}, {1000, 1000}, 1}), HasSubstr("two luminaires on site 1"));
  EXPECT_THAT(refusal({{1, 2}, {1000}, 1}), HasSubstr("2 sites but 1 fluxes"));
  EXPECT_THAT(refusal({{1}, {std::nan("")}, 1}), HasSubstr("flux"));
  EXPECT_THAT(refusal({{1}, {1000}, -1}), HasSubstr("dimming"));
}

}  // namespace
}  // namespace fiatlux
