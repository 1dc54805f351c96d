// The tracer against every triangle tried in turn.
#include "precompute/rays/ray_tracer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>

#include "core/base/random.h"

namespace fiatlux {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();

struct Soup {
  std::vector<Vec3> positions;
  std::vector<RayTracer::Triangle> triangles;
};

Soup randomSoup(std::uint32_t count) {
  Random random(5);
  Soup soup;
  const auto coordinate = [&](double size) { return size * (random.unit() - 0.5); };
  for (std::uint32_t t = 0; t < count; ++t) {
    const Vec3 at{100 + coordinate(4), coordinate(4), coordinate(4)};
    for (int i = 0; i < 3; ++i)
      soup.positions.push_back(at + Vec3{coordinate(1), coordinate(1), coordinate(1)});
    soup.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return soup;
}

/// Where a ray meets a triangle, in lengths of its direction (Moller and Trumbore 1997).
std::optional<double> meet(const Soup& soup, std::uint32_t t, const Vec3& origin, const Vec3& direction) {
  const auto& [a, b, c] = soup.triangles[t];
  const Vec3 e1 = soup.positions[b] - soup.positions[a], e2 = soup.positions[c] - soup.positions[a];
  const Vec3 p = cross(direction, e2), s = origin - soup.positions[a], q = cross(s, e1);
  const double determinant = dot(e1, p), u = dot(s, p) / determinant, v = dot(direction, q) / determinant;
  const double distance = dot(e2, q) / determinant;
  if (!(u >= 0 && v >= 0 && u + v <= 1 && distance > 0)) return {};
  return distance;
}

TEST(RayTracer, MeetsWhatIsFirst) {
  const Soup soup = randomSoup(300);
  const auto tracer = RayTracer::build(soup.positions, soup.triangles);
  ASSERT_TRUE(tracer) << tracer.error().message;
  Random random(8);
  int met = 0, different = 0;
  for (int round = 0; round < 200; ++round) {
    RayPacket packet;
    Vec3 origin[RayPacket::kSize], direction[RayPacket::kSize];
    const std::uint32_t lanes = 1 + random.below(RayPacket::kSize);
    for (std::uint32_t i = 0; i < lanes; ++i) {
      origin[i] = {100 + 6 * (random.unit() - 0.5), 6 * (random.unit() - 0.5), 6 * (random.unit() - 0.5)};
      direction[i] = normalized(Vec3{random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5});
      tracer->aim(packet, origin[i], direction[i], kFar);
    }
    HitPacket hits;
    bool blocked[RayPacket::kSize];
    tracer->intersect(packet, hits);
    tracer->occluded(packet, blocked, round % 2 == 0);
    for (std::uint32_t i = 0; i < lanes; ++i) {
      double nearest = kFar;
      std::uint32_t expected = kNone;
      for (std::uint32_t t = 0; t < soup.triangles.size(); ++t)
        if (const auto distance = meet(soup, t, origin[i], direction[i]); distance && *distance < nearest)
          nearest = *distance, expected = t;
      EXPECT_EQ(blocked[i], hits.triangle[i] != kNone);
      different += hits.triangle[i] != expected;
      if (hits.triangle[i] != expected || expected == kNone) continue;
      ++met;
      EXPECT_NEAR(hits.distance[i], nearest, 1e-4);
    }
  }
  EXPECT_GT(met, 200);
  EXPECT_LE(different, 1);  // a ray that grazes an edge in single precision
}

TEST(RayTracer, AShadowRayEndsWhereItIsTold) {
  const Soup wall{{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}, {{0, 1, 2}}};
  const auto tracer = RayTracer::build(wall.positions, wall.triangles);
  ASSERT_TRUE(tracer);
  RayPacket packet;
  for (const double reach : {0.4, 0.6}) tracer->aim(packet, {1, 1, 0}, {0, 0, 2}, reach);
  bool blocked[RayPacket::kSize];
  tracer->occluded(packet, blocked);
  EXPECT_FALSE(blocked[0]);
  EXPECT_TRUE(blocked[1]);
  EXPECT_GT(tracer->offset(), 0);
  EXPECT_LT(tracer->offset(), 1e-4);
}

TEST(RayTracer, OneRayAloneIsLaneOfAPacket) {
  const Soup wall{{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}, {{0, 1, 2}}};
  const auto tracer = RayTracer::build(wall.positions, wall.triangles);
  ASSERT_TRUE(tracer);
  const RayHit hit = tracer->firstHit({1, 1, 0}, {0, 0, 2});
  EXPECT_EQ(hit.triangle, 0u);
  EXPECT_NEAR(hit.distance, 0.5, 1e-6);
  EXPECT_EQ(tracer->firstHit({1, 1, 0}, {0, 0, -2}).triangle, kNone);
  EXPECT_FALSE(tracer->isBlocked({1, 1, 0}, {1, 1, 0.9}));
  EXPECT_TRUE(tracer->isBlocked({1, 1, 0}, {1, 1, 1.1}));
  EXPECT_TRUE(tracer->isBlocked({1, 1, 1.1}, {1, 1, 0}));
}

TEST(RayTracer, WithoutTrianglesARayMeetsNothing) {
  const auto tracer = RayTracer::build(Room{});
  ASSERT_TRUE(tracer) << tracer.error().message;
  RayPacket packet;
  tracer->aim(packet, {0, 0, 0}, {0, 1, 0}, kFar);
  HitPacket hits;
  tracer->intersect(packet, hits);
  EXPECT_EQ(hits.triangle[0], kNone);
}

}  // namespace
}  // namespace fiatlux
