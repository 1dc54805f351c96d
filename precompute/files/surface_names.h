// Surfaces as files and commands name them (core/scene/surface_names.h), with an answer for names that are
// not there.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace fiatlux {

/// The set that names mean together. An unknown name is answered with the closest ones.
Result<SurfaceSet> surfacesNamed(const Scene& scene, const std::vector<std::string>& names);

}  // namespace fiatlux
