// Points and directions that rays start with (ray_sequence, area_sampler, patch_sampler, patch_sets,
// hemisphere), and how many (effort).
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "precompute/rays/area_sampler.h"
#include "precompute/rays/effort.h"
#include "precompute/rays/hemisphere.h"
#include "precompute/rays/patch_sampler.h"
#include "precompute/rays/patch_sets.h"
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

TEST(RaySequence, EightPointsAtOnceAreThose) {
  const RaySequence sequence(40);
  const auto scramble = RaySequence::scramble(5);
  const auto together = sequence.eightPoints(16, scramble);
  constexpr std::uint32_t kAny[8]{3, 39, 0, 7, 7, 20, 11, 16};
  const auto pairs = sequence.eightPairs(kAny, scramble);
  for (std::uint32_t i = 0; i < 8; ++i) {
    for (std::uint32_t d = 0; d < 4; ++d) {
      EXPECT_NEAR(together[d][i], sequence.point(16 + i, scramble)[d], 0x1p-24);
      EXPECT_LT(together[d][i], 1);
    }
    for (std::uint32_t d = 0; d < 2; ++d)
      EXPECT_NEAR(pairs[d][i], sequence.point(kAny[i], scramble)[d], 0x1p-24);
  }
}

TEST(Hemisphere, EightDirectionsAtOnceAreThose) {
  const Frame axes({0, 0, 1});
  const Float8 u{0.0f, 0.5f, 0.75f, 0.1f, 0.9f, 0.5f, 0.25f, 0.999f},
      v{0.0f, 0.5f, 0.2f, 0.8f, 0.9f, 0.01f, 0.25f, 0.5f};
  const EightDirections together = cosineDirections(u, v);
  for (int i = 0; i < 8; ++i) {
    const Vec3 one = cosineDirection(axes, u[i], v[i]);
    EXPECT_NEAR(dot(one, axes.x), together.x[i], 1e-6) << i;
    EXPECT_NEAR(dot(one, axes.y), together.y[i], 1e-6) << i;
    EXPECT_NEAR(one.z, together.z[i], 4e-4) << i;  // at the horizon the root of a rounding
  }
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

/// Two whole cells side by side, the lower triangle of a third, and a patch without area.
Room fourPatches() {
  Room room = onePatch(true);
  const auto add = [&](std::vector<Fragment> fragments, double area, const Vec3& center) {
    room.fragments.insert(room.fragments.end(), fragments.begin(), fragments.end());
    room.fragmentOffset.push_back(static_cast<std::uint32_t>(room.fragments.size()));
    room.chartOfPatch.push_back(0);
    room.patches.area.push_back(area);
    room.patches.center.push_back(center);
    room.patches.normal.push_back({0, 1, 0});
    ++room.patches.count;
  };
  const Vec3 a{0.5, 0, 0}, b{1, 0, 0}, c{1, 0, -0.25}, d{0.5, 0, -0.25}, right{0.5, 0, 0};
  add({{{a, b, c}}, {{a, c, d}}}, 0.125, 0.5 * (a + c));
  add({{{a + right, b + right, c + right}}}, 0.0625, (1.0 / 3) * (a + b + c) + right);
  add({{{a, a, c}}}, 1e-9, a);
  return room;
}

TEST(PatchSets, PointsLieOnTheirPatchesByArea) {
  const Room room = fourPatches();
  const Vec3 center{2, 3, 4};
  PatchSets sets(room, center);
  const std::uint32_t cells[]{0, 1}, mixed[]{0, 2}, thin[]{3};
  sets.add(cells);
  sets.add(mixed);
  sets.add(thin);
  int onTriangle = 0;
  constexpr int kEdge = 30;
  for (int i = 0; i < kEdge; ++i)
    for (int j = 0; j < kEdge; ++j) {
      const float u = (i + 0.5f) / kEdge, v = (j + 0.5f) / kEdge;
      const auto [on, normal] = sets.at(0, u, v);
      EXPECT_NEAR(on[0] + center.x, u, 1e-6);  // one rectangle of 1 x 0.25 m
      EXPECT_NEAR(on[1] + center.y, 0, 1e-6);
      EXPECT_NEAR(on[2] + center.z, -0.25 * v, 1e-6);
      EXPECT_EQ(normal[1], 1);
      const auto [other, ignored] = sets.at(1, u, v);
      const double x = other[0] + center.x, z = other[2] + center.z;
      if (x > 0.75) {
        ++onTriangle;
        EXPECT_GE((x - 1) * 0.5 + z, -1e-6);  // below the diagonal
      } else {
        EXPECT_LE(x, 0.5 + 1e-6);
      }
    }
  EXPECT_EQ(onTriangle, kEdge * kEdge / 3);
  const auto [alone, upwards] = sets.at(2, 0.3f, 0.7f);
  EXPECT_NEAR(alone[0] + center.x, 0.5, 1e-6);
  EXPECT_EQ(upwards[1], 1);
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
