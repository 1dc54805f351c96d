// Mean rows and covariances of quantised responses: what writer and reader of a file both know, so that only
// the difference to the true ones need be stored. Quick rather than exact: single precision, one order of
// sums.
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/patches.h"
#include "core/scene/scene.h"

namespace fiatlux {

/// The rows of each surface that count in its statistics, ascending.
std::vector<std::vector<std::uint32_t>> rowsOfSurfaces(const Patches& patches, std::uint32_t surfaces);

/// Area-weighted statistics of `rows` (at least one) of the responses: paper (8) and (11), of illuminance or
/// of exitance (reflectance times that).
SurfaceStatistics storedStatistics(const Patches& patches, const Responses& responses, Quantity quantity,
                                   const std::vector<std::uint32_t>& rows);

}  // namespace fiatlux
