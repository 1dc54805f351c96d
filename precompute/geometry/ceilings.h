// Where luminaires would hang in a room whose author has marked nothing: its ceilings, storey by storey.
#pragma once

#include <string>
#include <vector>

#include "precompute/geometry/free_space.h"
#include "precompute/geometry/surfaces.h"

namespace fiatlux {

/// Share of the rays up from a floor that meet nothing, from which it lies outdoors.
inline constexpr double kOpenSky = 0.35;

/// The ceilings of one storey.
struct Ceiling {
  std::string name;         // of its largest surface
  std::vector<Face> faces;  // that face down
  double area = 0;          // m2
  double height = 0;        // m, of the largest one above its floor; 0: there is no floor below
  bool isOutdoors = false;  // the floor below the largest one lies under the open sky
};

/// Whether a name says ceiling in one of the common languages, and not a lamp that hangs there.
bool saysCeiling(const std::string& name);

/// What faces down and has free space before it, a floor 2 to 6 m below and no open sky above that floor;
/// what its author calls a ceiling comes first, and one that lies lower, higher or in the open only where
/// there is no better one. Storeys with the largest first; none where nothing is a ceiling.
std::vector<Ceiling> proposeCeilings(const SourceScene& source, const WeldedMesh& mesh,
                                     const SurfaceTree& tree, const FreeSpace& space);

}  // namespace fiatlux
