// The one formula of what a run needs, from plain counts: asked while a room is being made, from what is
// known or foreseen by then, before anything large is allocated.
#pragma once

#include <cstdint>
#include <string>

#include "core/base/result.h"

namespace fiatlux {

/// Groups of patches between which light is exchanged: never more.
inline constexpr std::uint32_t kMostGroups = 3000;

/// What a run consists of; 0 where nothing is known or foreseen yet.
struct RunCounts {
  double patches = 0;   // n
  double clusters = 0;  // k
  double rows = 0;      // n and the patches of measuring planes
  double sites = 0;     // m
  double surfaces = 0;
  std::uint32_t rays = 0;  // per patch
  bool exchange = false;   // visible shares and the exchange between groups of patches as well
  bool paper = false;      // --paper: a ray's patch is kept each, Y and k x k covariances as well
  unsigned threads = 1;
};

/// Bytes that making a scene would hold at its peak.
double bytesNeeded(const RunCounts& counts);

/// An error that names what is too many, and the cure, where that is more than `gigabytes`.
Result<Done> checkMemory(const RunCounts& counts, double gigabytes);

}  // namespace fiatlux
