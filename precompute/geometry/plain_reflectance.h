// What meshes without a material, or with a pure white one, reflect: the usual values
// of lighting design, by what a face is in its room.
#pragma once

#include <string>
#include <vector>

#include "precompute/geometry/surfaces.h"

namespace fiatlux {

/// By mesh of the source and its triangle; no values for a mesh that has a material's colour, colours of its
/// vertices or a reflectance of its own. Ceilings 0.7, walls 0.5, floors 0.2, other things 0.4.
struct AssumedReflectance {
  std::vector<std::vector<float>> ofTriangle;
  std::string note;  // one line; "" where nothing is assumed
};
AssumedReflectance assumeReflectance(const SourceScene& source, const SurfaceTree& tree);

}  // namespace fiatlux
