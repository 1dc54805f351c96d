// Where the floor ends in plan.
#include "core/scene/floor_plan.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/synthetic_scene.h"

namespace fiatlux {
namespace {

double lengthOf(const std::vector<PlanSegment>& edges) {
  double sum = 0;
  for (const auto& [from, to] : edges) sum += std::hypot(to[0] - from[0], to[1] - from[1]);
  return sum;
}

TEST(FloorPlan, ARoomEndsAtItsFourWallsWhateverLiesOnItsFloor) {
  Scene scene;
  addGrid(scene, "floor", {1, 0, 2}, {0, 0, 1}, {1, 0, 0}, 16, 20, 0.25, 0.3f, false);
  EXPECT_NEAR(lengthOf(floorEdges(scene)), 2 * (4 + 5), 1e-9);
  addGrid(scene, "rug", {2, 0.02, 3}, {0, 0, 1}, {1, 0, 0}, 4, 4, 0.25, 0.3f, false);
  addGrid(scene, "working plane", {2, 0.75, 3}, {0, 0, 1}, {1, 0, 0}, 4, 4, 0.25, 0, true);
  const std::vector<PlanSegment> edges = floorEdges(scene);
  EXPECT_NEAR(lengthOf(edges), 2 * (4 + 5), 1e-9);
  const auto nearest = [&](const PlanPoint& at) {
    double least = 1e9;
    for (const PlanSegment& edge : edges) least = std::min(least, distance(at, edge));
    return least;
  };
  EXPECT_NEAR(nearest({1.5, 4}), 0.5, 1e-9);
  EXPECT_NEAR(nearest({3, 5.25}), 0.75, 1e-9);
  EXPECT_NEAR(nearest({0, 1}), std::hypot(1, 1), 1e-9) << "from outside, to the corner";
}

TEST(FloorPlan, FloorsThatMeetAreOneAndAGapIsAnEnd) {
  Scene scene;
  addGrid(scene, "floor", {0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 8, 8, 0.25, 0.3f, false);
  addGrid(scene, "floor beyond", {2, 0, 0}, {0, 0, 1}, {1, 0, 0}, 8, 8, 0.25, 0.3f, false);
  EXPECT_NEAR(lengthOf(floorEdges(scene)), 2 * (4 + 2), 1e-9);
  addGrid(scene, "floor apart", {5, 0, 0}, {0, 0, 1}, {1, 0, 0}, 8, 8, 0.25, 0.3f, false);
  EXPECT_NEAR(lengthOf(floorEdges(scene)), 2 * (4 + 2) + 8, 1e-9);
}

TEST(FloorPlan, NoFloorHasNoEdge) {
  Scene scene;
  addGrid(scene, "wall", {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 8, 8, 0.25, 0.3f, false);
  EXPECT_TRUE(floorEdges(scene).empty());
}

}  // namespace
}  // namespace fiatlux
