// Colours -> reflectances: factors, textures with their wrap modes and transforms, vertex colours.
#include "precompute/gltf/reflectance.h"

#include <gtest/gtest.h>

#include "tests/precompute/gltf/textured_square.h"

namespace fiatlux {
namespace {

using testing::texturedSquare;

TEST(Reflectance, IsTheLuminanceOfTheLinearFactor) {
  SourceScene scene = texturedSquare();
  scene.materials[0].image = -1;
  scene.materials[0].baseColor = {1, 0.5, 0.25, 1};
  const ReflectanceMap map(scene);
  EXPECT_TRUE(map.isConstant(0));
  EXPECT_NEAR(map.at(0, 0, {1, 0, 0}), 0.2126 + 0.5 * 0.7152 + 0.25 * 0.0722, 1e-12);
}

TEST(Reflectance, WhatIsSaidOfAMeshLeavesItsColourAlone) {
  SourceScene scene = texturedSquare();
  scene.materials[0].image = -1;
  scene.materials[0].baseColor = {1, 0.5, 0.25, 1};
  scene.meshes[0].extras.reflectance = 0.1;
  const ReflectanceMap map(scene);
  EXPECT_EQ(map.at(0, 0, {1, 0, 0}), 0.1);
  EXPECT_EQ(map.colorAt(0, 0, {1, 0, 0}), (std::array<double, 3>{1, 0.5, 0.25}));
}

TEST(Reflectance, TexturesAreDecodedFromSrgb) {
  const SourceScene scene = texturedSquare({188, 188, 188});
  const ReflectanceMap map(scene);
  EXPECT_FALSE(map.isConstant(0));
  EXPECT_NEAR(map.at(0, 0, {0.9, 0.1, 0}), 0, 1e-9);       // u = 0.1
  EXPECT_NEAR(map.at(0, 0, {0.2, 0.8, 0}), 0.5029, 1e-3);  // u = 0.8: sRGB 188 is half
}

TEST(Reflectance, WrapModesAndTransforms) {
  SourceScene scene = texturedSquare();
  const auto atU = [&](double u) { return ReflectanceMap(scene).at(0, 0, {1 - u, u, 0}); };
  EXPECT_EQ(atU(1.25), 0);
  EXPECT_EQ(atU(1.75), 1);
  EXPECT_EQ(atU(-0.25), 1);  // repeat
  scene.materials[0].wrapS = 33071;
  EXPECT_EQ(atU(1.25), 1);
  EXPECT_EQ(atU(-0.25), 0);  // clamp
  scene.materials[0].wrapS = 33648;
  EXPECT_EQ(atU(1.25), 1);
  EXPECT_EQ(atU(1.75), 0);
  EXPECT_EQ(atU(-0.25), 0);
  EXPECT_EQ(atU(1), 1);  // the very edge belongs to the texel beside it
  EXPECT_EQ(atU(-1), 1);
  EXPECT_EQ(atU(2), 0);  // mirror
  scene.materials[0].wrapS = 10497;
  scene.materials[0].uvTransform = {0.5, 0, 1, 1, 0};
  EXPECT_EQ(atU(0.25), 1);
  EXPECT_EQ(atU(0.75), 0);
  scene.materials[0].uvTransform = {0, 0, 2, 1, 0};
  EXPECT_EQ(atU(0.3), 1);
  EXPECT_EQ(atU(0.55), 0);
}

TEST(Reflectance, VertexColoursTint) {
  SourceScene scene = texturedSquare();
  scene.materials[0].image = -1;
  scene.meshes[0].colors = {{0, 0, 0, 1}, {1, 1, 1, 1}, {1, 1, 1, 1}, {0, 0, 0, 1}};
  EXPECT_NEAR(ReflectanceMap(scene).at(0, 0, {0.7, 0.3, 0}), 0.3, 1e-6);
}

}  // namespace
}  // namespace fiatlux
