// Names of leaves and of inner nodes, "all", and what a misspelt one is answered with.
#include "precompute/files/surface_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace fiatlux {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Scene namedScene() {
  Scene scene;
  for (const char* name : {"desk/top", "desk/legs", "desk 2", "floor", "plane"}) {
    Surface surface;
    surface.name = name;
    surface.measuring = surface.name == "plane";
    scene.surfaces.push_back(surface);
  }
  return scene;
}

TEST(SurfaceNames, LeavesAndNodes) {
  const Scene scene = namedScene();
  EXPECT_THAT(surfacesNamed(scene, {"floor"}).value(), ElementsAre(3));
  EXPECT_THAT(surfacesNamed(scene, {"desk"}).value(), ElementsAre(0, 1)) << "not \"desk 2\"";
  EXPECT_THAT(surfacesNamed(scene, {"floor", "desk/legs", "floor"}).value(), ElementsAre(1, 3))
      << "sorted, once";
  EXPECT_THAT(surfacesNamed(scene, {"plane"}).value(), ElementsAre(4));
}

TEST(SurfaceNames, AllHasOneForm) {
  const Scene scene = namedScene();
  EXPECT_THAT(surfacesNamed(scene, {"all"}).value(), IsEmpty());
  EXPECT_THAT(surfacesNamed(scene, {"desk", "desk 2", "floor"}).value(), IsEmpty());
  EXPECT_THAT(surfacesNamed(scene, {"all", "plane"}).value(), ElementsAre(0, 1, 2, 3, 4));
}

TEST(SurfaceNames, AnUnknownOneIsAnsweredWithTheClosest) {
  const auto unknown = surfacesNamed(namedScene(), {"floor", "desk/leg"});
  ASSERT_FALSE(unknown);
  EXPECT_THAT(unknown.error().message,
              HasSubstr("no surface is called \"desk/leg\". The closest are \"desk/legs\""));
  EXPECT_FALSE(surfacesNamed(namedScene(), {"desk/"}));
  EXPECT_THAT(surfacesNamed(Scene{}, {"floor"}).error().message, HasSubstr("has none"));
}

}  // namespace
}  // namespace fiatlux
