// How even can a plane be lit at all from the places where luminaires may hang? Any weights w of its points
// (>= 0, sum 1) prove something: the least light of a layout is not above its light averaged by w, so that
// least / mean is not above the largest (w . column) / (mean of column) that a single luminaire has. The
// weights are found as the one side of a matrix game, by regret matching (Tammelin 2014, "CFR+").
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/scene.h"
#include "core/search/intentions.h"
#include "core/search/prepared_scene.h"

namespace fiatlux {

/// No layout that leaves the excluded sites free, of however many luminaires at whatever fluxes, reaches a
/// uniformity above this on the points that a constraint speaks of. Precondition: as for lightAtPoints
/// (core/search/plane_values.h).
double evennessLimit(PreparedScene& prepared, const Constraint& constraint,
                     const std::vector<std::uint32_t>& excluded);

}  // namespace fiatlux
