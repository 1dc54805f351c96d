// Names of surfaces to leaves and back. A name is a leaf of the surface tree, an inner node of it (all leaves
// below), or "all": every leaf that is not a measuring plane. As a set "all" has one form, the empty one.
#pragma once

#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace fiatlux {

/// The leaves that a set stands for: itself, or those of "all" for the empty one. Sorted.
SurfaceSet leavesOf(const Scene& scene, const SurfaceSet& surfaces);

/// The leaves that a name means, sorted; none where nothing has that name.
SurfaceSet leavesNamed(const Scene& scene, const std::string& name);

/// The set that stands for leaves, sorted and different: the empty one where they are those of "all".
SurfaceSet setOfLeaves(const Scene& scene, const SurfaceSet& leaves);

/// Every name but "all", leaves and inner nodes, sorted.
std::vector<std::string> knownSurfaceNames(const Scene& scene);

/// "floor", "floor + desk 1", or "all": a set as a person reads it.
std::string surfaceSetName(const Scene& scene, const SurfaceSet& surfaces);

}  // namespace fiatlux
