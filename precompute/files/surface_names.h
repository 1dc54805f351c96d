// Names of surfaces to leaves of the surface tree.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/layout.h"
#include "core/scene/scene.h"

namespace fiatlux {

/// The leaves that names mean, sorted: a leaf itself, all leaves below an inner node ("node" of
/// "node/material"), or "all" (every leaf that is not a measuring plane: the empty set). An unknown name is
/// answered with the closest ones.
Result<SurfaceSet> surfacesNamed(const Scene& scene, const std::vector<std::string>& names);

}  // namespace fiatlux
