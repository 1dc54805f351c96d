// The luminous area of a luminaire as it is seen from a direction.
#pragma once

#include "core/base/vec3.h"
#include "core/photometry/photometry.h"

namespace fiatlux {

/// m2, projected along the unit vector `direction` (from the luminaire to the eye) in the luminaire's axes: x
/// along C0, y along C90, z along gamma 0. The bodies are convex, so this is exact; 0 for a point.
double projectedArea(const LuminousArea& area, PhotometricAxis longAxis, const Vec3& direction);

}  // namespace fiatlux
