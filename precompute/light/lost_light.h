// Where a room loses light, before anything is computed: openings, and faces that are turned the wrong way.
#pragma once

#include <string>
#include <vector>

#include "core/scene/luminaire.h"
#include "precompute/rays/ray_tracer.h"

namespace fiatlux {

struct LostLight {
  double share = 0;  // of the flux, through openings and in backs
  /// One line where half a per cent or more leaves the room, with the ways it takes, and one for the surfaces
  /// whose backs, which are no surfaces, swallow as much; each with its cure.
  std::vector<std::string> warnings;
};

/// Follows a sample of the light of all sites alike, or where there is none of the luminaires, from patch to
/// patch.
LostLight lostLight(const Room& room, const std::vector<Luminaire>& luminaires, const RayTracer& tracer);

}  // namespace fiatlux
