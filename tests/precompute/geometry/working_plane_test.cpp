// The measuring plane that is laid over a floor: as large as the floor without its rim, whatever its shape.
#include "precompute/geometry/working_plane.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "tests/precompute/geometry/trap_rooms.h"

namespace fiatlux {
namespace {

using testing::boxRoom;
using ::testing::HasSubstr;
using testing::surfaceIndex;
using testing::TestGltf;
using testing::TestMesh;

RoomOptions withPlane(double height, double rim) {
  RoomOptions options;
  options.patch = 0.25;
  options.plane = height, options.planeRim = rim;
  return options;
}

/// A floor and the same as ceiling, `high` above it.
TestGltf sandwich(const TestMesh& floor, double high) {
  TestGltf gltf;
  const int grey = gltf.material("grey", 0.5);
  TestMesh ceiling;
  for (std::size_t i = 0; i < floor.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) {
      const auto& p = floor.positions[floor.indices[i + k]];
      return Vec3{p[0], p[1] + high, p[2]};
    };
    ceiling.triangle(at(0), at(2), at(1));
  }
  gltf.node("floor", gltf.mesh(floor, grey));
  gltf.node("ceiling", gltf.mesh(ceiling, grey));
  return gltf;
}

double areaOfPlane(TestGltf gltf, const RoomOptions& options) {
  const auto room = gltf.build(options);
  EXPECT_TRUE(room) << (room ? "" : room.error().message);
  if (!room) return 0;
  const Surface& plane = room->surfaces[surfaceIndex(*room, "working plane")];
  EXPECT_TRUE(plane.measuring);
  EXPECT_EQ(plane.border, options.planeRim);
  for (std::uint32_t p = room->patches.count; p < room->patches.rows(); ++p) {
    EXPECT_NEAR(room->patches.center[p].y, options.plane, 1e-5);
    EXPECT_NEAR(room->patches.normal[p].y, 1, 1e-5);
  }
  return plane.area;
}

TEST(WorkingPlane, LiesOverTheFloorWithoutItsRim) {
  EXPECT_NEAR(areaOfPlane(boxRoom({6, 2.8, 5}, 1), withPlane(0.75, 0.5)), 5 * 4, 1e-4);
  EXPECT_NEAR(areaOfPlane(boxRoom({6, 2.8, 5}, 1), withPlane(0.02, 0)), 6 * 5, 1e-4);
}

TEST(WorkingPlane, FollowsCornersAndGoesAroundColumns) {
  TestMesh corner;  // an L of two pieces that share a part of an edge
  corner.quad({0, 0, 0}, {0, 0, 2}, {6, 0, 0});
  corner.quad({0, 0, 2}, {0, 0, 3}, {2, 0, 0});
  EXPECT_NEAR(areaOfPlane(sandwich(corner, 3), withPlane(0.8, 0.5)), 5 * 1 + 1 * 3, 1e-4);

  TestMesh around;  // a floor with a hole of 1 x 1 m
  around.quad({0, 0, 0}, {0, 0, 2}, {5, 0, 0});
  around.quad({0, 0, 3}, {0, 0, 2}, {5, 0, 0});
  around.quad({0, 0, 2}, {0, 0, 1}, {2, 0, 0});
  around.quad({3, 0, 2}, {0, 0, 1}, {2, 0, 0});
  EXPECT_NEAR(areaOfPlane(sandwich(around, 3), withPlane(0.8, 0.5)), 4 * 4 - 2 * 2, 1e-4);
}

TEST(WorkingPlane, ARoundFloorHasARoundOne) {
  TestMesh disc;
  const int sides = 48;
  const auto at = [&](int i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    return Vec3{3 * std::cos(angle), 0, 3 * std::sin(angle)};
  };
  for (int i = 0; i < sides; ++i) disc.triangle({}, at(i + 1), at(i));
  EXPECT_NEAR(areaOfPlane(sandwich(disc, 3), withPlane(0.75, 0.5)), std::numbers::pi * 2.5 * 2.5, 0.3);
}

TEST(WorkingPlane, DesksAreNoFloorAndANarrowFloorHasNone) {
  TestGltf office = boxRoom({6, 2.8, 5}, 1);
  TestMesh desk;
  desk.box({1, 0, 1}, {1.6, 0.7, 0.8}, false);
  office.node("desk", office.mesh(desk));
  EXPECT_NEAR(areaOfPlane(office, withPlane(0.75, 0.5)), 5 * 4, 1e-4);

  const auto none = boxRoom({6, 2.8, 5}, 1).build(withPlane(0.75, 2.6));
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("narrower than two rims of 2.6 m"));
}

}  // namespace
}  // namespace fiatlux
