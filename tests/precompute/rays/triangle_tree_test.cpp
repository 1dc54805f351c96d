// The tree of our own (and float8, which it computes with) against every triangle tried in turn, and natively
// against Embree (embree_scene).
#include "precompute/rays/triangle_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/base/random.h"
#ifndef __EMSCRIPTEN__
#include "precompute/rays/embree_scene.h"
#endif
#include "tests/precompute/rays/tracer_agreement.h"

namespace fiatlux {
namespace {

using testing::LocalTriangles;

constexpr double kOffset = 4e-6 * 10;  // of a room's diagonal, m

struct Mesh {
  std::vector<Vec3> positions;
  std::vector<TriangleTree::Triangle> triangles;

  void addBox(const Vec3& low, const Vec3& size) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (int i = 0; i < 8; ++i)
      positions.push_back(low + Vec3{i & 1 ? size.x : 0, i & 2 ? size.y : 0, i & 4 ? size.z : 0});
    constexpr std::uint32_t kSides[][4]{{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                        {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
    for (const auto& [a, b, c, d] : kSides) {
      triangles.push_back({first + a, first + b, first + c});
      triangles.push_back({first + a, first + c, first + d});
    }
  }
};

/// A room of 8 x 3 x 6 m with `boxes` things in it.
LocalTriangles furnishedRoom(std::uint32_t boxes) {
  Random random(3);
  Mesh mesh;
  mesh.addBox({0, 0, 0}, {8, 3, 6});
  for (std::uint32_t i = 0; i < boxes; ++i)
    mesh.addBox({8 * random.unit(), 2.5 * random.unit(), 6 * random.unit()},
                {0.02 + 0.5 * random.unit(), 0.02 + 0.3 * random.unit(), 0.02 + 0.5 * random.unit()});
  return {mesh.positions, mesh.triangles};
}

/// Eight rays from one place in the room to anywhere, `reach` lengths long.
RayPacket raysAnywhere(Random& random, double reach) {
  RayPacket rays;
  const Vec3 at{7.8 * (random.unit() - 0.5), 2.8 * (random.unit() - 0.5), 5.8 * (random.unit() - 0.5)};
  while (rays.count < RayPacket::kSize) {
    const Vec3 direction{random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5};
    testing::aimAt(rays, at, normalized(direction), reach);
  }
  return rays;
}

TriangleTree treeOf(const LocalTriangles& scene) {
  return std::move(*TriangleTree::build(scene.positions, scene.triangles));
}

/// Every triangle in turn (Moller and Trumbore 1997).
HitPacket metInTurn(const LocalTriangles& scene, const RayPacket& rays) {
  HitPacket hits;
  for (std::uint32_t i = 0; i < rays.count; ++i) {
    const Vec3 origin{rays.originX[i], rays.originY[i], rays.originZ[i]};
    const Vec3 direction{rays.directionX[i], rays.directionY[i], rays.directionZ[i]};
    hits.triangle[i] = kNone;
    hits.distance[i] = rays.reach[i];
    for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) {
      const Vec3 a = scene.corner(t, 0), e1 = scene.corner(t, 1) - a, e2 = scene.corner(t, 2) - a;
      const Vec3 p = cross(direction, e2), s = origin - a, q = cross(s, e1);
      const double determinant = dot(e1, p), u = dot(s, p) / determinant, v = dot(direction, q) / determinant;
      const double distance = dot(e2, q) / determinant;
      if (!(u >= 0 && v >= 0 && u + v <= 1 && distance > 0 && distance < hits.distance[i])) continue;
      hits.distance[i] = static_cast<float>(distance);
      hits.triangle[i] = t;
    }
  }
  return hits;
}

TEST(TriangleTree, MeetsWhatIsFirst) {
  const LocalTriangles scene = furnishedRoom(40);
  const TriangleTree tree = treeOf(scene);
  Random random(8);
  std::uint32_t differ = 0;
  for (int round = 0; round < 500; ++round) {
    const RayPacket rays = raysAnywhere(random, INFINITY);
    HitPacket hits;
    tree.intersect(rays, hits);
    differ += testing::differing(scene, kOffset, rays, hits, metInTurn(scene, rays));
  }
  EXPECT_EQ(differ, 0u);
}

TEST(TriangleTree, WhatStandsBetweenIsWhatIsMet) {
  const LocalTriangles scene = furnishedRoom(100);
  const TriangleTree tree = treeOf(scene);
  Random random(9);
  std::uint32_t blockedRays = 0;
  for (int round = 0; round < 2000; ++round) {
    RayPacket rays = raysAnywhere(random, 2);
    if (round % 2 == 0)  // nearly the same way
      for (std::uint32_t i = 1; i < rays.count; ++i)
        rays.directionX[i] = rays.directionX[0] + 0.1f * static_cast<float>(i),
        rays.directionY[i] = rays.directionY[0], rays.directionZ[i] = rays.directionZ[0];
    HitPacket hits;
    bool alone[RayPacket::kSize], together[RayPacket::kSize];
    tree.intersect(rays, hits);
    tree.occluded(rays, alone, false);
    tree.occluded(rays, together, true);
    for (std::uint32_t i = 0; i < rays.count; ++i) {
      ASSERT_EQ(alone[i], hits.triangle[i] != kNone);
      ASSERT_EQ(together[i], alone[i]);
      blockedRays += alone[i];
    }
  }
  EXPECT_GT(blockedRays, 4000u);
  EXPECT_LT(blockedRays, 14000u);
}

TEST(TriangleTree, NoRaySlipsBetweenTriangles) {
  // A ball of strips, seen from within: straight at its corners and along its edges.
  constexpr std::uint32_t kRings = 40, kSectors = 60;
  Mesh ball;
  for (std::uint32_t r = 0; r <= kRings; ++r)
    for (std::uint32_t s = 0; s < kSectors; ++s) {
      const double polar = std::numbers::pi * r / kRings, around = 2 * std::numbers::pi * s / kSectors;
      ball.positions.push_back({3 * std::sin(polar) * std::cos(around), 3 * std::cos(polar),
                                3 * std::sin(polar) * std::sin(around)});
    }
  for (std::uint32_t r = 0; r < kRings; ++r)
    for (std::uint32_t s = 0; s < kSectors; ++s) {
      const std::uint32_t next = (s + 1) % kSectors, a = r * kSectors + s, b = r * kSectors + next;
      ball.triangles.push_back({a, a + kSectors, b});
      ball.triangles.push_back({b, a + kSectors, b + kSectors});
    }
  const LocalTriangles scene(ball.positions, ball.triangles);
  const TriangleTree tree = treeOf(scene);
  Random random(4);
  for (int round = 0; round < 20000; ++round) {
    RayPacket rays;
    const std::uint32_t t = random.below(static_cast<std::uint32_t>(scene.triangles.size()));
    const Vec3 from{random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5};
    const double along = round % 2 == 0 ? 0 : random.unit();
    testing::aimAt(rays, from, (1 - along) * scene.corner(t, 0) + along * scene.corner(t, 1) - from,
                   INFINITY);
    HitPacket hits;
    bool blocked = false;
    tree.intersect(rays, hits);
    ASSERT_NE(hits.triangle[0], kNone);
    tree.occluded(rays, &blocked, true);
    ASSERT_TRUE(blocked);
  }
}

TEST(TriangleTree, OfTrianglesAtOnePlaceTheFirstIsMet) {
  Mesh mesh;
  mesh.positions = {{-1, 0, -1}, {3, 0, -1}, {-1, 0, 3}, {0, 2, 0}};
  mesh.triangles.assign(5000, {0, 1, 2});
  mesh.triangles.insert(mesh.triangles.begin(), {0, 3, 0});  // without area
  const LocalTriangles scene(mesh.positions, mesh.triangles);
  RayPacket rays;
  testing::aimAt(rays, {-0.9, 0.5, -0.9}, {0, -1, 0}, INFINITY);
  HitPacket hits;
  treeOf(scene).intersect(rays, hits);
  EXPECT_EQ(hits.triangle[0], 1u);
}

#ifndef __EMSCRIPTEN__
TEST(TriangleTree, AnswersAsEmbreeDoes) {
  const LocalTriangles scene = furnishedRoom(300);
  const TriangleTree tree = treeOf(scene);
  const auto embree = EmbreeScene::build(scene.positions, scene.triangles);
  ASSERT_TRUE(embree);
  Random random(11);
  std::uint32_t differ = 0;
  for (int round = 0; round < 12500; ++round) {
    const RayPacket rays = raysAnywhere(random, INFINITY);
    HitPacket here, there;
    tree.intersect(rays, here);
    embree->intersect(rays, there);
    differ += testing::differing(scene, kOffset, rays, here, there);
  }
  EXPECT_EQ(differ, 0u);
}
#endif

}  // namespace
}  // namespace fiatlux
