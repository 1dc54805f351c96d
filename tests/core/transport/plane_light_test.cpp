// What falls upright at the points of measuring planes (plane_light, core/scene/plane_points,
// core/search/plane_values): the inverse square law, an even furnace, trials of the search against full
// evaluations.
#include "core/transport/plane_light.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/search/evaluator.h"
#include "core/search/plane_values.h"
#include "core/search/shown.h"
#include "core/session/session.h"
#include "tests/core/synthetic_scene.h"

namespace fiatlux {
namespace {

constexpr double kEdge = 0.25, kHeight = 0.75;
const Vec3 kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

/// A floor of 4 x 4 m and, where asked, walls and ceiling 3 m up, all of one reflectance; a plane of 3 x 3 m
/// over it, and four small luminaires. All light is direct: the inverse square law on patches that face it.
Scene room(float reflectance, bool isClosed) {
  Scene scene;
  std::vector<Charts::Frame> frames;
  const auto add = [&](const char* name, const Vec3& from, const Vec3& u, const Vec3& v,
                       std::uint32_t columns, std::uint32_t rows, bool measuring) {
    addGrid(scene, name, from, u, v, columns, rows, kEdge, reflectance, measuring);
    frames.push_back({u, v, kEdge, kEdge});
  };
  add("floor", {0, 0, 0}, kZ, kX, 16, 16, false);
  if (isClosed) {
    add("ceiling", {0, 3, 0}, kX, kZ, 16, 16, false);
    add("west", {0, 0, 0}, kY, kZ, 12, 16, false);
    add("east", {4, 0, 0}, kZ, kY, 16, 12, false);
    add("north", {0, 0, 0}, kX, kY, 16, 12, false);
    add("south", {0, 0, 4}, kY, kX, 12, 16, false);
  }
  add("plane", {0.5, kHeight, 0.5}, kZ, kX, 12, 12, true);
  scene.lightOperator.emplace();
  scene.lightOperator->charts = {frames, scene.patches.surface};
  for (const double x : {1.0, 3.0})
    for (const double z : {1.2, 2.9}) scene.sites.push_back({{x, 2.9, z}, {0, -1, 0}, kX, 0.02});
  scene.responses = {scene.patches.rows(), 4, {}};
  for (const Site& site : scene.sites)
    for (std::uint32_t p = 0; p < scene.patches.rows(); ++p) {
      const Vec3 way = scene.patches.center[p] - site.position;
      const double squared = dot(way, way), facing = std::max(0.0, -dot(way, scene.patches.normal[p]));
      scene.responses.illuminance.push_back(
          static_cast<float>(std::max(0.0, -way.y) * facing / (squared * squared) / std::numbers::pi));
    }
  scene.errorBound.assign(scene.surfaces.size(), 0);
  setStatistics(scene);
  return scene;
}

std::uint32_t planeOf(const Scene& scene) { return static_cast<std::uint32_t>(scene.surfaces.size() - 1); }

const Vec3 kAskew = normalized({-3, 0, 1});

/// Faces are seen and modelled everywhere, and light comes from the side.
Intentions faces(std::uint32_t plane) {
  Intentions intentions;
  intentions.luminaires.count = 2;
  intentions.luminaires.flux = {3000};
  const auto add = [&](Statistic statistic, double lower, double upper, bool isLeast, const Vec3& direction) {
    intentions.constraints.push_back(
        {statistic, lower, upper, 1, {plane}, {}, kNone, {}, isLeast, direction});
  };
  add(Statistic::kCylindrical, 60, kUnbounded, false, {});
  add(Statistic::kCylindrical, 30, kUnbounded, true, {});
  add(Statistic::kModelling, 0.3, 0.6, false, {});
  add(Statistic::kModelling, 0.25, kUnbounded, true, {});
  add(Statistic::kVertical, 50, kUnbounded, false, kX);
  add(Statistic::kVertical, 10, kUnbounded, true, kAskew);
  intentions.goals = {{Statistic::kMean, Sense::kMaximize, 1, {0}, {}}};
  return intentions;
}

TEST(PlaneLight, UnderAPointItFollowsTheInverseSquareLaw) {
  Scene scene = room(0, false);
  const std::uint32_t plane = planeOf(scene);
  ASSERT_TRUE(addPlanes(scene, {{plane, {kX, kAskew}}}));
  const PlaneLight& light = scene.planes[0];
  const std::vector<PlanePoint> points = pointsOnPlane(scene, plane);
  ASSERT_GT(points.size(), 20u);
  ASSERT_EQ(light.cylindrical.rows, points.size());
  for (std::uint32_t j = 0; j < 4; ++j)
    for (std::size_t p = 0; p < points.size(); ++p) {
      EXPECT_NEAR(points[p].position.y, kHeight, 1e-9);
      const Vec3 way = scene.sites[j].position - points[p].position;
      const double d = length(way), cosine = way.y / d, sine = std::hypot(way.x, way.z) / d;
      const double candela = cosine / std::numbers::pi;
      EXPECT_NEAR(light.horizontal.column(j)[p], candela * cosine / (d * d), 0.03 * candela / (d * d));
      EXPECT_NEAR(light.cylindrical.column(j)[p], candela * sine / (std::numbers::pi * d * d),
                  1e-3 / (d * d));
      for (const PlaneLight::Vertical& vertical : light.verticals)
        EXPECT_NEAR(vertical.light.column(j)[p],
                    candela * std::max(0.0, dot(way, vertical.direction)) / (d * d * d), 1e-3 / (d * d));
    }
}

TEST(PlaneLight, InAnEvenFurnaceItIsTheSameOnEveryPlane) {
  const Scene scene = room(0.5f, true);
  Luminaire dark = luminaireOf(scene.sites[0]);
  dark.flux = 0;
  const Responses even{scene.patches.rows(), 1, std::vector<float>(scene.patches.rows(), 200)};
  const std::vector<PlaneLight> planes =
      planeLight(scene, RoomView(scene), {{planeOf(scene), {kX, kAskew}}}, {dark}, even);
  const PlaneReading reading = readPlanes(planes, {{0}, {1}, 1})[0];
  EXPECT_NEAR(reading.cylindrical.mean, 100, 0.2);
  EXPECT_NEAR(reading.cylindrical.least, 100, 0.5);
  for (const PlaneReading::Vertical& vertical : reading.verticals)
    EXPECT_NEAR(vertical.light.least, 100, 0.5);
  EXPECT_NEAR(reading.modelling.mean, 0.5, 0.002);
}

TEST(PlaneLight, TheDarkModelsNothing) {
  EXPECT_EQ(modellingOf(30, 100), 0.3);
  EXPECT_TRUE(std::isinf(modellingOf(30, 0)));
  EXPECT_TRUE(std::isnan(modellingOf(0, 0)));
}

TEST(PlaneValues, TrialsOfTheSearchAreFullEvaluations) {
  Scene scene = room(0.5f, true);
  const Intentions asked = faces(planeOf(scene));
  ASSERT_TRUE(addPlanes(scene, planesAskedOf(asked)));
  PreparedScene prepared(scene);
  Evaluator evaluator(prepared, asked);
  evaluator.load({0, 1});
  for (const std::uint32_t site : {2u, 3u}) {
    Trial best;
    best.evaluation.violation = kUnbounded;
    evaluator.tryMoves(1, &site, 1, best);
    ASSERT_EQ(best.count, 1u);
    const Evaluation full = Evaluator(prepared, asked).evaluate({0, site});
    EXPECT_NEAR(best.evaluation.violation, full.violation, 1e-6);
    EXPECT_NEAR(best.evaluation.goal, full.goal, 1e-6);
    // What is shown is read off the points themselves.
    const Shown shown = shownOf(prepared, asked, {{0, site}, {3000, 3000}, 1});
    double violation = 0;
    for (const ConstraintReading& reading : shown.constraints) violation += reading.violation;
    EXPECT_NEAR(violation, full.violation, 1e-6);
    const PlaneReading& plane = shown.planes[0];
    EXPECT_NEAR(shown.constraints[0].value, plane.cylindrical.mean, 1e-4);
    EXPECT_NEAR(shown.constraints[1].value, plane.cylindrical.least, 1e-4);
    EXPECT_NEAR(shown.constraints[2].value, plane.modelling.mean, 1e-6);
    EXPECT_NEAR(shown.constraints[3].value, plane.modelling.least, 1e-6);
    EXPECT_NEAR(shown.constraints[4].value, plane.verticals[0].light.mean, 1e-4);
    EXPECT_NEAR(shown.constraints[5].value, plane.verticals[1].light.least, 1e-4);
  }
}

TEST(PlaneValues, ASittingMakesWhatIsAskedAndKeepsIt) {
  Session session;
  session.adopt(room(0.5f, true));
  const std::uint32_t plane = planeOf(*session.scene());
  ASSERT_TRUE(session.setIntentions(faces(plane)));
  ASSERT_TRUE(session.start(1, nullptr));
  EXPECT_EQ(session.advance(200).evaluations, 200u);
  EXPECT_EQ(session.incumbent()->constraints.size(), 6u);
  Intentions turned = faces(plane);
  turned.constraints[4].direction = kZ;
  EXPECT_FALSE(session.startAside(turned, 1, nullptr, 10));
  ASSERT_TRUE(session.setIntentions(turned));
  EXPECT_EQ(session.scene()->planes[0].verticals.size(), 3u);
}

TEST(PlaneValues, FaultsAreNamedWithTheirCure) {
  Session session;
  session.adopt(room(0.5f, true));
  const std::uint32_t plane = planeOf(*session.scene());
  const auto refusal = [&](std::size_t c, const auto& change) {
    Intentions asked = faces(plane);
    change(asked.constraints[c]);
    const Result<Done> set = session.setIntentions(asked);
    return set ? std::string() : set.error().message;
  };
  using ::testing::HasSubstr;
  EXPECT_THAT(refusal(0, [](Constraint& c) { c.surfaces = {0}; }),
              HasSubstr("\"floor\" is no measuring plane"));
  EXPECT_THAT(refusal(0, [](Constraint& c) { c.surfaces = {}; }), HasSubstr("measuring planes only"));
  EXPECT_THAT(refusal(4, [](Constraint& c) { c.direction = {}; }), HasSubstr("Give \"direction\""));
  EXPECT_THAT(refusal(4, [](Constraint& c) { c.direction = kY; }), HasSubstr("level \"direction\""));
  EXPECT_THAT(refusal(2, [](Constraint& c) { c.quantity = Quantity::kDirect; }), HasSubstr("of no quantity"));

  Scene dark = room(0.5f, true);
  std::fill(dark.responses.illuminance.begin(), dark.responses.illuminance.end(), 0.0f);
  session.adopt(std::move(dark));
  EXPECT_THAT(refusal(2, [](Constraint&) {}), HasSubstr("no light reaches \"plane\""));
  Scene older = room(0.5f, true);
  older.lightOperator.reset();
  session.adopt(std::move(older));
  EXPECT_THAT(refusal(0, [](Constraint&) {}), HasSubstr("without --no-exchange"));
}

}  // namespace
}  // namespace fiatlux
