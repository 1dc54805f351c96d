// Whether a room will fit into the memory that may be used, asked while it is being made, before anything
// large is allocated; transport_memory.h asks again when its sizes are known.
#pragma once

#include <vector>

#include "precompute/charts.h"
#include "precompute/room_options.h"

namespace fiatlux {

/// Throws a CommandError that names the largest part where sizes that are known or foreseen need more than
/// --memory.
void checkForeseenMemory(const RoomOptions& options, double patches, double clusters, double rows,
                         double sites, double surfaces);

/// How many patches charts will have, about.
double foreseenPatches(const std::vector<ChartDraft>& charts);

/// Refuses grids that are too fine, before they are cut; `patch` in m, at most `mostClusters` outside
/// --paper.
void checkGrids(const std::vector<ChartDraft>& charts, const RoomOptions& options, double patch,
                std::uint32_t mostClusters);

}  // namespace fiatlux
