// A draft of a room: patches so long, and rays so few, that its light is there soon. The full light takes its
// place, so it need not last; means should be about what they will be then.
#pragma once

#include <cstdint>

namespace fiatlux {

/// From a patch of a draft.
inline constexpr std::uint32_t kDraftRays = 256;

/// As coreSeconds, of a draft that consists of so much.
double draftSeconds(double rows, double sites, double triangles);

/// How many times as long its patches are as those of the room, which consists of so much.
double draftCoarseness(double rows, double sites, double triangles);

}  // namespace fiatlux
