// Visible shares of sites in a file. Whether a row sees a site wholly, partly or not at all is range coded by
// what the cells beside it see of the same site and of the one before; how much, only of the partly seen.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/scene/light_operator.h"
#include "core/scene/patches.h"

namespace fiatlux {

/// Visible shares of the sites [first, last).
std::vector<std::uint8_t> encodeVisibility(const Patches& patches, const SiteVisibility& visibility,
                                           std::uint32_t first, std::uint32_t last);
/// The inverse, into visibility.steps, which has its size. "" or what does not fit.
std::string decodeVisibility(std::span<const std::uint8_t> bytes, const Patches& patches, std::uint32_t first,
                             std::uint32_t last, SiteVisibility& visibility);

}  // namespace fiatlux
