// Zones: parts of a leaf surface that count as leaves of their own, as a task area on a measuring plane, the
// band around it and the rest of the plane. They own no rows of the responses: they share those of the leaf
// that they are of.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace fiatlux {

/// Replaces the zones of a scene: they are its last surfaces, outside "all" and without exitance. An Error,
/// and nothing changes, where a name is taken, or a zone has no rows or others than those of its leaf that
/// count, ascending.
Result<Done> takeZones(Scene& scene, const std::vector<Zone>& zones);

/// The means of a zone, for whatever light that each site sends; no covariance.
SurfaceStatistics zoneMeans(const Scene& scene, const Responses& responses, const Zone& zone);

/// The first surface that is a zone, or their number where none is.
inline std::uint32_t firstZone(const Scene& scene) {
  return static_cast<std::uint32_t>(scene.surfaces.size() - scene.zones.size());
}

}  // namespace fiatlux
