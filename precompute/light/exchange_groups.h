// The groups between which light is exchanged: rows of one facing that see the room alike.
#pragma once

#include <cstdint>

#include "core/scene/light_operator.h"
#include "precompute/rays/ray_tracer.h"
#include "precompute/room/memory.h"
#include "precompute/room/room.h"

namespace fiatlux {

/// The grids of a room's charts, as a scene keeps them.
Charts chartsOf(const Room& room);

/// Blocks of about 4 x 4 cells of large charts, small charts together by surface, direction and place; split
/// where something stands between neighbouring cells. Blocks grow until there are at most kMostGroups.
ExchangeGroups exchangeGroups(const Room& room, const RayTracer& tracer);

}  // namespace fiatlux
