// Colours -> reflectances: factors, textures with their wrap modes and transforms, vertex colours.
#include "precompute/gltf/reflectance.h"

#include <gtest/gtest.h>

#include "tests/precompute/gltf/gltf_builder.h"

namespace fiatlux {
namespace {

/// One square over uv [0, 1]^2 with a 2 x 1 texture: left black, right white (or another colour).
SourceScene texturedSquare(std::array<std::uint8_t, 3> right = {255, 255, 255}) {
  SourceScene scene;
  SourceImage image;
  image.width = 2, image.height = 1;
  image.rgba = {0, 0, 0, 255, right[0], right[1], right[2], 255};
  scene.images.push_back(image);
  SourceMaterial material;
  material.name = "paint";
  material.image = 0;
  scene.materials.push_back(material);
  SourceMesh mesh;
  mesh.node = "square", mesh.material = 0;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 0, -1}, {0, 0, -1}};
  mesh.uv = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.meshes.push_back(mesh);
  return scene;
}

TEST(Reflectance, IsTheLuminanceOfTheLinearFactor) {
  SourceScene scene = texturedSquare();
  scene.materials[0].image = -1;
  scene.materials[0].baseColor = {1, 0.5, 0.25, 1};
  const ReflectanceMap map(scene);
  EXPECT_TRUE(map.isConstant(0));
  EXPECT_NEAR(map.at(0, 0, {1, 0, 0}), 0.2126 + 0.5 * 0.7152 + 0.25 * 0.0722, 1e-12);
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

TEST(Reflectance, PatchesTakeTheMeanOfTheirTexels) {
  SourceScene scene = texturedSquare();
  RoomOptions options;
  options.requireSites = false;
  for (const double patch : {1.0, 0.5, 0.25}) {
    options.patch = patch;
    const auto room = buildRoom(scene, options);
    ASSERT_TRUE(room) << room.error().message;
    EXPECT_NEAR(room->surfaces[0].reflectance, 0.5, 0.03);
    for (std::uint32_t p = 0; p < room->patches.count; ++p) {
      const double expected = patch == 1.0 ? 0.5 : room->patches.center[p].x < 0.5 ? 0.0 : 0.95;
      EXPECT_NEAR(room->patches.reflectance[p], expected, patch == 1.0 ? 0.06 : 1e-6);
    }
  }
}

}  // namespace
}  // namespace fiatlux
