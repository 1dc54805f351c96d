// Photometric files measure angles in degrees.
#pragma once

#include <numbers>

namespace fiatlux {

inline constexpr double kDegree = std::numbers::pi / 180;  // radians

}  // namespace fiatlux
