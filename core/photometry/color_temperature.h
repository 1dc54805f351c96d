// The colour temperature that a maker's words tell.
#pragma once

#include <optional>
#include <string_view>

namespace fiatlux {

/// K of a field that holds nothing else: "3000", "3000K", "ww 3000 K", or a lamp code such as "830" or "940".
std::optional<double> colorTemperatureOf(std::string_view field);

/// K named within a sentence: four or five digits followed by K ("LED 4000K CRI80").
std::optional<double> colorTemperatureIn(std::string_view sentence);

}  // namespace fiatlux
