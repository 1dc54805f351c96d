// Layouts and readings as JSON and text; see solve_report.h.
#include "precompute/files/solve_report.h"

#include <cassert>
#include <cmath>

#include "core/base/short_number.h"
#include "core/scene/surface_names.h"
#include "core/search/eased.h"
#include "precompute/files/planes_json.h"
#include "precompute/files/terminal.h"

namespace fiatlux {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMet = 1e-6;

/// "met", "met but for 0.04 %", "NOT met"
std::string verdictOn(const ConstraintReading& reading, const StatisticTraits& traits) {
  if (reading.violation <= kMet) return "met";
  if (traits.needsExtremes || !(reading.violation <= kHardlyMissed)) return "NOT met";
  return "met but for " + shortNumber(100 * reading.violation, 2) + " %";
}

std::string boundsText(const Constraint& c) {
  std::string text;
  if (std::isfinite(c.lower)) text += "at least " + shortNumber(c.lower, kReportDigits);
  if (std::isfinite(c.upper))
    text += (text.empty() ? "at most " : ", at most ") + shortNumber(c.upper, kReportDigits);
  return text;
}

/// The luminaires of each tie.
std::vector<std::vector<std::size_t>> tiesIn(const Layout& layout) {
  std::vector<std::vector<std::size_t>> ties;
  for (std::size_t i = 0; i < layout.ties.size(); ++i) {
    if (layout.ties[i] >= ties.size()) ties.resize(layout.ties[i] + 1);
    ties[layout.ties[i]].push_back(i);
  }
  return ties;
}

const char* nameOf(Rule rule) { return kRuleNames[static_cast<std::size_t>(rule)]; }

}  // namespace

std::string valueText(const Scene& scene, double value, Statistic statistic, Quantity quantity) {
  if (std::isnan(value)) return "undefined";
  if (statistic == Statistic::kUgr && value < 0 && std::isinf(value)) return "none";
  if (std::isinf(value)) return "infinite";
  const bool isWatts = traitsOf(statistic).unit == Unit::kFlux && !scene.hangings.empty();
  const std::string unit = isWatts ? "W" : unitName(statistic, quantity);
  return shortNumber(value, kReportDigits) + (unit.empty() ? "" : " " + unit);
}

Json violationsJson(const Scene& scene, const Intentions& intentions, const Shown& shown) {
  assert(shown.constraints.size() == intentions.constraints.size());
  Json violations = Json::array();
  for (std::size_t c = 0; c < shown.constraints.size(); ++c) {
    const ConstraintReading& reading = shown.constraints[c];
    const Constraint& constraint = intentions.constraints[c];
    if (reading.violation <= kMet) continue;
    Json entry = {{"constraint", c + 1}, {"statistic", statisticName(constraint.statistic)}};
    if (traitsOf(constraint.statistic).needsSurfaces)
      entry["surface"] = surfaceSetName(scene, constraint.surfaces);
    if (constraint.quantity)
      entry["quantity"] = kQuantityNames[static_cast<std::size_t>(*constraint.quantity)];
    if (constraint.isLeast) entry["of"] = "minimum";
    if (constraint.onGrid) entry["on"] = "grid";
    if (constraint.statistic == Statistic::kVertical)
      entry["direction"] = {constraint.direction.x, constraint.direction.y, constraint.direction.z};
    if (constraint.observer != kNone) entry["observer"] = intentions.observers[constraint.observer].name;
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

Json arrangementJson(const Arrangement& asked, const Layout& layout) {
  Json json = {{"rule", nameOf(asked.rule)}};
  if (asked.axis != PlanAxis::kFound) json["axis"] = kPlanAxisNames[static_cast<std::size_t>(asked.axis)];
  json["ties"] = tiesIn(layout);
  return json;
}

std::string arrangementLine(const Arrangement& asked, const Layout& layout) {
  std::string line = nameOf(asked.rule);
  const char* between = ": ";
  for (const std::vector<std::size_t>& tie : tiesIn(layout)) {
    line += between;
    for (std::size_t k = 0; k < tie.size(); ++k) line += (k > 0 ? " L" : "L") + std::to_string(tie[k] + 1);
    between = ", ";
  }
  return line;
}

std::string constraintLine(const Scene& scene, const Intentions& intentions, const Shown& shown,
                           std::size_t c) {
  assert(c < intentions.constraints.size() && c < shown.constraints.size());
  const Constraint& constraint = intentions.constraints[c];
  const ConstraintReading& reading = shown.constraints[c];
  const StatisticTraits& traits = traitsOf(constraint.statistic);
  const Quantity quantity = quantityOf(intentions, constraint);
  const bool isDirect = quantity == Quantity::kDirect && traits.needsSurfaces && !traits.ofPlanes;
  std::string line = isDirect ? "direct " : constraint.isLeast ? "least " : "";
  line += traits.name;
  if (traits.needsAlpha) line += " (alpha " + shortNumber(constraint.alpha, kReportDigits) + ")";
  if (constraint.statistic == Statistic::kVertical) line += " towards " + directionText(constraint.direction);
  if (traits.needsSurfaces)
    line += (constraint.onGrid ? " on the grid of " : " of ") +
            printable(surfaceSetName(scene, constraint.surfaces), 80);
  if (constraint.statistic == Statistic::kUgr)
    line += constraint.observer == kNone
                ? " of the worst observer"
                : " of " + printable(intentions.observers[constraint.observer].name, 80);
  return line + " " + valueText(scene, reading.value, constraint.statistic, quantity) + " (" +
         boundsText(constraint) + "): " + verdictOn(reading, traits);
}

}  // namespace fiatlux
