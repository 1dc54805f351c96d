// Luminaires take room on their mounts: no search hangs two of them where they run into each other.
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/scene.h"

namespace fiatlux {

/// Do any of the scene's candidates take room? Squares of light take none.
bool haveBodies(const Scene& scene);

/// Do two of the scene's candidates run into each other: on mounts that lie in one plane, by more than a
/// touch?
bool collide(const Scene& scene, std::uint32_t a, std::uint32_t b);

/// Do two of a regular field, row by row from a corner, that hang in one way?
bool fieldCollides(const Scene& scene, const std::vector<std::uint32_t>& sites, std::size_t columns);

}  // namespace fiatlux
