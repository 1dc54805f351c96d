// Names to leaves and back, with "all" in its one form.
#include "core/scene/surface_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fiatlux {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// "desk/top", "desk/legs/oak", "desktop", and a measuring plane.
Scene tree() {
  Scene scene;
  for (const char* name : {"desk/top", "desk/legs/oak", "desktop", "plane"}) {
    Surface surface;
    surface.name = name;
    scene.surfaces.push_back(surface);
  }
  scene.surfaces[3].measuring = true;
  return scene;
}

TEST(SurfaceNames, MeanLeavesNodesOrAll) {
  EXPECT_THAT(leavesNamed(tree(), "desk"), ElementsAre(0, 1));
  EXPECT_THAT(leavesNamed(tree(), "desk/legs"), ElementsAre(1));
  EXPECT_THAT(leavesNamed(tree(), "desktop"), ElementsAre(2));
  EXPECT_THAT(leavesNamed(tree(), "plane"), ElementsAre(3));
  EXPECT_THAT(leavesNamed(tree(), "all"), ElementsAre(0, 1, 2));
  EXPECT_THAT(leavesNamed(tree(), "des"), IsEmpty());
  EXPECT_THAT(knownSurfaceNames(tree()),
              ElementsAre("desk", "desk/legs", "desk/legs/oak", "desk/top", "desktop", "plane"));
}

TEST(SurfaceNames, AllHasOneForm) {
  EXPECT_THAT(setOfLeaves(tree(), {0, 1, 2}), IsEmpty());
  EXPECT_THAT(setOfLeaves(tree(), {0, 1}), ElementsAre(0, 1));
  EXPECT_THAT(setOfLeaves(tree(), {0, 1, 2, 3}), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(leavesOf(tree(), {}), ElementsAre(0, 1, 2));
  EXPECT_THAT(leavesOf(tree(), {3}), ElementsAre(3));
}

TEST(SurfaceNames, OfASetReadAsASum) {
  EXPECT_EQ(surfaceSetName(tree(), {}), "all");
  EXPECT_EQ(surfaceSetName(tree(), {0, 2}), "desk/top + desktop");
}

}  // namespace
}  // namespace fiatlux
