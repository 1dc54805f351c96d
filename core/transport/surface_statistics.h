// Mean rows and covariances of surfaces, straight from responses: paper equations (8) and (11), in double.
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/patches.h"
#include "core/scene/scene.h"

namespace fiatlux {

/// Area-weighted mean row and population covariance of `columns` columns over the patches of one surface.
/// values: row-major rows x columns of these patches only, in the order of `members`; weights: their areas.
SurfaceStatistics surfaceStatistics(const float* values, const double* weights, std::uint32_t members,
                                    std::uint32_t columns);

/// Of responses: per leaf surface, of illuminance (lx per lm) or of exitance rho g (lm/m2 per lm; measuring
/// planes get empty statistics). An index in [0, surfaceCount).
SurfaceStatistics responseStatistics(const Patches& patches, const Responses& responses, Quantity quantity,
                                     std::uint32_t surface);

/// Sets the statistics of `quantity`, and those of illuminance, to mean rows alone, made of the scene's
/// responses over the patches that count: unionStatistics then makes covariances where they are asked for.
void setMeanRows(Quantity quantity, Scene& scene);

}  // namespace fiatlux
