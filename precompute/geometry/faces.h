// Triangles after welding, and their faces: a face is one side of a triangle that takes part in the light.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/scene/patches.h"
#include "precompute/gltf/source_scene.h"
#include "precompute/room/room.h"

namespace fiatlux {

struct WeldedTriangle {
  std::array<std::uint32_t, 3> vertex;  // counter-clockwise from the front
  std::uint32_t mesh = 0;               // of the source scene
  std::uint32_t source = 0;             // which triangle of that mesh
  std::uint32_t backMesh = kNone;       // an equal triangle that faces the other way came from this mesh
  std::uint32_t backSource = 0;
};

/// All triangles of some meshes on common vertices; none without area, none twice.
struct WeldedMesh {
  std::vector<Vec3> positions;  // m
  std::vector<WeldedTriangle> triangles;
  double tolerance = 0;                         // m, vertices closer than this are one
  double diagonal = 0;                          // m, of the bounding box
  std::size_t withoutArea = 0, duplicates = 0;  // triangles that were dropped
};

/// Welds the listed meshes of a scene.
WeldedMesh weld(const SourceScene& source, const std::vector<std::uint32_t>& meshes);

/// One side of a welded triangle.
struct Face {
  std::array<std::uint32_t, 3> vertex;  // counter-clockwise seen from this side
  std::uint32_t triangle = 0;           // of the welded mesh
  std::uint32_t mesh = 0, source = 0;   // where its material comes from
  bool back = false;
};

/// Where the faces are, for points and rays on them.
std::vector<Fragment> trianglesOf(const WeldedMesh& mesh, const std::vector<Face>& faces);

inline Vec3 areaVector(const std::vector<Vec3>& positions, const std::array<std::uint32_t, 3>& v) {
  return 0.5 * cross(positions[v[1]] - positions[v[0]], positions[v[2]] - positions[v[0]]);
}

/// The back faces that double-sided sheets have (back_faces.cpp): those of double-sided materials whose
/// connected piece is open, is a thing turned inside out, or is a room drawn from outside. Other closed
/// pieces need none: nothing can be seen from behind them. `all`: as if every material were double-sided.
std::vector<Face> backFaces(const SourceScene& source, const WeldedMesh& mesh, bool all = false);

/// By triangle: one that stands for its closed piece, where the fronts of that look outward; else kNone.
std::vector<std::uint32_t> closedBodies(const SourceScene& source, const WeldedMesh& mesh);

}  // namespace fiatlux
