// What faces the void is left out, and nothing else is: shells drawn as sheets, whichever way they face,
// rooms that are open, sealed or joined, things that rest on a floor, and what a person asked for (outlook).
#include "precompute/geometry/outside.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "precompute/light/lost_light.h"
#include "tests/precompute/gltf/gltf_builder.h"
#include "tests/precompute/transport_of.h"

namespace fiatlux {
namespace {

using testing::allWarnings;
using testing::boxRoom;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::ordered_json;
using testing::surfaceIndex;
using testing::surfaceNames;
using testing::TestGltf;
using testing::TestMesh;
using testing::totalArea;
using testing::transportOf;
using ::testing::UnorderedElementsAre;

const Vec3 kRoomSize{4, 3, 5};  // m

RoomOptions coarse() {
  RoomOptions options;
  options.patch = 0.5;
  return options;
}

/// A room of sheets, one node a side, with or without its north side (z = 5 m). `outward`: the fronts look
/// out.
TestGltf shell(bool closed, bool outward, bool doubleSided = true) {
  TestGltf gltf;
  const int paint = gltf.material("paint", 0.5, {{"doubleSided", doubleSided}});
  const Vec3 x{kRoomSize.x, 0, 0}, y{0, kRoomSize.y, 0}, z{0, 0, kRoomSize.z};
  const auto side = [&](const char* name, const Vec3& o, const Vec3& u, const Vec3& v) {
    TestMesh mesh;
    outward ? mesh.quad(o, v, u) : mesh.quad(o, u, v);
    gltf.node(name, gltf.mesh(mesh, paint));
  };
  side("floor", {}, z, x), side("ceiling", y, x, z), side("south", {}, x, y);
  if (closed) side("north", z, y, x);
  side("west", {}, y, z), side("east", x, z, y);
  gltf.glb.json["nodes"][1]["extras"] = {{"fiatlux", {{"mount", true}, {"siteSpacing", 1}}}};
  return gltf;
}

TEST(Outside, AnOpenShellOfSheetsHasNoBacks) {
  const auto plain = shell(false, false, false).build(coarse());
  ASSERT_TRUE(plain);
  for (const bool outward : {false, true}) {
    const auto room = shell(false, outward).build(coarse());
    ASSERT_TRUE(room) << room.error().message;
    EXPECT_THAT(surfaceNames(*room), UnorderedElementsAre("floor", "ceiling", "south", "west", "east"));
    EXPECT_NEAR(totalArea(*room), 20 + 20 + 12 + 15 + 15, 1e-4);
    EXPECT_EQ(room->patches.count, plain->patches.count);
    EXPECT_EQ(room->sites.size(), 20u);
    for (const Site& site : room->sites) EXPECT_LT(site.normal.y, -0.99);
    EXPECT_GT(room->patches.normal[0].y, 0.99);  // the floor's
    EXPECT_THAT(allWarnings(room->warnings), HasSubstr("82 m2 face the void"));
    EXPECT_THAT(allWarnings(room->warnings), HasSubstr("'ceiling (back)' 20 m2"));
    const auto tracer = RayTracer::build(*room);
    EXPECT_THAT(lostLight(*room, {}, *tracer).warnings,
                ::testing::ElementsAre(HasSubstr("the room is open")));
  }
  EXPECT_THAT(allWarnings(plain->warnings), Not(HasSubstr("void")));
}

TEST(Outside, TheLightOfAShellOfSheetsIsThatOfItsInside) {
  const auto sheets = shell(false, true).build(coarse()), plain = shell(false, false, false).build(coarse());
  ASSERT_TRUE(sheets && plain);
  const auto a = transportOf(*sheets), b = transportOf(*plain);
  ASSERT_TRUE(a && b);
  for (const char* name : {"floor", "ceiling", "south", "west", "east"}) {
    const int s = surfaceIndex(*sheets, name), p = surfaceIndex(*plain, name);
    EXPECT_NEAR(a->lost[s], b->lost[p], 0.01) << name;
    EXPECT_LT(a->lost[s], 0.45) << name;
    for (const std::size_t j : {0u, 7u, 19u})
      EXPECT_NEAR(a->illuminance[s].mean[j] / b->illuminance[p].mean[j], 1, 0.01) << name;
  }
}

TEST(Outside, AClosedSheetDrawnFromOutsideIsARoom) {
  // What a modelling program makes of a cube that is blown up to be a room: one mesh, double-sided, outward.
  TestGltf gltf;
  TestMesh cube, chest;
  cube.box({}, kRoomSize, false), chest.box({1, 0.5, 1}, {1, 0.5, 2}, false);
  const int paint = gltf.material("paint", 0.5, {{"doubleSided", true}});
  gltf.node("cube", gltf.mesh(cube, paint)),
      gltf.node("chest", gltf.mesh(chest, paint), TestGltf::extras({{"surface", "chest"}}));
  const auto room = gltf.build(coarse());
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_THAT(surfaceNames(*room),
              UnorderedElementsAre("cube/floor", "cube/ceiling", "cube/wall 1", "cube/wall 2", "cube/wall 3",
                                   "cube/wall 4", "chest"));
  EXPECT_NEAR(room->surfaces[surfaceIndex(*room, "cube/floor")].area, 20, 1e-4);
  EXPECT_THAT(allWarnings(room->warnings), HasSubstr("proposed to hang on 'cube/ceiling'"));
  const auto transport = transportOf(*room);
  ASSERT_TRUE(transport);
  for (const double lost : transport->lost) EXPECT_EQ(lost, 0);

  // A closed chest stays a thing, however large: nothing stands within it.
  TestGltf filled = shell(true, false);
  TestMesh large;
  large.box({0.2, 0.2, 0.2}, {3.6, 2.6, 4.6}, false);
  filled.node("chest", filled.mesh(large, 0), TestGltf::extras({{"surface", "chest"}}));
  const auto around = filled.build(coarse());
  ASSERT_TRUE(around);
  EXPECT_EQ(surfaceIndex(*around, "chest (back)"), -1);
  EXPECT_GE(surfaceIndex(*around, "chest"), 0);
}

TEST(Outside, AnOutsideThatSeesItselfIsLeftOut) {
  // An L of sheets, open at one end: the outsides of its wings see each other, and otherwise nothing.
  TestGltf gltf;
  TestMesh mesh;
  const Vec3 y{0, 3, 0};
  const double plan[][2] = {{0, 0}, {6, 0}, {6, 3}, {3, 3}, {3, 6}, {0, 6}};
  for (const int i : {0, 1, 2, 3, 5}) {
    const Vec3 a{plan[i][0], 0, plan[i][1]}, b{plan[(i + 1) % 6][0], 0, plan[(i + 1) % 6][1]};
    mesh.quad(a, b - a, y);
  }
  for (const double from : {0.0, 3.0}) {
    const Vec3 o{0, 0, from}, u{from > 0 ? 3.0 : 6.0, 0, 0}, v{0, 0, 3};
    mesh.quad(o, v, u), mesh.quad(o + y, u, v);
  }
  gltf.node("house", gltf.mesh(mesh, gltf.material("paint", 0.5, {{"doubleSided", true}})));
  const auto room = gltf.build(coarse());
  ASSERT_TRUE(room) << room.error().message;
  for (const std::string& name : surfaceNames(*room)) EXPECT_THAT(name, Not(HasSubstr("(back)")));
  EXPECT_NEAR(totalArea(*room), 2 * 27 + 21 * 3, 0.01);
}

/// Two rooms of sheets side by side, 4 m wide each; perhaps a door of 1 x 2 m in the sheet between them.
TestGltf twoRooms(bool door) {
  TestGltf gltf = shell(true, false);
  auto& nodes = gltf.glb.json["nodes"];
  TestMesh partition;
  const auto piece = [&](double z0, double z1, double y0, double y1) {
    partition.quad({4, y0, z0}, {0, 0, z1 - z0}, {0, y1 - y0, 0});
  };
  if (door)
    piece(0, 2, 0, 3), piece(3, 5, 0, 3), piece(2, 3, 2, 3);
  else
    piece(0, 5, 0, 3);
  nodes[5]["mesh"] = gltf.mesh(partition, 0);
  const Vec3 o{4, 0, 0}, x{4, 0, 0}, y{0, 3, 0}, z{0, 0, 5};
  const auto side = [&](const char* name, const Vec3& from, const Vec3& u, const Vec3& v) {
    TestMesh mesh;
    mesh.quad(from, u, v);
    gltf.node(name, gltf.mesh(mesh, 0));
  };
  side("B floor", o, z, x), side("B ceiling", o + y, x, z), side("B south", o, x, y);
  side("B north", o + z, y, x), side("B east", o + x, z, y);
  return gltf;
}

TEST(Outside, JoinedAndSealedRoomsStay) {
  for (const bool door : {true, false}) {
    const auto room = twoRooms(door).build(coarse());
    ASSERT_TRUE(room) << room.error().message;
    for (const char* name : {"B floor", "B ceiling", "B south", "B north", "B east", "floor", "east"})
      EXPECT_GE(surfaceIndex(*room, name), 0) << name;
    EXPECT_GE(surfaceIndex(*room, "east (back)"), 0);  // the partition, seen from B
    for (const char* name : {"B floor (back)", "B north (back)", "south (back)", "ceiling (back)"})
      EXPECT_EQ(surfaceIndex(*room, name), -1) << name;
    const auto transport = transportOf(*room);
    ASSERT_TRUE(transport);
    const double lit = transport->illuminance[surfaceIndex(*room, "floor")].mean[0],
                 beyond = transport->illuminance[surfaceIndex(*room, "B floor")].mean[0];
    if (door) {
      EXPECT_GT(beyond, 1e-3 * lit);
    } else {
      EXPECT_LE(beyond, 1e-6 * lit);
      EXPECT_THAT(allWarnings(room->warnings), HasSubstr("94 m2 are shut off"));
    }
    for (const double lost : transport->lost) EXPECT_EQ(lost, 0);
  }
}

TEST(Outside, ARoomWithoutItsCeilingKeepsItsInside) {
  TestGltf gltf = shell(true, false);
  TestMesh lamp;
  lamp.quad({1.5, 2.5, 2}, {1, 0, 0}, {0, 0, 1});  // a small mount within
  gltf.glb.json["nodes"][1]["mesh"] = gltf.mesh(lamp, 0);
  const auto room = gltf.build(coarse());
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_THAT(surfaceNames(*room),
              UnorderedElementsAre("floor", "ceiling", "ceiling (back)", "south", "north", "west",
                                   "east"));  // the lamp's top sees the walls
  const auto transport = transportOf(*room);
  ASSERT_TRUE(transport);
  EXPECT_GT(transport->lost[surfaceIndex(*room, "floor")], 0.2);
  EXPECT_LT(transport->lost[surfaceIndex(*room, "floor")], 0.5);
}

TEST(Outside, WhatRestsOnTheFloorHasNoUnderside) {
  TestGltf gltf = boxRoom(kRoomSize, 1);
  TestMesh chest;
  chest.box({1, 0, 1}, {1, 0.5, 2}, false);
  gltf.node("chest", gltf.mesh(chest, 0), TestGltf::extras({{"surface", "chest"}}));
  const auto room = gltf.build(coarse());
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_NEAR(room->surfaces[surfaceIndex(*room, "chest")].area, 2 + 2 * 0.5 * 3, 1e-4);
  EXPECT_THAT(allWarnings(room->warnings), HasSubstr("2 m2 face the void or rest on something"));
  EXPECT_THAT(allWarnings(room->warnings), HasSubstr("'chest' 2 m2"));
  for (const RoomTriangle& triangle : room->triangles)
    if (triangle.chart == kNone) {
      EXPECT_EQ(room->leftOut[triangle.leftOut], "chest");
    }
}

TEST(Outside, ABodyBeforeTheOpenSideOfARoomIsNotTurned) {
  // Its north side looks out of the room, and the floor below it at the backs of its sides.
  for (const bool doubleSided : {false, true}) {
    TestGltf gltf = shell(false, false, doubleSided);
    TestMesh body;
    body.box({1, 0, 2.5}, {2, 2, 2}, false);
    gltf.node("body", gltf.mesh(body, 0));
    const Result<Room> room = gltf.build(coarse());
    ASSERT_TRUE(room) << room.error().message;
    EXPECT_THAT(allWarnings(room->warnings), Not(HasSubstr("are turned")));
    double area = 0;
    for (std::uint32_t p = 0; p < room->patches.count; ++p) {
      const Vec3& at = room->patches.center[p];
      if (std::max(std::abs(at.x - 2), std::abs(at.z - 3.5)) > 1.01) continue;
      if (at.y > 0.01 && at.y < 2.01) {
        area += room->patches.area[p];
        EXPECT_GT(dot(at - Vec3{2, 1, 3.5}, room->patches.normal[p]), 0);
      }
      if (at.y < 0.01 && std::max(std::abs(at.x - 2), std::abs(at.z - 3.5)) < 0.99) {
        EXPECT_FALSE(room->patches.counts(p)) << at.x << " " << at.z;
      }
    }
    EXPECT_NEAR(area, 20, 1e-6);
  }
}

TEST(Outside, WhatAPersonAskedForStays) {
  // A porch: a mount outside the house, and a measuring plane below it.
  TestGltf gltf = shell(true, false);
  TestMesh porch, plane;
  porch.quad({0, 2.5, -2}, {2, 0, 0}, {0, 0, 1});
  plane.quad({0, 0.8, -2}, {0, 0, 1}, {2, 0, 0});
  gltf.node("porch", gltf.mesh(porch, 0), TestGltf::extras({{"mount", true}, {"siteSpacing", 1}}));
  gltf.node("plane", gltf.mesh(plane, 0), TestGltf::extras({{"measure", true}}));
  const auto room = gltf.build(coarse());
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_THAT(surfaceNames(*room), Contains(std::string("porch")));
  EXPECT_THAT(surfaceNames(*room), Contains(std::string("plane")));
  EXPECT_THAT(surfaceNames(*room), Contains(std::string("south (back)")));  // the porch's light falls on it
  EXPECT_THAT(surfaceNames(*room), Not(Contains(std::string("north (back)"))));
  EXPECT_EQ(room->sites.size(), 22u);

  // A luminaire that hangs outside lights what it sees.
  RoomOptions options = coarse();
  Luminaire lamp;
  lamp.position = {2, 2, 8};
  lamp.normal = {0, 0, -1};
  options.luminaires = {lamp};
  const auto lit = shell(true, false).build(options);
  ASSERT_TRUE(lit);
  EXPECT_GE(surfaceIndex(*lit, "north (back)"), 0);
  EXPECT_EQ(surfaceIndex(*lit, "south (back)"), -1);
}

TEST(Outside, WithoutAPlaceForLightNothingIsLeftOut) {
  TestGltf gltf;
  TestMesh mesh;
  mesh.quad({}, {0, 0, 2}, {2, 0, 0});
  gltf.node("ground", gltf.mesh(mesh));
  RoomOptions options = coarse();
  options.requireSites = false;
  const auto room = gltf.build(options);
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_EQ(room->patches.count, 16u);
}

TEST(Outside, TheSameEveryTime) {
  const auto one = twoRooms(true).build(coarse()), two = twoRooms(true).build(coarse());
  ASSERT_TRUE(one && two);
  EXPECT_EQ(surfaceNames(*one), surfaceNames(*two));
  EXPECT_EQ(one->patches.area, two->patches.area);
  EXPECT_EQ(one->warnings, two->warnings);
}

}  // namespace
}  // namespace fiatlux
