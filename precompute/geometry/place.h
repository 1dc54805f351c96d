// One place of a building alone: what the air around a point touches, through open doors as far as is wished;
// the rest is left out before there are surfaces.
#pragma once

#include <string>

#include "precompute/geometry/room_options.h"
#include "precompute/gltf/source_scene.h"

namespace fiatlux {

/// Takes all but the place out of a scene in metres, y up; triangles end where it ends, and what it opens on
/// gets a lid, one-sided surface "lid", as far as one is wished. One line on what stays. Throws CommandError
/// where the point lies in no air.
std::string keepPlace(const PlaceOptions& place, SourceScene& source);

}  // namespace fiatlux
