// Zones: parts of a leaf that the search, its readings and its error margins know as surfaces of their own.
#include "core/scene/zones.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/scene/calculation_grid.h"
#include "core/search/patch_extremes.h"
#include "core/session/session.h"
#include "tests/core/synthetic_scene.h"

namespace fiatlux {
namespace {

using ::testing::HasSubstr;

constexpr std::uint32_t kPlane = 2;

/// The rows of the plane whose x lies between two bounds.
Zone zoneBetween(const Scene& scene, const char* name, double low, double high) {
  Zone zone{name, kPlane, {}};
  for (std::uint32_t p = scene.patches.count; p < scene.patches.rows(); ++p)
    if (scene.patches.center[p].x > low && scene.patches.center[p].x < high) zone.rows.push_back(p);
  return zone;
}

const Layout kLayout{{1, 6}, {800, 1200}, 1};

TEST(Zones, HaveTheStatisticsOfTheirRows) {
  Scene scene = syntheticScene(16, 8);
  const std::uint32_t first = static_cast<std::uint32_t>(scene.surfaces.size());
  const Zone left = zoneBetween(scene, "task 1", 0, 1), rest = zoneBetween(scene, "background", 1, 9);
  ASSERT_TRUE(takeZones(scene, {left, rest}));
  EXPECT_EQ(firstZone(scene), first);
  EXPECT_EQ(scene.zones[1].leaf, kPlane);
  EXPECT_NEAR(scene.surfaces[first].area + scene.surfaces[first + 1].area, scene.surfaces[kPlane].area, 1e-9);

  const std::vector<float> light = illuminanceOf(scene, kLayout);
  double sum = 0;
  for (const std::uint32_t p : left.rows) sum += light[p];
  const ExplicitStatistics explicitly = explicitStatistics(scene, light, {first});
  const MeanAndSigma quickly = meanAndSigmaOf(scene.illuminance[first], kLayout);
  EXPECT_NEAR(explicitly.mean, sum / left.rows.size(), 1e-4 * explicitly.mean);
  EXPECT_NEAR(quickly.mean, explicitly.mean, 1e-5 * explicitly.mean);
  EXPECT_NEAR(quickly.sigma, explicitly.sigma, 1e-4 * explicitly.mean);
  // Both together are the plane again.
  const SurfaceStatistics both = unionStatistics(scene, Quantity::kIlluminance, {first, first + 1});
  const MeanAndSigma together = meanAndSigmaOf(both, kLayout),
                     plane = meanAndSigmaOf(scene.illuminance[kPlane], kLayout);
  EXPECT_NEAR(together.mean, plane.mean, 1e-4 * plane.mean);
  EXPECT_NEAR(together.sigma, plane.sigma, 1e-3 * plane.mean);
  const Extremes extremes = extremesUnder(scene, Quantity::kIlluminance, {first}, kLayout);
  EXPECT_NEAR((extremes.minimumLow + extremes.minimumHigh) / 2, explicitly.minimum, 1e-4 * explicitly.mean);
}

TEST(Zones, HaveAGridOfTheirOwnWithoutARim) {
  Scene scene = syntheticScene(16, 8);
  const std::vector<float> light = illuminanceOf(scene, kLayout);
  const std::size_t before = readGrids(scene, light).size();
  const Zone left = zoneBetween(scene, "task 1", 0, 1);
  ASSERT_TRUE(takeZones(scene, {left}));
  const std::vector<GridReading> readings = readGrids(scene, light);
  ASSERT_EQ(readings.size(), before + 1);
  const GridReading& task = readings.back();
  EXPECT_EQ(scene.surfaces[task.surface].name, "task 1");
  EXPECT_EQ(task.rim, 0);
  const ExplicitStatistics patches = explicitStatistics(scene, light, {task.surface});
  EXPECT_NEAR(task.mean, patches.mean, 0.03 * patches.mean);
  EXPECT_GE(task.least, patches.minimum * (1 - 1e-6));
  EXPECT_LE(task.most, patches.maximum * (1 + 1e-6));
  EXPECT_EQ(gridPointsOf(scene, task.surface).size(), task.points);
}

TEST(Zones, AreReplacedAndLeaveNothingBehind) {
  Scene scene = syntheticScene(16, 8);
  const Scene before = scene;
  ASSERT_TRUE(takeZones(scene, {zoneBetween(scene, "task 1", 0, 1)}));
  ASSERT_TRUE(takeZones(scene, {zoneBetween(scene, "task 2", 1, 2)}));
  EXPECT_EQ(scene.surfaces.size(), before.surfaces.size() + 1);
  EXPECT_EQ(scene.surfaces.back().name, "task 2");
  ASSERT_TRUE(takeZones(scene, {}));
  EXPECT_EQ(scene.surfaces.size(), before.surfaces.size());
  EXPECT_EQ(scene.illuminance.size(), before.illuminance.size());
  EXPECT_EQ(scene.errorBound.size(), before.errorBound.size());
}

TEST(Zones, SayWhatTheyCannotBe) {
  Scene scene = syntheticScene(16, 8);
  const auto refused = [&](const Zone& zone) { return takeZones(scene, {zone}).error().message; };
  EXPECT_THAT(refused({"task 1", kPlane, {}}), HasSubstr("holds no point of \"desk plane\""));
  EXPECT_THAT(refused({"floor", kPlane, {scene.patches.count}}), HasSubstr("has that name"));
  EXPECT_THAT(refused({"task 1", 99, {scene.patches.count}}), HasSubstr("of no surface"));
  EXPECT_THAT(refused({"task 1", 0, {scene.patches.count}}), HasSubstr("not those of its surface"));
  EXPECT_TRUE(scene.zones.empty());
}

TEST(Zones, AreAskedForAndSearched) {
  Session session;
  session.adopt(syntheticScene(24, 24));
  const auto zone = static_cast<std::uint32_t>(session.scene()->surfaces.size());
  Intentions asked;
  asked.luminaires.count = 1;
  asked.zones = {zoneBetween(*session.scene(), "task 1", 1.4, 2.1)};
  asked.goals = {{Statistic::kMean, Sense::kMaximize, 1, {zone}, {}}};
  ASSERT_TRUE(session.setIntentions(asked));
  ASSERT_TRUE(session.start(1, nullptr));
  session.advance(2000);
  const Layout best = session.incumbent()->layout;
  EXPECT_NEAR(session.scene()->sites[best.sites[0]].position.x, 1.75, 0.3) << "above the task";
  EXPECT_EQ(session.incumbent()->surfaces.size(), zone + 2u);
  EXPECT_NEAR(session.incumbent()->surfaces[zone].mean, session.incumbent()->goals[0], 1e-3);

  Intentions wrong = asked;
  wrong.zones.clear();
  EXPECT_THAT(session.setIntentions(wrong).error().message, HasSubstr("does not exist"));
  EXPECT_EQ(session.scene()->zones.size(), 1u) << "what was asked before still holds";
  EXPECT_THAT(session.startAside(wrong, 1, nullptr, 10).error().message, HasSubstr("area"));
  asked.zones[0] = zoneBetween(*session.scene(), "task 1", 2.4, 2.9);
  ASSERT_TRUE(session.setIntentions(asked));
  ASSERT_TRUE(session.start(1, nullptr));
  session.advance(2000);
  EXPECT_NEAR(session.scene()->sites[session.incumbent()->layout.sites[0]].position.x, 2.65, 0.3);
}

}  // namespace
}  // namespace fiatlux
