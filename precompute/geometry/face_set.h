// Faces with their neighbourhood: who shares an edge, or a part of one.
#pragma once

#include <cstdint>
#include <vector>

#include "precompute/geometry/faces.h"

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

}  // namespace fiatlux
