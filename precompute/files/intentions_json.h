// intentions.json read strictly: every key known, every type right, every surface found, or one line that
// says what is wrong and where. Surfaces are names of leaves or of inner nodes of the surface tree, "all", or
// lists of these.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/scene.h"
#include "core/search/intentions.h"

namespace fiatlux {

/// The intentions in `text` for this scene, checked by checkIntentions too.
Result<Intentions> parseIntentions(const Scene& scene, const std::string& text);

/// The same from a file of at most 1 MB; errors begin with the path.
Result<Intentions> readIntentionsFile(const Scene& scene, const std::string& path);

/// The leaves that a name means: a leaf itself, all leaves below an inner node ("node" of "node/material"),
/// or "all" (every leaf that is not a measuring plane: the empty set). An unknown name is answered with the
/// closest ones.
Result<SurfaceSet> surfacesNamed(const Scene& scene, const std::vector<std::string>& names);

}  // namespace fiatlux
