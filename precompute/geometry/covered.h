// Area that is there and that nobody can light, see or measure: floor under a cabinet, wall behind a shelf, a
// measuring plane where it passes through furniture. Its darkness says nothing about a layout, and a minimum
// or a uniformity over it would always be 0.
#pragma once

#include <cstdint>
#include <vector>

#include "precompute/rays/ray_tracer.h"
#include "precompute/room/room.h"

namespace fiatlux {

/// One value a row of the patches, 1 = covered; empty where none is. A patch is covered where at least half
/// of its area is hidden, by whatever hides each place: a body closer than 2 cm in front of it, or around it,
/// or things closer than 25 cm on both sides, 50 cm in a slit not higher than 15 cm, as of floor under a low
/// sofa or wall behind a shelf. A measuring plane where something lies on it (within 10 cm above) or where it
/// is inside a body. A surface that would be covered throughout counts as a whole. The same for any number of
/// threads.
std::vector<std::uint8_t> coveredRows(const Room& room, const RayTracer& tracer, unsigned threads);

}  // namespace fiatlux
