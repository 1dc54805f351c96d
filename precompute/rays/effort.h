// How many more samples than usual the rows of small surfaces get, whose means and sigmas average over few
// patches and would else be noisy.
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/patches.h"

namespace fiatlux {

/// Rays from a row of effort 1, unless asked otherwise (--rays; docs/transport.md says why so many).
inline constexpr std::uint32_t kUsualRays = 1024;

inline constexpr std::uint32_t kMostEffort = 16;

/// A factor from 1 to kMostEffort for every row, the same on all rows of a surface, their mean at most 2; 1
/// for all where it is to be even.
std::vector<std::uint32_t> effortOfRows(const Patches& patches, bool isEven = false);

}  // namespace fiatlux
