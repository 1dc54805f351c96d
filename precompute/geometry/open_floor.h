// The floor of a room without a ceiling, over which luminaires hang in a plane of their own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "precompute/geometry/free_space.h"
#include "precompute/geometry/surfaces.h"

namespace fiatlux {

struct OpenFloor {
  std::string name;         // of its largest surface
  std::vector<Face> faces;  // that face up
  double area = 0;          // m2
  double walls = 0;  // m, from the floor to where most of the walls around it end, or a roof over half of it;
                     // 0: there is none
};

/// The largest plane that faces up with free space above, and what lies as high; indoors before outdoors.
std::optional<OpenFloor> largestFloor(const WeldedMesh& mesh, const SurfaceTree& tree,
                                      const FreeSpace& space);

/// How high over that floor luminaires are proposed to hang, m: just below the top of the walls, or 2.7.
double proposedHeight(const OpenFloor& floor);

}  // namespace fiatlux
