// What all parts of all clusters send to a place at once (part_kernels).
#include "precompute/light/part_kernels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace fiatlux {
namespace {

/// Three clusters of one square patch each: on the floor, and on a wall at x = 4.
Room threeSquares() {
  Room room;
  const Vec3 center[]{{0, 0, 0}, {1, 0, 2}, {4, 1, 1}}, normal[]{{0, 1, 0}, {0, 1, 0}, {-1, 0, 0}};
  for (std::uint32_t p = 0; p < 3; ++p) {
    Chart chart;
    chart.normal = normal[p];
    chart.uAxis = {0, 0, 1};
    chart.vAxis = cross(chart.normal, chart.uAxis);
    room.charts.push_back(chart);
    room.chartOfPatch.push_back(p);
    room.patches.center.push_back(center[p]);
    room.patches.normal.push_back(normal[p]);
    room.patches.area.push_back(0.04 * (p + 1));
    room.patches.cluster.push_back(p);
  }
  room.patches.count = room.patches.clusterCount = 3;
  return room;
}

TEST(PartKernels, AreTheKernelToEachPartAndNothingBehind) {
  const Room room = threeSquares();
  const ClusterParts clusters(room);
  const PartKernels kernels(clusters);
  const Vec3 position{0.5, 2, 0.25}, down{0, -1, 0}, east{1, 0, 0};
  std::vector<float> of;
  for (const Vec3& normal : {down, east}) {
    kernels.at(position, normal, of);
    ASSERT_GE(of.size(), clusters.parts().size());
    for (std::size_t i = 0; i < clusters.parts().size(); ++i) {
      const ClusterPart& part = clusters.parts()[i];
      const Vec3 d = part.center - position;
      const double leaves = std::max(0.0, dot(d, normal)), arrives = std::max(0.0, -dot(d, part.normal));
      const double expected = part.area * leaves * arrives / (std::numbers::pi * std::pow(dot(d, d), 2));
      EXPECT_NEAR(of[i], expected, 1e-5 * expected) << i;
    }
  }
  kernels.at(position, {0, 1, 0}, of);
  for (std::size_t i = 0; i < of.size(); ++i) EXPECT_EQ(of[i], 0) << i;
}

}  // namespace
}  // namespace fiatlux
