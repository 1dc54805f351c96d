// What falls at the points of measuring planes on cylinders and on vertical planes
// (core/scene/plane_points.h): direct light part by part of each luminaire, as far as tiles of the room let
// it through, and what a few thousand lines of sight meet of the light on the room's surfaces.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/scene/luminaire.h"
#include "core/scene/plane_points.h"
#include "core/transport/room_view.h"

namespace fiatlux {

/// For every wish, of each luminaire at its flux; column j of the responses is its light in the room as the
/// view has it. Of columns beyond the luminaires: what the room reflects of them. The scene must have a light
/// operator, and its planes points (checkPlane).
std::vector<PlaneLight> planeLight(const Scene& room, const RoomView& view,
                                   const std::vector<PlaneWish>& wishes,
                                   const std::vector<Luminaire>& luminaires, const Responses& responses);

/// Makes what of these is missing in scene.planes, of the squares on its sites. An Error in a scene whose
/// file does not tell the shape of its patches, or where modelling would be told of a plane that no light
/// reaches.
Result<Done> addPlanes(Scene& scene, const std::vector<PlaneWish>& wishes);

/// Done, or an Error that names a plane of these which no light reaches.
Result<Done> checkLit(const Scene& scene, const std::vector<PlaneLight>& planes);

}  // namespace fiatlux
