// Where a room loses light, before anything is computed: faces that are turned the wrong way, and openings.
#pragma once

#include <string>
#include <vector>

#include "precompute/rays/ray_tracer.h"

namespace fiatlux {

/// One line where half a per cent or more of a sample of rays leave the room, with the ways they take, and
/// one for the surfaces whose backs, which are no surfaces, meet as many; each with its cure. Rays within
/// walls do not count.
std::vector<std::string> warningsOfLostRays(const Room& room, const RayTracer& tracer);

}  // namespace fiatlux
