// Which clusters single luminaires may make bright: what is seen of these must be known best.
#pragma once

#include <vector>

#include "precompute/light/cluster_parts.h"
#include "precompute/room/room.h"

namespace fiatlux {

/// Of every cluster, the illuminance that the nearest of the room's sites would give it if nothing were
/// between, over the mean of that by area, within bounds; 1 where there are no sites.
std::vector<double> brightestByMean(const Room& room, const ClusterParts& clusters);

}  // namespace fiatlux
