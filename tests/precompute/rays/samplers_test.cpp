// Points and directions that rays start with (ray_sequence, area_sampler, patch_sampler, hemisphere), and how
// many (effort).
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "precompute/rays/area_sampler.h"
#include "precompute/rays/effort.h"
#include "precompute/rays/hemisphere.h"
#include "precompute/rays/patch_sampler.h"
#include "precompute/rays/ray_sequence.h"

namespace fiatlux {
namespace {

TEST(RaySequence, EveryScrambleFillsTheSquareEvenlyInEachPairOfDimensions) {
  constexpr std::uint32_t kCount = 256;
  const RaySequence sequence(kCount);
  for (const std::uint64_t seed : {1u, 2u, 77u}) {
    const auto scramble = RaySequence::scramble(seed);
    std::vector<int> first(kCount, 0), second(kCount, 0);  // 16 x 16 strata of (0, 1); 256 of dimension 0
    for (std::uint32_t i = 0; i < kCount; ++i) {
      const auto p = sequence.point(i, scramble);
      for (const double x : p) {
        EXPECT_GE(x, 0);
        EXPECT_LT(x, 1);
      }
      ++first[static_cast<int>(p[0] * 16) * 16 + static_cast<int>(p[1] * 16)];
      ++second[static_cast<int>(p[0] * kCount)];
    }
    for (std::uint32_t i = 0; i < kCount; ++i) {
      EXPECT_EQ(first[i], 1) << seed;
      EXPECT_EQ(second[i], 1) << seed;
    }
  }
  EXPECT_NE(sequence.point(0, RaySequence::scramble(1)), sequence.point(0, RaySequence::scramble(2)));
  EXPECT_EQ(sequence.point(9, RaySequence::scramble(3)), sequence.point(9, RaySequence::scramble(3)));
}

TEST(Hemisphere, DirectionsFollowTheCosine) {
  for (const Vec3& n : {Vec3{0, 1, 0}, Vec3{0, 0, -1}, normalized(Vec3{1, -2, 0.5})}) {
    const Frame frame(n);
    EXPECT_NEAR(length(cross(frame.x, frame.y) - n), 0, 1e-12);
    double mean = 0, square = 0;
    constexpr int kEdge = 256;  // midpoints miss a little at the horizon
    for (int i = 0; i < kEdge; ++i)
      for (int j = 0; j < kEdge; ++j) {
        const Vec3 d = cosineDirection(frame, (i + 0.5) / kEdge, (j + 0.5) / kEdge);
        EXPECT_NEAR(length(d), 1, 1e-12);
        mean += dot(d, n) / (kEdge * kEdge);
        square += std::pow(dot(d, n), 2) / (kEdge * kEdge);
      }
    EXPECT_NEAR(mean, 2.0 / 3, 1e-3);  // of cos under a density of cos / pi
    EXPECT_NEAR(square, 0.5, 1e-3);
  }
}

TEST(AreaSampler, PointsLieOnItsTrianglesByTheirArea) {
  const std::vector<Fragment> triangles = {{{Vec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                                           {{Vec3{5, 0, 0}, {5, 0, 0}, {5, 1, 0}}},  // no area
                                           {{Vec3{0, 0, 3}, {3, 0, 3}, {0, 1, 3}}}};
  const AreaSampler sampler(triangles);
  EXPECT_NEAR(sampler.area(), 2, 1e-12);
  EXPECT_EQ(sampler.pieces().size(), 2u);
  int far = 0;
  constexpr int kEdge = 40;
  for (int i = 0; i < kEdge; ++i)
    for (int j = 0; j < kEdge; ++j) {
      const auto [p, n] = sampler.at((i + 0.5) / kEdge, (j + 0.5) / kEdge);
      EXPECT_NEAR(n.z, 1, 1e-12);
      far += p.z == 3;
      EXPECT_LE(p.x / (p.z == 3 ? 3 : 1) + p.y, 1 + 1e-12);
    }
  EXPECT_EQ(far, kEdge * kEdge * 3 / 4);
}

/// One patch: a cell of 0.5 x 0.25 m, whole or its lower triangle alone.
Room onePatch(bool whole) {
  Room room;
  Chart chart;
  chart.uAxis = {1, 0, 0}, chart.vAxis = {0, 0, -1}, chart.normal = {0, 1, 0};
  chart.cellU = 0.5, chart.cellV = 0.25, chart.columns = chart.rows = 1;
  chart.patchOfCell = {0};
  room.charts.push_back(chart);
  const Vec3 a{0, 0, 0}, b{0.5, 0, 0}, c{0.5, 0, -0.25}, d{0, 0, -0.25};
  room.fragments = {{{a, b, c}}};
  if (whole) room.fragments.push_back({{a, c, d}});
  room.fragmentOffset = {0, static_cast<std::uint32_t>(room.fragments.size())};
  room.chartOfPatch = {0};
  room.patches.count = 1;
  room.patches.area = {whole ? 0.125 : 0.0625};
  room.patches.center = {whole ? 0.5 * (a + c) : (1.0 / 3) * (a + b + c)};
  room.patches.normal = {{0, 1, 0}};
  return room;
}

TEST(PatchSampler, QuadratureIsExactOnWholeCellsAndItsWeightsSumToOne) {
  const Room whole = onePatch(true), half = onePatch(false);
  for (const std::uint32_t edge : {2u, 4u}) {
    double weight = 0, square = 0;
    for (const PatchPoint& p : PatchSampler(whole, 0).quadrature(edge)) {
      weight += p.weight;
      square += p.weight * p.position.x * p.position.x;
    }
    EXPECT_NEAR(weight, 1, 1e-12);
    EXPECT_NEAR(square, 0.25 / 3, 1e-12);  // mean of x^2 over [0, 0.5]
    weight = 0;
    for (const PatchPoint& p : PatchSampler(half, 0).quadrature(edge)) {
      weight += p.weight;
      EXPECT_GE(p.position.x, -2 * p.position.z - 1e-12);  // below the diagonal
    }
    EXPECT_NEAR(weight, 1, 1e-12);
  }
}

TEST(Effort, SmallSurfacesGetMoreButAllTogetherAtMostTwice) {
  Patches patches;
  const auto add = [&](std::uint32_t surface, std::size_t count) {
    patches.surface.insert(patches.surface.end(), count, surface);
    patches.area.insert(patches.area.end(), count, 1.0);
  };
  add(0, 5000), add(1, 10), add(2, 200);
  const std::vector<std::uint32_t> effort = effortOfRows(patches);
  EXPECT_EQ(effort[0], 1u);
  EXPECT_EQ(effort[5000], kMostEffort);
  EXPECT_EQ(effort.back(), 2u);

  patches = {};
  for (std::uint32_t s = 0; s < 100; ++s) add(s, 4);
  std::uint64_t total = 0;
  for (const std::uint32_t e : effortOfRows(patches)) total += e;
  EXPECT_LE(total, 2u * patches.rows());
}

}  // namespace
}  // namespace fiatlux
