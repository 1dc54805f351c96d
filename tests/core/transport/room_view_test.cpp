// What observers see in a box of patches (room_view, tile_tree, core/scene/observer): backgrounds that are
// known, glare summed by hand, and what hides it.
#include "core/transport/room_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/core/synthetic_scene.h"

namespace fiatlux {
namespace {

constexpr double kEdge = 0.25;

/// 4 x 3 x 4 m, its faces inwards; where asked a screen across it at x = 2, 2 m high; two sites on the
/// ceiling.
Scene box(bool withScreen) {
  Scene scene;
  const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  addGrid(scene, "floor", {0, 0, 0}, z, x, 16, 16, kEdge, 0.2f, false);
  addGrid(scene, "ceiling", {0, 3, 0}, x, z, 16, 16, kEdge, 0.8f, false);
  addGrid(scene, "west", {0, 0, 0}, y, z, 12, 16, kEdge, 0.5f, false);
  addGrid(scene, "east", {4, 0, 0}, z, y, 16, 12, kEdge, 0.5f, false);
  addGrid(scene, "north", {0, 0, 0}, x, y, 16, 12, kEdge, 0.5f, false);
  addGrid(scene, "south", {0, 0, 4}, y, x, 12, 16, kEdge, 0.5f, false);
  std::vector<Charts::Frame> frames{{z, x, kEdge, kEdge}, {x, z, kEdge, kEdge}, {y, z, kEdge, kEdge},
                                    {z, y, kEdge, kEdge}, {x, y, kEdge, kEdge}, {y, x, kEdge, kEdge}};
  if (withScreen) {
    addGrid(scene, "screen", {2, 0, 0}, z, y, 16, 8, kEdge, 0.5f, false);
    frames.push_back({z, y, kEdge, kEdge});
  }
  scene.sites = {{{1.1, 3, 2}, {0, -1, 0}, x, 0.6}, {{3.5, 3, 2.3}, {0, -1, 0}, x, 0.6}};
  scene.lightOperator.emplace();
  scene.lightOperator->charts = {frames, scene.patches.surface};
  scene.responses = {scene.patches.rows(), 2, {}};
  for (std::uint32_t j = 0; j < 2; ++j)
    for (std::uint32_t p = 0; p < scene.patches.rows(); ++p)
      scene.responses.illuminance.push_back(static_cast<float>(0.02 * (1 + p % 7) + 0.01 * j));
  return scene;
}

const Observer kFromWest{"west", {0.4, 1.2, 2}, {1, 0, 0}};

/// Guth's position index by its formula, of a source at `way` from an eye that looks along +x.
double guth(const Vec3& way) {
  const double degree = std::numbers::pi / 180;
  const double alpha = std::atan2(std::abs(way.z), way.y) / degree,
               beta = std::acos(way.x / length(way)) / degree;
  return std::exp((35.2 - 0.31889 * alpha - 1.22 * std::exp(-2 * alpha / 9)) * 1e-3 * beta +
                  (21 + 0.26667 * alpha - 0.002963 * alpha * alpha) * 1e-5 * beta * beta);
}

TEST(RoomView, InAnEvenFurnaceTheBackgroundIsItsLuminance) {
  Scene scene = box(false);
  for (float& rho : scene.patches.reflectance) rho = 0.5f;
  const std::vector<float> light(scene.patches.rows(), 200);
  const Vec3 slanted = normalized({1, 0.3, -2});
  for (const Observer& observer : {kFromWest, Observer{"", {2.2, 1.7, 1}, slanted}}) {
    const auto readings = RoomView(scene).readings({observer}, {}, 1, light);
    EXPECT_NEAR(readings[0].background, 100 / std::numbers::pi, 0.02);
    EXPECT_NEAR(readings[0].vertical, 100, 0.1);
    EXPECT_NEAR(readings[0].cylindrical, 100, 0.1);
    EXPECT_EQ(readings[0].glare, 0);
  }
}

/// Of patches that are no whole cells the tiles leave slits; nobody sees through them.
TEST(RoomView, SlitsBetweenTilesDarkenNothing) {
  Scene scene = box(true);
  for (float& rho : scene.patches.reflectance) rho = 0.5f;
  for (double& area : scene.patches.area) area *= 0.9;
  const std::vector<float> light(scene.patches.rows(), 200);
  const auto reading = RoomView(scene).readings({kFromWest}, {}, 1, light)[0];
  EXPECT_NEAR(reading.background, 100 / std::numbers::pi, 0.003 * 100 / std::numbers::pi);
}

/// lx that a lit patch reflects on the plane before an eye, in finer parts.
double reflectedBy(const Scene& scene, std::uint32_t p, double lux, const Observer& observer) {
  const Charts::Frame& frame = scene.lightOperator->charts.frames[scene.patches.surface[p]];
  double sum = 0;
  for (int part = 0; part < 64; ++part) {
    const double u = (part % 8 - 3.5) / 8 * kEdge, v = (part / 8 - 3.5) / 8 * kEdge;
    const Vec3 way = scene.patches.center[p] + u * frame.uAxis + v * frame.vAxis - observer.position;
    const double squared = dot(way, way), facing = -dot(way, scene.patches.normal[p]);
    sum += std::max(0.0, dot(way, observer.direction)) * facing / (squared * squared) * kEdge * kEdge / 64;
  }
  return scene.patches.reflectance[p] * lux / std::numbers::pi * sum;
}

/// Most of a background may come from a small bright part of the room, and UGR moves by 0.1 where it is 3 %
/// off.
TEST(RoomView, ASmallBrightPartOfTheRoomCountsInTheBackground) {
  constexpr std::uint32_t kPart = 12;  // patches
  const Scene scene = box(false);
  double squares = 0;
  int parts = 0;
  for (std::uint32_t first = 0; first + kPart <= scene.patches.rows(); first += kPart) {
    std::vector<float> light(scene.patches.rows(), 0);
    double vertical = 0;
    for (std::uint32_t p = first; p < first + kPart; ++p) {
      light[p] = 1000;
      vertical += reflectedBy(scene, p, 1000, kFromWest);
    }
    if (vertical < 1) continue;
    const double off = RoomView(scene).readings({kFromWest}, {}, 1, light)[0].vertical / vertical - 1;
    squares += off * off;
    ++parts;
  }
  ASSERT_GT(parts, 20);
  EXPECT_LT(std::sqrt(squares / parts), 0.06);
}

TEST(RoomView, UgrIsThatOfASumByHand) {
  const Scene scene = box(false);
  const Layout layout{{0, 1}, {3000, 1800}, 0.8};
  const std::vector<float> light = illuminanceOf(scene, layout);
  double indirect = 0, sum = 0;
  for (std::uint32_t p = 0; p < scene.patches.rows(); ++p)
    indirect += reflectedBy(scene, p, light[p], kFromWest);
  for (std::size_t i = 0; i < 2; ++i) {
    const Vec3 way = scene.sites[i].position - kFromWest.position;
    if (way.y > 1.9 * way.x) continue;
    const double d = length(way), cosine = way.y / d, area = 0.36 * cosine;
    const double luminance = 0.8 * layout.flux[i] / std::numbers::pi * cosine / area;
    sum += luminance * luminance * area / (d * d) / (guth(way) * guth(way));
  }
  ASSERT_GT(sum, 0);
  const double ugr = 8 * std::log10(0.25 * sum / (indirect / std::numbers::pi));

  std::vector<Luminaire> luminaires;
  for (std::size_t i = 0; i < 2; ++i) {
    luminaires.push_back(luminaireOf(scene.sites[i]));
    luminaires.back().flux = layout.flux[i];
  }
  const auto reading = RoomView(scene).readings({kFromWest}, luminaires, layout.dimming, light)[0];
  EXPECT_NEAR(reading.background, indirect / std::numbers::pi, 0.01 * reading.background);
  EXPECT_NEAR(ugrOf(glareRatio(reading)), ugr, 0.05);

  Scene observed = scene;
  ASSERT_TRUE(observe(observed, {kFromWest}));
  const auto byRows = readObservers(observed.observers, layout)[0];
  EXPECT_NEAR(byRows.glare, reading.glare, 1e-9 * reading.glare);
  EXPECT_NEAR(byRows.background, reading.background, 1e-5 * reading.background);
  EXPECT_NEAR(byRows.vertical, reading.vertical, 1e-5 * reading.vertical);
  EXPECT_NEAR(byRows.cylindrical, reading.cylindrical, 1e-5 * reading.cylindrical);
}

TEST(RoomView, AScreenHidesWhatStandsBehindIt) {
  const Scene scene = box(true);
  const Luminaire behind = luminaireOf(scene.sites[1]);
  const auto glare = [&](const Scene& room, double height) {
    const Observer observer{"", {1, height, 2.3}, {1, 0, 0}};
    return RoomView(room).readings({observer}, {behind}, 1, room.responses.illuminance)[0].glare;
  };
  EXPECT_EQ(glare(scene, 0.6), 0);
  EXPECT_GT(glare(box(false), 0.6), 0);
  EXPECT_NEAR(glare(scene, 1.7), glare(box(false), 1.7), 1e-12);
}

/// A share of the square that is seen, not of a few points of it.
TEST(RoomView, WhatIsSeenInPartGlaresByThatPart) {
  const Scene scene = box(true);
  const Luminaire behind = luminaireOf(scene.sites[1]);
  const Observer observer{"", {1, 1.3, 2.3}, {1, 0, 0}};
  const auto glareIn = [&](const Scene& room) {
    return RoomView(room).readings({observer}, {behind}, 1, room.responses.illuminance)[0].glare;
  };
  // Past the screen's edge, 1 m away and 0.7 m above the eye, one sees the ceiling up to here.
  const double upTo = 1 + 1.7 / 0.7;
  EXPECT_NEAR(glareIn(scene) / glareIn(box(false)), (upTo - 3.2) / 0.6, 0.02);
}

TEST(RoomView, ARoomHasPlacesOnItsFloorOrItsWorkingPlane) {
  Scene scene = box(false);
  const std::vector<Observer> onFloor = observersInRoom(scene.patches);
  ASSERT_EQ(onFloor.size(), 4 * 9u);
  for (const Observer& observer : onFloor) EXPECT_NEAR(observer.position.y, kEyeHeight, 1e-9);
  addGrid(scene, "plane", {1, 0.75, 1}, {0, 0, 1}, {1, 0, 0}, 4, 4, kEdge, 0, true);
  const std::vector<Observer> atPlane = observersInRoom(scene.patches);
  ASSERT_EQ(atPlane.size(), 4u);
  EXPECT_NEAR(atPlane[0].position.y, kEyeHeight, 1e-9);
  EXPECT_EQ(atPlane[0].name, "P1 +x");
}

TEST(RoomView, FaultsAreNamedWithTheirCure) {
  Scene scene = box(false);
  Luminaire point = luminaireOf(scene.sites[0]);
  point.width = point.height = 0;
  const Result<Done> checked = checkLuminousAreas({luminaireOf(scene.sites[0]), point});
  ASSERT_FALSE(checked);
  EXPECT_THAT(checked.error().message, ::testing::HasSubstr("luminaires[1]"));
  scene.lightOperator.reset();
  const Result<Done> observed = observe(scene, {kFromWest});
  ASSERT_FALSE(observed);
  EXPECT_THAT(observed.error().message, ::testing::HasSubstr("fiatlux precompute"));
}

}  // namespace
}  // namespace fiatlux
