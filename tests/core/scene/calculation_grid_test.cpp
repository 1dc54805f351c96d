// The calculation grid of EN 12464-1: its rule by its own examples, its points on patches, and what is read
// off them.
#include "core/scene/calculation_grid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/synthetic_scene.h"

namespace fiatlux {
namespace {

/// A floor of `columns` x `rows` cells of 0.25 m whose left and upper neighbours are known.
Scene floorScene(std::uint32_t columns, std::uint32_t rows) {
  Scene scene;
  addGrid(scene, "floor", {1, 0, 2}, {0, 0, 1}, {1, 0, 0}, columns, rows, 0.25, 0.3f, false);
  return scene;
}

TEST(CalculationGrid, TheRuleIsThatOfTheStandard) {
  const GridRule rule = gridRule(5, 4);
  EXPECT_EQ(rule.rim, 0.5);
  EXPECT_NEAR(rule.spacing, 0.527, 5e-4);
  EXPECT_EQ(rule.columns, 8u);
  EXPECT_EQ(rule.rows, 6u);
  EXPECT_NEAR(gridRule(11, 11).spacing, 1, 1e-12);
  EXPECT_EQ(gridRule(11, 11).columns, 10u);
  EXPECT_NEAR(gridRule(7, 4).spacing, 0.2 * std::pow(5, std::log10(3)), 1e-12);  // twice as long as wide
  EXPECT_NEAR(gridRule(1.6, 0.8).rim, 0.12, 1e-12);                              // 15 % of a desk
  EXPECT_EQ(gridRule(1e5, 9e4).spacing, 10);
}

TEST(CalculationGrid, ABorderThatAPlaneLeavesOutIsNotLeftOutAgain) {
  // A room of 5 x 4 m, measured to its walls, half a metre off them, and a fifth of one off them.
  const GridRule whole = gridRule(5, 4), within = gridRule(4, 3, 0.5), between = gridRule(4.6, 3.6, 0.2);
  EXPECT_EQ(within.rim, 0);
  EXPECT_NEAR(between.rim, 0.3, 1e-12);
  for (const GridRule& rule : {within, between}) {
    EXPECT_NEAR(rule.spacing, whole.spacing, 1e-12);
    EXPECT_EQ(rule.columns, whole.columns);
    EXPECT_EQ(rule.rows, whole.rows);
  }
  // Two metres of a passage ask for 15 %, which is of the passage and not of what is measured in it.
  EXPECT_NEAR(gridRule(9.6, 1.6, 0.2).rim, 0.1, 1e-12);
  EXPECT_EQ(gridRule(9, 1, 0.5).rim, 0);  // more is left out already than need be
}

TEST(CalculationGrid, APlaneWithinABorderHasThePointsOfTheWholeOne) {
  // The cells between 0.5 m from the edges of a plane of 5 x 4 m, and that plane.
  Scene inner, outer;
  addGrid(outer, "plane", {1, 0.75, 2}, {0, 0, 1}, {1, 0, 0}, 16, 20, 0.25, 0, true);
  addGrid(inner, "plane", {1.5, 0.75, 2.5}, {0, 0, 1}, {1, 0, 0}, 12, 16, 0.25, 0, true);
  inner.surfaces[0].border = 0.5;
  const auto readingOf = [](const Scene& scene) {
    std::vector<float> light;
    for (const Vec3& c : scene.patches.center) light.push_back(static_cast<float>(100 * c.x + 7 * c.z));
    return readGrids(scene, light).at(0);
  };
  const GridReading a = readingOf(inner), b = readingOf(outer);
  EXPECT_EQ(a.points, 48u);
  EXPECT_EQ(b.points, 48u);
  EXPECT_NEAR(a.rim, b.rim, 1e-12);  // all that is left out, by whomever
  EXPECT_NEAR(a.mean, b.mean, 1e-3);
  EXPECT_NEAR(a.uniformity(), b.uniformity(),
              0.01);  // the outermost points of the inner one lie between fewer cells
}

TEST(CalculationGrid, PointsLieInsideTheRimAndOnWhatIsThere) {
  Scene scene = floorScene(16, 20);
  const std::vector<PatchLattice> lattices = measuredLattices(scene);
  ASSERT_EQ(lattices.size(), 1u);
  const CalculationGrid whole = calculationGridOn(lattices[0], scene.patches, scene.surfaces[0]);
  EXPECT_EQ(whole.points.size(), 48u);
  const auto placeOf = [&](const std::array<double, 2>& point) {
    return lattices[0].origin + point[0] * lattices[0].uAxis + point[1] * lattices[0].vAxis;
  };
  for (const auto& point : whole.points) {
    EXPECT_GT(placeOf(point).x, 1.5);
    EXPECT_LT(placeOf(point).x, 5.5);
    EXPECT_GT(placeOf(point).z, 2.5);
    EXPECT_LT(placeOf(point).z, 5.5);
  }
  // What something stands on has no points.
  scene.patches.covered.assign(scene.patches.rows(), 0);
  for (std::uint32_t p = 0; p < scene.patches.rows(); ++p)
    scene.patches.covered[p] = scene.patches.center[p].x > 3.5;
  const CalculationGrid half = calculationGridOn(lattices[0], scene.patches, scene.surfaces[0]);
  EXPECT_EQ(half.points.size(), 24u);
  for (const auto& point : half.points) EXPECT_LT(placeOf(point).x, 3.5);
}

TEST(CalculationGrid, AThresholdIsNoFloor) {
  const Scene scene = floorScene(1, 6);
  EXPECT_TRUE(readGrids(scene, std::vector<float>(scene.patches.rows(), 100)).empty());
}

TEST(CalculationGrid, ASlopeIsReadExactly) {
  const Scene scene = floorScene(16, 20);
  std::vector<float> light;
  for (const Vec3& center : scene.patches.center) light.push_back(static_cast<float>(100 * (center.x - 1)));
  const std::vector<GridReading> readings = readGrids(scene, light);
  ASSERT_EQ(readings.size(), 1u);
  EXPECT_NEAR(readings[0].mean, 250, 1e-3);
  EXPECT_NEAR(readings[0].least, 75, 1e-3);
  EXPECT_NEAR(readings[0].uniformity(), 0.3, 1e-5);
}

TEST(CalculationGrid, ItsMeanIsThatOfThePatchesInsideTheRim) {
  const Scene scene = syntheticScene(24, 6, 0);
  const std::vector<float> light = illuminanceOf(scene, {{0, 2, 5}, {1000, 1000, 1000}, 1});
  const std::vector<GridReading> readings = readGrids(scene, light);
  ASSERT_EQ(readings.size(), 2u);  // floor and plane; the wall has none
  EXPECT_TRUE(scene.surfaces[readings[1].surface].measuring);
  for (const GridReading& reading : readings) {
    double low[2] = {1e9, 1e9}, high[2] = {-1e9, -1e9};
    const auto each = [&](auto&& visit) {
      for (std::uint32_t p = 0; p < scene.patches.rows(); ++p)
        if (scene.patches.surface[p] == reading.surface) visit(scene.patches.center[p], light[p]);
    };
    each([&](const Vec3& c, float) {
      low[0] = std::min(low[0], c.x), high[0] = std::max(high[0], c.x);
      low[1] = std::min(low[1], c.z), high[1] = std::max(high[1], c.z);
    });
    double sum = 0, count = 0;
    const auto inside = [&](double middle, int axis) {  // share of a cell that the rim leaves
      const double from = low[axis] - 0.125 + reading.rim, to = high[axis] + 0.125 - reading.rim;
      return std::max(0.0, std::min(to, middle + 0.125) - std::max(from, middle - 0.125)) / 0.25;
    };
    each([&](const Vec3& c, float value) {
      const double share = inside(c.x, 0) * inside(c.z, 1);
      sum += share * value, count += share;
    });
    EXPECT_NEAR(reading.mean, sum / count, 0.01 * sum / count);
  }
}

}  // namespace
}  // namespace fiatlux
