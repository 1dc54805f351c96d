// What is said of surfaces before anything is computed, and what those without a material reflect (survey,
// plain_reflectance).
#include "precompute/geometry/survey.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/precompute/geometry/trap_rooms.h"

namespace fiatlux {
namespace {

using testing::allWarnings;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::surfaceIndex;
using testing::TestGltf;
using testing::TestMesh;
using Use = SurveyedSurface::Use;
using Facing = SurveyedSurface::Facing;

TEST(Survey, SaysWhatSurfacesAreGoodFor) {
  testing::TrapRoom made = testing::noMaterials();
  TestMesh plane;
  plane.quad({2, 0.8, 2}, {0, 0, 2}, {2, 0, 0});
  made.gltf.node("task", made.gltf.mesh(plane), TestGltf::extras({{"measure", true}}));
  const auto source = made.gltf.read();
  const auto survey = surveyRoom(*source, {});
  ASSERT_TRUE(survey) << survey.error().message;
  const auto surface = [&](const std::string& name) {
    const auto found = std::find_if(survey->surfaces.begin(), survey->surfaces.end(),
                                    [&](const SurveyedSurface& s) { return s.name == name; });
    EXPECT_NE(found, survey->surfaces.end()) << name;
    return found == survey->surfaces.end() ? SurveyedSurface{} : *found;
  };
  EXPECT_EQ(survey->surfaces[0].area, 30);
  const SurveyedSurface ceiling = surface("room/ceiling"), floor = surface("room/floor"),
                        wall = surface("room/wall 1");
  EXPECT_EQ(ceiling.use, Use::kMount);
  EXPECT_EQ(ceiling.facing, Facing::kDown);
  EXPECT_NEAR(ceiling.low, 2.8, 1e-5);
  EXPECT_EQ(floor.use, Use::kFloor);
  EXPECT_EQ(floor.facing, Facing::kUp);
  EXPECT_EQ(floor.tilt, 0);
  EXPECT_EQ(wall.use, Use::kNone);
  EXPECT_EQ(wall.facing, Facing::kSideways);
  EXPECT_NEAR(wall.tilt, 90, 1e-6);
  EXPECT_EQ(surface("table").facing, Facing::kAllWays);
  EXPECT_EQ(surface("task").use, Use::kMeasuringPlane);
  EXPECT_THAT(survey->warnings[0], HasSubstr("proposed to hang on 'room/ceiling'"));
  EXPECT_NEAR(survey->size.y, 2.8, 1e-5);
  EXPECT_EQ(survey->lost, 0);
}

TEST(Survey, ForeseesTheWork) {
  TestGltf gltf = testing::boxRoom({4, 3, 5}, 1);
  const auto source = gltf.read();
  RoomOptions options;
  options.patch = 0.5, options.plane = 0.75, options.planeRim = 0.5;
  const auto survey = surveyRoom(*source, options);
  ASSERT_TRUE(survey) << survey.error().message;
  EXPECT_EQ(survey->patch, 0.5);
  EXPECT_NEAR(survey->rows, 94 / 0.25 + 12 / 0.25, 1);  // its sides, and the plane of 3 x 4 m
  EXPECT_EQ(survey->sites, 20);
  EXPECT_EQ(survey->triangles, 12);
  EXPECT_EQ(survey->surfaces.back().name, "working plane");
  EXPECT_EQ(survey->surfaces.back().use, Use::kMeasuringPlane);

  options.siteSize = options.siteSpacing = 6;
  const auto none = surveyRoom(*source, options);
  ASSERT_TRUE(none) << none.error().message;
  EXPECT_EQ(none->sites, 0);
}

TEST(Survey, SaysWhatWouldBeLostBeforeItIs) {
  TestGltf gltf = testing::boxRoom({6, 2.8, 5}, 1);
  gltf.glb.json["scenes"][0]["nodes"] = {0, 1, 2};  // floor, ceiling and one wall
  const auto source = gltf.read();
  const auto survey = surveyRoom(*source, {});
  ASSERT_TRUE(survey) << survey.error().message;
  EXPECT_GT(survey->lost, 0.2);
  EXPECT_LT(survey->lost, 0.7);
  EXPECT_THAT(survey->warnings[0], HasSubstr("% of the light would be lost"));
}

TEST(Survey, WhatCountsAsLostIsWhatThePlacesShine) {
  // Storeys under slabs of which luminaires hang on the undersides alone, not on what looks to the sky.
  const auto source = testing::twoStoreys().gltf.read();
  RoomOptions options;
  for (const std::string& mount : {std::string("s1"), std::string("s2")}) {
    options.mounts = {mount};
    const auto survey = surveyRoom(*source, options);
    ASSERT_TRUE(survey) << survey.error().message;
    // About a fifth leaves by the windows. Of 64 rays some meet edges, which machines see differently.
    EXPECT_LT(survey->lost, 0.25);
    for (const SurveyedSurface& surface : survey->surfaces)
      if (surface.use == Use::kMount) EXPECT_EQ(surface.facing, Facing::kDown) << surface.name;
  }
}

TEST(PlainReflectance, PureWhiteIsNoMaterialYet) {
  TestGltf gltf;
  TestMesh mesh;
  mesh.box({}, {6, 2.8, 5}, true);
  gltf.node("room", gltf.mesh(mesh, gltf.material("Default", 1)));
  RoomOptions options;
  options.patch = 0.5;
  const auto room = gltf.build(options);
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_NEAR(room->surfaces[surfaceIndex(*room, "room/ceiling")].reflectance, 0.7, 1e-6);
  EXPECT_THAT(allWarnings(room->warnings), HasSubstr("1 mesh has no material but white"));
}

TEST(PlainReflectance, AMeasuringPlaneReflectsNothingAndNeedsNoMaterial) {
  TestGltf gltf = testing::boxRoom({4, 2.5, 4}, 1);
  TestMesh plane;
  plane.quad({1, 0.75, 1}, {0, 0, 2}, {2, 0, 0});
  gltf.node("plane 1", gltf.mesh(plane), TestGltf::extras({{"measure", true}}));
  RoomOptions options;
  options.patch = 0.5;
  const auto room = gltf.build(options);
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_THAT(allWarnings(room->warnings), Not(HasSubstr("no material")));
  EXPECT_THAT(room->assumptions, Not(HasSubstr("materials=roles")));
}

TEST(PlainReflectance, GoesByWhatASurfaceIs) {
  RoomOptions options;
  options.patch = 0.5;
  testing::TrapRoom made = testing::noMaterials();
  const auto room = made.gltf.build(options);
  ASSERT_TRUE(room) << room.error().message;
  for (const auto& [name, reflectance] : {std::pair("room/ceiling", 0.7), std::pair("room/wall 1", 0.5),
                                          std::pair("room/floor", 0.2), std::pair("table", 0.4)})
    EXPECT_NEAR(room->surfaces[surfaceIndex(*room, name)].reflectance, reflectance, 1e-6) << name;
  EXPECT_THAT(allWarnings(room->warnings), HasSubstr("2 meshes have no material"));
  EXPECT_THAT(allWarnings(room->warnings), Not(HasSubstr("reflects 1.00")));
  EXPECT_THAT(room->assumptions, HasSubstr(" materials=roles"));
  EXPECT_EQ(room->surfaces[room->floor].name, "room/floor");
}

}  // namespace
}  // namespace fiatlux
