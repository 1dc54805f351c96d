// The shape of patches: a rectangle as large as each, on the grid of its chart.
#pragma once

#include <vector>

#include "core/base/vec3.h"
#include "core/scene/light_operator.h"
#include "core/scene/patches.h"

namespace fiatlux {

struct PatchTile {
  Vec3 edgeU, edgeV;                // m, perpendicular, in the patch's plane
  double lengthU = 0, lengthV = 0;  // m
};

/// Of every row. What is not a whole cell is a rectangle of its area, as long as it is along the cell's
/// sides.
std::vector<PatchTile> patchTiles(const Patches& patches, const Charts& charts);

}  // namespace fiatlux
