// Direct light of any photometry by rays: against Lambert's polygon where both know the answer, and by its
// flux.
#include "precompute/light/photometric_shadow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "precompute/light/direct_light.h"
#include "precompute/validation/rectangle_room.h"

namespace fiatlux {
namespace {

/// 4 x 2.5 x 5 m with a block on the floor.
Room blockRoom() {
  auto faces = boxSurfaces({0, 0, 0}, {4, 2.5, 5}, 0.5, 0.25);
  const auto block = blockSurfaces("block", {1, 0, 1.5}, {1, 1, 1}, 0.6, 0.25);
  faces.insert(faces.end(), block.begin(), block.end());
  return rectangleRoom(faces);
}

Luminaire squareAt(const Vec3& position, double size, double flux) {
  Luminaire luminaire;
  luminaire.position = position;
  luminaire.width = luminaire.height = size;
  luminaire.flux = flux;
  return luminaire;
}

/// The same luminaire with a table of its intensities instead.
Luminaire withTable(Luminaire luminaire, Intensity intensity, double beam) {
  luminaire.distribution = Luminaire::Distribution::kPhotometric;
  luminaire.intensity = std::move(intensity);
  luminaire.beam = beam;
  return luminaire;
}

double absorbed(const Room& room, const std::vector<float>& light) {
  double sum = 0;
  for (std::uint32_t p = 0; p < room.patches.count; ++p) sum += room.patches.area[p] * light[p];
  return sum;
}

TEST(PhotometricShadow, ALambertianTableIsALambertianSquare) {
  const Room room = blockRoom();
  const Result<RayTracer> built = RayTracer::build(room);
  ASSERT_TRUE(built) << built.error().message;
  const RayTracer& tracer = *built;
  const Luminaire square = squareAt({2, 2.5, 2.5}, 0.5, 1000);
  const auto lambert = [](const Vec3& d) { return 1000 / std::numbers::pi * std::max(0.0, d.z); };
  DirectLightOptions options;
  options.split = 4;
  const auto exact = directLight(room, tracer, {square}, options);
  const auto table = directLight(room, tracer, {withTable(square, lambert, 2)}, options);
  double difference = 0, all = 0;
  for (std::uint32_t p = 0; p < room.patches.rows(); ++p) {
    difference += room.patches.area[p] * std::abs(exact[p] - table[p]);
    all += room.patches.area[p] * exact[p];
  }
  EXPECT_LT(difference / all, 0.01);
  EXPECT_NEAR(absorbed(room, table), 1000, 10);
}

TEST(PhotometricShadow, ANarrowBeamLosesNoFlux) {
  const Room room = blockRoom();
  const Result<RayTracer> built = RayTracer::build(room);
  ASSERT_TRUE(built) << built.error().message;
  const RayTracer& tracer = *built;
  // cos^126 from the ceiling straight down beside the block: 2 pi / 127 lm for each cd.
  const auto spot = [](const Vec3& d) { return d.z > 0 ? 1000 * std::pow(d.z, 126) : 0.0; };
  const Luminaire luminaire = withTable(squareAt({2.9, 2.5, 2.6}, 0.1, 0), spot, 0.21);
  const auto light = directLight(room, tracer, {luminaire}, {});
  EXPECT_NEAR(absorbed(room, light) / (1000 * 2 * std::numbers::pi / 127), 1, 0.02);
}

TEST(PhotometricShadow, AShadowsEdgeAlongThePatchesLosesNoFluxEither) {
  const Room room = blockRoom();
  const Result<RayTracer> built = RayTracer::build(room);
  ASSERT_TRUE(built) << built.error().message;
  const auto spot = [](const Vec3& d) { return d.z > 0 ? 1000 * std::pow(d.z, 126) : 0.0; };
  std::vector<Luminaire> luminaires;
  for (const double x : {1.7, 1.8, 1.9, 2.0, 2.1})  // around the block's edge above the floor
    luminaires.push_back(withTable(squareAt({x, 2.5, 2.02}, 0.1, 0), spot, 0.21));
  DirectLightOptions options;
  options.split = 4;
  const auto light = directLight(room, *built, luminaires, options);
  const std::uint32_t rows = room.patches.rows();
  for (std::size_t j = 0; j < luminaires.size(); ++j) {
    const std::vector<float> column(light.begin() + static_cast<std::ptrdiff_t>(j * rows),
                                    light.begin() + static_cast<std::ptrdiff_t>((j + 1) * rows));
    EXPECT_NEAR(absorbed(room, column) / (1000 * 2 * std::numbers::pi / 127), 1, 0.003) << j;
  }
}

TEST(PhotometricShadow, LightGoesUpToo) {
  const Room room = blockRoom();
  const Result<RayTracer> built = RayTracer::build(room);
  ASSERT_TRUE(built) << built.error().message;
  const RayTracer& tracer = *built;
  const auto upwards = [](const Vec3& d) { return 100 * std::max(0.0, -d.z); };
  const auto light = directLight(room, tracer, {withTable(squareAt({2, 1.5, 2.5}, 0.3, 0), upwards, 2)}, {});
  EXPECT_NEAR(absorbed(room, light), 100 * std::numbers::pi, 5);
  for (std::uint32_t p = 0; p < room.patches.count; ++p)
    if (room.patches.center[p].y < 1.5) {
      EXPECT_EQ(light[p], 0) << p;
    }
}

TEST(PhotometricShadow, APointReadsTheInverseSquare) {
  const Room room = blockRoom();
  const Result<RayTracer> built = RayTracer::build(room);
  ASSERT_TRUE(built) << built.error().message;
  const RayTracer& tracer = *built;
  const auto even = [](const Vec3&) { return 500.0; };
  const Luminaire lamp = withTable(squareAt({3, 2, 4}, 0, 0), even, 2);
  const PatchPoint below{{3, 0.5, 4}, {0, 1, 0}, 1}, behind{{1.5, 0.3, 1.0}, {0, 0, 1}, 1};
  EXPECT_NEAR(photometricPointLight(tracer, below, lamp, 4, 1), 500 / (1.5 * 1.5), 1e-6);
  EXPECT_EQ(photometricPointLight(tracer, behind, lamp, 4, 1), 0);  // the block stands between
}

}  // namespace
}  // namespace fiatlux
