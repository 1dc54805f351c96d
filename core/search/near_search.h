// Steadiness: when a luminaire is moved by hand, only a few of those beside it make up for it and all others
// stay where they are. Which few is found out by a short search for each choice, then by exchanging one of
// them for another.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/search/layout_search.h"

namespace fiatlux {

inline constexpr std::uint32_t kMostFollowers = 4;  // luminaires that may leave their places

/// The search that goes on for the best choice of followers, from `start`, whose luminaires `moved` stay
/// where they are put as do the pinned ones; the count is that of `start`. Null where the arrangement ties
/// luminaires together, the rules want another count or nothing may follow. Preconditions: those of
/// LayoutSearch; `start` is of the scene's sites, each at most once, and holds at least one luminaire.
std::unique_ptr<LayoutSearch> searchNear(PreparedScene& prepared, const Intentions& intentions,
                                         std::uint64_t seed, const Layout& start,
                                         const std::vector<std::uint32_t>& moved);

}  // namespace fiatlux
