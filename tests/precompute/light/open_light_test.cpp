#include "precompute/light/open_light.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/transport/polygon_form_factor.h"

namespace fiatlux {
namespace {

const Luminaire kPanel = [] {
  Luminaire panel;
  panel.position = {0.4, -0.3, 2.6};
  panel.normal = {0, 0, -1};
  panel.axis = {1, 0, 0};
  panel.width = 0.6, panel.height = 0.3;
  panel.flux = 3000;
  return panel;
}();
const Vec3 kUp{0, 0, 1};

TEST(OpenLight, GaussPointsAreTheWholeAreaFromFarAway) {
  const Emission source(kPanel);
  for (const double x : {-3.0, 0.0, 2.0, 5.0}) {
    const double exact = openLight(source, {x, 1, 0}, kUp);
    EXPECT_GT(exact, 0);
    EXPECT_NEAR(openLightFar(source, {x, 1, 0}, kUp) / exact, 1, 1e-4) << x;
  }
}

TEST(OpenLight, PartsMakeUpTheWholeNearAndFar) {
  const Emission source(kPanel);
  const Float8 u{0.125f, 0.375f, 0.625f, 0.875f, 0.125f, 0.375f, 0.625f, 0.875f};
  for (const double z : {2.5, 2.2, 1.0, 0.0}) {
    const PatchPoint receiver{{0.5, 0.1, z}, kUp, 1};
    double parts = 0;
    for (const float v : {0.125f, 0.375f, 0.625f, 0.875f})
      parts += 0.5 * laneSum(lightOfParts(source, receiver, u, all8(v), 0.25, 8));
    const double whole = polygonFormFactor(receiver.position, receiver.normal, source.corners().data(), 4);
    EXPECT_NEAR(parts / whole, 1, 3e-3) << z;  // as middles three edges away are off
  }
}

TEST(OpenLight, PartsThatAreNotWantedGiveNothing) {
  const Emission source(kPanel);
  const PatchPoint receiver{{0.5, 0.1, 0}, kUp, 1};
  const Float8 light = lightOfParts(source, receiver, all8(0.25f), all8(0.75f), 0.5, 3);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(light[i] > 0, i < 3) << i;
}

}  // namespace
}  // namespace fiatlux
