// Drawing programs and printers have z up where glTF has y: which one a model has is guessed where it would
// else lie on its back.
#pragma once

#include <string>

#include "precompute/gltf/source_scene.h"

namespace fiatlux {

/// Whether a scene that was read as y up has its floors and ceilings across z: by what its author calls them,
/// or else where rooms would be far higher than rooms are and are not along z, and things stand that way.
/// False where its author has marked a mount. Deterministic. `scale`: metres per unit, 0 where it is a guess.
bool looksZUp(const SourceScene& source, double scale);

/// One line on a guess that says z, `source` being upright: the sizes before and after, how to refuse.
std::string noteOfUp(const SourceScene& source);

}  // namespace fiatlux
