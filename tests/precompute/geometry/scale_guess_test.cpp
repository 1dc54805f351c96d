// Units of models (trap_rooms.h): guessed where sizes are absurd, and only there.
#include "precompute/geometry/scale_guess.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/precompute/geometry/trap_rooms.h"

namespace fiatlux {
namespace {

using ::testing::HasSubstr;

TEST(ScaleGuess, IsTheUnitThatMakesACeilingOfACeiling) {
  const struct {
    double perMetre, scale;
    const char* unit;
  } files[] = {{100, 0.01, "centimetres"},     {1000, 0.001, "millimetres"},
               {1 / 0.0254, 0.0254, "inches"}, {1, 1, ""},
               {0.01, 100, "units of 100 m"},  {1 / 0.3048, 1, ""}};
  for (const auto& [perMetre, scale, unit] : files) {
    auto source = testing::inUnits(perMetre).gltf.read();
    ASSERT_TRUE(source) << source.error().message;
    EXPECT_EQ(guessedScale(*source), scale) << perMetre;
    if (scale == 1) continue;
    scaleBy(scale, *source);
    EXPECT_THAT(noteOfScale(scale, *source), HasSubstr(unit));
    EXPECT_THAT(noteOfScale(scale, *source), HasSubstr("6 x 5 m and 2.8 m high; --scale 1"));
    EXPECT_EQ(guessedScale(*source), 1);
  }
}

TEST(ScaleGuess, LeavesAloneWhatIsPossible) {
  // A hall, wide ground below a low house, what its author has measured in metres, and a plate.
  for (const Vec3& size : {Vec3{40, 14, 60}, Vec3{400, 6, 300}, Vec3{1.5, 1.2, 1.5}, Vec3{10, 0.2, 10}}) {
    const auto source = testing::boxRoom(size, 0).read();
    EXPECT_EQ(guessedScale(*source), 1) << size.x;
  }
  EXPECT_EQ(guessedScale(*testing::terrain().gltf.read()), 1);
  EXPECT_EQ(guessedScale(*testing::boxRoom({600, 280, 500}, 60).read()), 1);
}

}  // namespace
}  // namespace fiatlux
