// Every room that misleads (trap_rooms.h), from its bytes to a scene with nothing chosen: where luminaires
// are proposed to hang, which unit is guessed, how much is said of it, and whether the result is of use (exit
// status 0, else 3).
#include "tests/precompute/geometry/trap_rooms.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/precompute/pipeline/box_model.h"

namespace fiatlux {
namespace {

using testing::allWarnings;
using ::testing::HasSubstr;
using testing::TrapRoom;

constexpr std::size_t kTold = 5;  // remarks without --verbose

struct Trap {
  const char* name;
  TrapRoom room;
  const char* mount;        // as the remark on it says
  double scale = 1;         // metres per unit of the file
  std::size_t remarks = 0;  // that are told by default
  bool isOfUse = true;
};

std::vector<Trap> traps() {
  return {{"hollow walls", testing::hollowWalls(), "hang on 's1", 1, 2},
          {"plenum", testing::plenum(), "hang on 'panels'", 1, 5},
          {"slab", testing::hollowSlab(), "hang on 's1", 1, 5},
          {"no ceiling", testing::noCeiling(), "hang in a plane 2.7 m above 's0", 1, 5},
          {"inside out", testing::insideOut(), "hang on 'shell", 1, 3},
          {"centimetres", testing::inUnits(100), "hang on 'room/ceiling'", 0.01, 2},
          {"millimetres", testing::inUnits(1000), "hang on 'room/ceiling'", 0.001, 2},
          {"two storeys", testing::twoStoreys(), "hang on 's", 1, 5},
          {"terrain", testing::terrain(), "hang on 's1", 1, 4},
          {"single mesh", testing::singleMesh(), "hang on 'mesh/ceiling'", 1, 1},
          {"no materials", testing::noMaterials(), "hang on 'room/ceiling'", 1, 3},
          {"double-sided everything", testing::twoSided(), "hang on 's1", 1, 5}};
}

TEST(TrapRooms, AreUnderstoodWithNothingChosen) {
  SceneOptions options = testing::quickOptions();
  options.room.patch = 0.8;
  options.transport.rays = 16;
  options.transport.exchange = false;
  std::vector<Trap> all = traps();
  for (Trap& trap : all) {
    SCOPED_TRACE(trap.name);
    const ModelFile model{"trap.glb", trap.room.gltf.glb.bytes()};
    const auto opened = openRoom(model, options.room, testing::plainHost());
    ASSERT_TRUE(opened) << opened.error().message;
    EXPECT_EQ(opened->room.scale, trap.scale);
    const auto made = makeScene(model, options, testing::plainHost());
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_THAT(allWarnings(made->warnings), HasSubstr(std::string("proposed to ") + trap.mount));
    EXPECT_EQ(std::min(made->warnings.size(), kTold), trap.remarks) << allWarnings(made->warnings);
    EXPECT_EQ(made->report.useless.empty(), trap.isOfUse) << made->report.useless;
  }
}

}  // namespace
}  // namespace fiatlux
