// A room that tests light: a box with something in it and a measuring plane.
#pragma once

#include <vector>

#include "precompute/validation/rectangle_room.h"

namespace fiatlux::testing {

/// Walls of 0.5, a floor of 0.3 (surface 0), a ceiling of 0.7 (surface 1) with a grid of 12 sites, the
/// furniture, and a plane at 0.75 m, the last surface. `patch`: m, the edge of a patch.
inline Room furnishedBox(const Vec3& size, const std::vector<RectangleSurface>& furniture, double patch) {
  std::vector<RectangleSurface> faces = boxSurfaces({0, 0, 0}, size, 0.5, patch);
  faces[0].reflectance = 0.3;
  faces[1].reflectance = 0.7;
  faces.insert(faces.end(), furniture.begin(), furniture.end());
  RectangleSurface plane = faces[0];
  plane.name = "plane";
  plane.corner.y = 0.75;
  plane.measuring = true;
  faces.push_back(plane);
  Room room = rectangleRoom(faces);
  room.sites = siteGrid(faces[1], 3, 4, 0.5);
  return room;
}

}  // namespace fiatlux::testing
