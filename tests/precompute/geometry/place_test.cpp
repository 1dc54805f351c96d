// One room of a building alone (place, spaces, box_cut, lid): what stays of three rooms in a row, through how
// many doors, and what closes it.
#include "precompute/geometry/place.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "precompute/base/error.h"
#include "precompute/geometry/faces.h"
#include "precompute/geometry/source_bounds.h"
#include "tests/precompute/geometry/trap_rooms.h"

namespace fiatlux {
namespace {

using ::testing::HasSubstr;
using testing::TestMesh;
using testing::TrapRoom;
using Lid = PlaceOptions::Lid;

constexpr double kWide = 4, kDeep = 5, kTall = 2.6, kThick = 0.2;  // m, of each room and of what is between
constexpr double kDoor = 0.9, kWideDoor = 2, kDoorTop = 2;
const Vec3 kInFirst{2, 1, 2.5}, kInMiddle{6, 1, 2.5};

/// Rooms along x with doors between them, and a window without glass at the far end of the first; floor and
/// ceiling are one slab each.
SourceScene rooms(bool hasGlass = false, double doorWidth = kDoor, double thick = kThick) {
  TrapRoom made;
  if (hasGlass) {
    TestMesh pane;
    pane.quad({-thick / 2, 0.9, 2}, {0, 1, 0}, {0, 0, 1});
    made.gltf.node("pane", made.gltf.mesh(pane, made.gltf.material("glass", 0.8, {{"alphaMode", "BLEND"}})));
  }
  const double far = 3 * kWide + 2 * thick, door = 2;
  const auto across = [&](const std::string& name, double x, double from, double to, double low,
                          double high) {
    made.block(name + " before", {x, 0, 0}, {thick, kTall, from});
    made.block(name + " after", {x, 0, to}, {thick, kTall, kDeep - to});
    if (low > 0) made.block(name + " below", {x, 0, from}, {thick, low, to - from});
    made.block(name + " above", {x, high, from}, {thick, kTall - high, to - from});
  };
  made.block("floor", {-thick, -thick, -thick}, {far + 2 * thick, thick, kDeep + 2 * thick});
  made.block("ceiling", {-thick, kTall, -thick}, {far + 2 * thick, thick, kDeep + 2 * thick});
  made.block("north", {-thick, 0, -thick}, {far + 2 * thick, kTall, thick});
  made.block("south", {-thick, 0, kDeep}, {far + 2 * thick, kTall, thick});
  across("west", -thick, 2, 3, 0.9, 1.9);
  across("one", kWide, door, door + doorWidth, 0, kDoorTop);
  across("two", 2 * kWide + thick, door, door + doorWidth, 0, kDoorTop);
  made.block("east", {far, 0, 0}, {thick, kTall, kDeep});
  made.block("wardrobe", {kWide + thick + 1, 0, 0}, {1.5, 2.2, 0.6});
  return *made.gltf.read();
}

double areaOf(const SourceMesh& mesh) {
  double area = 0;
  for (const auto& t : mesh.triangles) area += length(areaVector(mesh.positions, t));
  return area;
}

const SourceMesh* meshCalled(const SourceScene& source, const std::string& name) {
  const auto found = std::find_if(source.meshes.begin(), source.meshes.end(),
                                  [&](const SourceMesh& mesh) { return mesh.node == name; });
  return found == source.meshes.end() ? nullptr : &*found;
}

TEST(Place, KeepsOneRoomAlone) {
  SourceScene source = rooms();
  EXPECT_THAT(keepPlace({kInFirst}, source), HasSubstr(": 1 of 3 rooms"));
  const Bounds bounds = boundsOf(source);
  EXPECT_NEAR(bounds.low.x, 0, 0.4);  // m: in the depth of the window
  EXPECT_NEAR(bounds.high.x, kWide, 0.4);
  EXPECT_NEAR(areaOf(*meshCalled(source, "floor")), kWide * kDeep, 0.15 * kWide * kDeep);
  EXPECT_EQ(meshCalled(source, "wardrobe"), nullptr);
  EXPECT_EQ(meshCalled(source, "east"), nullptr);
  EXPECT_EQ(meshCalled(source, "lid"), nullptr);
  RoomOptions options;
  options.patch = 0.25;
  const auto room = buildRoom(source, options);
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_GT(room->sites.size(), 0u);
  // The ceiling goes on over the walls, luminaires do not.
  for (const Site& site : room->sites) {
    const double half = 0.49 * site.size;
    EXPECT_GE(site.position.x - half, 0);
    EXPECT_LE(site.position.x + half, kWide);
    EXPECT_GE(site.position.z - half, 0);
    EXPECT_LE(site.position.z + half, kDeep);
  }
}

TEST(Place, SeesThroughOpenDoorsAsFarAsIsWished) {
  SourceScene one = rooms(), two = rooms();
  EXPECT_THAT(keepPlace({kInFirst, 1}, one), HasSubstr(": 2 of 3 rooms"));
  EXPECT_NEAR(boundsOf(one).high.x, 2 * kWide + kThick, 0.4);
  EXPECT_NE(meshCalled(one, "wardrobe"), nullptr);
  EXPECT_THAT(keepPlace({kInFirst, 2}, two), HasSubstr(": 3 of 3 rooms"));
  EXPECT_NE(meshCalled(two, "east"), nullptr);
}

TEST(Place, AWideOpeningBelowALintelIsADoor) {
  SourceScene source = rooms(false, kWideDoor);
  EXPECT_THAT(keepPlace({kInFirst}, source), HasSubstr(": 1 of 3 rooms"));
  EXPECT_NEAR(boundsOf(source).high.x, kWide, 0.4);
}

TEST(Place, ABeamPartsNothing) {
  TrapRoom made = testing::twoSided();
  made.block("beam", {2.9, 2.4, 0}, {0.2, 0.4, testing::kPlan.z});
  SourceScene source = *made.gltf.read();
  EXPECT_THAT(keepPlace({Vec3{1, 1, 2}}, source), HasSubstr(": 1 of 1 rooms"));

  // Nor one that is as low as a door, from wall to wall; one above a wide opening does.
  for (const double from : {0.0, 0.6}) {
    TrapRoom low = testing::twoSided();
    low.block("beam", {2.9, 2.0, 0}, {0.2, 0.8, testing::kPlan.z});
    if (from > 0) low.block("jamb", {2.9, 0, 0}, {0.2, 2.0, from});
    SourceScene beamed = *low.gltf.read();
    EXPECT_THAT(keepPlace({Vec3{1, 1, 2}}, beamed),
                HasSubstr(from > 0 ? ": 1 of 2 rooms" : ": 1 of 1 rooms"));
  }
}

TEST(Place, HasNoFarSidesOfItsWalls) {
  // Nor of thin ones, which a step of the air's cubes reaches through.
  for (const double thick : {kThick, 0.12, 0.08, 0.05}) {
    SourceScene source = rooms(false, kDoor, thick);
    keepPlace({kInFirst, 0, Lid::kWhite}, source);
    // The walls between end in the doorway, where the place ends; what looks into the next room is left out.
    const SourceMesh* wall = meshCalled(source, "one after");
    ASSERT_NE(wall, nullptr) << thick;
    double away = 0, toward = 0;  // m2, that look along x
    for (const auto& t : wall->triangles) {
      const double x = areaVector(wall->positions, t).x;
      (x > 0 ? away : toward) += std::abs(x);
    }
    EXPECT_EQ(away, 0) << thick;
    EXPECT_NEAR(toward, (kDeep - 2 - kDoor) * kTall, 1e-6) << thick;
  }
}

TEST(Place, AMountEndsAtItsWalls) {
  SourceScene source = rooms();
  for (SourceMesh& mesh : source.meshes)
    if (mesh.node == "ceiling") mesh.extras.mount = true;
  keepPlace({kInFirst}, source);
  RoomOptions options;
  options.patch = 0.5, options.siteSpacing = options.siteSize = 1;
  const auto room = buildRoom(source, options);
  ASSERT_TRUE(room) << room.error().message;
  ASSERT_GT(room->sites.size(), 0u);
  for (const Site& site : room->sites) {
    EXPECT_GE(site.position.x - 0.5, -1e-6);
    EXPECT_LE(site.position.x + 0.5, kWide + 1e-6);
  }
}

TEST(Place, ClosesItsOpeningsWithALid) {
  for (const Lid kind : {Lid::kDark, Lid::kWhite}) {
    SourceScene source = rooms();
    keepPlace({kInFirst, 0, kind}, source);
    const SourceMesh* lid = meshCalled(source, "lid");
    ASSERT_NE(lid, nullptr);
    const double hole = kDoor * kDoorTop + 1;  // m2: a door and the window
    EXPECT_GE(areaOf(*lid), hole);
    EXPECT_LE(areaOf(*lid), 1.5 * hole);
    EXPECT_EQ(source.materials[static_cast<std::size_t>(lid->material)].baseColor[0],
              kind == Lid::kDark ? 0 : 0.8);
    // It looks into the room.
    for (const auto& t : lid->triangles) {
      const Vec3 normal = areaVector(lid->positions, t);
      EXPECT_GT(dot(normal, kInFirst - lid->positions[t[0]]), 0);
    }
  }
}

TEST(Place, ClosesPanesToo) {
  for (const bool hasGlass : {false, true}) {
    SourceScene source = rooms(hasGlass);
    keepPlace({kInFirst, 0, Lid::kWhite}, source);
    EXPECT_EQ(meshCalled(source, "pane"), nullptr);
    const SourceMesh& lid = *meshCalled(source, "lid");
    double window = 0;  // m2, of the lid in the west
    for (const auto& t : lid.triangles) {
      const Vec3 vector = areaVector(lid.positions, t);
      if (lid.positions[t[0]].x > 0) continue;
      EXPECT_GT(vector.x, 0);
      window += vector.x;
    }
    EXPECT_NEAR(window, hasGlass ? 1 : 1.4, hasGlass ? 1e-6 : 0.4);
  }
  SourceScene open = rooms(true);
  keepPlace({kInFirst}, open);
  EXPECT_NE(meshCalled(open, "pane"), nullptr);
}

TEST(Place, ARoomWithoutACeilingIsNotOutdoors) {
  TrapRoom made = testing::noCeiling();
  SourceScene source = *made.gltf.read();
  EXPECT_THAT(keepPlace({Vec3{3, 1, 3}}, source), HasSubstr("1 of 1 rooms"));
}

TEST(Place, RefusesAPointInNoAir) {
  const auto refusal = [](const Vec3& point) {
    SourceScene source = rooms();
    try {
      keepPlace({point}, source);
    } catch (const CommandError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal(kInMiddle), "");
  EXPECT_THAT(refusal({kWide + kThick + 1.7, 1, -0.1}), HasSubstr("no air"));
}

TEST(Place, CutsWhatAVertexSays) {
  SourceScene source = rooms();
  for (SourceMesh& mesh : source.meshes) {
    mesh.normals.assign(mesh.positions.size(), {0, 1, 0});
    mesh.uv.clear();
    for (const Vec3& p : mesh.positions)
      mesh.uv.push_back({static_cast<float>(p.x), static_cast<float>(p.z)});
  }
  keepPlace({kInMiddle}, source);
  for (const SourceMesh& mesh : source.meshes) {
    ASSERT_EQ(mesh.uv.size(), mesh.positions.size());
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
      EXPECT_NEAR(mesh.uv[v][0], mesh.positions[v].x, 1e-5);
      EXPECT_NEAR(mesh.uv[v][1], mesh.positions[v].z, 1e-5);
    }
  }
}

}  // namespace
}  // namespace fiatlux
