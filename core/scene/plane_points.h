// The points of a measuring plane's EN 12464-1 grid, and what is told there beside the light on the plane:
// the cylindrical illuminance (the mean of the vertical planes of all directions: how well faces are seen),
// its ratio to the horizontal one (modelling), and the light on vertical planes that face one way.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/calculation_grid.h"
#include "core/scene/scene.h"

namespace fiatlux {

/// A plane whose light is asked for, and on vertical planes that face which ways.
struct PlaneWish {
  std::uint32_t surface = 0;
  std::vector<Vec3> directions;  // unit, level
};

struct PlanePoint {
  Vec3 position;
  std::vector<PatchShare> shares;  // of the light on the plane
};

/// In the order of its grids. None on a surface that is no level measuring plane.
std::vector<PlanePoint> pointsOnPlane(const Scene& scene, std::uint32_t surface);

/// Done, or why nothing can be told of a surface; the line names it.
Result<Done> checkPlane(const Scene& scene, std::uint32_t surface);

/// Is everything of a wish there? Its verticals face exactly its directions.
bool isToldBy(const std::vector<PlaneLight>& planes, const PlaneWish& wish);

/// Against darkness every light is an infinite ratio; darkness against darkness is none (NaN).
double modellingOf(double cylindrical, double horizontal);

struct MeanAndLeast {
  double mean = 0, least = 0;
};

/// lx, but for modelling: the mean and the least of the ratios at the points.
struct PlaneReading {
  std::uint32_t surface = 0, points = 0;
  MeanAndLeast horizontal, cylindrical, modelling;
  struct Vertical {
    Vec3 direction;
    MeanAndLeast light;
  };
  std::vector<Vertical> verticals;
};

/// Of every plane under a layout, dimming included.
std::vector<PlaneReading> readPlanes(const std::vector<PlaneLight>& planes, const Layout& layout);

}  // namespace fiatlux
