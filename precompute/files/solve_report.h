// What `solve`, `alpha` and the experiments tell of a layout, as JSON and as lines for a person.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/search/shown.h"

namespace fiatlux {

/// The constraints that are not met (by more than a millionth): number, statistic, surface, value, bounds,
/// violation.
nlohmann::ordered_json violationsJson(const Scene& scene, const Intentions& intentions, const Shown& shown);

/// The goal's value in its own unit; of several goals the list of theirs; null without one.
nlohmann::ordered_json goalJson(const Shown& shown);

/// "mean of yellow wall 42.1 lx (at least 40): met"
std::string constraintLine(const Scene& scene, const Intentions& intentions, const Shown& shown,
                           std::size_t c);

/// " lx" or " lm/m2" where the statistic has the quantity's unit, " lm" for power, nothing for ratios.
std::string unitOf(Statistic statistic, Quantity quantity);

inline constexpr int kReportDigits = 6;  // of a number in a report

}  // namespace fiatlux
