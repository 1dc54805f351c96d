// The light operator of a small room against the radiosity solution that it stands for (exchange_groups,
// surface_exchange and operator_errors too).
#include "precompute/light/exchange.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "core/transport/exchange.h"
#include "core/transport/low_rank_radiosity.h"
#include "core/transport/patch_tiles.h"
#include "core/transport/photometric_light.h"
#include "core/transport/repaint.h"
#include "core/transport/site_responses.h"
#include "precompute/light/exchange_groups.h"
#include "precompute/light/operator_errors.h"
#include "precompute/light/transport.h"
#include "precompute/pipeline/scene_build.h"
#include "tests/precompute/furnished_box.h"
#include "tests/precompute/transport_of.h"

namespace fiatlux {
namespace {

/// 4 x 2.5 x 5 m with a free-standing wall that reaches neither side nor ceiling, and a measuring plane.
Room dividedRoom() {
  return testing::furnishedBox({4, 2.5, 5}, blockSurfaces("wall", {1, 0, 2.4}, {2, 1.6, 0.1}, 0.6, 0.125),
                               0.125);
}

TransportOptions quick(bool exchange) {
  TransportOptions options;
  options.rays = 512;
  options.exchange = exchange;
  return options;
}

class DividedRoom : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    room = new Room(dividedRoom());
    transport = new Transport(testing::transportOf(*room, quick(true)).value());
  }
  static void TearDownTestSuite() {
    delete transport;
    delete room;
  }
  static Room* room;
  static Transport* transport;
};
Room* DividedRoom::room = nullptr;
Transport* DividedRoom::transport = nullptr;

TEST_F(DividedRoom, ResponsesAreTheSameBitsWithAndWithoutExchange) {
  const auto without = testing::transportOf(*room, quick(false));
  ASSERT_TRUE(without);
  EXPECT_FALSE(without->lightOperator);
  EXPECT_EQ(without->responses.illuminance, transport->responses.illuminance);
  EXPECT_EQ(without->direct, transport->direct);
}

TEST_F(DividedRoom, GroupsDoNotReachAcrossTheWall) {
  const ExchangeGroups& groups = transport->lightOperator->groups;
  const Patches& patches = room->patches;
  std::uint32_t barriers = 0;
  std::vector<std::vector<std::uint32_t>> members(groups.total);
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    barriers += groups.barriers[p] != 0;
    members[groups.ofRow[p]].push_back(p);
  }
  EXPECT_GT(barriers, 4u);
  for (const auto& group : members)
    for (const std::uint32_t p : group) {
      EXPECT_GT(dot(patches.normal[p], patches.normal[group[0]]), 0.99);
      const Vec3 &a = patches.center[p], &b = patches.center[group[0]];
      const bool onFloor = patches.normal[p].y > 0.9 && a.y < 0.01;
      const bool beside = onFloor && a.x > 1.3 && a.x < 2.7 && b.x > 1.3 && b.x < 2.7;
      if (beside) {
        EXPECT_EQ(a.z < 2.45, b.z < 2.45) << "group of the floor around " << a.x << " " << a.z;
      }
    }
}

TEST_F(DividedRoom, ExchangeIsReciprocal) {
  const auto& [visibility, charts, groups, exchange, surfaces] = *transport->lightOperator;
  for (std::uint32_t c = 0; c < groups.count; ++c)
    for (std::uint32_t d = 0; d < c; ++d)
      ASSERT_EQ(exchange.means[std::size_t{c} * groups.count + d],
                exchange.means[std::size_t{d} * groups.count + c]);
}

TEST_F(DividedRoom, ReflectedLightIsAbsorbedOnce) {
  // Of phi lumens that leave the patches, all are absorbed in the end: sum of A (1 - rho) S phi = sum of phi.
  const Patches& patches = room->patches;
  const ExchangeOperator exchange(patches, transport->lightOperator->groups,
                                  transport->lightOperator->exchange);
  const std::uint32_t rows = patches.rows();
  for (const std::uint32_t site : {0u, 5u}) {
    const std::vector<float> direct(transport->direct.begin() + std::size_t{site} * rows,
                                    transport->direct.begin() + std::size_t{site + 1} * rows);
    const std::vector<float> light = exchange.indirect(direct, 1);
    double left = 0, absorbed = 0;
    for (std::uint32_t p = 0; p < patches.count; ++p) {
      left += patches.area[p] * patches.reflectance[p] * direct[p];
      absorbed += patches.area[p] * (1 - patches.reflectance[p]) * light[p];
    }
    EXPECT_NEAR(absorbed / left, 1, 0.01);
  }
}

TEST_F(DividedRoom, VisibilityIsDirectLightOverUnshadowedLight) {
  const SiteVisibility& visibility = transport->lightOperator->visibility;
  const std::uint32_t rows = room->patches.rows();
  ASSERT_EQ(visibility.steps.size(), transport->direct.size());
  std::uint32_t partly = 0;
  double onMount = 0, beside = 0;
  for (std::size_t i = 0; i < visibility.steps.size(); ++i) {
    const bool isMount = room->patches.surface[i % rows] == 1;
    if (visibility.steps[i] > 0 && !isMount) {
      EXPECT_GT(transport->direct[i], 0);
    }
    // What is beside a luminaire on its mount is lit where it is tilted.
    if (isMount) onMount += 1, beside += SiteVisibility::shareOf(visibility.steps[i]);
    partly += visibility.steps[i] > 0 && visibility.steps[i] < SiteVisibility::kSteps;
  }
  EXPECT_GT(beside / onMount, 0.95);
  EXPECT_GT(partly, 10u);
  EXPECT_LT(partly, rows * room->sites.size() / 4);
}

TEST_F(DividedRoom, OtherPhotometriesComeOutAsTheWholeSolution) {
  Transport copy = *transport;
  const Scene scene = sceneOf(*room, std::move(copy), "0123456789abcdef");
  ASSERT_TRUE(scene.lightOperator);
  const auto errors = measureOperator(scene, transport->factors);
  ASSERT_TRUE(errors);
  ASSERT_EQ(errors->size(), 2u);
  for (const OperatorError& error : *errors) {
    EXPECT_GT(error.meanWorst, 0) << error.photometry;
    EXPECT_LT(error.meanMedian, 0.003) << error.photometry;
    EXPECT_LT(error.meanWorst, 0.02) << error.photometry;
    EXPECT_LT(error.sigmaMedian, 0.02) << error.photometry;
  }
}

TEST_F(DividedRoom, MeansOverSurfacesAreThoseOfTheWholeSolution) {
  // Of a site's light, and of what falls on single patches, where the exchange knows only groups.
  const Patches& patches = room->patches;
  const SurfaceExchange& exchange = transport->lightOperator->surfaces;
  ASSERT_EQ(exchange.surfaces, room->surfaces.size());
  const auto lowRank = LowRankRadiosity::factorize(transport->factors, patches);
  ASSERT_TRUE(lowRank);
  constexpr std::uint32_t kWidth = 8;
  ResponseBlock block;
  block.width = kWidth;
  block.direct.assign(std::size_t{patches.rows()} * kWidth, 0.0f);
  for (std::uint32_t p = 0; p < patches.rows(); ++p)
    block.direct[std::size_t{p} * kWidth] = transport->direct[p];
  for (std::uint32_t j = 1; j < kWidth; ++j)
    block.direct[std::size_t{j * patches.count / kWidth} * kWidth + j] = 100;
  const std::vector<float> direct = block.direct;
  solveResponses(transport->factors, patches, *lowRank, 20, 1e-6, block);
  std::uint32_t compared = 0;
  for (std::uint32_t j = 0; j < kWidth; ++j) {
    std::vector<double> known(exchange.surfaces), whole(exchange.surfaces), area(exchange.surfaces);
    double room = 0, of = 0;
    for (std::uint32_t p = 0; p < patches.rows(); ++p) {
      const std::uint32_t s = patches.surface[p];
      const double reflected =
          block.irradiance[std::size_t{p} * kWidth + j] - direct[std::size_t{p} * kWidth + j];
      if (patches.counts(p)) area[s] += patches.area[p], whole[s] += patches.area[p] * reflected;
      room += patches.area[p] * reflected, of += patches.area[p];
      for (std::uint32_t to = 0; to < exchange.surfaces && p < patches.count; ++to)
        known[to] += patches.area[p] * patches.reflectance[p] * direct[std::size_t{p} * kWidth + j] *
                     exchange.means[std::size_t{p} * exchange.surfaces + to];
    }
    for (std::uint32_t s = 0; s < exchange.surfaces; ++s) {
      if (whole[s] / area[s] < 0.05 * room / of) continue;
      // Half a step of a small surface's logarithm; of many patches' light, far less.
      EXPECT_NEAR(known[s] * area[s] / whole[s], 1, j == 0 ? 0.005 : 0.065) << s << ", column " << j;
      ++compared;
    }
  }
  EXPECT_GT(compared, 40u);
}

TEST(Charts, KnowWhichWayPartsOfCellsAreLonger) {
  Room room = rectangleRoom(boxSurfaces({0, 0, 0}, {2, 2, 2}, 0.5, 0.25));
  for (const std::int8_t aspect : chartsOf(room).aspect) EXPECT_EQ(aspect, 0);
  // Of one cell a strip is left, 0.3 as wide: all its triangles nearer to a line along u.
  constexpr std::uint32_t kCut = 5;
  const Chart& chart = room.charts[room.chartOfPatch[kCut]];
  const Vec3 from = room.fragmentsOf(kCut)[0].corner[0];
  for (std::uint32_t i = room.fragmentOffset[kCut]; i < room.fragmentOffset[kCut + 1]; ++i)
    for (Vec3& corner : room.fragments[i].corner)
      corner = corner - 0.7 * dot(corner - from, chart.vAxis) * chart.vAxis;
  room.patches.area[kCut] *= 0.3;
  const PatchTile tile = patchTiles(room.patches, chartsOf(room))[kCut];
  EXPECT_NEAR(tile.lengthU, 0.25, 0.25 * 0.02);
  EXPECT_NEAR(tile.lengthV, 0.075, 0.075 * 0.02);
}

TEST_F(DividedRoom, RepaintedWallsShineAsTheRoomMadeSo) {
  Transport copy = *transport;
  const Scene scene = sceneOf(*room, std::move(copy), "0123456789abcdef");
  const std::uint32_t rows = scene.patches.rows();
  const std::vector<float> before(scene.responses.column(0), scene.responses.column(0) + rows);
  const std::vector<SurfacePaint> paint = {{2, 0.8}, {3, 0.2}, {4, 0.8}};
  const ExchangeOperator exchange(scene.patches, scene.lightOperator->groups, scene.lightOperator->exchange);
  const std::vector<float> painted =
      Repaint(scene, exchange, paintedReflectance(scene, paint)).light(before, 1);

  // The same light in a room whose material is that.
  Patches made = room->patches;
  for (const auto& [surface, reflectance] : paint)
    for (std::uint32_t p = 0; p < made.count; ++p)
      if (made.surface[p] == surface) made.reflectance[p] = static_cast<float>(reflectance);
  const auto lowRank = LowRankRadiosity::factorize(transport->factors, made);
  ASSERT_TRUE(lowRank);
  ResponseBlock block;
  block.width = 1;
  block.direct.assign(transport->direct.begin(), transport->direct.begin() + rows);
  solveResponses(transport->factors, made, *lowRank, 3, 0, block);

  double largestChange = 0, worst = 0;
  const double least = 0.05 * explicitStatistics(scene, block.irradiance, {}).mean;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    const double truth = explicitStatistics(scene, block.irradiance, {s}).mean;
    if (truth < least) continue;
    const double was = explicitStatistics(scene, before, {s}).mean;
    largestChange = std::max(largestChange, std::abs(was / truth - 1));
    worst = std::max(worst, std::abs(explicitStatistics(scene, painted, {s}).mean / truth - 1));
  }
  EXPECT_GT(largestChange, 0.05);
  EXPECT_LT(worst, 0.016);
}

TEST(ExchangeGroups, SmallThingsStayTogetherWhereOneOfThemIsCrossed) {
  // Twelve leaves of 2 x 2 patches, one of them cut in two by a fin: near each other, and of one surface.
  auto faces = boxSurfaces({0, 0, 0}, {2, 2, 2}, 0.5, 0.25);
  const auto firstLeaf = static_cast<std::uint32_t>(faces.size());
  constexpr std::uint32_t kLeaves = 12;
  for (std::uint32_t i = 0; i < kLeaves; ++i)
    faces.push_back({"leaf " + std::to_string(i),
                     {0.8 + 0.05 * (i % 4), 0.4 + 0.05 * (i / 4), 0.9},
                     {0, 0, 0.1},
                     {0.1, 0, 0},
                     0.4,
                     2,
                     2});
  const auto fin = blockSurfaces("fin", {0.845, 0.35, 0.85}, {0.01, 0.3, 0.2}, 0.5, 0.2);
  faces.insert(faces.end(), fin.begin(), fin.end());
  Room room = rectangleRoom(faces);
  const auto isLeaf = [&](std::uint32_t p) {
    const std::uint32_t surface = room.patches.surface[p];
    return surface >= firstLeaf && surface < firstLeaf + kLeaves;
  };
  std::vector<std::uint32_t> leaves;
  for (std::uint32_t p = 0; p < room.patches.rows(); ++p)
    if (isLeaf(p)) leaves.push_back(p);
  for (const std::uint32_t p : leaves) room.patches.surface[p] = firstLeaf;

  const Result<RayTracer> tracer = RayTracer::build(room);
  ASSERT_TRUE(tracer);
  const ExchangeGroups groups = exchangeGroups(room, *tracer);
  std::set<std::uint32_t> used;
  std::uint32_t barriers = 0;
  for (const std::uint32_t p : leaves) {
    used.insert(groups.ofRow[p]);
    barriers += groups.barriers[p] != 0;
  }
  EXPECT_GT(barriers, 0u);
  EXPECT_EQ(leaves.size(), 4 * kLeaves);
  EXPECT_LE(used.size(), 2u);
}

TEST(Pendants, LightThatGoesUpReachesTheCeiling) {
  const auto faces = boxSurfaces({0, 0, 0}, {4, 2.5, 5}, 0.5, 0.25);
  Room room = rectangleRoom(faces);
  room.sites = siteGrid(faces[1], 2, 2, 0.3);
  for (Site& site : room.sites) site.position.y -= 0.6;
  TransportOptions options = quick(true);
  options.rays = 64;
  auto transport = testing::transportOf(room, options);
  ASSERT_TRUE(transport) << transport.error().message;
  const Scene scene = sceneOf(room, std::move(*transport), "0123456789abcdef");
  Luminaire luminaire = luminaireOf(scene.sites[1]);
  luminaire.distribution = Luminaire::Distribution::kPhotometric;
  luminaire.flux = 1000;
  luminaire.intensity = [](const Vec3& d) { return d.z < 0 ? -1000 / std::numbers::pi * d.z : 0.0; };
  const std::vector<float> direct = PhotometricLight(scene).direct({{1, luminaire}});
  double ceiling = 0, all = 0;
  for (std::uint32_t p = 0; p < room.patches.count; ++p) {
    all += room.patches.area[p] * direct[p];
    if (room.patches.surface[p] == 1) ceiling += room.patches.area[p] * direct[p];
  }
  EXPECT_NEAR(all, 1000, 15);
  EXPECT_GT(ceiling, 700);
}

}  // namespace
}  // namespace fiatlux
