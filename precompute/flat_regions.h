// Connected planes among faces: what a person calls a wall, however it is triangulated.
#pragma once

#include <vector>

#include "precompute/faces.h"

namespace fiatlux {

/// A piece of a face's edge between neighbouring vertices of the set, T-junctions included.
struct SubEdge {
  std::uint32_t a = 0, b = 0;  // a < b
  std::uint32_t face = 0;      // index into the set
  bool forward = true;         // the face runs from a to b
};

/// Faces of one group with their neighbourhood.
struct FaceSet {
  std::vector<Face> faces;
  std::vector<SubEdge> edges;                            // sorted by (a, b, face)
  std::vector<std::uint32_t> faceEdgeOffset, faceEdges;  // indices into edges, per face
  std::vector<std::uint32_t> neighborOffset, neighbors;  // faces that share a sub-edge, per face
};

/// Splits edges at vertices that lie on them and finds who shares what. O(N log N) but for pathological
/// soups, which are cut short (their T-junctions stay open).
FaceSet makeFaceSet(const WeldedMesh& mesh, std::vector<Face> faces);

/// The straight sides of a region's boundary: neighbouring edges in one line are one side.
struct Outline {
  double perimeter = 0;   // m
  Vec3 longestDirection;  // unit, of the longest side (ties: nearest to x, then y, then z); zero without a
                          // boundary
};
/// O(N log N) in the number of faces.
Outline outlineOf(const WeldedMesh& mesh, const FaceSet& set, const std::vector<std::uint32_t>& faces);

struct Region {
  std::vector<std::uint32_t> faces;  // indices into the set
  Vec3 normal, centroid;             // unit; m
  double area = 0;                   // m2
  Outline outline;
};

/// Partitions the set into connected planar regions, largest seed first. Unless `strict`, a plane may be bent
/// by up to 3 degrees and 1 % of its size, as hand-made walls are.
std::vector<Region> flatRegions(const WeldedMesh& mesh, const FaceSet& set, bool strict = false);

}  // namespace fiatlux
