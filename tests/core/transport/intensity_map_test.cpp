// Intensities by look-up against the intensities themselves.
#include "core/transport/intensity_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/random.h"

namespace fiatlux {
namespace {

Vec3 anyDirection(Random& random) {
  const double z = 2 * random.unit() - 1, angle = 2 * std::numbers::pi * random.unit();
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

TEST(IntensityMap, IsTheDistributionInEveryDirection) {
  // Light to both sides, uneven in all planes.
  const auto candela = [](const Vec3& d) { return 100 + 40 * d.x + 20 * d.y * d.x - 30 * d.z; };
  const IntensityMap map(candela);
  Random random(5);
  for (int i = 0; i < 2000; ++i) {
    const Vec3 d = anyDirection(random);
    EXPECT_NEAR(map.at(d), candela(d), 0.02);
  }
  for (const Vec3& axis : {Vec3{0, 0, 1}, Vec3{0, 0, -1}, Vec3{1, 0, 0}, Vec3{0, -1, 0}})
    EXPECT_NEAR(map.at(axis), candela(axis), 0.02);
}

TEST(IntensityMap, KeepsANarrowBeam) {
  // cos^126: half as bright at 6 degrees.
  const auto beam = [](const Vec3& d) { return d.z > 0 ? 1000 * std::pow(d.z, 126) : 0.0; };
  const IntensityMap map(beam);
  Random random(6);
  double worst = 0;
  for (int i = 0; i < 5000; ++i) {
    const double angle = 2 * std::numbers::pi * random.unit(), r = 0.3 * random.unit();
    const Vec3 d = normalized({r * std::cos(angle), r * std::sin(angle), 1});
    worst = std::max(worst, std::abs(map.at(d) - beam(d)));
  }
  EXPECT_LT(worst, 3);
}

TEST(IntensityMap, KnowsTheFluxBeforeAPlane) {
  const Vec3 down{0, 0, 1}, tilted = normalized({0.3, -0.4, 0.87});
  const auto beam = [](const Vec3& d) { return d.z > 0 ? 1000 * std::pow(d.z, 126) : 0.0; };
  for (const bool mirrored : {false, true})
    for (const Vec3& before : {down, tilted})
      EXPECT_NEAR(IntensityMap(beam, mirrored).flux(before) / (2000 * std::numbers::pi / 127), 1, 1e-3);
  // As bright to all sides; and twice as bright to one.
  const IntensityMap even([](const Vec3&) { return 10.0; });
  const IntensityMap uneven([](const Vec3& d) { return 10 + 10 * d.x; });
  for (const Vec3& before : {down, tilted, Vec3{1, 0, 0}, Vec3{0, -1, 0}}) {
    EXPECT_NEAR(even.flux(before) / (20 * std::numbers::pi), 1, 0.01);
    // The mean of d.x over half a sphere about `before` is half of before.x.
    EXPECT_NEAR(uneven.flux(before) / (20 * std::numbers::pi), 1 + 0.5 * before.x, 0.01);
  }
}

}  // namespace
}  // namespace fiatlux
