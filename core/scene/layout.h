// Where the luminaires of a scene are, and what of its light is looked at.
#pragma once

#include <cstdint>
#include <vector>

namespace fiatlux {

enum class Quantity : std::uint8_t {
  kIlluminance,  // lx
  kExitance,     // reflected lm/m2 (the paper's B)
  kDirect,       // lx, of what nothing has reflected yet: emergency lighting counts no more (EN 1838)
};

inline constexpr const char* kQuantityNames[] = {"illuminance", "exitance",
                                                 "direct"};  // in intentions.json, by code

/// A set of leaf surfaces by index, sorted, unique. Empty means "all" (every leaf that is not a measuring
/// plane).
using SurfaceSet = std::vector<std::uint32_t>;

/// Luminaire i hangs on sites[i] (at most one a site) and emits dimming * flux[i] lm.
struct Layout {
  std::vector<std::uint32_t> sites;
  std::vector<double> flux;  // lm each, before dimming
  double dimming = 1;
  std::vector<std::uint32_t> ties = {};  // of each, the number of the tie it moves with; empty: none is tied
};

}  // namespace fiatlux
