// Layouts and readings as JSON and text; see solve_report.h.
#include "precompute/files/solve_report.h"

#include <cassert>
#include <cmath>

#include "core/base/short_number.h"
#include "core/search/validate_intentions.h"
#include "precompute/files/terminal.h"

namespace fiatlux {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMet = 1e-6;

std::string boundsText(const Constraint& c) {
  std::string text;
  if (std::isfinite(c.lower)) text += "at least " + shortNumber(c.lower, kReportDigits);
  if (std::isfinite(c.upper))
    text += (text.empty() ? "at most " : ", at most ") + shortNumber(c.upper, kReportDigits);
  return text;
}

}  // namespace

std::string unitOf(Statistic statistic, Quantity quantity) {
  if (statistic == Statistic::kPower) return " lm";
  if (statistic == Statistic::kUniformity || statistic == Statistic::kContrast) return "";
  return quantity == Quantity::kIlluminance ? " lx" : " lm/m2";
}

Json violationsJson(const Scene& scene, const Intentions& intentions, const Shown& shown) {
  assert(shown.constraints.size() == intentions.constraints.size());
  Json violations = Json::array();
  for (std::size_t c = 0; c < shown.constraints.size(); ++c) {
    const ConstraintReading& reading = shown.constraints[c];
    const Constraint& constraint = intentions.constraints[c];
    if (reading.violation <= kMet) continue;
    Json entry = {{"constraint", c + 1}, {"statistic", statisticName(constraint.statistic)}};
    if (constraint.statistic != Statistic::kPower)
      entry["surface"] = surfaceSetName(scene, constraint.surfaces);
    entry["value"] = reading.value;
    if (std::isfinite(constraint.lower)) entry["min"] = constraint.lower;
    if (std::isfinite(constraint.upper)) entry["max"] = constraint.upper;
    entry["violation"] = reading.violation;
    violations.push_back(entry);
  }
  return violations;
}

Json goalJson(const Shown& shown) {
  if (shown.goals.empty()) return nullptr;
  return shown.goals.size() == 1 ? Json(shown.goals[0]) : Json(shown.goals);
}

std::string constraintLine(const Scene& scene, const Intentions& intentions, const Shown& shown,
                           std::size_t c) {
  assert(c < intentions.constraints.size() && c < shown.constraints.size());
  const Constraint& constraint = intentions.constraints[c];
  const ConstraintReading& reading = shown.constraints[c];
  std::string line = statisticName(constraint.statistic);
  if (constraint.statistic == Statistic::kChebyshev)
    line += " (alpha " + shortNumber(constraint.alpha, kReportDigits) + ")";
  if (constraint.statistic != Statistic::kPower)
    line += " of " + printable(surfaceSetName(scene, constraint.surfaces), 80);
  return line + " " + shortNumber(reading.value, kReportDigits) +
         unitOf(constraint.statistic, intentions.quantity) + " (" + boundsText(constraint) +
         "): " + (reading.violation <= kMet ? "met" : "NOT met");
}

}  // namespace fiatlux
