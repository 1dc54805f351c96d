// The calculation grid of EN 12464-1 on a room: where its points are, and what rays read there.
#include "precompute/light/measuring_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "precompute/light/forward_light.h"
#include "precompute/validation/rectangle_room.h"
#include "tests/precompute/gltf/gltf_builder.h"

namespace fiatlux {
namespace {

/// Under the middle of a room of 4 x 2.5 x 4 m.
Luminaire lampOfMiddle() {
  Luminaire lamp;
  lamp.position = {2, 2.4, 2};
  lamp.flux = 1000;
  return lamp;
}

PointOptions oneThread() {
  PointOptions options;
  options.threads = 1;
  return options;
}

TEST(MeasuringGrid, AFloorHasOneWithARimAndAMeasuringPlaneToo) {
  auto faces = boxSurfaces({0, 0, 0}, {6, 2.5, 4}, 0.5, 0.25);
  RectangleSurface plane = faces[0];
  plane.name = "plane";
  plane.corner.y = 0.75;
  plane.measuring = true;
  faces.push_back(plane);
  const Room room = rectangleRoom(faces);
  const std::vector<MeasuringGrid> grids = measuringGrids(room);
  ASSERT_EQ(grids.size(), 2u);
  EXPECT_EQ(room.surfaces[grids[0].surface].name, "floor");
  EXPECT_EQ(room.surfaces[grids[1].surface].name, "plane");
  for (const MeasuringGrid& grid : grids) {
    EXPECT_EQ(grid.grid.rule.rim, 0.5);
    const auto along = [&](double side) {
      return static_cast<std::size_t>(std::ceil(side / grid.grid.rule.spacing));
    };
    EXPECT_EQ(grid.points.size(), along(5) * along(3));
    for (const MeasuringPoint& point : grid.points) {
      EXPECT_GT(point.position.x, 0.5);
      EXPECT_LT(point.position.x, 5.5);
      EXPECT_EQ(point.normal.y, 1);
    }
  }
}

TEST(MeasuringGrid, ReadingsGiveMeanLeastAndUniformity) {
  const Room room = rectangleRoom(boxSurfaces({0, 0, 0}, {4, 2.5, 4}, 0.5, 0.5));
  const auto tracer = RayTracer::build(room);
  ASSERT_TRUE(tracer);
  const std::vector<GridReading> readings = readGrids(room, *tracer, {lampOfMiddle()}, {}, {}, oneThread());
  ASSERT_EQ(readings.size(), 1u);
  const std::vector<PointReading> points =
      readPoints(room, *tracer, measuringGrids(room)[0].points, {lampOfMiddle()}, {}, oneThread());
  double sum = 0, least = points[0].total;
  for (const PointReading& point : points) sum += point.total, least = std::min(least, point.total);
  EXPECT_NEAR(readings[0].mean, sum / static_cast<double>(points.size()), 1e-9);
  EXPECT_EQ(readings[0].least, least);
  EXPECT_NEAR(readings[0].uniformity(), least / readings[0].mean, 1e-12);
  EXPECT_LT(readings[0].uniformity(), 0.9);
  EXPECT_GT(readings[0].uniformity(), 0.1);
}

TEST(MeasuringGrid, OfAnUnfurnishedRoomItsMeanIsThatOfThePatches) {
  auto faces = boxSurfaces({0, 0, 0}, {6, 3, 4}, 0.5, 0.2);
  RectangleSurface plane = faces[0];
  plane.name = "plane";
  plane.corner = {0.5, 0.75, 0.5};
  plane.u = {0, 0, 3}, plane.v = {5, 0, 0};
  plane.measuring = true;
  faces.push_back(plane);
  Room room = rectangleRoom(faces);
  for (Surface& surface : room.surfaces)
    if (surface.measuring) surface.border = 0.5;
  const auto tracer = RayTracer::build(room);
  ASSERT_TRUE(tracer);
  std::vector<Luminaire> lamps;
  for (const double x : {1.5, 4.5})
    for (const double z : {1.0, 3.0}) {
      Luminaire lamp;
      lamp.position = {x, 2.9, z};
      lamp.flux = 3000;
      lamps.push_back(lamp);
    }
  ForwardOptions forward;
  forward.rays = 256;
  forward.threads = 1;
  const Result<ForwardLight> light = computeForwardLight(room, *tracer, lamps, forward);
  ASSERT_TRUE(light) << light.error().message;
  const std::vector<GridReading> readings =
      readGrids(room, *tracer, lamps, light->radiosity, light->illuminance, oneThread());
  ASSERT_EQ(readings.size(), 2u);
  const GridReading& ofPlane = readings[1];
  double sum = 0, area = 0;
  for (std::uint32_t p = 0; p < room.patches.rows(); ++p) {
    if (room.patches.surface[p] != ofPlane.surface) continue;
    sum += room.patches.area[p] * light->illuminance[p];
    area += room.patches.area[p];
  }
  EXPECT_NEAR(area, 15, 1e-9);
  EXPECT_NEAR(ofPlane.mean, sum / area, 0.01 * sum / area);
}

TEST(MeasuringGrid, APointThatSomethingStandsOnIsReadBesideIt) {
  testing::TestGltf gltf = testing::boxRoom({4, 2.5, 4}, 1);
  testing::TestMesh block;
  block.box({1.4, 0.001, 1.4}, {0.75, 0.6, 0.75}, false);
  gltf.node("block", gltf.mesh(block, 0));
  RoomOptions options;
  options.patch = 0.5;
  const Result<Room> room = gltf.build(options);
  ASSERT_TRUE(room) << room.error().message;
  const auto tracer = RayTracer::build(*room);
  ASSERT_TRUE(tracer);
  const auto isIn = [](const MeasuringPoint& p) {
    return p.position.x > 1.4 && p.position.x < 2.15 && p.position.z > 1.4 && p.position.z < 2.15;
  };
  const std::vector<MeasuringGrid> grids = measuringGrids(*room);
  ASSERT_EQ(grids.size(), 1u);
  const auto within = std::count_if(grids[0].points.begin(), grids[0].points.end(), isIn);
  ASSERT_GT(within, 0);
  const std::vector<float> around(room->patches.rows(), 7);
  const std::vector<GridReading> readings =
      readGrids(*room, *tracer, {lampOfMiddle()}, {}, around, oneThread());
  EXPECT_EQ(readings[0].points, grids[0].points.size());
  EXPECT_NEAR(readings[0].least, 7, 1e-9);  // the lamp sends more to all others
}

}  // namespace
}  // namespace fiatlux
