// Unions of surfaces against explicit statistics of their patches.
#include "core/scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fiatlux {
namespace {

/// Two surfaces of two patches each, areas 1, 3 | 2, 2, one site with given light.
Scene twoSurfaces() {
  Scene scene;
  scene.patches.count = 4;
  scene.patches.area = {1, 3, 2, 2};
  scene.patches.surface = {0, 0, 1, 1};
  scene.surfaces = {{"floor", 4, 0.5, 2, false, 0}, {"wall", 4, 0.5, 2, false, 0}};
  scene.sites.resize(1);
  scene.responses = {4, 1, {2, 6, 1, 3}};
  scene.illuminance = {{{5}, {3}}, {{2}, {1}}};
  return scene;
}

TEST(Scene, SigmaIsTheAreaWeightedPopulationStatistic) {
  const Scene scene = twoSurfaces();
  const ExplicitStatistics floor = explicitStatistics(scene, illuminanceOf(scene, {{0}, {1}, 1}), {0});
  EXPECT_DOUBLE_EQ(floor.mean, 5);
  EXPECT_NEAR(floor.sigma, 1.7320508075688772, 1e-12);
  EXPECT_EQ(floor.minimum, 2);
  EXPECT_EQ(floor.maximum, 6);
}

TEST(Scene, UnionOfLeavesEqualsExplicitStatisticsOfAllPatches) {
  const Scene scene = twoSurfaces();
  const SurfaceStatistics all = unionStatistics(scene, Quantity::kIlluminance, {});
  const ExplicitStatistics truth = explicitStatistics(scene, illuminanceOf(scene, {{0}, {1}, 1}), {});
  EXPECT_NEAR(all.mean[0], truth.mean, 1e-12);
  EXPECT_NEAR(std::sqrt(all.covariance[0]), truth.sigma, 1e-12);
}

}  // namespace
}  // namespace fiatlux
