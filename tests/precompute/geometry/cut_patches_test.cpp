// Patches cut out of charts, and their clusters: nothing of the area is lost, slivers join, small things
// share, textures are averaged.
#include "precompute/geometry/cut_patches.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "precompute/geometry/clusters.h"
#include "tests/precompute/geometry/charted.h"
#include "tests/precompute/gltf/textured_square.h"

namespace fiatlux {
namespace {

using testing::Charted;
using ::testing::HasSubstr;
using testing::TestGltf;
using testing::TestMesh;
using testing::texturedSquare;

Room cut(const SourceScene& source, double patch) {
  Charted made(source, patch);
  const ReflectanceMap reflectance(source);
  Room room;
  room.patchSize = patch;
  appendPatches(made.mesh, made.charts, patch, &reflectance, room);
  room.patches.count = room.patches.rows();
  return room;
}

Room cut(const TestMesh& mesh, double patch, double grey = 0.5) {
  TestGltf gltf;
  gltf.node("thing", gltf.mesh(mesh, gltf.material("grey", grey)));
  const auto scene = gltf.read();
  EXPECT_TRUE(scene);
  return cut(*scene, patch);
}

double areaOf(const Room& room) {
  return std::accumulate(room.patches.area.begin(), room.patches.area.end(), 0.0);
}

TEST(CutPatches, AWholeCellIsARectangleOfTwoTriangles) {
  TestMesh mesh;
  mesh.quad({}, {0, 0, 2}, {1, 0, 0}, 5, 3);
  const Room room = cut(mesh, 0.5);
  ASSERT_EQ(room.patches.rows(), 8u);
  for (std::uint32_t p = 0; p < 8; ++p) {
    EXPECT_NEAR(room.patches.area[p], 0.25, 1e-6);
    EXPECT_NEAR(room.patches.reflectance[p], 0.5, 1e-6);
    EXPECT_EQ(room.fragmentsOf(p).size(), 2u);
    EXPECT_NEAR(room.patches.normal[p].y, 1, 1e-9);
  }
  // Neighbours are the cells before: one row and one column have none.
  EXPECT_EQ(std::count(room.patches.left.begin(), room.patches.left.end(), kNone), 2);
  EXPECT_EQ(std::count(room.patches.up.begin(), room.patches.up.end(), kNone), 4);
}

TEST(CutPatches, NothingOfTheAreaIsLostAndSliversJoin) {
  TestMesh mesh;
  mesh.triangle({0, 0, 0}, {0, 0, 3}, {2.9, 0, 0.2});
  const Room room = cut(mesh, 0.25);
  EXPECT_NEAR(areaOf(room), 0.5 * 3 * 2.9, 1e-5);
  for (const double area : room.patches.area) EXPECT_GE(area, 0.04 * 0.25 * 0.25);
}

TEST(CutPatches, ManyCrumbsShareAFewPatches) {
  TestMesh mesh;
  mesh.quad({0, 0, 0}, {0, 0, 4}, {4, 0, 0});
  for (int i = 0; i < 100; ++i) mesh.box({1 + 0.01 * i, 0.5, 1}, {0.004, 0.004, 0.004}, false);
  const Room room = cut(mesh, 0.5);
  EXPECT_NEAR(areaOf(room), 16 + 100 * 6 * 0.004 * 0.004, 1e-4);
  EXPECT_LT(room.patches.rows(), 64u + 40u);
}

TEST(CutPatches, ReflectanceIsTheMeanOfTheTexels) {
  const SourceScene scene = texturedSquare();
  for (const double patch : {1.0, 0.5, 0.25}) {
    const Room room = cut(scene, patch);
    for (std::uint32_t p = 0; p < room.patches.count; ++p) {
      const double expected = patch == 1.0 ? 0.5 : room.patches.center[p].x < 0.5 ? 0.0 : 0.95;
      EXPECT_NEAR(room.patches.reflectance[p], expected, patch == 1.0 ? 0.06 : 1e-6);
    }
  }
}

TEST(CutPatches, WhatReflectsTooMuchIsClampedAndNamed) {
  TestMesh mesh;
  mesh.quad({}, {0, 0, 1}, {1, 0, 0});
  const Room room = cut(mesh, 0.5, 1);
  for (const float rho : room.patches.reflectance) EXPECT_FLOAT_EQ(rho, 0.95f);
  ASSERT_EQ(room.warnings.size(), 1u);
  EXPECT_THAT(room.warnings[0], HasSubstr("material 'grey' reflects 1.00 of the light: taken as 0.95"));
}

TEST(Clusters, AreBlocksOfCellsAndGrowWhereThereWouldBeTooMany) {
  TestMesh mesh;
  mesh.quad({}, {0, 0, 8}, {8, 0, 0});
  Room room = cut(mesh, 0.5);
  EXPECT_EQ(assignClusters(room, 4, 3000, false), 4u);
  EXPECT_EQ(room.patches.clusterCount, 16u);
  for (std::uint32_t c = 0; c < 16; ++c)
    EXPECT_EQ(std::count(room.patches.cluster.begin(), room.patches.cluster.end(), c), 16);
  EXPECT_EQ(assignClusters(room, 1, 64, false), 2u);
  EXPECT_EQ(room.patches.clusterCount, 64u);
  EXPECT_EQ(assignClusters(room, 1, 64, true), 1u);
  EXPECT_EQ(room.patches.clusterCount, 256u);
}

}  // namespace
}  // namespace fiatlux
