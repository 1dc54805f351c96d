// Cracks of the picture: neighbours that are cut at different points of a common edge are cut at all of them.
#pragma once

#include "precompute/picture/display_part.h"

namespace fiatlux {

/// Splits triangles of the parts at vertices of others that lie on their open edges, within charts, between
/// charts and between surfaces. What was watertight in the room is so in the picture (to about 0.1 mm).
void closeJunctions(const PatchBlender& blender, Parts& parts);

}  // namespace fiatlux
