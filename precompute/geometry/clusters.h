// Clusters of patches, the k columns of the low-rank form factors (paper section 2.4: about 4 x 4 patches
// each).
#pragma once

#include <cmath>
#include <cstdint>

#include "precompute/room/room.h"

namespace fiatlux {

/// Which of -x, +x, -y, +y, -z, +z a direction is nearest to, 0..5.
inline int dominantDirection(const Vec3& n) {
  const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
  const int axis = x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  return 2 * axis + ((axis == 0 ? n.x : axis == 1 ? n.y : n.z) > 0);
}

/// Fills `cluster` and clusterCount of the room's patches: blocks of edge x edge cells of a chart. Unless
/// `exact`, small clusters join and blocks grow until there are at most `most`. Returns the edge that was
/// used.
std::uint32_t assignClusters(Room& room, std::uint32_t edge, std::uint32_t most, bool exact);

}  // namespace fiatlux
