// "planes" of a layout, and what is told of them (core/scene/plane_points.h), as JSON and for a person.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/plane_points.h"

namespace fiatlux {

class JsonField;

/// As it is written.
struct AskedPlane {
  std::string surface;
  std::vector<Vec3> directions;  // unit, level
};

/// ["desk plane", {"surface": "board plane", "directions": [[0, 0, 1]]}]
std::vector<AskedPlane> planesOf(const JsonField& json);

/// A direction that is level, made a unit one.
Vec3 levelDirectionOf(const JsonField& json);

/// An error names the first that is no measuring plane of the room.
Result<std::vector<PlaneWish>> planeWishes(const std::vector<AskedPlane>& asked,
                                           const std::vector<Surface>& surfaces);

/// [{"surface", "points", "horizontal": {"mean", "min"}, "cylindrical", "modelling", "vertical":
/// [{"direction", "mean", "min"}]}]; a ratio of null: no light on the plane.
nlohmann::ordered_json planesJson(const std::vector<Surface>& surfaces,
                                  const std::vector<PlaneReading>& readings);
/// A line for each.
std::string planesText(const std::vector<Surface>& surfaces, const std::vector<PlaneReading>& readings);

/// "(1, 0, 0)"
std::string directionText(const Vec3& direction);

}  // namespace fiatlux
