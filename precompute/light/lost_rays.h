// Where a room loses light, before anything is computed: faces that are turned the wrong way, and openings.
#pragma once

#include <string>
#include <vector>

#include "precompute/rays/ray_tracer.h"

namespace fiatlux {

/// One line for every surface (the worst eight) whose back, which is no surface, meets half a per cent or
/// more of a sample of rays, and one where as many leave the room, with the ways they take; each with its
/// cure.
std::vector<std::string> warningsOfLostRays(const Room& room, const RayTracer& tracer);

}  // namespace fiatlux
