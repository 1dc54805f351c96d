// Every room that misleads (trap_rooms.h), given to the command with nothing chosen: where luminaires are
// proposed to hang, which unit is guessed, how much is said of it, and the exit status: 0 where the result is
// of use, else 3.
#include "tests/precompute/geometry/trap_rooms.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/precompute/commands/command_run.h"
#include "tests/precompute/pipeline/box_model.h"

namespace fiatlux {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using testing::TrapRoom;

struct Trap {
  const char* name;
  TrapRoom room;
  const char* mount;        // as the remark on it says
  double scale = 1;         // metres per unit of the file
  std::size_t remarks = 0;  // that are told by default
  int status = 0;
};

std::vector<Trap> traps() {
  return {{"hollow walls", testing::hollowWalls(), "hang on 's1", 1, 2},
          {"plenum", testing::plenum(), "hang on 'panels'", 1, 3},
          {"slab", testing::hollowSlab(), "hang on 's1", 1, 3},
          {"no ceiling", testing::noCeiling(), "hang in a plane 2.7 m above 's0", 1, 3},
          {"inside out", testing::insideOut(), "hang on 'shell", 1, 3},
          {"half turned", testing::halfTurned(), "hang on 'level/ceiling'", 1, 2},
          {"centimetres", testing::inUnits(100), "hang on 'room/ceiling'", 0.01, 2},
          {"millimetres", testing::inUnits(1000), "hang on 'room/ceiling'", 0.001, 2},
          {"two storeys", testing::twoStoreys(), "hang on 's", 1, 2},
          {"terrain", testing::terrain(), "hang on 's1", 1, 2},
          {"single mesh", testing::singleMesh(), "hang on 'mesh/ceiling'", 1, 1},
          {"no materials", testing::noMaterials(), "hang on 'room/ceiling'", 1, 3},
          {"panels in a grid", testing::panels(), "hang on 'panels", 1, 2},
          {"scan", testing::scan(), "hang on 'mesh0/ceiling'", 1, 2},
          {"gable", testing::gable(), "hang in a plane 3 m above 'house/floor'", 1, 1},
          {"double-sided everything", testing::twoSided(), "hang on 's1", 1, 3}};
}

/// How many lines say it.
std::size_t linesWith(const std::string& text, const std::string& said) {
  std::size_t lines = 0;
  for (std::size_t at = text.find(said); at != std::string::npos; at = text.find(said, at + 1)) ++lines;
  return lines;
}

TEST(TrapRooms, AreUnderstoodWithNothingChosen) {
  const TemporaryFolder folder;
  std::vector<Trap> all = traps();
  for (Trap& trap : all) {
    SCOPED_TRACE(trap.name);
    const ModelFile model{"trap.glb", trap.room.gltf.glb.bytes()};
    const auto opened = openRoom(model, testing::quickOptions().room, testing::plainHost());
    ASSERT_TRUE(opened) << opened.error().message;
    EXPECT_EQ(opened->room.scale, trap.scale);
    writeTextFile(folder / model.name, {model.bytes.begin(), model.bytes.end()});
    const CommandRun run = runFiatlux(folder, "precompute trap.glb --patch 0.8 --rays 16 --no-exchange");
    EXPECT_EQ(run.status, trap.status) << run.err;
    EXPECT_THAT(run.err, HasSubstr(std::string("proposed to ") + trap.mount));
    EXPECT_EQ(linesWith(run.err, "warning: "), trap.remarks) << run.err;
  }
}

TEST(TrapRooms, LoseNoLightWithinTheirWalls) {
  const auto lines = [](TrapRoom made) {
    const ModelFile model{"trap.glb", made.gltf.glb.bytes()};
    return testing::allWarnings(
        openRoom(model, testing::quickOptions().room, testing::plainHost())->room.warnings);
  };
  // Walls of solid blocks, a slab over them.
  EXPECT_THAT(lines(testing::terrain()), Not(HasSubstr("backs, those of 'w")));
  EXPECT_THAT(lines(testing::twoStoreys()), Not(HasSubstr("swallowed")));
  // What is lost through openings comes first.
  const std::string open = lines(testing::noCeiling());
  EXPECT_THAT(open, Not(HasSubstr("'w1/wall 2' (")));
  // It is measured in light, and so much of it is told before all.
  EXPECT_EQ(open.find("the room is open: 2"), 0u);
}

/// One mesh around nothing; `size` in the model's units.
void writeEmptyRoom(const std::string& file, const Vec3& size) {
  TrapRoom made;
  testing::TestMesh mesh;
  mesh.box({}, size, true);
  made.add("room", mesh);
  const auto bytes = made.gltf.glb.bytes();
  writeTextFile(file, {bytes.begin(), bytes.end()});
}

TEST(TrapRooms, OneOnItsBackIsStoodUprightWhichCanBeRefused) {
  const TemporaryFolder folder;
  writeEmptyRoom(folder / "z.glb", {6, 5, 2.8});
  const CommandRun guessed = runFiatlux(folder, "surfaces z.glb");
  EXPECT_THAT(guessed.err,
              HasSubstr("with y up the model would be 5 m high: it is taken to have z up, 6 x 5 m "
                        "and 2.8 m high; --up y refuses that"));
  EXPECT_THAT(guessed.err, HasSubstr("hang on 'room/ceiling'"));
  const CommandRun refused = runFiatlux(folder, "surfaces z.glb --up y");
  EXPECT_THAT(refused.err, Not(HasSubstr("z up")));
  const CommandRun said = runFiatlux(folder, "surfaces z.glb --up z");
  EXPECT_EQ(said.out, guessed.out);
  EXPECT_THAT(said.err, Not(HasSubstr("taken to have")));
}

TEST(TrapRooms, OneInFeetIsAskedOfAndARoofIsACeiling) {
  const TemporaryFolder folder;
  writeEmptyRoom(folder / "feet.glb", {20, 9, 16});
  EXPECT_THAT(runFiatlux(folder, "surfaces feet.glb").err,
              HasSubstr("the ceiling is 9 m above the floor: is that so? in feet it would be 2.74 m: "
                        "--scale 0.3048"));
  EXPECT_THAT(runFiatlux(folder, "surfaces feet.glb --scale 0.3048").err, Not(HasSubstr("is that so")));
  for (const char* name : {"roof", "ceilling", "'Ceil*x'"})
    EXPECT_THAT(runFiatlux(folder, std::string("surfaces feet.glb --mount ") + name).err,
                HasSubstr("the closest are 'room/ceiling'"))
        << name;
}

}  // namespace
}  // namespace fiatlux
