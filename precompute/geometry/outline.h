// The boundary of a region as a person sees it: straight sides, however many edges they are made of.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "precompute/geometry/face_set.h"

namespace fiatlux {

using BoundaryStep = std::pair<std::uint32_t, std::uint32_t>;  // from vertex, to vertex

/// The sub-edges that the faces' turns do not cancel, sorted.
std::vector<BoundaryStep> boundaryOf(const FaceSet& set, const std::vector<std::uint32_t>& faces);

/// The straight sides of a region's boundary: neighbouring edges in one line are one side.
struct Outline {
  double perimeter = 0;   // m
  Vec3 longestDirection;  // unit, of the longest side (ties: nearest to x, then y, then z); zero without a
                          // boundary
};
/// O(N log N) in the number of faces.
Outline outlineOf(const WeldedMesh& mesh, const FaceSet& set, const std::vector<std::uint32_t>& faces);

}  // namespace fiatlux
