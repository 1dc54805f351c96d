// glTF -> Room on shapes whose patches, surfaces and sites can be counted by hand (surfaces, back_faces,
// mounts, sites).
#include "precompute/geometry/build_room.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "precompute/rays/patch_sampler.h"
#include "tests/precompute/gltf/gltf_builder.h"

namespace fiatlux {
namespace {

using testing::allWarnings;
using testing::boxRoom;
using ::testing::HasSubstr;
using testing::ordered_json;
using testing::surfaceIndex;
using testing::surfaceNames;
using testing::TestGltf;
using testing::TestMesh;
using testing::totalArea;
using ::testing::UnorderedElementsAre;

/// The line with which a room is refused.
std::string refusal(TestGltf& gltf, const RoomOptions& options) {
  const auto room = gltf.build(options);
  EXPECT_FALSE(room);
  return room ? "" : room.error().message;
}

/// What the tracer relies on: every patch can be sampled, and the samples lie in that patch.
void expectConsistent(const Room& room) {
  const Patches& patches = room.patches;
  ASSERT_EQ(room.fragmentOffset.size(), patches.rows() + 1u);
  ASSERT_EQ(patches.cluster.size(), patches.count);
  for (const std::uint32_t c : patches.cluster) ASSERT_LT(c, patches.clusterCount);
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    ASSERT_GT(patches.area[p], 0);
    ASSERT_NEAR(length(patches.normal[p]), 1, 1e-9);
    for (const std::uint32_t q : {patches.left[p], patches.up[p]}) ASSERT_TRUE(q == kNone || q < p);
    const auto point = PatchSampler(room, p).at(0.3, 0.6);
    ASSERT_GT(dot(point.normal, patches.normal[p]), 0);
  }
  for (std::uint32_t t = 0; t < room.triangles.size(); ++t) {
    const RoomTriangle& triangle = room.triangles[t];
    ASSERT_NE(triangle.chart, kNone);
    const Vec3 center = (1.0 / 3) * (room.positions[triangle.vertex[0]] + room.positions[triangle.vertex[1]] +
                                     room.positions[triangle.vertex[2]]);
    ASSERT_LT(room.patchAt(t, false, center), patches.count);
    for (const std::uint32_t v : triangle.vertex)
      ASSERT_LT(room.patchAt(t, false, room.positions[v]), patches.count);
  }
}

/// A vertical wall between two points of the plan (cells), facing left of the way from a to b.
void wall(TestMesh& mesh, double ax, double az, double bx, double bz) {
  constexpr double kCell = 0.75;
  mesh.quad(kCell * Vec3{ax, 0, az}, kCell * Vec3{bx - ax, 0, bz - az}, {0, 4 * kCell, 0});
}

/// The corridor of the paper's counts: an E of cells of 0.75 m, spine 6 x 43, arms 11 deep.
TestGltf eCorridor() {
  constexpr double kCell = 0.75;
  TestGltf gltf;
  const struct { double z, wide; } arms[] = {{0, 6}, {19, 5}, {37, 6}};
  const auto plate = [&](TestMesh& mesh, double x, double z, double w, double d, double y, bool up) {
    const Vec3 o = kCell * Vec3{x, y, z}, u = kCell * Vec3{w, 0, 0}, v = kCell * Vec3{0, 0, d};
    up ? mesh.quad(o, v, u) : mesh.quad(o, u, v);
  };
  TestMesh floor, spine, armCeilings, yellow, walls;
  plate(floor, 0, 0, 6, 43, 0, true), plate(spine, 0, 0, 6, 43, 4, false);
  for (const auto& arm : arms) {
    plate(floor, 6, arm.z, 11, arm.wide, 0, true), plate(armCeilings, 6, arm.z, 11, arm.wide, 4, false);
    wall(walls, 17, arm.z, 17, arm.z + arm.wide);
    if (arm.z > 0) wall(walls, 6, arm.z, 17, arm.z);
    if (arm.z == 19) wall(yellow, 17, 24, 6, 24);
    if (arm.z == 0) wall(walls, 17, 6, 6, 6);
  }
  wall(walls, 0, 0, 17, 0), wall(walls, 17, 43, 0, 43), wall(walls, 0, 43, 0, 0);
  wall(walls, 6, 6, 6, 19), wall(walls, 6, 24, 6, 37);
  const auto named = [](const char* name, ordered_json more = ordered_json::object()) {
    more["surface"] = name;
    return TestGltf::extras(more);
  };
  gltf.node("f", gltf.mesh(floor, gltf.material("f", 0.3)), named("floor"));
  const int white = gltf.material("c", 0.7), grey = gltf.material("w", 0.5);
  gltf.node("spine", gltf.mesh(spine, white), named("ceiling", {{"mount", true}, {"siteSpacing", kCell}}));
  gltf.node("arms", gltf.mesh(armCeilings, white), named("ceiling"));
  gltf.node("y", gltf.mesh(yellow, grey), named("yellow wall"));
  gltf.node("w", gltf.mesh(walls, grey), named("walls"));
  return gltf;
}

TEST(BuildRoom, TheCorridorHasThePapersCounts) {
  TestGltf gltf = eCorridor();
  for (const double patch : {0.1875, 0.0}) {  // 0: the default finds the same
    RoomOptions options;
    options.patch = patch;
    const auto room = gltf.build(options);
    ASSERT_TRUE(room) << room.error().message;
    EXPECT_EQ(room->patches.count, 24736u);
    EXPECT_EQ(room->patches.clusterCount, 1546u);
    EXPECT_EQ(room->sites.size(), 258u);
    EXPECT_EQ(room->surfaces[surfaceIndex(*room, "yellow wall")].patches, 704u);
    EXPECT_EQ(room->surfaces[surfaceIndex(*room, "floor")].patches, 445u * 16);
    EXPECT_EQ(room->surfaces[surfaceIndex(*room, "ceiling")].patches, 445u * 16);
    EXPECT_EQ(room->surfaces.size(), 4u);
    EXPECT_NEAR(totalArea(*room), 24736 * 0.1875 * 0.1875, 1e-3);
    for (const double area : room->patches.area) ASSERT_NEAR(area, 0.1875 * 0.1875, 1e-5);
    expectConsistent(*room);
  }
}

TEST(BuildRoom, PatchesOfASmallRoomAreNoShorterThanADecimetre) {
  TestGltf gltf = testing::boxRoom({3, 2.5, 2}, 0);
  EXPECT_NEAR(gltf.build()->patchSize, 0.1, 1e-9);
  RoomOptions options;
  options.patch = 0.07;  // but where that is asked for
  EXPECT_NEAR(gltf.build(options)->patchSize, 0.07, 1e-9);
}

TEST(BuildRoom, SitesLieOnTheirMountAndShineIntoTheRoom) {
  const auto room = eCorridor().build();
  ASSERT_TRUE(room);
  for (const Site& site : room->sites) {
    EXPECT_NEAR(site.position.y, 3, 1e-6);
    EXPECT_NEAR(site.normal.y, -1, 1e-9);
    EXPECT_NEAR(dot(site.axis, site.normal), 0, 1e-9);
    EXPECT_EQ(site.size, 0.75);
    EXPECT_NEAR(std::fmod(site.position.x, 0.75), 0.375, 1e-5);
    EXPECT_NEAR(std::fmod(site.position.z, 0.75), 0.375, 1e-5);
  }
}

TEST(BuildRoom, TriangulationDoesNotMatter) {
  RoomOptions options;
  options.patch = 0.21;
  const auto plain = boxRoom({4.1, 2.9, 5.3}, 0.5).build(options),
             fine = boxRoom({4.1, 2.9, 5.3}, 0.5, 7).build(options);
  ASSERT_TRUE(plain && fine);
  EXPECT_EQ(plain->patches.count, fine->patches.count);
  EXPECT_EQ(plain->sites.size(), fine->sites.size());
  for (std::uint32_t p = 0; p < plain->patches.count; ++p) {
    ASSERT_NEAR(plain->patches.area[p], fine->patches.area[p], 1e-5);
    ASSERT_LT(length(plain->patches.center[p] - fine->patches.center[p]), 1e-4);
  }
  expectConsistent(*fine);
}

TEST(BuildRoom, JunctionsAndSliversDoNotMatter) {
  // One wall of two halves, cut differently: vertices of one lie on edges of the other; plus a needle without
  // area.
  TestGltf gltf = boxRoom({4, 3, 5}, 1);
  TestMesh mesh;
  mesh.quad({}, {0, 0, 5}, {1.7, 0, 0}, 3, 1);
  mesh.quad({1.7, 0, 0}, {0, 0, 5}, {2.3, 0, 0}, 7, 2);
  mesh.triangle({0, 0, 0}, {4, 0, 0}, {2, 0, 1e-7});
  gltf.glb.json["meshes"][0]["primitives"][0] = gltf.primitive(mesh, 0);
  RoomOptions options;
  options.patch = 0.25;
  const auto room = gltf.build(options), plain = boxRoom({4, 3, 5}, 1).build(options);
  ASSERT_TRUE(room && plain);
  EXPECT_EQ(room->surfaces[0].patches, 16u * 20);
  EXPECT_EQ(room->patches.count, plain->patches.count);
  EXPECT_THAT(allWarnings(room->warnings), HasSubstr("triangles without area are left out: 1"));
}

TEST(BuildRoom, RotationMirrorAndInstancingDoNotMatter) {
  RoomOptions options;
  options.patch = 0.21;
  const auto plain = boxRoom({4.1, 2.9, 5.3}, 0.5).build(options);
  ASSERT_TRUE(plain);
  const double s = std::sin(0.35), c = std::cos(0.35);
  for (const ordered_json& change :
       {ordered_json{{"rotation", {0, s, 0, c}}}, ordered_json{{"scale", {-1, 1, 1}}},
        ordered_json{{"scale", {-1, 1, -1}}},
        ordered_json{{"matrix", {0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 7, 8, 9, 1}}}}) {
    TestGltf gltf = boxRoom({4.1, 2.9, 5.3}, 0.5);
    for (auto& node : gltf.glb.json["nodes"])
      for (const auto& [key, value] : change.items()) node[key] = value;
    const auto room = gltf.build(options);
    ASSERT_TRUE(room) << room.error().message;
    EXPECT_EQ(room->patches.count, plain->patches.count) << change.dump();
    EXPECT_EQ(room->sites.size(), plain->sites.size()) << change.dump();
    EXPECT_NEAR(totalArea(*room), totalArea(*plain), 1e-3);
    EXPECT_LT(room->sites[0].normal.y, -0.99);  // the fronts still face the room
    EXPECT_GT(room->patches.normal[0].y, 0.99);
  }
}

TEST(BuildRoom, OneMeshBecomesFloorCeilingAndWalls) {
  TestGltf gltf;
  TestMesh mesh;
  mesh.box({}, {4, 3, 5}, true, 2);
  mesh.box({1, 0.001, 1}, {0.2, 0.4, 0.2}, false);
  gltf.node("room", gltf.mesh(mesh, gltf.material("paint", 0.5)));
  const auto room = gltf.build();
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_THAT(surfaceNames(*room),
              UnorderedElementsAre("room/floor", "room/ceiling", "room/wall 1", "room/wall 2", "room/wall 3",
                                   "room/wall 4", "room/rest"));
  const auto areaOf = [&](const char* name) {
    double area = 0;
    for (std::uint32_t p = 0; p < room->patches.rows(); ++p)
      if (static_cast<int>(room->patches.surface[p]) == surfaceIndex(*room, name))
        area += room->patches.area[p];
    return area;
  };
  EXPECT_NEAR(areaOf("room/floor"), 20, 1e-4);
  EXPECT_NEAR(areaOf("room/rest"), 4 * 0.08 + 2 * 0.04, 1e-4);
  EXPECT_THAT(allWarnings(room->warnings), HasSubstr("proposed to hang on 'room/ceiling'"));
  expectConsistent(*room);
}

TEST(BuildRoom, NamesFollowNodesMaterialsAndExtras) {
  TestGltf gltf = boxRoom({4, 3, 5}, 1);
  TestMesh low, high;
  low.quad({1, 0.5, 1}, {0, 0, 1}, {1, 0, 0}), high.quad({1, 1, 1}, {0, 0, 1}, {1, 0, 0});
  const int oak = gltf.material("oak", 0.3), steel = gltf.material("steel", 0.4);
  gltf.node("shelf", gltf.mesh(ordered_json::array({gltf.primitive(low, oak), gltf.primitive(high, steel)})));
  gltf.node("floor", gltf.mesh(low, oak));
  gltf.node("a", gltf.mesh(high, oak), TestGltf::extras({{"surface", "desks"}, {"reflectance", 0.25}}));
  gltf.node("b", gltf.mesh(low, steel), TestGltf::extras({{"surface", "desks"}, {"reflectance", 0.25}}));
  for (int i = 0; i < 4; ++i) gltf.glb.json["nodes"][6 + i]["translation"] = {i * 0.01, i * 0.03, 0};
  const auto room = gltf.build();
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_THAT(surfaceNames(*room), UnorderedElementsAre("floor", "ceiling", "south", "north", "west", "east",
                                                        "shelf/oak", "shelf/steel", "floor 2", "desks"));
  EXPECT_NEAR(room->surfaces[surfaceIndex(*room, "desks")].reflectance, 0.25, 1e-6);
  EXPECT_NEAR(room->surfaces[surfaceIndex(*room, "shelf/steel")].reflectance, 0.4, 1e-6);
}

TEST(BuildRoom, ASheetHasTwoSidesASolidHasOne) {
  TestGltf gltf = boxRoom({4, 3, 5}, 1);
  const int both = gltf.material("both", 0.4, {{"doubleSided", true}});
  TestMesh sheet, solid;
  sheet.quad({1, 1, 1}, {0, 0, 2}, {1, 0, 0});
  solid.box({2.5, 0.5, 1}, {1, 0.5, 1}, false);
  gltf.node("table", gltf.mesh(sheet, both)), gltf.node("chest", gltf.mesh(solid, both));
  const auto room = gltf.build();
  ASSERT_TRUE(room) << room.error().message;
  ASSERT_GE(surfaceIndex(*room, "table (back)"), 0);
  EXPECT_EQ(surfaceIndex(*room, "chest (back)"), -1);
  EXPECT_EQ(room->surfaces[surfaceIndex(*room, "table")].patches,
            room->surfaces[surfaceIndex(*room, "table (back)")].patches);
  const auto table = std::find_if(room->triangles.begin(), room->triangles.end(),
                                  [](const RoomTriangle& t) { return t.backChart != kNone; });
  ASSERT_NE(table, room->triangles.end());
  const auto index = static_cast<std::uint32_t>(table - room->triangles.begin());
  const Vec3 point{1.2, 1, 1.3};
  const std::uint32_t front = room->patchAt(index, false, point), back = room->patchAt(index, true, point);
  ASSERT_LT(front, room->patches.count);
  ASSERT_LT(back, room->patches.count);
  EXPECT_NEAR(room->patches.normal[front].y, 1, 1e-9);
  EXPECT_NEAR(room->patches.normal[back].y, -1, 1e-9);
  EXPECT_LT(length(room->patches.center[front] - room->patches.center[back]), 1e-6);
}

TEST(BuildRoom, EqualTrianglesAreOneOrAFrontAndABack) {
  TestGltf gltf = boxRoom({4, 3, 5}, 1);
  TestMesh twice, turned;
  twice.quad({1, 1, 1}, {0, 0, 2}, {1, 0, 0}), twice.quad({1, 1, 1}, {0, 0, 2}, {1, 0, 0});
  gltf.node("rug", gltf.mesh(twice));
  turned.triangle({1, 2, 1}, {2, 2, 1}, {1, 2, 2}), turned.triangle({1, 2, 1}, {1, 2, 2}, {2, 2, 1});
  gltf.node("sail", gltf.mesh(turned));
  const auto room = gltf.build();
  ASSERT_TRUE(room);
  EXPECT_EQ(room->triangles.size(), 12u + 2 + 1);
  EXPECT_THAT(allWarnings(room->warnings), HasSubstr("triangles that repeat others are left out: 2"));
  EXPECT_NEAR(room->surfaces[surfaceIndex(*room, "rug")].area, 2, 1e-5);
  EXPECT_NEAR(room->surfaces[surfaceIndex(*room, "sail")].area, 1, 1e-5);
}

TEST(BuildRoom, MeasuringPlanesReceiveOnly) {
  TestGltf gltf = boxRoom({4, 3, 5}, 1);
  TestMesh plane;
  plane.quad({0.5, 0.75, 0.5}, {3, 0, 0}, {0, 0, 4});  // faces down: it is turned up
  gltf.node("working plane", gltf.mesh(plane), TestGltf::extras({{"measure", true}}));
  gltf.node("second", gltf.mesh(plane), {{"translation", {0, 0.1, 0}}});
  RoomOptions options;
  options.patch = 0.25;
  options.measures = {"second"};
  const auto room = gltf.build(options);
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_EQ(room->triangles.size(), 12u);
  EXPECT_EQ(room->patches.rows() - room->patches.count, 2u * 12 * 16);
  for (std::uint32_t p = room->patches.count; p < room->patches.rows(); ++p) {
    ASSERT_NEAR(room->patches.normal[p].y, 1, 1e-9);
    ASSERT_EQ(room->patches.reflectance[p], 0);
    ASSERT_TRUE(room->surfaces[room->patches.surface[p]].measuring);
  }
  options.measures = {"workin plane"};
  EXPECT_THAT(refusal(gltf, options), HasSubstr("'working plane'"));
  expectConsistent(*room);
}

TEST(BuildRoom, AMeasuringPlaneKeepsTheBorderThatAllItsNodesHave) {
  TestGltf gltf = boxRoom({4, 3, 5}, 1);
  TestMesh near, far, plane, wrong;
  near.quad({0.5, 0.75, 0.5}, {0, 0, 1}, {3, 0, 0}), far.quad({0.5, 0.75, 3.5}, {0, 0, 1}, {3, 0, 0});
  plane.quad({0.5, 1, 0.5}, {0, 0, 1}, {3, 0, 0}), wrong.quad({0.5, 1, 3.5}, {0, 0, 1}, {3, 0, 0});
  const auto marks = [](const char* surface, double border) {
    return TestGltf::extras({{"measure", true}, {"surface", surface}, {"border", border}});
  };
  gltf.node("near", gltf.mesh(near), marks("task", 0.5));
  gltf.node("far", gltf.mesh(far), marks("task", 0.3));
  gltf.node("plane", gltf.mesh(plane), TestGltf::extras({{"measure", true}}));
  gltf.node("wrong", gltf.mesh(wrong), TestGltf::extras({{"measure", true}, {"border", -1}}));
  const auto room = gltf.build();
  ASSERT_TRUE(room) << room.error().message;
  for (const char* name : {"task", "plane", "wrong"}) ASSERT_GE(surfaceIndex(*room, name), 0) << name;
  EXPECT_EQ(room->surfaces[surfaceIndex(*room, "task")].border, 0.3);
  EXPECT_EQ(room->surfaces[surfaceIndex(*room, "plane")].border, 0);
  EXPECT_EQ(room->surfaces[surfaceIndex(*room, "wrong")].border, 0);
  EXPECT_THAT(allWarnings(room->warnings), HasSubstr("extras.fiatlux.border is ignored"));
}

TEST(BuildRoom, AMeasuringPlaneThatIsTooFineIsRefusedBeforeItIsCut) {
  TestGltf gltf = boxRoom({4, 3, 5}, 1);
  TestMesh plane;
  plane.quad({-250, 0.75, -250}, {0, 0, 500}, {500, 0, 0});
  gltf.node("working plane", gltf.mesh(plane), TestGltf::extras({{"measure", true}}));
  RoomOptions options;
  options.patch = 0.25;
  options.memory = 0.05;
  EXPECT_THAT(refusal(gltf, options), HasSubstr("patches of 0.25 m need 4000000 grid cells"));
}

TEST(BuildRoom, MountsByNameAndWhatHappensWithoutRoom) {
  TestGltf gltf = boxRoom({4, 3, 5}, 0);
  RoomOptions options;
  options.mounts = {"north"};
  options.siteSpacing = 0.9;
  options.siteSize = 0.2;
  const auto room = gltf.build(options);
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_EQ(room->sites.size(), 4u * 3);
  for (const Site& site : room->sites) EXPECT_NEAR(site.normal.z, -1, 1e-6);
  EXPECT_EQ(room->sites[0].size, 0.2);
  options.mounts = {"nroth"};
  EXPECT_THAT(refusal(gltf, options), HasSubstr("the closest are 'north'"));
  options.mounts = {"north"};
  options.siteSpacing = options.siteSize = 9;
  EXPECT_THAT(refusal(gltf, options), HasSubstr("--site-spacing"));
  options.requireSites = false;
  EXPECT_TRUE(gltf.build(options));
}

TEST(BuildRoom, AMountMaySayHowLargeItsLuminairesAre) {
  TestGltf gltf = boxRoom({4, 3, 5}, 1);
  for (auto& node : gltf.glb.json["nodes"])
    if (node.contains("extras")) node["extras"]["fiatlux"]["siteSize"] = 0.25;
  const auto room = gltf.build();
  ASSERT_TRUE(room) << room.error().message;
  ASSERT_EQ(room->sites.size(), 4u * 5);
  for (const Site& site : room->sites) EXPECT_EQ(site.size, 0.25);
  RoomOptions options;
  options.siteSize = 0.5;
  EXPECT_EQ(gltf.build(options)->sites[0].size, 0.5);
}

TEST(BuildRoom, PendantsHangBelowTheirMount) {
  RoomOptions options;
  options.mounts = {"north"};
  options.siteSpacing = 0.9;
  options.siteSize = 0.2;
  TestGltf gltf = boxRoom({4, 3, 5}, 0);
  const auto plain = gltf.build(options);
  options.drop = 0.75;
  const auto lowered = gltf.build(options);
  ASSERT_TRUE(plain && lowered);
  ASSERT_EQ(lowered->sites.size(), plain->sites.size());
  for (std::size_t j = 0; j < plain->sites.size(); ++j) {
    const Vec3 apart = lowered->sites[j].position - plain->sites[j].position;
    EXPECT_NEAR(length(apart - 0.75 * plain->sites[j].normal), 0, 1e-9);
  }
  // What stands in the way of some of them.
  TestMesh block;
  block.box({0, 0, 4.3}, {2, 3, 0.3}, false);
  gltf.node("block", gltf.mesh(block));
  const auto fewer = gltf.build(options);
  ASSERT_TRUE(fewer) << fewer.error().message;
  EXPECT_LT(fewer->sites.size(), plain->sites.size());
  EXPECT_THAT(allWarnings(fewer->warnings), HasSubstr("something is less than 0.75 m below them"));
}

TEST(BuildRoom, WhatItsAuthorCallsACeilingIsProposedFirst) {
  // A lowered ceiling within a shell whose own upper side is larger and looks like a ceiling.
  TestGltf gltf;
  TestMesh shell, lowered;
  shell.box({}, {6, 4, 6}, true), lowered.quad({1, 3, 1}, {4, 0, 0}, {0, 0, 4});
  gltf.node("shell", gltf.mesh(shell, gltf.material("paint", 0.5)));
  const int panels = gltf.material("Ceiling panels", 0.7);
  gltf.node("sheet", gltf.mesh(lowered, panels));
  const auto room = gltf.build();
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_THAT(allWarnings(room->warnings), HasSubstr("proposed to hang on 'sheet'"));
  gltf.glb.json["materials"][panels]["name"] = "panels";
  EXPECT_THAT(allWarnings(gltf.build()->warnings), HasSubstr("proposed to hang on 'shell/ceiling'"));
}

TEST(BuildRoom, TooMuchIsRefusedBeforeItIsMade) {
  TestGltf gltf = boxRoom({4, 3, 5}, 1);
  RoomOptions options;
  options.patch = 1e-4;
  EXPECT_THAT(refusal(gltf, options), HasSubstr("--patch"));
  options.patch = 0.012;
  EXPECT_THAT(refusal(gltf, options), HasSubstr("GB, and --memory allows 4"));
  options.patch = 0.25;
  options.siteSpacing = 0.002;
  EXPECT_THAT(refusal(gltf, options), HasSubstr("--site-spacing"));
}

TEST(BuildRoom, WrongUnitsAreGuessed) {
  TestGltf gltf = boxRoom({400, 300, 500}, 0);
  EXPECT_THAT(allWarnings(gltf.build()->warnings), HasSubstr("--scale 0.01"));
  gltf = boxRoom({0.04, 0.03, 0.05}, 0);
  RoomOptions options;
  options.patch = 0.01, options.siteSpacing = 0.01;
  EXPECT_THAT(allWarnings(gltf.build(options)->warnings), HasSubstr("only 0.05 m wide"));
}

TEST(BuildRoom, GlassIsNoWall) {
  TestGltf gltf = boxRoom({4, 3, 5}, 1);
  TestMesh pane;
  pane.quad({1, 1, 1}, {1, 0, 0}, {0, 1, 0});
  gltf.node("pane", gltf.mesh(pane, gltf.material("glass", 0.9, {{"alphaMode", "BLEND"}})));
  const auto room = gltf.build();
  ASSERT_TRUE(room);
  EXPECT_EQ(room->triangles.size(), 12u);
  EXPECT_THAT(allWarnings(room->warnings), HasSubstr("material 'glass' is transparent"));
}

TEST(BuildRoom, ABallIsOneSurfaceOfFewPatches) {
  TestGltf gltf = boxRoom({4, 3, 5}, 1);
  TestMesh ball;
  constexpr int kSteps = 96;  // 18 000 triangles
  const auto at = [](int i, int j) {
    const double a = M_PI * i / kSteps, b = 2 * M_PI * j / kSteps;
    return Vec3{2 + 0.5 * std::sin(a) * std::cos(b), 1 + 0.5 * std::cos(a),
                2 - 0.5 * std::sin(a) * std::sin(b)};
  };
  for (int i = 0; i < kSteps; ++i)
    for (int j = 0; j < kSteps; ++j) {
      ball.triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      ball.triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  gltf.node("ball", gltf.mesh(ball));
  RoomOptions options;
  options.patch = 0.2;
  const auto room = gltf.build(options);
  ASSERT_TRUE(room) << room.error().message;
  const Surface& surface = room->surfaces[surfaceIndex(*room, "ball")];
  EXPECT_NEAR(surface.area, M_PI, 0.01);
  EXPECT_LT(surface.patches, 250u);  // 79 patches' area, and the rims of the charts
  EXPECT_GT(surface.patches, 60u);
  EXPECT_EQ(surfaceIndex(*room, "ball/rest"), -1);
  expectConsistent(*room);
}

}  // namespace
}  // namespace fiatlux
