// What `solve`, `alpha` and the experiments tell of a layout, as JSON and as lines for a person.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "core/search/shown.h"

namespace fiatlux {

/// The constraints that are not met (by more than a millionth): number, statistic, surface, value (null where
/// it is infinite or undefined), bounds, violation.
nlohmann::ordered_json violationsJson(const Scene& scene, const Intentions& intentions, const Shown& shown);

/// The goal's value in its own unit (of an aim its distance from the target, as a share of that); of several
/// goals the list of theirs; null without one.
nlohmann::ordered_json goalJson(const Shown& shown);

/// "mean of yellow wall 42.1 lx (at least 40): met"
std::string constraintLine(const Scene& scene, const Intentions& intentions, const Shown& shown,
                           std::size_t c);

/// "42.1 lx", "0.4", "120 W" (power of types), "infinite", "none" (where nothing glares), "undefined" (a
/// contrast of darkness against darkness).
std::string valueText(const Scene& scene, double value, Statistic statistic, Quantity quantity);

/// {"rule", "axis" where one was asked for, "ties": the luminaires that move together, numbers from 0}.
nlohmann::ordered_json arrangementJson(const Arrangement& asked, const Layout& layout);

/// "rows: L1 L2 L3, L4 L5 L6"
std::string arrangementLine(const Arrangement& asked, const Layout& layout);

inline constexpr int kReportDigits = 6;  // of a number in a report

}  // namespace fiatlux
