// What is told of measuring planes by rays in the room itself: the truth beside what a scene file tells
// (core/transport/plane_light.h).
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/scene/plane_points.h"
#include "precompute/light/point_light.h"

namespace fiatlux {

/// Of each plane; `radiosity` as for readPoints. An error names a plane that has no point.
Result<std::vector<PlaneReading>> planeReadings(const Room& room, const RayTracer& tracer,
                                                const std::vector<PlaneWish>& wishes,
                                                const std::vector<Luminaire>& luminaires,
                                                const std::vector<float>& radiosity, PointOptions options);

}  // namespace fiatlux
