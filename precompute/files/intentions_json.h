// intentions.json read strictly: every key known, every type right, every surface found, or one line that
// says what is wrong and where. Surfaces are names (core/scene/surface_names.h) or lists of them.
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/scene/scene.h"
#include "core/search/intentions.h"

namespace fiatlux {

/// The intentions in `text` for this scene, checked by checkIntentions too.
Result<Intentions> parseIntentions(const Scene& scene, const std::string& text);

/// The same from a file; errors begin with the path.
Result<Intentions> readIntentionsFile(const Scene& scene, const std::string& path);

}  // namespace fiatlux
