// Means over surfaces in a file: logarithms, for what counts is the share of light that is missing, each
// predicted from its neighbours left, above and at the corner, and range coded: likely as far off as these
// were, and as it was on the surface before.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/scene/light_operator.h"
#include "core/scene/patches.h"

namespace fiatlux {

/// Of the logarithm of a mean over a large surface.
inline constexpr double kSurfaceExchangeStep = 0.03f;

/// Surface after surface; small ones in larger steps.
std::vector<std::uint8_t> encodeSurfaceExchange(const Patches& patches, const SurfaceExchange& exchange);
/// The inverse, into exchange.means. "" or what does not fit. `isOlder`: as before method 9,
/// without regard to the surface before.
std::string decodeSurfaceExchange(std::span<const std::uint8_t> bytes, const Patches& patches,
                                  SurfaceExchange& exchange, double step = kSurfaceExchangeStep,
                                  bool isOlder = false);

}  // namespace fiatlux
