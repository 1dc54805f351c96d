// The calculation grids of EN 12464-1 (core/scene/calculation_grid.h) of a room before it is a scene: the
// same points, read by rays.
#pragma once

#include <vector>

#include "core/scene/calculation_grid.h"
#include "precompute/light/point_light.h"
#include "precompute/rays/ray_tracer.h"

namespace fiatlux {

/// A grid and where its points are.
struct MeasuringGrid {
  std::uint32_t surface = 0;
  PatchLattice lattice;
  CalculationGrid grid;
  std::vector<MeasuringPoint> points;
};

/// One grid for each chart of a floor or a level measuring plane that has a point.
std::vector<MeasuringGrid> measuringGrids(const Room& room);

/// Every grid of the room, read on its own plane (PointOptions::spatial does not matter). A patch that is
/// free for its greater part counts, and its point may be in the rest, under what stands there: a meter is
/// then put beside it, so such a point has what the patches around it get, `illuminance` (one a row), as in a
/// scene file. `radiosity` as in readPoints.
std::vector<GridReading> readGrids(const Room& room, const RayTracer& tracer,
                                   const std::vector<Luminaire>& luminaires,
                                   const std::vector<float>& radiosity, const std::vector<float>& illuminance,
                                   PointOptions options);

}  // namespace fiatlux
