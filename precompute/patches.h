// Charts -> patches: what of a chart's faces lies in one cell of its grid. DESIGN: patches follow area, not triangles.
#pragma once

#include <string>
#include <vector>

#include "precompute/charts.h"
#include "precompute/reflectance.h"
#include "precompute/room.h"

namespace fiatlux {

/// Appends the patches of `drafts` (and their charts, fragments) to the room, in order. `reflectance` null: receivers,
/// which have none. Slivers below 5 % of a cell join a neighbour; charts far smaller than a patch share patches with
/// like-minded ones nearby. Nothing of the area is lost.
void appendPatches(const WeldedMesh& mesh, std::vector<ChartDraft>& drafts, double patch, const ReflectanceMap* reflectance, Room& room);

/// Fills `cluster`, clusterCount: blocks of edge x edge cells of a chart. Unless `exact`, blocks grow (and small charts
/// share clusters) until there are at most `most`. Returns the edge that was used.
std::uint32_t assignClusters(Room& room, std::uint32_t edge, std::uint32_t most, bool exact);

}  // namespace fiatlux
