// What lighter paint would do for what is asked of the light: the derivative of every goal and constraint
// with respect to the reflectance of each surface, in the room as it is painted.
#pragma once

#include <cstdint>
#include <vector>

#include "core/search/intentions.h"
#include "core/transport/exchange.h"
#include "core/transport/repaint.h"

namespace fiatlux {

/// Per 0.1 more reflectance of a surface, in the units of the readings (core/search/shown.h).
struct PaintGain {
  std::uint32_t surface = 0;
  std::vector<double> goals, constraints;
};

inline constexpr std::size_t kMostGains = 96;  // surfaces: the largest

/// Of the surfaces that can be painted, by their numbers. `light`: rows, lx, of a layout in the repainted
/// room. What no paint changes (power), and glare, gains 0.
std::vector<PaintGain> paintGains(const Scene& room, const ExchangeOperator& exchange, const Repaint& paint,
                                  const std::vector<float>& light, const Intentions& asked);

}  // namespace fiatlux
