// What is covered is left out of statistics, and nothing else is: under bodies and behind them, hollows
// without a way out, planes with something on them or inside furniture.
#include "precompute/geometry/covered.h"

#include <gtest/gtest.h>

#include "core/scene/scene.h"
#include "core/transport/surface_statistics.h"
#include "precompute/light/measuring_grid.h"
#include "tests/precompute/gltf/gltf_builder.h"
#include "tests/precompute/transport_of.h"

namespace fiatlux {
namespace {

using testing::boxRoom;
using testing::TestGltf;
using testing::TestMesh;
using testing::transportOf;

const Vec3 kSize{4, 3, 4};  // m

RoomOptions fine() {
  RoomOptions options;
  options.patch = 0.25;
  return options;
}

void addBox(TestGltf& gltf, const char* name, const Vec3& low, const Vec3& size) {
  TestMesh mesh;
  mesh.box(low, size, false);
  gltf.node(name, gltf.mesh(mesh, 0));
}

void addPlane(TestGltf& gltf, double height) {
  TestMesh mesh;
  mesh.quad({0.5, height, 0.5}, {0, 0, 3}, {3, 0, 0});
  gltf.node("plane", gltf.mesh(mesh, 0), TestGltf::extras({{"measure", true}}));
}

/// m2 of a surface that is covered.
double coveredOf(const Room& room, const std::string& name) {
  double area = 0;
  for (std::uint32_t p = 0; p < room.patches.rows(); ++p)
    if (room.surfaces[room.patches.surface[p]].name == name && !room.patches.counts(p))
      area += room.patches.area[p];
  return area;
}

TEST(Covered, AnEmptyRoomHasNothingOfTheKind) {
  for (const double patch : {0.25, 0.1, 0.05}) {  // small ones lie wholly in corners
    RoomOptions options;
    options.patch = patch;
    const Result<Room> room = boxRoom(kSize, 1).build(options);
    ASSERT_TRUE(room) << room.error().message;
    EXPECT_TRUE(room->patches.covered.empty()) << patch;
  }
}

TEST(Covered, FloorUnderAWallThatReachesTheCeiling) {
  for (const double rise : {0.0, 0.2}) {  // m, of a floor that the wall stands on, over that of the room
    TestGltf gltf = boxRoom(kSize, 1);
    const double thick = 0.5;  // m, more than a hollow
    addBox(gltf, "wall", {1, rise, 0}, {thick, kSize.y - rise, kSize.z});
    if (rise > 0) addBox(gltf, "plate", {0, 0, 0}, {kSize.x, rise, kSize.z});
    const Result<Room> room = gltf.build(fine());
    ASSERT_TRUE(room) << room.error().message;
    EXPECT_NEAR(coveredOf(*room, rise > 0 ? "plate/top" : "floor"), thick * kSize.z, 1e-6) << rise;
  }
}

TEST(Covered, FloorUnderABodyAndWallBehindIt) {
  TestGltf gltf = boxRoom(kSize, 1);
  addBox(gltf, "cabinet", {1, 0.01, 0.01},
         {1, 1, 0.5});  // a centimetre above the floor and off the wall z = 0
  const Result<Room> room = gltf.build(fine());
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_NEAR(coveredOf(*room, "floor"), 0.5, 0.13);
  EXPECT_NEAR(coveredOf(*room, "south"), 1, 0.26);
  EXPECT_EQ(coveredOf(*room, "north"), 0);
  for (const Surface& surface : room->surfaces)
    if (surface.name == "floor") {
      EXPECT_NEAR(surface.area, 16 - coveredOf(*room, "floor"), 1e-6);
    }
}

TEST(Covered, ATableShadesItsFloorAndCoversNothing) {
  TestGltf gltf = boxRoom(kSize, 1);
  addBox(gltf, "top", {1, 0.7, 1}, {1.5, 0.04, 1});
  const Result<Room> room = gltf.build(fine());
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_EQ(coveredOf(*room, "floor"), 0);
}

TEST(Covered, AHollowWithoutAWayOut) {
  TestGltf gltf = boxRoom(kSize, 1);
  addBox(gltf, "lid", {1, 0.1, 1}, {0.24, 0.5, 0.24});
  addBox(gltf, "south", {0.98, 0, 0.98}, {0.28, 0.11, 0.02});
  addBox(gltf, "north", {0.98, 0, 1.24}, {0.28, 0.11, 0.02});
  addBox(gltf, "west", {0.98, 0, 1}, {0.02, 0.11, 0.24});
  addBox(gltf, "east", {1.24, 0, 1}, {0.02, 0.11, 0.24});
  RoomOptions options = fine();
  options.patch = 0.08;
  const Result<Room> room = gltf.build(options);
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_GT(coveredOf(*room, "floor"), 0.02);
  EXPECT_LT(coveredOf(*room, "floor"), 0.28 * 0.28 + 0.04);
}

TEST(Covered, WhatHidesAPatchTogether) {
  // A third of a patch is under a pot's foot, another is inside the pot: neither is half of it.
  TestGltf gltf = boxRoom(kSize, 1);
  addBox(gltf, "foot", {1, 0.01, 1}, {0.25, 0.05, 0.0834});
  addBox(gltf, "pot", {1, -0.01, 1.1}, {0.25, 0.5, 0.0834});
  const Result<Room> room = gltf.build(fine());
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_NEAR(coveredOf(*room, "floor"), 0.0625, 1e-6);
}

TEST(Covered, FloorUnderALowSofa) {
  TestGltf gltf = boxRoom(kSize, 1);
  addBox(gltf, "sofa", {1, 0.14, 0.01}, {2, 0.7, 0.74});
  const Result<Room> room = gltf.build(fine());
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_GT(coveredOf(*room, "floor"), 1);  // 2 m x 0.75 m but for what its edges let in
  EXPECT_LE(coveredOf(*room, "floor"), 1.5 + 1e-6);
}

TEST(Covered, FloorBehindASofaAHandFromItsWallAndNotBesideIt) {
  TestGltf gltf = boxRoom(kSize, 1);
  addBox(gltf, "seat", {1, 0.14, 0.12}, {2, 0.3, 0.8});
  addBox(gltf, "back", {1, 0.14, 0.12}, {2, 0.7, 0.2});
  const Result<Room> room = gltf.build(fine());
  ASSERT_TRUE(room) << room.error().message;
  for (std::uint32_t p = 0; p < room->patches.count; ++p) {
    const Vec3& at = room->patches.center[p];
    if (at.y > 0) continue;
    const bool isBelow = at.z < 0.7 && at.x > 1.2 && at.x < 2.8;
    const bool isClear = at.z > 1 || at.x < 0.9 || at.x > 3.1;
    if (isBelow || isClear) {
      EXPECT_EQ(room->patches.counts(p), isClear) << at.x << " " << at.z;
    }
  }
}

TEST(Covered, APlaneWithSomethingOnItOrInsideFurniture) {
  TestGltf gltf = boxRoom(kSize, 1);
  addPlane(gltf, 0.75);
  addBox(gltf, "shelf", {1, 0.001, 1}, {1, 2, 0.5});          // the plane passes through it
  addBox(gltf, "tray", {2.25, 0.8, 2.25}, {0.5, 0.02, 0.5});  // five centimetres above
  addBox(gltf, "lamp", {1, 1.5, 2.25}, {0.5, 0.1, 0.5});      // well above
  const Result<Room> room = gltf.build(fine());
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_NEAR(coveredOf(*room, "plane"), 0.5 + 0.25, 0.13);

  // Its grid leaves out the same, and its least light is that of what can be used.
  const RayTracer tracer = std::move(RayTracer::build(*room).value());
  for (const MeasuringGrid& grid : measuringGrids(*room))
    for (const MeasuringPoint& point : grid.points)
      EXPECT_FALSE(point.position.y > 0.7 && point.position.x > 1.25 && point.position.x < 1.75 &&
                   point.position.z > 1.01 && point.position.z < 1.49);
  const Result<Transport> transport = transportOf(*room);
  ASSERT_TRUE(transport) << transport.error().message;
  std::uint32_t plane = 0;
  while (room->surfaces[plane].name != "plane") ++plane;
  double darkest = 1e9, hidden = 1e9;
  for (std::uint32_t p = 0; p < room->patches.rows(); ++p) {
    if (room->patches.surface[p] != plane) continue;
    double light = 0;
    for (std::uint32_t j = 0; j < room->sites.size(); ++j) light += transport->responses.column(j)[p];
    (room->patches.counts(p) ? darkest : hidden) =
        std::min(room->patches.counts(p) ? darkest : hidden, light);
  }
  EXPECT_LT(hidden, 1e-6);
  EXPECT_GT(darkest, 0.01);
}

TEST(Covered, WhatIsCoveredThroughoutCountsAsAWhole) {
  TestGltf gltf = boxRoom(kSize, 1);
  TestMesh mesh;
  mesh.quad({1, 0.005, 1}, {0, 0, 1}, {1, 0, 0});
  gltf.node("mat", gltf.mesh(mesh, 0));
  addBox(gltf, "chest", {0.9, 0.01, 0.9}, {1.2, 0.5, 1.2});
  const Result<Room> room = gltf.build(fine());
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_EQ(coveredOf(*room, "mat"), 0);
  EXPECT_GT(coveredOf(*room, "floor"), 0.9);
}

}  // namespace
}  // namespace fiatlux
