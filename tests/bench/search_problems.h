// The problems of the benchmark of search quality: ten families of intentions, asked of any room and number
// of luminaires. Their bounds are quantiles of random layouts in that room, so that every problem is tight
// and one of these layouts, at least, meets all of it; the same on every machine.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/search/intentions.h"
#include "core/search/prepared_scene.h"

namespace fiatlux {

/// What a room's problems are about.
struct ProblemSurfaces {
  SurfaceSet focus, other, third;
};

/// "even", "varied", ...; nothing for a family that does not exist. `prepared` is of sites.
std::optional<Intentions> problemOf(PreparedScene& prepared, const ProblemSurfaces& surfaces,
                                    const std::string& family, std::uint32_t count);

}  // namespace fiatlux
