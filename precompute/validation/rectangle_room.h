// Rooms made of rectangles, patched exactly as asked: the scenes of the analytic cases (`fiatlux validate`,
// tests).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "precompute/room/room.h"

namespace fiatlux {

/// One rectangle: corner + u edge + v edge; its front is where u x v points.
struct RectangleSurface {
  std::string name;
  Vec3 corner, u, v;  // m; u and v perpendicular
  double reflectance = 0;
  std::uint32_t columns = 1, rows = 1;  // patches along u and v
  bool measuring = false;
};

/// Surfaces in this order, measuring planes last; clusters of cluster x cluster patches. No sites.
Room rectangleRoom(const std::vector<RectangleSurface>& surfaces, std::uint32_t cluster = 4);

/// The six inner faces of a box from `corner`, y up: floor, ceiling, wall -x, wall +x, wall -z, wall +z;
/// patches of about `patch` metres.
std::vector<RectangleSurface> boxSurfaces(const Vec3& corner, const Vec3& size, double reflectance,
                                          double patch);
/// The same faces seen from outside: a block that stands in a room.
std::vector<RectangleSurface> blockSurfaces(const std::string& name, const Vec3& corner, const Vec3& size,
                                            double reflectance, double patch);

/// A grid of hanging sites over a rectangle: columns x rows squares of side `size`, its front side down the
/// normal.
std::vector<Site> siteGrid(const RectangleSurface& mount, std::uint32_t columns, std::uint32_t rows,
                           double size);

}  // namespace fiatlux
