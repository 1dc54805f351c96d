// Made rooms, one for each way in which real models mislead: what hangs luminaires in walls, slabs and
// plenums, in the open, or nowhere. None of them marks a mount or is named for what it is.
#pragma once

#include <array>
#include <cmath>
#include <utility>

#include "tests/precompute/gltf/gltf_builder.h"

namespace fiatlux::testing {

inline constexpr double kStorey = 2.8;              // m, from a floor to the ceiling above
inline const Vec3 kPlan{6, 0, 5};                   // m, clear of the walls
inline constexpr double kWall = 0.3, kSlab = 0.25;  // m, how thick

/// A model under construction: solid or hollow boxes, sheets; all of one material.
struct TrapRoom {
  TestGltf gltf;
  int paint;

  explicit TrapRoom(bool doubleSided = false)
      : paint(gltf.material("paint", 0.5, {{"doubleSided", doubleSided}})) {}

  void add(const std::string& name, const TestMesh& mesh) { gltf.node(name, gltf.mesh(mesh, paint)); }
  /// A closed box that looks outward.
  void block(const std::string& name, const Vec3& low, const Vec3& size) {
    TestMesh mesh;
    mesh.box(low, size, false);
    add(name, mesh);
  }
  /// The same without its lower side: of a double-sided material it has an inside.
  void hood(const std::string& name, const Vec3& low, const Vec3& size) {
    TestMesh mesh;
    mesh.box(low, size, false);
    mesh.indices.erase(mesh.indices.begin(), mesh.indices.begin() + 6);
    add(name, mesh);
  }
  /// Four walls around the plan, from `y` to the ceiling; hollow where they are hoods.
  void walls(double y, bool hollow) {
    const auto wall = [&](const std::string& name, const Vec3& low, const Vec3& size) {
      hollow ? hood(name, low, size) : block(name, low, size);
    };
    const double x = kPlan.x, z = kPlan.z;
    wall("w1", {-kWall, y, -kWall}, {x + 2 * kWall, kStorey, kWall});
    wall("w2", {-kWall, y, z}, {x + 2 * kWall, kStorey, kWall});
    wall("w3", {-kWall, y, 0}, {kWall, kStorey, z});
    wall("w4", {x, y, 0}, {kWall, kStorey, z});
  }
  /// A plate below, between or above storeys, whose upper side is at y; `over` the walls' outer edge, m.
  void slab(const std::string& name, double y, double over = 0) {
    const double edge = kWall + over;
    block(name, {-edge, y - kSlab, -edge}, {kPlan.x + 2 * edge, kSlab, kPlan.z + 2 * edge});
  }
};

/// Caps of double-sided hollow walls look down upon the plate they stand on.
inline TrapRoom hollowWalls() {
  TrapRoom room(true);
  room.slab("s0", 0), room.walls(0, true), room.slab("s1", kStorey + kSlab);
  return room;
}

/// Above a lowered ceiling of panels there is more than a metre of nothing.
inline TrapRoom plenum() {
  TrapRoom room(true);
  room.slab("s0", 0), room.walls(0, false), room.walls(kStorey, false);
  TestMesh panels;
  panels.quad({0, kStorey, 0}, {kPlan.x, 0, 0}, {0, 0, kPlan.z}, 10, 8);
  room.add("panels", panels), room.slab("s1", kStorey + 1.3 + kSlab);
  return room;
}

/// The upper plate is hollow and open to a side.
inline TrapRoom hollowSlab() {
  TrapRoom room(true);
  room.slab("s0", 0), room.walls(0, false);
  TestMesh mesh;
  mesh.box({-kWall, kStorey, -kWall}, {kPlan.x + 2 * kWall, 0.6, kPlan.z + 2 * kWall}, false);
  mesh.indices.resize(mesh.indices.size() - 6);
  room.add("s1", mesh);
  return room;
}

/// Two rooms, one above the other.
inline TrapRoom twoStoreys() {
  TrapRoom room;
  room.slab("s0", 0), room.walls(0, false);
  room.slab("s1", kStorey + kSlab), room.walls(kStorey + kSlab, false);
  room.slab("s2", 2 * (kStorey + kSlab));
  return room;
}

/// A house on wide ground, with eaves, and a mast that lifts the middle of the model above its ceiling.
inline TrapRoom terrain() {
  TrapRoom room;
  TestMesh ground;
  ground.quad({-30, -kSlab, -30}, {0, 0, 60}, {60, 0, 0}, 4, 4);
  room.add("ground", ground);
  room.slab("s0", 0), room.walls(0, false), room.slab("s1", kStorey + kSlab, 0.6);
  room.block("mast", {-12, -kSlab, -12}, {0.2, 14, 0.2});
  return room;
}

/// Everything in one mesh, the ceiling in many pieces, a wardrobe that is open below.
inline TrapRoom singleMesh() {
  TrapRoom room(true);
  TestMesh mesh;
  mesh.box({}, {kPlan.x, kStorey, kPlan.z}, true, 6);
  TestMesh wardrobe;
  wardrobe.box({0.5, 0, 0.5}, {1.2, 2.4, 0.6}, false);
  for (std::size_t i = 6; i < wardrobe.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) {
      const auto& p = wardrobe.positions[wardrobe.indices[i + k]];
      return Vec3{p[0], p[1], p[2]};
    };
    mesh.triangle(at(0), at(1), at(2));
  }
  room.add("mesh", mesh);
  return room;
}

/// Floor and walls, as models are drawn to be looked into; a cupboard as high as the walls stands within.
inline TrapRoom noCeiling() {
  TrapRoom room;
  room.slab("s0", 0), room.walls(0, false);
  room.block("cupboard", {1, 0, 1}, {0.8, kStorey, 0.8});
  return room;
}

/// One mesh of one-sided faces that all look out of the room.
inline TrapRoom insideOut() {
  TrapRoom room;
  TestMesh mesh;
  mesh.box({}, {kPlan.x, kStorey, kPlan.z}, false);
  room.add("shell", mesh);
  return room;
}

/// A ceiling and a floor that look into the room, and walls that look out of it.
inline TrapRoom halfTurned() {
  TrapRoom room;
  TestMesh level, walls;
  level.quad({}, {0, 0, kPlan.z}, {kPlan.x, 0, 0});
  level.quad({0, kStorey, 0}, {kPlan.x, 0, 0}, {0, 0, kPlan.z});
  const Vec3 up{0, kStorey, 0}, x{kPlan.x, 0, 0}, z{0, 0, kPlan.z};
  walls.quad({}, up, x), walls.quad(z, x, up), walls.quad({}, z, up), walls.quad(x, up, z);
  room.add("level", level), room.add("walls", walls);
  return room;
}

/// A room drawn in another unit than metres.
inline TrapRoom inUnits(double perMetre) {
  TrapRoom room;
  TestMesh mesh;
  mesh.box({}, perMetre * Vec3{kPlan.x, kStorey, kPlan.z}, true);
  room.add("room", mesh);
  return room;
}

/// A plain house whose every face has two sides.
inline TrapRoom twoSided() {
  TrapRoom room(true);
  room.slab("s0", 0), room.walls(0, false), room.slab("s1", kStorey + kSlab);
  return room;
}

/// A lowered ceiling of panels that do not touch, each its own square, below a slab.
inline TrapRoom panels() {
  TrapRoom room;
  room.slab("s0", 0), room.walls(0, false), room.slab("s1", kStorey + kSlab);
  TestMesh mesh;
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 8; ++j)
      mesh.box({0.6 * i + 0.01, kStorey - 0.2, 0.6 * j + 0.01}, {0.58, 0.02, 0.58}, false);
  room.add("panels", mesh);
  return room;
}

/// One mesh of triangles that all look their own way, some of which are missing.
inline TrapRoom scan() {
  TrapRoom room;
  TestMesh box, mesh;
  box.box({}, {kPlan.x, kStorey, kPlan.z}, true, 40);
  const auto moved = [](const std::array<float, 3>& p) {
    const auto by = [&](double phase) {
      return 0.02 * std::sin(37 * p[0] + 53 * p[1] + 71 * p[2] + phase);  // m
    };
    return Vec3{p[0] + by(0), p[1] + by(2), p[2] + by(4)};
  };
  for (std::size_t i = 0; i < box.indices.size(); i += 3)
    if (i % 70 != 0)
      mesh.triangle(moved(box.positions[box.indices[i]]), moved(box.positions[box.indices[i + 1]]),
                    moved(box.positions[box.indices[i + 2]]));
  room.add("mesh0", mesh);
  return room;
}

/// A room up to the ridge, whose roof is too steep for a ceiling.
inline TrapRoom gable() {
  TrapRoom room;
  TestMesh mesh;
  const double x = 8, z = 7, knee = 1.2, ridge = 4.2;
  mesh.quad({}, {0, 0, z}, {x, 0, 0});
  mesh.quad({}, {x, 0, 0}, {0, knee, 0}), mesh.quad({0, 0, z}, {0, knee, 0}, {x, 0, 0});
  mesh.quad({0, knee, 0}, {x, 0, 0}, {0, ridge - knee, z / 2});
  mesh.quad({0, ridge, z / 2}, {x, 0, 0}, {0, knee - ridge, z / 2});
  for (const double at : {0.0, x}) {
    const Vec3 a{at, 0, 0}, b{at, knee, 0}, c{at, ridge, z / 2}, d{at, knee, z}, e{at, 0, z};
    for (const auto& [p, q] : {std::pair{b, c}, std::pair{c, d}, std::pair{d, e}})
      at == 0 ? mesh.triangle(a, p, q) : mesh.triangle(a, q, p);
  }
  room.add("house", mesh);
  return room;
}

/// No material at all, and a table.
inline TrapRoom noMaterials() {
  TrapRoom room;
  TestMesh mesh, table;
  mesh.box({}, {kPlan.x, kStorey, kPlan.z}, true);
  table.box({1, 0, 1}, {0.8, 0.72, 0.6}, false);
  room.gltf.node("room", room.gltf.mesh(mesh)), room.gltf.node("table", room.gltf.mesh(table));
  return room;
}

}  // namespace fiatlux::testing
