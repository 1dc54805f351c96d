// Charts and what they are made of (faces, face_set, flat_regions, outline): planes and gently bent pieces,
// with a grid along their longest side.
#include "precompute/geometry/charts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/precompute/geometry/charted.h"

namespace fiatlux {
namespace {

using testing::Charted;
using testing::TestGltf;
using testing::TestMesh;

Charted chartedOf(const TestMesh& mesh, double patch) {
  TestGltf gltf;
  gltf.node("thing", gltf.mesh(mesh));
  const auto scene = gltf.read();
  EXPECT_TRUE(scene);
  return Charted(*scene, patch);
}

TEST(Charts, ARectangleIsOneFlatGridHoweverItIsCut) {
  for (const int cuts : {1, 2, 7}) {
    TestMesh mesh;
    mesh.quad({1, 0, 2}, {0, 0, 3}, {2, 0, 0}, cuts, cuts);
    const Charted made = chartedOf(mesh, 0.25);
    ASSERT_EQ(made.charts.size(), 1u) << cuts;
    const ChartDraft& draft = made.charts[0];
    EXPECT_TRUE(draft.flat);
    EXPECT_NEAR(draft.area, 6, 1e-6);
    EXPECT_EQ(draft.chart.columns, 12u);  // along the longest side
    EXPECT_EQ(draft.chart.rows, 8u);
    EXPECT_NEAR(draft.chart.cellU, 0.25, 1e-6);
    EXPECT_NEAR(std::abs(draft.chart.uAxis.z), 1, 1e-9);
    EXPECT_NEAR(dot(cross(draft.chart.uAxis, draft.chart.vAxis), draft.chart.normal), 1, 1e-9);
  }
}

TEST(Charts, ATJunctionDoesNotPartAPlane) {
  TestMesh mesh;
  mesh.quad({0, 0, 0}, {0, 0, 2}, {1, 0, 0});        // one long side
  mesh.quad({1, 0, 0}, {0, 0, 2}, {1, 0, 0}, 3, 1);  // meets three short ones
  const Charted made = chartedOf(mesh, 0.5);
  ASSERT_EQ(made.charts.size(), 1u);
  EXPECT_NEAR(made.charts[0].area, 4, 1e-6);
}

TEST(Charts, ABoxHasAChartASideAndAWideTubeGrowsRoundUpToItsCone) {
  TestMesh box;
  box.box({}, {1, 1, 1}, false);
  EXPECT_EQ(chartedOf(box, 0.25).charts.size(), 6u);

  TestMesh tube;  // strips of 5 degrees, each far narrower than a patch
  constexpr int kStrips = 72;
  tube.quad({-5, 5, -5}, {0, 0, 10}, {10, 0, 0});  // beside which no strip is a surface of its own
  for (int i = 0; i < kStrips; ++i) {
    const auto at = [](int strip) {
      const double angle = 2 * std::numbers::pi * strip / kStrips;
      return Vec3{0.5 * std::cos(angle), 0, 0.5 * std::sin(angle)};
    };
    tube.quad(at(i), {0, 1, 0}, at(i + 1) - at(i));
  }
  const Charted made = chartedOf(tube, 0.25);
  double area = 0;
  for (const ChartDraft& draft : made.charts) {
    if (draft.area > 99) continue;
    area += draft.area;
    for (const Face& face : draft.faces)
      EXPECT_GT(dot(normalized(areaVector(made.mesh.positions, face.vertex)), draft.chart.normal),
                std::cos(40 * std::numbers::pi / 180));
  }
  EXPECT_NEAR(area, kStrips * std::sin(std::numbers::pi / kStrips), 1e-5);
  EXPECT_GE(made.charts.size(), 1u + 5u);  // 360 degrees in pieces of at most 2 x 35
  EXPECT_LE(made.charts.size(), 1u + 12u);
}

TEST(Charts, ForeseenPatchesAndTheirRefusal) {
  TestMesh mesh;
  mesh.quad({}, {0, 0, 10}, {10, 0, 0});
  const Charted made = chartedOf(mesh, 0.1);
  EXPECT_NEAR(foreseenPatches(made.charts), 10000, 1);
  RoomOptions options;
  EXPECT_NO_THROW(checkGrids(made.charts, options, 0.1, 3000));
  options.memory = 1e-4;
  EXPECT_THROW(checkGrids(made.charts, options, 0.1, 3000), std::runtime_error);
}

}  // namespace
}  // namespace fiatlux
