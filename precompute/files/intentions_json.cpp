// JSON to intentions; see intentions_json.h.
#include "precompute/files/intentions_json.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "core/search/validate_intentions.h"
#include "precompute/base/error.h"
#include "precompute/base/json_text.h"
#include "precompute/files/surface_names.h"
#include "precompute/files/terminal.h"

namespace fiatlux {
namespace {

using Json = nlohmann::json;

constexpr std::uintmax_t kLongest = 1 << 20;
constexpr std::size_t kMostEntries = 1000;

[[noreturn]] void fail(const std::string& where, const std::string& what) {
  throw CommandError(printable(where.empty() ? what : where + ": " + what, 800));
}

const char* typeOf(const Json& value) {
  return value.is_number()   ? "a number"
         : value.is_string() ? "a text"
         : value.is_array()  ? "a list"
         : value.is_object() ? "an object"
         : value.is_null()   ? "null"
                             : "true or false";
}

void requireKeys(const Json& object, const std::string& where, std::initializer_list<const char*> known) {
  if (!object.is_object()) fail(where, std::string("expected an object, found ") + typeOf(object));
  for (const auto& [key, value] : object.items()) {
    bool found = false;
    std::string list;
    for (const char* name : known) {
      found = found || key == name;
      list += (list.empty() ? "" : ", ") + std::string(name);
    }
    if (!found) fail(where, "unknown key \"" + key.substr(0, 60) + "\"; known are " + list);
  }
}

double numberOf(const Json& value, const std::string& where) {
  if (!value.is_number()) fail(where, std::string("expected a number, found ") + typeOf(value));
  const double number = value.get<double>();
  if (!std::isfinite(number)) fail(where, "the number is not finite");
  return number;
}

std::uint32_t indexOf(const Json& value, const std::string& where) {
  const double number = numberOf(value, where);
  if (number < 0 || number > 4e9 || number != std::floor(number))
    fail(where, "expected a whole number from 0 on, found " + value.dump().substr(0, 40));
  return static_cast<std::uint32_t>(number);
}

const Json& listOf(const Json& value, const std::string& where) {
  if (!value.is_array()) fail(where, std::string("expected a list, found ") + typeOf(value));
  if (value.size() > kMostEntries) fail(where, "more than " + std::to_string(kMostEntries) + " entries");
  return value;
}

template <class T>
T oneOf(const Json& value, const std::string& where, const std::vector<std::pair<const char*, T>>& choices) {
  if (!value.is_string()) fail(where, std::string("expected a text, found ") + typeOf(value));
  std::string list;
  for (const auto& [name, choice] : choices) {
    if (value.get_ref<const std::string&>() == name) return choice;
    list += (list.empty() ? "" : ", ") + std::string(name);
  }
  fail(where, "unknown \"" + value.get_ref<const std::string&>().substr(0, 60) + "\"; known are " + list);
}

/// The enumerators whose names a table holds in their order.
template <class E, std::size_t kCount>
std::vector<std::pair<const char*, E>> namedBy(const char* const (&names)[kCount]) {
  std::vector<std::pair<const char*, E>> choices;
  for (std::size_t i = 0; i < kCount; ++i) choices.emplace_back(names[i], static_cast<E>(i));
  return choices;
}

SurfaceSet surfacesOf(const Scene& scene, const Json& value, const std::string& where) {
  std::vector<std::string> names;
  if (value.is_string()) {
    names.push_back(value.get<std::string>());
  } else {
    if (!value.is_array())
      fail(where, std::string("expected a surface name or a list of them, found ") + typeOf(value));
    for (const Json& name : listOf(value, where)) {
      if (!name.is_string()) fail(where, std::string("expected a surface name, found ") + typeOf(name));
      names.push_back(name.get<std::string>());
    }
    if (names.empty()) fail(where, "an empty list of surfaces; name one, or \"all\"");
  }
  Result<SurfaceSet> set = surfacesNamed(scene, names);
  if (!set) fail(where, set.error().message);
  return std::move(*set);
}

std::vector<std::uint32_t> sitesOf(const Json& value, const std::string& where) {
  std::vector<std::uint32_t> sites;
  for (const Json& site : listOf(value, where)) sites.push_back(indexOf(site, where));
  return sites;
}

LuminaireRules rulesOf(const Json& json) {
  requireKeys(json, "luminaires", {"count", "flux", "dimming", "pinned", "excluded", "minDistance"});
  LuminaireRules rules;
  if (json.contains("count")) rules.count = indexOf(json["count"], "luminaires.count");
  if (json.contains("flux")) {
    rules.flux.clear();
    if (json["flux"].is_array())
      for (const Json& flux : listOf(json["flux"], "luminaires.flux"))
        rules.flux.push_back(numberOf(flux, "luminaires.flux"));
    else
      rules.flux.push_back(numberOf(json["flux"], "luminaires.flux"));
  }
  if (json.contains("dimming")) {
    const Json& range = json["dimming"];
    if (range.is_array()) {
      if (range.size() != 2) fail("luminaires.dimming", "expected [low, high]");
      rules.dimmingLow = numberOf(range[0], "luminaires.dimming");
      rules.dimmingHigh = numberOf(range[1], "luminaires.dimming");
    } else {
      rules.dimmingLow = rules.dimmingHigh = numberOf(range, "luminaires.dimming");
    }
  }
  if (json.contains("pinned")) rules.pinned = sitesOf(json["pinned"], "luminaires.pinned");
  if (json.contains("excluded")) rules.excluded = sitesOf(json["excluded"], "luminaires.excluded");
  if (json.contains("minDistance"))
    rules.minDistance = numberOf(json["minDistance"], "luminaires.minDistance");
  return rules;
}

/// A statistic by its name in the table.
Statistic statisticOf(const Json& json, const std::string& where, bool asGoal) {
  if (!json.contains("statistic")) fail(where, "no \"statistic\"");
  std::vector<std::pair<const char*, Statistic>> choices;
  for (const StatisticTraits& traits : kStatistics)
    if (traits.mayBeGoal || !asGoal) choices.emplace_back(traits.name, traits.statistic);
  return oneOf(json["statistic"], where + ".statistic", choices);
}

/// The surfaces (and what they are compared with) of a goal or a constraint.
template <class Intention>
void readSurfaces(const Scene& scene, const Json& json, const std::string& where, Intention& intention) {
  const StatisticTraits& traits = traitsOf(intention.statistic);
  if (!traits.needsSurfaces && json.contains("surface"))
    fail(where, std::string(traits.name) + " belongs to the luminaires: drop \"surface\"");
  if (traits.needsSurfaces && !json.contains("surface")) fail(where, "no \"surface\"; name one, or \"all\"");
  if (traits.needsOver && !json.contains("over"))
    fail(where, "a " + std::string(traits.name) + " needs \"over\", the surface to compare with");
  if (!traits.needsOver && json.contains("over")) fail(where, "\"over\" belongs to a contrast only");
  if (traits.needsSurfaces) intention.surfaces = surfacesOf(scene, json["surface"], where + ".surface");
  if (traits.needsOver) intention.over = surfacesOf(scene, json["over"], where + ".over");
}

Goal goalOf(const Scene& scene, const Json& json, const std::string& where) {
  requireKeys(json, where, {"surface", "statistic", "sense", "weight", "over", "target"});
  Goal goal;
  goal.statistic = statisticOf(json, where, true);
  if (!json.contains("sense")) fail(where, "no \"sense\"; say \"min\", \"max\" or \"near\"");
  goal.sense = oneOf(json["sense"], where + ".sense", namedBy<Sense>(kSenseNames));
  const bool near = goal.sense == Sense::kNear;
  if (near != json.contains("target"))
    fail(where, near ? "near what? give a \"target\"" : "\"target\" belongs to \"near\" only");
  if (near) goal.target = numberOf(json["target"], where + ".target");
  if (json.contains("weight")) goal.weight = numberOf(json["weight"], where + ".weight");
  readSurfaces(scene, json, where, goal);
  return goal;
}

Constraint constraintOf(const Scene& scene, const Json& json, const std::string& where) {
  requireKeys(json, where, {"surface", "statistic", "min", "max", "alpha", "over"});
  Constraint constraint;
  constraint.statistic = statisticOf(json, where, false);
  if (json.contains("min")) constraint.lower = numberOf(json["min"], where + ".min");
  if (json.contains("max")) constraint.upper = numberOf(json["max"], where + ".max");
  if (json.contains("alpha")) {
    if (!traitsOf(constraint.statistic).needsAlpha) fail(where, "\"alpha\" belongs to chebyshev only");
    constraint.alpha = numberOf(json["alpha"], where + ".alpha");
  }
  readSurfaces(scene, json, where, constraint);
  return constraint;
}

Intentions intentionsOf(const Scene& scene, const Json& json) {
  requireKeys(json, "", {"luminaires", "goals", "constraints", "quantity"});
  Intentions intentions;
  if (json.contains("quantity"))
    intentions.quantity = oneOf(json["quantity"], "quantity", namedBy<Quantity>(kQuantityNames));
  if (json.contains("luminaires")) intentions.luminaires = rulesOf(json["luminaires"]);
  if (json.contains("goals"))
    for (const Json& goal : listOf(json["goals"], "goals"))
      intentions.goals.push_back(goalOf(scene, goal, "goal " + std::to_string(intentions.goals.size() + 1)));
  if (json.contains("constraints"))
    for (const Json& constraint : listOf(json["constraints"], "constraints"))
      intentions.constraints.push_back(
          constraintOf(scene, constraint, "constraint " + std::to_string(intentions.constraints.size() + 1)));
  return intentions;
}

}  // namespace

Result<Intentions> parseIntentions(const Scene& scene, const std::string& text) {
  try {
    if (text.size() > kLongest) return Error{"longer than 1 MB"};
    const Result<Json> json = parseJson(text);
    if (!json) return json.error();
    Intentions intentions = intentionsOf(scene, *json);
    if (auto ok = checkIntentions(scene, intentions); !ok) return ok.error();
    return intentions;
  } catch (const CommandError& error) {
    return Error{error.what()};
  } catch (const Json::exception&) {
    return Error{"text that is not UTF-8"};
  }
}

Result<Intentions> readIntentionsFile(const Scene& scene, const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) return Error{path + ": is a folder, not a file"};
  std::ifstream file(path, std::ios::binary);
  if (!file) return Error{path + ": cannot be opened; check the path"};
  std::string text(kLongest + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  Result<Intentions> intentions = parseIntentions(scene, text);
  if (!intentions) return Error{path + ": " + intentions.error().message};
  return intentions;
}

}  // namespace fiatlux
