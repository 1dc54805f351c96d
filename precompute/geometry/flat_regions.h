// Connected planes among faces: what a person calls a wall, however it is triangulated.
#pragma once

#include <vector>

#include "precompute/geometry/face_set.h"
#include "precompute/geometry/outline.h"

namespace fiatlux {

struct Region {
  std::vector<std::uint32_t> faces;  // indices into the set
  Vec3 normal, centroid;             // unit; m
  double area = 0;                   // m2
  Outline outline;
};

/// How far a plane may leave itself: not at all; by 3 degrees and 1 % of its size, as hand-made walls do; by
/// 45 degrees and 5 cm, as the triangles of a scan do.
enum class Flatness { kExact, kHandMade, kScanned };

/// Partitions the set into connected planar regions, largest seed first.
std::vector<Region> flatRegions(const WeldedMesh& mesh, const FaceSet& set,
                                Flatness flatness = Flatness::kHandMade);

}  // namespace fiatlux
