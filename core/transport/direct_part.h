// What reaches the patches before anything reflects it (Quantity::kDirect), from the light operator of a
// scene: a file knows all light of a site, and which share of the site each patch sees.
#pragma once

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace fiatlux {

/// Fills scene.direct with the light of the squares on its sites, unless it is there already. An Error in a
/// scene whose file has no operator.
Result<Done> addDirect(Scene& scene);

}  // namespace fiatlux
