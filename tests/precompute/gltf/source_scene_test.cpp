// Reading glTF: every way the format can say the same triangles (model, primitive, nodes, materials).
#include "precompute/gltf/source_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/precompute/gltf/gltf_builder.h"

namespace fiatlux {
namespace {

using testing::allWarnings;
using ::testing::HasSubstr;
using testing::ordered_json;
using testing::TestGltf;
using testing::TestMesh;

/// World-space triangles as text, to compare two ways of saying them.
std::vector<std::array<Vec3, 3>> trianglesOf(const SourceScene& scene) {
  std::vector<std::array<Vec3, 3>> all;
  for (const SourceMesh& mesh : scene.meshes)
    for (const auto& t : mesh.triangles)
      all.push_back({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]});
  return all;
}

Vec3 areaVectorOf(const SourceScene& scene) {
  Vec3 sum{};
  for (const auto& t : trianglesOf(scene)) sum += 0.5 * cross(t[1] - t[0], t[2] - t[0]);
  return sum;
}

TestMesh unitSquare() {
  TestMesh mesh;
  for (const Vec3& p : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{1, 1, 0}}) mesh.add(p);
  return mesh;
}

TEST(GltfFile, ListsStripsAndFansSayTheSame) {
  for (const int mode : {4, 5, 6})
    for (const bool indexed : {true, false}) {
      TestGltf gltf;
      TestMesh mesh = unitSquare();
      if (mode == 4) mesh.indices = {0, 1, 2, 2, 1, 3};
      if (mode == 5) mesh.indices = {0, 1, 2, 3};
      if (mode == 6) mesh.indices = {0, 1, 3, 2};
      if (!indexed) {
        TestMesh flat;
        for (const auto i : mesh.indices) flat.positions.push_back(mesh.positions[i]);
        mesh = flat;
      }
      ordered_json primitive = {{"attributes", {{"POSITION", gltf.positions(mesh)}}}, {"mode", mode}};
      if (indexed) primitive["indices"] = gltf.indices(mesh.indices);
      gltf.node("square", gltf.mesh(ordered_json::array({primitive})));
      const auto scene = gltf.read();
      ASSERT_TRUE(scene) << scene.error().message;
      EXPECT_EQ(trianglesOf(*scene).size(), 2u);
      EXPECT_NEAR(areaVectorOf(*scene).z, 1, 1e-6) << "mode " << mode;
    }
}

template <class T>
void expectQuantised(int componentType, bool normalized, double one) {
  TestGltf gltf;
  TestMesh mesh = unitSquare();
  mesh.indices = {0, 1, 2, 2, 1, 3};
  ordered_json primitive = gltf.primitive(mesh);
  std::vector<std::array<T, 4>> packed;
  for (const auto& p : mesh.positions) packed.push_back({T(p[0] * one), T(p[1] * one), T(p[2] * one), 0});
  const int view = gltf.glb.addView(packed.data(), packed.size() * sizeof packed[0], sizeof packed[0], 0);
  primitive["attributes"]["POSITION"] = gltf.glb.addAccessor(view, componentType, normalized, 4, "VEC3");
  gltf.glb.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  gltf.node("square", gltf.mesh(ordered_json::array({primitive})), {{"scale", {2, 3, 1}}});
  const auto scene = gltf.read();
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_NEAR(areaVectorOf(*scene).z, normalized ? 6 : 6 * one * one, 1e-4 * one * one) << componentType;
}

TEST(GltfFile, QuantisedPositions) {
  expectQuantised<std::int8_t>(5120, true, 127), expectQuantised<std::uint8_t>(5121, true, 255);
  expectQuantised<std::int16_t>(5122, true, 32767), expectQuantised<std::uint16_t>(5123, true, 65535);
  expectQuantised<std::int8_t>(5120, false, 5), expectQuantised<std::uint16_t>(5123, false, 7);
}

TEST(GltfFile, IndicesOfEveryWidth) {
  const auto check = [](auto zero, int type) {
    using T = decltype(zero);
    TestGltf gltf;
    TestMesh mesh = unitSquare();
    mesh.indices = {0, 1, 2};
    ordered_json primitive = gltf.primitive(mesh);
    const std::vector<T> indices{0, 1, 2, 2, 1, 3};
    primitive["indices"] =
        gltf.glb.addAccessor(gltf.glb.addView(indices.data(), 6 * sizeof(T), 0, 0), type, false, 6, "SCALAR");
    gltf.node("square", gltf.mesh(ordered_json::array({primitive})));
    const auto scene = gltf.read();
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_NEAR(areaVectorOf(*scene).z, 1, 1e-6);
  };
  check(std::uint8_t{}, 5121), check(std::uint16_t{}, 5123), check(std::uint32_t{}, 5125);
}

TEST(GltfFile, SparseChangesAreApplied) {
  TestGltf gltf;
  TestMesh mesh = unitSquare();
  mesh.indices = {0, 1, 2, 2, 1, 3};
  gltf.node("square", gltf.mesh(mesh));
  const std::uint8_t index[4] = {1, 3, 0, 0};
  const float values[6] = {5, 0, 0, 5, 1, 0};
  const int i = gltf.glb.addView(index, 2, 0, 0), v = gltf.glb.addView(values, 24, 0, 0);
  gltf.glb.json["accessors"][0]["sparse"] = {{"count", 2},
                                             {"indices", {{"bufferView", i}, {"componentType", 5121}}},
                                             {"values", {{"bufferView", v}}}};
  const auto scene = gltf.read();
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_NEAR(areaVectorOf(*scene).z, 5, 1e-6);
}

TEST(GltfFile, TransformsMultiplyDownTheTree) {
  TestGltf gltf;
  TestMesh mesh = unitSquare();
  mesh.indices = {0, 1, 2, 2, 1, 3};
  const int m = gltf.mesh(mesh);
  gltf.glb.json["nodes"] = {
      {{"children", {1}}, {"translation", {10, 0, 0}}, {"rotation", {0, 0.70710678, 0, 0.70710678}}},
      {{"children", {2}}, {"scale", {2, 2, 2}}},
      {{"name", "leaf"}, {"mesh", m}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1}}}};
  gltf.glb.json["scenes"][0]["nodes"] = {0};
  const auto scene = gltf.read(0.5);
  ASSERT_TRUE(scene) << scene.error().message;
  // (1, 0, 0) of the leaf -> (2, 0, 0) -> (4, 0, 0) -> turned to (0, 0, -4) -> (10, 0, -4) -> halved.
  const Vec3 p = trianglesOf(*scene)[0][1];
  EXPECT_LT(length(p - Vec3{5, 0, -2}), 1e-6);
  EXPECT_NEAR(areaVectorOf(*scene).x, 1, 1e-6);
  EXPECT_EQ(scene->meshes[0].node, "leaf");
}

TEST(GltfFile, MirrorsKeepTheirFronts) {
  TestGltf gltf;
  TestMesh mesh = unitSquare();
  mesh.indices = {0, 1, 2, 2, 1, 3};
  gltf.node("mirrored", gltf.mesh(mesh), {{"scale", {-1, 1, 1}}});
  EXPECT_NEAR(areaVectorOf(*gltf.read()).z, 1, 1e-6);
}

TEST(GltfFile, WhatIsIgnoredIsSaid) {
  TestGltf gltf;
  TestMesh mesh = unitSquare();
  mesh.indices = {0, 1, 2};
  gltf.node("lamp", gltf.mesh(mesh, gltf.material("glow", 0.5, {{"emissiveFactor", {1, 1, 0}}})),
            {{"skin", 0}});
  gltf.glb.json["skins"] = {{{"joints", {0}}}};
  gltf.glb.json["animations"] = {{{"channels", ordered_json::array()}, {"samplers", ordered_json::array()}}};
  const auto scene = gltf.read();
  ASSERT_TRUE(scene) << scene.error().message;
  const std::string warnings = allWarnings(scene->warnings);
  EXPECT_THAT(warnings, HasSubstr("do not shine"));
  EXPECT_THAT(warnings, HasSubstr("rest pose"));
  EXPECT_THAT(warnings, HasSubstr("skinned meshes"));
}

TEST(GltfFile, TheHashIsOfTheContent) {
  TestGltf gltf;
  TestMesh mesh = unitSquare();
  mesh.indices = {0, 1, 2};
  gltf.node("a", gltf.mesh(mesh));
  const std::string first = gltf.read()->hash;
  EXPECT_EQ(first.size(), 16u);
  EXPECT_EQ(gltf.read()->hash, first);
  gltf.glb.json["nodes"][0]["name"] = "b";
  EXPECT_NE(gltf.read()->hash, first);
}

}  // namespace
}  // namespace fiatlux
