// Which axis is up: every room that misleads is known for upright, and for lying on its back.
#include "precompute/geometry/up_guess.h"

#include <gtest/gtest.h>

#include "precompute/geometry/source_changes.h"
#include "tests/precompute/geometry/trap_rooms.h"

namespace fiatlux {
namespace {

using testing::TrapRoom;

/// As a program with z up writes it: a quarter turn back.
SourceScene lying(TrapRoom made) {
  SourceScene source = *made.gltf.read();
  for (int quarter = 0; quarter < 3; ++quarter) standUpright(source);
  return source;
}

TrapRoom boxOf(const Vec3& size) {
  TrapRoom room;
  testing::TestMesh mesh;
  mesh.box({}, size, true);
  room.add("room", mesh);
  return room;
}

struct Case {
  const char* name;
  TrapRoom room;
};

std::vector<Case> rooms() {
  return {{"hollow walls", testing::hollowWalls()},
          {"plenum", testing::plenum()},
          {"slab", testing::hollowSlab()},
          {"two storeys", testing::twoStoreys()},
          {"terrain", testing::terrain()},
          {"single mesh", testing::singleMesh()},
          {"no ceiling", testing::noCeiling()},
          {"inside out", testing::insideOut()},
          {"centimetres", testing::inUnits(100)},
          {"panels", testing::panels()},
          {"scan", testing::scan()},
          {"metres", testing::inUnits(1)}};
}

TEST(UpGuess, UprightRoomsStayAsTheyAre) {
  for (Case& each : rooms()) EXPECT_FALSE(looksZUp(*each.room.gltf.read(), 0)) << each.name;
  EXPECT_FALSE(looksZUp(*boxOf({30, 2.8, 2}).gltf.read(), 0));    // a corridor
  EXPECT_FALSE(looksZUp(*boxOf({20, 3.4, 2.6}).gltf.read(), 0));  // a taller one
  EXPECT_FALSE(looksZUp(*boxOf({40, 15, 20}).gltf.read(), 0));    // a hall
}

TEST(UpGuess, RoomsThatLieOnTheirBacksAreStoodUpright) {
  // Without a ceiling, or with one in many pieces above a slab, too little speaks for it.
  const auto isUnclear = [](const std::string& name) { return name == "no ceiling" || name == "panels"; };
  for (Case& each : rooms())
    EXPECT_EQ(looksZUp(lying(std::move(each.room)), 0), !isUnclear(each.name)) << each.name;
}

TEST(UpGuess, WhatStandsAndWhatIsCalledACeilingDecide) {
  TrapRoom shaft = boxOf({4, 12, 3});
  EXPECT_TRUE(looksZUp(*shaft.gltf.read(), 0));
  for (const double x : {0.5, 1.5, 2.5})
    shaft.block("chair " + std::to_string(x), {x, 0, 1}, {0.5, 0.9, 0.5});
  EXPECT_FALSE(looksZUp(*shaft.gltf.read(), 0));

  TrapRoom named = boxOf({4, 12, 3});
  named.block("Decke", {0, 11.9, 0}, {4, 0.1, 3});
  EXPECT_FALSE(looksZUp(*named.gltf.read(), 0));
  TrapRoom low = boxOf({5, 2.8, 4});  // too close to call, but for the name
  low.block("ceiling", {0, 2.7, 0}, {5, 0.1, 4});
  EXPECT_TRUE(looksZUp(lying(std::move(low)), 0));
}

}  // namespace
}  // namespace fiatlux
