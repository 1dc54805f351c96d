// What a person says of a model that its file says otherwise: which way is up, and what materials reflect.
#pragma once

#include <vector>

#include "precompute/geometry/room_options.h"
#include "precompute/gltf/source_scene.h"

namespace fiatlux {

/// From z up to y up: positions and normals are turned a quarter about x.
void standUpright(SourceScene& source);

/// Every material of a name gets that reflectance: of its own hue as far as that stays a colour, grey where a
/// picture said what it was. Throws CommandError where no material is called so.
void repaint(const std::vector<NamedReflectance>& reflectances, SourceScene& source);

}  // namespace fiatlux
