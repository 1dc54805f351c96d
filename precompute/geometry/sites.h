// Where luminaires may hang: whole squares of a grid on each mount, shining away from it.
#pragma once

#include <vector>

#include "precompute/geometry/faces.h"

namespace fiatlux {

/// Sites on the planes of a mount: squares of `size` in a grid of `spacing` (m) centred on each plane's
/// outline and aligned with its longest edge, only where they lie wholly on it. Where the mount has planes
/// that face down, only those count. Where no square finds room, the mount is taken to be drawn in pieces,
/// like panels in a grid or a scan: pieces in about one plane are one, and gaps between them do not count.
std::vector<Site> sitesOn(const WeldedMesh& mesh, const std::vector<Face>& faces, double spacing,
                          double size);

/// The faces that sitesOn would use.
std::vector<Face> facesForSites(const WeldedMesh& mesh, const std::vector<Face>& faces);

/// Area of the planes that sitesOn would use, m2.
double mountArea(const WeldedMesh& mesh, const std::vector<Face>& faces);

}  // namespace fiatlux
