// The calculation grid of EN 12464-1 on floors and horizontal measuring planes: p = 0.2 * 5^log10(d) m, at
// most 10 m, d = the longer side, or the shorter one where they differ by a factor of two or more; on areas
// large enough to be rooms a rim of 0.5 m is left out, and so are points that something covers.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "precompute/light/point_light.h"
#include "precompute/rays/ray_tracer.h"

namespace fiatlux {

struct MeasuringGrid {
  std::uint32_t surface = 0;
  double spacing = 0;  // m, largest allowed; the grid's own is that or a little less
  double rim = 0;      // m left out
  std::vector<MeasuringPoint> points;
};

/// One grid for each horizontal upward surface: measuring planes, and floors (the lowest ones).
std::vector<MeasuringGrid> measuringGrids(const Room& room);

/// Largest spacing of grid points for sides of `length` and `width` metres.
double gridSpacing(double length, double width);

/// What the luminaires do to a grid.
struct GridReading {
  MeasuringGrid grid;
  double mean = 0, least = 0;                                        // lx: E_m and E_min
  double uniformity() const { return mean > 0 ? least / mean : 0; }  // U_o
};

/// Every grid of the room, read on its own plane (PointOptions::spatial does not matter); `radiosity` as in
/// readPoints.
std::vector<GridReading> readGrids(const Room& room, const RayTracer& tracer,
                                   const std::vector<Luminaire>& luminaires,
                                   const std::vector<float>& radiosity, PointOptions options);

}  // namespace fiatlux
