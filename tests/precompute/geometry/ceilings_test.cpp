// Where luminaires hang in rooms that mislead (trap_rooms.h): proposals alone, nothing is lit (free_space
// and open_floor, too).
#include "precompute/geometry/ceilings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/precompute/geometry/trap_rooms.h"

namespace fiatlux {
namespace {

using testing::allWarnings;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::kPlan;
using testing::kSlab;
using testing::kStorey;
using ::testing::Not;
using testing::TestMesh;
using testing::TrapRoom;

Result<Room> coarse(TrapRoom room) {
  RoomOptions options;
  options.patch = 1;
  return room.gltf.build(options);
}

/// The heights at which sites hang, in centimetres.
std::set<long> heights(const Room& room) {
  std::set<long> heights;
  for (const Site& site : room.sites) heights.insert(std::lround(100 * site.position.y));
  return heights;
}

/// All sites shine down, clear of the walls, and there are enough to choose from.
void expectUseful(const Room& room) {
  EXPECT_GE(room.sites.size(), 30u);
  EXPECT_LE(room.sites.size(), 400u);
  for (const Site& site : room.sites) {
    ASSERT_LT(site.normal.y, -0.99);
    ASSERT_GT(site.position.x, 0);
    ASSERT_LT(site.position.x, kPlan.x);
    ASSERT_GT(site.position.z, 0);
    ASSERT_LT(site.position.z, kPlan.z);
  }
}

TEST(Ceilings, HangBelowTheCeilingAndNowhereElse) {
  const struct {
    const char* trap;
    TrapRoom room;
    const char* mount;
  } rooms[] = {{"hollow walls", testing::hollowWalls(), "'s1"},
               {"plenum", testing::plenum(), "'panels'"},
               {"slab", testing::hollowSlab(), "'s1"},
               {"terrain", testing::terrain(), "'s1"},
               {"single mesh", testing::singleMesh(), "'mesh/ceiling'"}};
  for (const auto& [trap, made, mount] : rooms) {
    SCOPED_TRACE(trap);
    const auto room = coarse(made);
    ASSERT_TRUE(room) << room.error().message;
    expectUseful(*room);
    EXPECT_THAT(heights(*room), ElementsAre(std::lround(100 * kStorey)));
    EXPECT_THAT(allWarnings(room->warnings), HasSubstr(std::string("proposed to hang on ") + mount));
    EXPECT_THAT(allWarnings(room->warnings), HasSubstr("2.8 m above the floor"));
  }
}

TEST(Ceilings, EveryStoreyHasItsOwn) {
  const auto room = coarse(testing::twoStoreys());
  ASSERT_TRUE(room) << room.error().message;
  expectUseful(*room);
  EXPECT_THAT(heights(*room),
              ElementsAre(std::lround(100 * kStorey), std::lround(100 * (2 * kStorey + kSlab))));
  EXPECT_THAT(allWarnings(room->warnings), HasSubstr(", of other storeys '"));
}

TEST(Ceilings, AreKnownByTheirNameInFiveLanguages) {
  for (const char* name : {"Ceiling_01", "Kellerdecke", "faux-plafond", "TECHO", "soffitto 2", "IfcCovering"})
    EXPECT_TRUE(saysCeiling(name)) << name;
  for (const char* name : {"ceiling lamp", "Deckenleuchte", "Plafonnier", "Ceiling Fan", "roof", ""})
    EXPECT_FALSE(saysCeiling(name)) << name;

  // What is named comes first, even below what looks more like a ceiling; a lamp of that name does not.
  TestMesh canopy;
  canopy.quad({1, 2.3, 1}, {2, 0, 0}, {0, 0, 2});
  for (const bool isNamed : {true, false}) {
    TrapRoom made = testing::singleMesh();
    made.add(isNamed ? "Techo bajo" : "Ceiling light", canopy);
    const auto room = coarse(made);
    ASSERT_TRUE(room) << room.error().message;
    EXPECT_EQ(heights(*room).count(280), isNamed ? 0u : 1u);
  }
}

TEST(Ceilings, AreReplacedByAPlaneWhereThereIsNone) {
  const auto room = coarse(testing::noCeiling());
  ASSERT_TRUE(room) << room.error().message;
  expectUseful(*room);
  EXPECT_THAT(heights(*room), ElementsAre(270));  // just below the top of the walls
  EXPECT_THAT(allWarnings(room->warnings),
              HasSubstr("nothing is a ceiling: luminaires are proposed to hang in "
                        "a plane 2.7 m above 's0"));
  for (const Site& site : room->sites)  // nor within the cupboard
    EXPECT_FALSE(site.position.x > 1 && site.position.x < 1.8 && site.position.z > 1 &&
                 site.position.z < 1.8);

  // The height that is asked for, there and where there is a ceiling.
  RoomOptions options;
  options.patch = 1;
  options.ceiling = 2.2;
  for (TrapRoom made : {testing::noCeiling(), testing::hollowWalls()}) {
    const auto asked = made.gltf.build(options);
    ASSERT_TRUE(asked) << asked.error().message;
    EXPECT_THAT(heights(*asked), ElementsAre(220));
    EXPECT_THAT(allWarnings(asked->warnings), Not(HasSubstr("proposed")));
    expectUseful(*asked);
  }
}

TEST(Ceilings, OfARoomThatIsInsideOutAreTurned) {
  const auto room = coarse(testing::insideOut());
  ASSERT_TRUE(room) << room.error().message;
  expectUseful(*room);
  EXPECT_THAT(heights(*room), ElementsAre(280));
  EXPECT_EQ(room->surfaces.size(), 6u);
  EXPECT_THAT(allWarnings(room->warnings), HasSubstr("taken as double-sided"));
}

TEST(Ceilings, AreKeptWhereOnlyTheWallsAreTurned) {
  const auto room = coarse(testing::halfTurned());
  ASSERT_TRUE(room) << room.error().message;
  expectUseful(*room);
  EXPECT_EQ(room->surfaces.size(), 6u);
  EXPECT_THAT(
      allWarnings(room->warnings),
      HasSubstr("61.6 m2 have one side, which looks away from the room they enclose, and are turned: "));
  EXPECT_THAT(room->assumptions, HasSubstr(" turned"));
  // Solid blocks look outward, too, and nobody sees their backs.
  for (TrapRoom made : {testing::terrain(), testing::twoStoreys(), testing::noCeiling()})
    EXPECT_THAT(allWarnings(coarse(std::move(made))->warnings), Not(HasSubstr("are turned")));
}

TEST(Ceilings, AreAskedForByPatternsAndMissedByMeaning) {
  TestMesh low, high;
  low.quad({0.5, 2.3, 1}, {2, 0, 0}, {0, 0, 2}), high.quad({3, 2.5, 1}, {2, 0, 0}, {0, 0, 2});
  TrapRoom made = testing::singleMesh();
  made.add("Decke 01", low), made.add("decke 02", high);
  RoomOptions options;
  options.patch = 1;
  options.mounts = {"Decke*"};
  const auto room = made.gltf.build(options);
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_THAT(heights(*room), ElementsAre(230, 250));
  options.mounts = {"ceiling"};
  const auto missed = made.gltf.build(options);
  ASSERT_FALSE(missed);
  EXPECT_THAT(missed.error().message, HasSubstr("'Decke 01'"));
}

TEST(Ceilings, WideOnesHaveNoMorePlacesThanOthers) {
  testing::TestGltf gltf = testing::boxRoom({80, 5, 60}, 0);
  RoomOptions options;
  options.patch = 4;
  const auto room = gltf.build(options);
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_GT(room->sites.size(), 250u);
  EXPECT_LE(room->sites.size(), 400u);
}

}  // namespace
}  // namespace fiatlux
