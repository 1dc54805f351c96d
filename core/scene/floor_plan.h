// The floor in plan: where its walls are, as far as the patches tell.
#pragma once

#include <array>
#include <vector>

#include "core/scene/scene.h"

namespace fiatlux {

using PlanPoint = std::array<double, 2>;  // x and z, m

struct PlanSegment {
  PlanPoint from, to;
};

/// From a point to the nearest one of a segment, m.
double distance(const PlanPoint& point, const PlanSegment& segment);

/// Where a scene's floors end in plan, in pieces of one patch. What lies on a floor (a rug, a threshold) ends
/// nothing; the foot of a column does. None where there is no floor.
std::vector<PlanSegment> floorEdges(const Scene& scene);

}  // namespace fiatlux
