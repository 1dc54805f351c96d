// What a person says of a model: which way is up, and what its materials reflect (room_options).
#include "precompute/geometry/source_changes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "precompute/base/error.h"
#include "precompute/gltf/reflectance.h"

namespace fiatlux {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(SourceChanges, WhatStandsOnZIsStoodUpright) {
  SourceScene source;
  source.meshes.emplace_back();
  source.meshes[0].positions = {{1, 2, 3}};
  source.meshes[0].normals = {{0, 0, 1}};
  standUpright(source);
  EXPECT_EQ(length(source.meshes[0].positions[0] - Vec3{1, 3, -2}), 0);
  EXPECT_THAT(source.meshes[0].normals[0], ElementsAre(0, 1, 0));
}

TEST(SourceChanges, MaterialsAreRepaintedInTheirHueAndGreyWhereAPictureWas) {
  SourceScene source;
  source.materials.resize(3);
  source.materials[0].name = "brick", source.materials[0].baseColor = {0.5, 0.2, 0.1, 1};
  source.materials[1].name = "oak", source.materials[1].image = 0;
  source.materials[2].name = "red", source.materials[2].baseColor = {0.9, 0, 0, 1};
  source.meshes.resize(2);
  source.meshes[0].material = 0, source.meshes[0].extras.reflectance = 0.7;
  source.meshes[1].material = 1, source.meshes[1].extras.reflectance = 0.6;
  repaint({{"brick", 0.1}, {"red", 0.5}}, source);
  const auto& brick = source.materials[0].baseColor;
  EXPECT_NEAR(brick[0] / brick[1], 2.5, 1e-9);
  EXPECT_NEAR(luminanceOf(brick[0], brick[1], brick[2]), 0.1, 1e-9);
  EXPECT_THAT(source.materials[2].baseColor, ElementsAre(0.5, 0.5, 0.5, 1));  // no such red
  EXPECT_FALSE(source.meshes[0].extras.reflectance);
  EXPECT_EQ(source.meshes[1].extras.reflectance, 0.6);

  repaint({{"oak", 0.3}}, source);
  EXPECT_EQ(source.materials[1].image, -1);
  EXPECT_THAT(source.materials[1].baseColor, ElementsAre(0.3, 0.3, 0.3, 1));
  EXPECT_THROW(
      {
        try {
          repaint({{"brik", 0.3}}, source);
        } catch (const CommandError& error) {
          EXPECT_THAT(error.what(), HasSubstr("--reflectance 'brik': no material is called that"));
          EXPECT_THAT(error.what(), HasSubstr("'brick'"));
          throw;
        }
      },
      CommandError);
}

}  // namespace
}  // namespace fiatlux
