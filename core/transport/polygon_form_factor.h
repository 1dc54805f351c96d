// Form factor from a point to a polygon, Lambert 1760: F = 1 / (2 pi) sum of (angle of edge i at the point) x
// (normal of the plane through the edge and the point) . n. Exact: no distance is too short for it.
#pragma once

#include <cstddef>

#include "core/base/vec3.h"

namespace fiatlux {

/// Share 0..1 of the cosine-weighted hemisphere above `point` (unit `normal`) that a convex planar polygon of
/// at most 14 corners (m, either orientation) fills; what lies below the horizon does not count.
double polygonFormFactor(const Vec3& point, const Vec3& normal, const Vec3* corners, std::size_t count);

}  // namespace fiatlux
