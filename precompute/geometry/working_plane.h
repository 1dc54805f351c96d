// The working plane: a measuring plane over the floor on which the luminaires' light falls, without a rim.
#pragma once

#include "precompute/geometry/inside.h"

namespace fiatlux {

/// One mesh, "working plane", options.plane above the floor below the mounts and options.planeRim within its
/// edges, facing up. Throws CommandError where there is no floor, or none as wide as two rims.
SourceScene workingPlane(const WeldedMesh& mesh, const Inside& inside, const RoomOptions& options);

}  // namespace fiatlux
