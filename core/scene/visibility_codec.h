// Visible shares of sites in a file, in fewer steps of their square root than shadow rays tell. Whether a row
// sees a site wholly, partly or not at all is range coded by what the cells beside it see of the same site
// and what it sees of sites beside that; how much, only of the partly seen, against what these say together.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/scene/light_operator.h"
#include "core/scene/patches.h"

namespace fiatlux {

/// Steps of a whole share's root in a file.
inline constexpr std::uint32_t kStoredShares = 12;

/// Visible shares of the sites [first, last).
std::vector<std::uint8_t> encodeVisibility(const Patches& patches, const std::vector<Site>& sites,
                                           const SiteVisibility& visibility, std::uint32_t first,
                                           std::uint32_t last);
/// The inverse, into visibility.steps, which has its size. "" or what does not fit. `stored`: steps that the
/// file counts in, 2..SiteVisibility::kSteps.
std::string decodeVisibility(std::span<const std::uint8_t> bytes, const Patches& patches,
                             const std::vector<Site>& sites, std::uint32_t first, std::uint32_t last,
                             SiteVisibility& visibility, std::uint32_t stored = kStoredShares);

}  // namespace fiatlux
