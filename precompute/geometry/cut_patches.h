// Charts -> patches: what of a chart's faces lies in one cell of its grid. Patches follow area, not
// triangles: a wall has as many however it is triangulated.
#pragma once

#include <string>
#include <vector>

#include "precompute/geometry/charts.h"
#include "precompute/gltf/reflectance.h"
#include "precompute/room/room.h"

namespace fiatlux {

/// Appends the patches of `drafts` (and their charts, fragments) to the room, in order. `reflectance` null:
/// receivers, which have none. Slivers below 5 % of a cell join a neighbour; charts far smaller than a patch
/// share patches with like-minded ones nearby. Nothing of the area is lost.
void appendPatches(const WeldedMesh& mesh, std::vector<ChartDraft>& drafts, double patch,
                   const ReflectanceMap* reflectance, Room& room);

}  // namespace fiatlux
