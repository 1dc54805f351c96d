// What observers see, by rays in the room itself: the truth beside what a scene file tells
// (core/transport/room_view.h).
#pragma once

#include <vector>

#include "core/scene/observer.h"
#include "precompute/light/point_light.h"

namespace fiatlux {

/// Of each observer; `radiosity` as for readPoints.
std::vector<ObserverReading> observerReadings(const Room& room, const RayTracer& tracer,
                                              const std::vector<Observer>& observers,
                                              const std::vector<Luminaire>& luminaires,
                                              const std::vector<float>& radiosity,
                                              const PointOptions& options);

}  // namespace fiatlux
