// What a shaft says of all rays between two places (shaft, blocker_tree, places) against rays that are cast.
#include "precompute/rays/blocker_tree.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>

#include "core/base/random.h"
#include "precompute/rays/places.h"
#include "precompute/rays/ray_tracer.h"

namespace fiatlux {
namespace {

using Corners = std::array<Vec3, 4>;

struct Boxes {
  std::vector<Vec3> positions;
  std::vector<RayTracer::Triangle> triangles;

  void addQuad(const Corners& corners) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), corners.begin(), corners.end());
    triangles.push_back({first, first + 1, first + 2});
    triangles.push_back({first, first + 2, first + 3});
  }
  void addBox(const Vec3& low, const Vec3& size) {
    const auto at = [&](int i) {
      return low + Vec3{i & 1 ? size.x : 0, i & 2 ? size.y : 0, i & 4 ? size.z : 0};
    };
    constexpr int kSides[][4]{{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                              {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
    for (const auto& [a, b, c, d] : kSides) addQuad({at(a), at(b), at(c), at(d)});
  }
  /// A room with `count` boxes in it, each side up to `largest` long.
  static Boxes furnished(int count, double largest, Random& random) {
    Boxes room;
    room.addBox({0, 0, 0}, {8, 3, 6});
    for (int i = 0; i < count; ++i)
      room.addBox(
          {8 * random.unit(), 3 * random.unit(), 6 * random.unit()},
          {0.02 + largest * random.unit(), 0.02 + largest * random.unit(), 0.02 + largest * random.unit()});
    return room;
  }
  RayTracer tracer() const {
    Result<RayTracer> built = RayTracer::build(positions, triangles);
    return std::move(*built);
  }
};

/// A rectangle around a point, its sides along two random directions that are square to each other.
Corners rectangleAt(const Vec3& center, double size, Random& random) {
  const auto any = [&] {
    return normalized(Vec3{random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5});
  };
  const Vec3 along = any(), across = normalized(cross(along, any()));
  const Vec3 u = (size * (0.2 + random.unit())) * along, v = (size * (0.2 + random.unit())) * across;
  return {center - u - v, center + u - v, center + u + v, center - u + v};
}

Vec3 pointOn(const Corners& corners, Random& random) {
  const double u = random.unit(), v = random.unit();
  return corners[0] + u * (corners[1] - corners[0]) + v * (corners[3] - corners[0]);
}

/// Rays from all over one place to all over another.
RayPacket raysBetween(const RayTracer& tracer, const Corners& from, const Corners& to, std::uint32_t count,
                      Random& random) {
  RayPacket rays;
  while (rays.count < count) {
    const Vec3 origin = pointOn(from, random);
    tracer.aim(rays, origin, pointOn(to, random) - origin, 1);
  }
  return rays;
}

/// How many of 64 rays from one place to another meet nothing.
int openRays(const RayTracer& tracer, const Corners& from, const Corners& to, Random& random) {
  int open = 0;
  for (int packet = 0; packet < 8; ++packet) {
    const RayPacket rays = raysBetween(tracer, from, to, RayPacket::kSize, random);
    bool blocked[RayPacket::kSize];
    tracer.occluded(rays, blocked);
    for (const bool stopped : blocked) open += stopped ? 0 : 1;
  }
  return open;
}

TEST(BlockerTree, WhatItFindsStopsTheRaysThatTheRoomStops) {
  Random random(12);
  const RayTracer tracer = Boxes::furnished(40, 0.5, random).tracer();
  int rays = 0, stopped = 0, differ = 0;
  for (int pair = 0; pair < 2000; ++pair) {
    const auto anywhere = [&] { return Vec3{8 * random.unit(), 3 * random.unit(), 6 * random.unit()}; };
    const Corners from = rectangleAt(anywhere(), 0.2, random), to = rectangleAt(anywhere(), 0.2, random);
    Blockers found;
    if (tracer.between(tracer.place(from), tracer.place(to), found) != Between::kUnknown || found.isFull())
      continue;
    EXPECT_GT(found.count(), 0u);
    for (int packet = 0; packet < 8; ++packet) {
      const RayPacket some = raysBetween(tracer, from, to, 5, random);
      bool byList[RayPacket::kSize], byRoom[RayPacket::kSize];
      found.occluded(some, byList);
      tracer.occluded(some, byRoom);
      for (std::uint32_t i = 0; i < some.count; ++i) {
        ++rays;
        stopped += byRoom[i] ? 1 : 0;
        differ += byList[i] != byRoom[i] ? 1 : 0;
      }
    }
  }
  EXPECT_GT(rays, 20000);
  EXPECT_GT(stopped, rays / 4);
  EXPECT_LT(stopped, rays * 3 / 4);
  EXPECT_LE(differ, rays / 10000);  // such as pass an edge within the slack
}

TEST(Blockers, LetNoRayThroughASeam) {
  Random random(13);
  Boxes wall;
  wall.addBox({0, 0, 0}, {8, 3, 6});
  // Strips of a wall that lean a little to one another, each two triangles.
  for (int i = 0; i < 20; ++i) {
    const double x = 0.4 * i, z = 3 + 0.01 * (i % 2), next = 3 + 0.01 * ((i + 1) % 2);
    wall.addQuad({Vec3{x, 0, z}, Vec3{x + 0.4, 0, next}, Vec3{x + 0.4, 3, next}, Vec3{x, 3, z}});
  }
  const RayTracer tracer = wall.tracer();
  int tried = 0;
  for (int pair = 0; pair < 500; ++pair) {
    const Corners from = rectangleAt({1 + 6 * random.unit(), 1.5, 1}, 0.1, random);
    const double seam = 0.4 * (2 + std::floor(16 * random.unit()));
    const Vec3 center = 0.25 * (from[0] + from[1] + from[2] + from[3]);
    const Vec3 through{seam, 1 + random.unit(), 3 + 0.01 * (std::lround(seam / 0.4) % 2)};
    const Corners to = rectangleAt(center + 1.5 * (through - center), 0.05, random);
    Blockers found;
    const Between known = tracer.between(tracer.place(from), tracer.place(to), found);
    if (known == Between::kWall) continue;
    ASSERT_EQ(known, Between::kUnknown);
    ASSERT_FALSE(found.isFull());
    ++tried;
    RayPacket rays;
    while (rays.count < RayPacket::kSize)
      tracer.aim(rays, center, through + 1e-7 * random.unit() * Vec3{1, 0, 0} - center, 1.5);
    bool blocked[RayPacket::kSize];
    found.occluded(rays, blocked);
    for (const bool is : blocked) EXPECT_TRUE(is) << seam;
  }
  EXPECT_GT(tried, 400);
}

TEST(BlockerTree, SaysOfAllRaysWhatHoldsForEach) {
  Random random(11);
  const RayTracer tracer = Boxes::furnished(60, 1, random).tracer();
  int clear = 0, walls = 0, mixed = 0;
  for (int round = 0; round < 6000; ++round) {
    const Vec3 one{8 * random.unit(), 3 * random.unit(), 6 * random.unit()};
    const Vec3 two = one + Vec3{4 * (random.unit() - 0.5), random.unit() - 0.5, 4 * (random.unit() - 0.5)};
    const Corners from = rectangleAt(one, 0.1, random), to = rectangleAt(two, 0.1, random);
    const Between between = tracer.between(tracer.place(from), tracer.place(to));
    const int open = openRays(tracer, from, to, random);
    if (between != Between::kUnknown) {
      EXPECT_EQ(open, between == Between::kNothing ? 64 : 0) << round;
    }
    clear += between == Between::kNothing && open == 64;
    walls += between == Between::kWall && open == 0;
    mixed += between == Between::kUnknown && open > 0 && open < 64;
  }
  EXPECT_GT(clear, 300);
  EXPECT_GT(walls, 300);
  EXPECT_GT(mixed, 300);
}

TEST(BlockerTree, KnowsAnEmptyRoomAndAWallAcrossIt) {
  Boxes room;
  room.addBox({0, 0, 0}, {8, 3, 6});
  const RayTracer empty = room.tracer();
  room.addQuad({Vec3{4, 0, 0}, Vec3{4, 0, 6}, Vec3{4, 3, 6}, Vec3{4, 3, 0}});
  const RayTracer divided = room.tracer();
  const double up = empty.offset();
  // Floor against the far wall and a luminaire, both down to an edge of the room.
  const Corners floor{Vec3{1, up, 0}, Vec3{1, up, 1}, Vec3{0, up, 1}, Vec3{0, up, 0}};
  const Corners wall{Vec3{8 - up, 0, 0}, Vec3{8 - up, 0, 1}, Vec3{8 - up, 1, 1}, Vec3{8 - up, 1, 0}};
  const Corners lamp{Vec3{5, 2.99, 0}, Vec3{6, 2.99, 0}, Vec3{6, 2.99, 1}, Vec3{5, 2.99, 1}};
  for (const Corners& far : {wall, lamp}) {
    EXPECT_EQ(empty.between(empty.place(floor), empty.place(far)), Between::kNothing);
    EXPECT_EQ(divided.between(divided.place(floor), divided.place(far)), Between::kWall);
    EXPECT_EQ(divided.between(divided.place(far), divided.place(floor)), Between::kWall);
  }
}

TEST(BlockerTree, AnHoleInAWallLetsLightThrough) {
  Boxes room;
  room.addBox({0, 0, 0}, {8, 3, 6});
  room.addQuad({Vec3{4, 0, 0}, Vec3{4, 0, 2.9}, Vec3{4, 3, 2.9}, Vec3{4, 3, 0}});
  room.addQuad({Vec3{4, 0, 3.1}, Vec3{4, 0, 6}, Vec3{4, 3, 6}, Vec3{4, 3, 3.1}});
  const RayTracer tracer = room.tracer();
  const auto square = [](double x, double z, double half) {
    return Corners{Vec3{x, 1 - half, z - half}, Vec3{x, 1 - half, z + half}, Vec3{x, 1 + half, z + half},
                   Vec3{x, 1 + half, z - half}};
  };
  const auto between = [&](double z, double half) {
    return tracer.between(tracer.place(square(2, z, half)), tracer.place(square(6, z, half)));
  };
  EXPECT_EQ(between(3, 0.05), Between::kNothing);
  EXPECT_EQ(between(3, 0.5), Between::kUnknown);
  EXPECT_EQ(between(1, 0.5), Between::kWall);
}

TEST(Places, AnAnswerIsKept) {
  Boxes room;
  room.addBox({0, 0, 0}, {8, 3, 6});
  const RayTracer tracer = room.tracer();
  const Place one = tracer.place({Vec3{1, 1, 1}, Vec3{1, 1, 2}, Vec3{1, 2, 2}, Vec3{1, 2, 1}});
  const Place two = tracer.place({Vec3{3, 1, 1}, Vec3{3, 1, 2}, Vec3{3, 2, 2}, Vec3{3, 2, 1}});
  const BetweenPlaces between(tracer, {one, std::nullopt}, {two});
  for (int round = 0; round < 2; ++round) EXPECT_EQ(between.at(0, 0), Between::kNothing);
  EXPECT_EQ(between.at(1, 0), Between::kUnknown);  // not flat: nobody knows
}

}  // namespace
}  // namespace fiatlux
