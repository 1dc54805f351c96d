// Clusters of patches, the k columns of the low-rank form factors (paper section 2.4: about 4 x 4 patches
// each).
#pragma once

#include <cstdint>

#include "precompute/room/direction.h"
#include "precompute/room/room.h"

namespace fiatlux {

/// Fills `cluster` and clusterCount of the room's patches: blocks of edge x edge cells of a chart. Unless
/// `exact`, small clusters join and blocks grow until there are at most `most`. Returns the edge that was
/// used.
std::uint32_t assignClusters(Room& room, std::uint32_t edge, std::uint32_t most, bool exact);

}  // namespace fiatlux
