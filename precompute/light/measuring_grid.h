// The calculation grid of EN 12464-1 on floors and horizontal measuring planes: p = 0.2 * 5^log10(d) m, at
// most 10 m, d = the longer side, or the shorter one where they differ by a factor of two or more; on areas
// large enough to be rooms a rim of 0.5 m is left out.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "precompute/light/point_light.h"
#include "precompute/room/room.h"

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

}  // namespace fiatlux
