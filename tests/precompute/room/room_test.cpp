// Where a point of a room lies in the patch numbering, and the cells and lattices that its geometry is cut
// with (grid_cut, vertex_lattice).
#include "precompute/room/room.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "precompute/room/grid_cut.h"
#include "precompute/room/vertex_lattice.h"

namespace fiatlux {
namespace {

/// A floor of 2 x 1 m in cells of 0.5 m, its last cell empty, front up.
Room floorRoom() {
  Room room;
  room.positions = {{0, 0, 0}, {2, 0, 0}, {2, 0, -1}, {0, 0, -1}};
  room.triangles = {{{0, 1, 2}}, {{0, 2, 3}}};
  room.triangles[0].chart = room.triangles[1].chart = 0;
  Chart chart;
  chart.uAxis = {1, 0, 0}, chart.vAxis = {0, 0, -1}, chart.normal = {0, 1, 0};
  chart.cellU = chart.cellV = 0.5;
  chart.columns = 4, chart.rows = 2;
  chart.patchOfCell = {0, 1, 2, 3, 4, 5, 6, kNone};
  room.charts.push_back(chart);
  return room;
}

TEST(Room, APointIsOnThePatchOfItsCellOrOfTheNearestOne) {
  const Room room = floorRoom();
  EXPECT_EQ(room.patchAt(0, false, {0.1, 0, -0.1}), 0u);
  EXPECT_EQ(room.patchAt(0, false, {0.7, 0, -0.1}), 1u);
  EXPECT_EQ(room.patchAt(0, false, {0.1, 0, -0.9}), 4u);
  EXPECT_EQ(room.patchAt(0, false, {-1, 0, 1}), 0u);       // outside: the nearest cell
  EXPECT_EQ(room.patchAt(0, false, {1.51, 0, -0.9}), 6u);  // an empty cell: the nearest that is none
  EXPECT_EQ(room.patchAt(0, true, {0.1, 0, -0.1}), kNone);
}

TEST(Room, ARayMeetsThePatchOfTheSideItComesFrom) {
  Room room = floorRoom();
  EXPECT_EQ(room.patchMet({0.7, 2, -0.1}, {0, -1, 0}, 0, 2), 1u);
  EXPECT_EQ(room.patchMet({0.7, -2, -0.1}, {0, 1, 0}, 0, 2), kNone);
  EXPECT_EQ(room.patchMet({0.7, 2, -0.1}, {0, 1, 0}, kNone, 0), kNone);
  room.triangles[0].backChart = 0;
  EXPECT_EQ(room.patchMet({0.7, -2, -0.1}, {0, 1, 0}, 0, 2), 1u);
}

TEST(GridCut, PiecesOfATriangleFillItAndStayInTheirCells) {
  const Room room = floorRoom();
  const std::array<Vec3, 3> triangle{Vec3{0.1, 0, -0.05}, {1.9, 0, -0.1}, {0.8, 0, -0.97}};
  GridCut cut;
  double sum = 0;
  std::set<std::uint32_t> cells;
  cut.cut(room.charts[0], triangle, [&](std::uint32_t cell, const std::vector<GridCorner>& polygon) {
    EXPECT_TRUE(cells.insert(cell).second);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const GridCorner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      EXPECT_GE(a.u, cell % 4 - 1e-12);
      EXPECT_LE(a.u, cell % 4 + 1 + 1e-12);
      EXPECT_GE(a.v, cell / 4 - 1e-12);
      EXPECT_LE(a.v, cell / 4 + 1 + 1e-12);
      sum += 0.5 * (a.u * b.v - a.v * b.u) * 0.25;
    }
  });
  EXPECT_NEAR(sum, 0.5 * length(cross(triangle[1] - triangle[0], triangle[2] - triangle[0])), 1e-12);
}

TEST(VertexLattice, FindsEveryVertexOnASegment) {
  std::vector<Vec3> positions;
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    positions.push_back(
        {std::fmod(i * 0.618, 1.0) * 3 - 1, std::fmod(i * 0.37, 1.0) * 2, std::fmod(i * 0.11, 1.0)});
    vertices.push_back(i);
  }
  const Vec3 a{-0.9, 0.1, 0.05}, b{1.9, 1.8, 0.9};
  for (std::uint32_t i = 0; i < 10; ++i) {
    positions.push_back(a + (0.05 + 0.1 * i) * (b - a));
    vertices.push_back(1000 + i);
  }
  for (const double cell : {0.02, 0.3, 10.0}) {
    const VertexLattice lattice(positions, vertices, cell);
    std::set<std::uint32_t> found;
    const std::size_t work = lattice.alongSegment(a, b, 1e-6, [&](std::uint32_t v) { found.insert(v); });
    for (std::uint32_t i = 1000; i < 1010; ++i) EXPECT_TRUE(found.count(i)) << cell << ", " << i;
    EXPECT_GT(work, 0u);
    if (cell < 0.1) {
      EXPECT_LT(found.size(), 200u);
    }
  }
}

}  // namespace
}  // namespace fiatlux
