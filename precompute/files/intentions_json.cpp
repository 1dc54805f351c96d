// JSON to intentions; see intentions_json.h.
#include "precompute/files/intentions_json.h"

#include <algorithm>

#include "core/scene/surface_names.h"
#include "core/scene/zones.h"
#include "core/search/validate_intentions.h"
#include "precompute/files/areas_json.h"
#include "precompute/files/files_on_disk.h"
#include "precompute/files/json_fields.h"
#include "precompute/files/observers_json.h"
#include "precompute/files/planes_json.h"
#include "precompute/files/surface_names.h"

namespace fiatlux {
namespace {

constexpr std::size_t kMostEntries = 1000, kMostTypes = 16, kMostWays = 72;
constexpr double kMostWatts = 1e6;  // W
constexpr double kFurthest = 1e6;   // m

SurfaceSet surfacesOf(const Scene& scene, const JsonField& field) {
  std::vector<std::string> names;
  if (field.isText()) names.push_back(field.text());
  if (!field.isText())
    for (const JsonField& name : field.list(kMostEntries)) names.push_back(name.text());
  if (names.empty()) field.fail("an empty list of surfaces; name one, or \"all\"");
  Result<SurfaceSet> set = surfacesNamed(scene, names);
  if (!set) field.fail(set.error().message);
  return std::move(*set);
}

std::vector<std::uint32_t> sitesOf(const JsonField& field) {
  std::vector<std::uint32_t> sites;
  for (const JsonField& site : field.list(kMostEntries)) {
    sites.push_back(site.whole());
    if (sites.back() == kNone) site.fail("there is no such site");  // it would mean "not pinned"
  }
  return sites;
}

std::vector<double> fluxesOf(const JsonField& field) {
  if (!field.isList()) return {field.number()};
  std::vector<double> fluxes;
  for (const JsonField& flux : field.list(kMostEntries)) fluxes.push_back(flux.number());
  return fluxes;
}

/// The enumerators whose names a table holds in their order.
template <class E, std::size_t kCount>
std::vector<std::pair<std::string, E>> namedBy(const char* const (&names)[kCount]) {
  std::vector<std::pair<std::string, E>> choices;
  for (std::size_t i = 0; i < kCount; ++i) choices.emplace_back(names[i], static_cast<E>(i));
  return choices;
}

/// 6, or [3, 24] of a range.
void readCount(const JsonField& json, LuminaireRules& rules) {
  if (!json.isList()) {
    rules.count = json.whole();
    return;
  }
  const std::vector<JsonField> range = json.list(2);
  if (range.size() != 2) json.fail("a range of counts is [least, most]");
  rules.count = range[0].whole();
  rules.countHigh = range[1].whole();
  if (rules.countHigh < rules.count) json.fail("a range of counts is [least, most], the least first");
}

Arrangement arrangementOf(const JsonField& json) {
  json.requireKeys({"rule", "axis", "leastInRow"});
  Arrangement arrangement;
  arrangement.rule =
      json.at("rule", "say \"free\", \"symmetric\", \"rows\" or \"field\"").oneOf(namedBy<Rule>(kRuleNames));
  if (const auto axis = json.find("axis")) arrangement.axis = axis->oneOf(namedBy<PlanAxis>(kPlanAxisNames));
  if (const auto least = json.find("leastInRow")) {
    if (arrangement.rule != Rule::kRows) least->fail("only \"rows\" have a least number in each; drop it");
    arrangement.leastInRow = least->whole();
  }
  return arrangement;
}

/// 2, or [0, 6] of a range.
TypeRange typeRangeOf(const JsonField& json) {
  TypeRange range;
  if (!json.isList()) {
    range.least = range.most = json.whole();
    return range;
  }
  const std::vector<JsonField> ends = json.list(2);
  if (ends.size() != 2) json.fail("a range of counts is [least, most]");
  range.least = ends[0].whole();
  range.most = ends[1].whole();
  if (range.most < range.least) json.fail("a range of counts is [least, most], the least first");
  return range;
}

/// The mean of the patches of a set, by area.
Vec3 middleOf(const Scene& room, const SurfaceSet& surfaces) {
  Vec3 sum;
  double area = 0;
  const SurfaceSet leaves = leavesOf(room, surfaces);
  for (std::uint32_t p = 0; p < room.patches.rows(); ++p) {
    if (!std::binary_search(leaves.begin(), leaves.end(), room.patches.surface[p])) continue;
    sum += room.patches.area[p] * room.patches.center[p];
    area += room.patches.area[p];
  }
  return (1 / area) * sum;
}

/// A point, or the middle of a surface by its name.
Vec3 aimOf(const Scene& room, const JsonField& json) {
  if (json.isText()) return middleOf(room, surfacesOf(room, json));
  const std::vector<double> at = json.numbers(3, "[x, y, z] or the name of a surface", -kFurthest, kFurthest);
  return {at[0], at[1], at[2]};
}

AskedType typeOf(const Scene& room, const JsonField& json, const ReadNamed& read) {
  json.requireKeys({"photometry", "count", "turns", "aims", "maxAimingAngle", "flux", "watts"});
  const JsonField file = json.at("photometry", "name an .ies or .ldt file");
  AskedType type;
  type.name = file.text();
  type.photometry = photometryOf(file, read);
  type.watts = type.photometry->watts;
  if (const auto flux = json.find("flux")) type.flux = flux->number(kLeastFlux, kLargestFlux);
  if (const auto watts = json.find("watts")) type.watts = watts->number(0, kMostWatts);
  if (const auto turns = json.find("turns")) {
    type.ways.turns.clear();
    for (const JsonField& turn : turns->list(kMostWays))
      type.ways.turns.push_back(turn.number(-kMostTurn, kMostTurn));
    if (type.ways.turns.empty()) turns->fail("an empty list; leave it out, or give degrees");
  }
  if (const auto aims = json.find("aims"))
    for (const JsonField& aim : aims->list(kMostWays)) type.ways.aims.push_back(aimOf(room, aim));
  if (const auto angle = json.find("maxAimingAngle")) {
    if (type.ways.aims.empty()) angle->fail("it is of luminaires with \"aims\"");
    type.ways.maxAimingAngle = angle->number(0, kMostAimingAngle);
  }
  return type;
}

void readTypes(const Scene& room, const JsonField& luminaires, const JsonField& json, const ReadNamed& read,
               IntentionsFile& asked) {
  if (const auto flux = luminaires.find("flux"))
    flux->fail("the photometric files of \"types\" say it; leave one of the two out");
  for (const JsonField& entry : json.list(kMostTypes)) {
    asked.types.push_back(typeOf(room, entry, read));
    const auto count = entry.find("count");
    asked.intentions.luminaires.types.push_back(count ? typeRangeOf(*count) : TypeRange{});
    asked.intentions.luminaires.types.back().name = asked.types.back().name;
  }
  if (asked.types.empty()) json.fail("an empty list; name a photometric file, or leave it out for squares");
}

/// [{"luminaire": 3, "photometry": "b.ies"}]: L3 is of that type.
void readFixed(const JsonField& json, IntentionsFile& asked) {
  if (asked.types.empty()) json.fail("it is of luminaires with \"types\"");
  std::vector<std::uint32_t>& ofType = asked.intentions.luminaires.ofType;
  for (const JsonField& entry : json.list(kMostEntries)) {
    entry.requireKeys({"luminaire", "photometry"});
    const JsonField number = entry.at("luminaire", "say which: 3 is L3");
    const std::uint32_t luminaire = number.whole();
    if (luminaire == 0 || luminaire > kMostEntries) number.fail("luminaires are numbered from 1");
    std::vector<std::pair<std::string, std::uint32_t>> choices;
    for (std::uint32_t t = 0; t < asked.types.size(); ++t) choices.emplace_back(asked.types[t].name, t);
    const std::uint32_t type = entry.at("photometry", "name one of the types").oneOf(choices);
    ofType.resize(std::max<std::size_t>(ofType.size(), luminaire), kNone);
    if (ofType[luminaire - 1] != kNone) number.fail("it is there twice");
    ofType[luminaire - 1] = type;
  }
}

LuminaireRules rulesOf(const Scene& scene, const JsonField& json) {
  json.requireKeys(
      {"count", "flux", "dimming", "pinned", "excluded", "areas", "minDistance", "types", "fixed"});
  LuminaireRules rules;
  if (const auto count = json.find("count")) readCount(*count, rules);
  if (const auto flux = json.find("flux")) rules.flux = fluxesOf(*flux);
  if (const auto dimming = json.find("dimming")) {
    const std::vector<double> range =
        dimming->isList() ? dimming->numbers(2, "[low, high]") : std::vector<double>(2, dimming->number());
    rules.dimmingLow = range[0];
    rules.dimmingHigh = range[1];
  }
  if (const auto pinned = json.find("pinned")) rules.pinned = sitesOf(*pinned);
  if (const auto excluded = json.find("excluded")) rules.excluded = sitesOf(*excluded);
  if (const auto areas = json.find("areas"))
    for (const std::uint32_t site : sitesLeftOut(scene, *areas, rules.pinned))
      if (std::find(rules.excluded.begin(), rules.excluded.end(), site) == rules.excluded.end())
        rules.excluded.push_back(site);
  if (const auto distance = json.find("minDistance")) rules.minDistance = distance->number();
  return rules;
}

/// A statistic by its name in the table.
Statistic statisticOf(const JsonField& json, bool asGoal) {
  std::vector<std::pair<std::string, Statistic>> choices;
  for (const StatisticTraits& traits : kStatistics)
    if (traits.mayBeGoal || !asGoal) choices.emplace_back(traits.name, traits.statistic);
  return json.at("statistic", "name one").oneOf(choices);
}

/// The surfaces (and what they are compared with) of a goal or a constraint.
template <class Intention>
void readSurfaces(const Scene& scene, const JsonField& json, Intention& intention) {
  const StatisticTraits& traits = traitsOf(intention.statistic);
  if (!traits.needsSurfaces && json.has("surface"))
    json.fail(std::string(traits.name) + " belongs to " +
              (traits.unit == Unit::kGlare ? "an observer" : "the luminaires") + ": drop \"surface\"");
  if (traits.needsSurfaces)
    intention.surfaces = surfacesOf(scene, json.at("surface", "name one, or \"all\""));
  if (!traits.needsOver && json.has("over")) json.fail("\"over\" belongs to a contrast only");
  if (traits.needsOver)
    intention.over = surfacesOf(scene, json.at("over", "name the surface to compare with"));
}

std::optional<Quantity> quantityOf(const JsonField& json) {
  const auto quantity = json.find("quantity");
  if (!quantity) return std::nullopt;
  return quantity->oneOf(namedBy<Quantity>(kQuantityNames));
}

Goal goalOf(const Scene& scene, const JsonField& json) {
  json.requireKeys({"surface", "statistic", "sense", "weight", "over", "target", "quantity"});
  Goal goal;
  goal.statistic = statisticOf(json, true);
  goal.sense = json.at("sense", "say \"min\", \"max\" or \"near\"").oneOf(namedBy<Sense>(kSenseNames));
  const bool near = goal.sense == Sense::kNear;
  if (!near && json.has("target")) json.fail("\"target\" belongs to \"near\" only");
  if (near) goal.target = json.at("target", "say near what").number();
  if (const auto weight = json.find("weight")) goal.weight = weight->number();
  readSurfaces(scene, json, goal);
  goal.quantity = quantityOf(json);
  return goal;
}

/// Which observer a constraint names; kNone where it names none.
std::uint32_t observerNamed(const JsonField& json, const std::vector<Observer>& observers) {
  const auto name = json.find("observer");
  if (!name) return kNone;
  std::vector<std::pair<std::string, std::uint32_t>> choices;
  for (std::uint32_t o = 0; o < observers.size(); ++o) choices.emplace_back(observers[o].name, o);
  if (choices.empty()) name->fail("there are no observers to choose from");
  return name->oneOf(choices);
}

/// What a statistic of a measuring plane's points has beside its surface.
void readPlanePart(const JsonField& json, Constraint& constraint) {
  const StatisticTraits& traits = traitsOf(constraint.statistic);
  if (const auto of = json.find("of")) {
    if (!traits.ofPlanes) of->fail("it belongs to cylindrical, modelling and vertical only");
    constraint.isLeast = of->oneOf<bool>({{"mean", false}, {"minimum", true}});
  }
  const bool isVertical = constraint.statistic == Statistic::kVertical;
  if (!isVertical && json.has("direction")) json.fail("\"direction\" belongs to vertical only");
  if (!isVertical) return;
  const JsonField direction = json.at("direction", "say which way the vertical plane faces: [x, 0, z]");
  constraint.direction = levelDirectionOf(direction);
}

Constraint constraintOf(const Scene& scene, const std::vector<Observer>& observers, const JsonField& json) {
  json.requireKeys({"surface", "statistic", "min", "max", "alpha", "over", "observer", "quantity", "of",
                    "direction", "on"});
  Constraint constraint;
  constraint.statistic = statisticOf(json, false);
  if (const auto least = json.find("min")) constraint.lower = least->number();
  if (const auto most = json.find("max")) constraint.upper = most->number();
  if (const auto alpha = json.find("alpha")) {
    if (!traitsOf(constraint.statistic).needsAlpha) json.fail("\"alpha\" belongs to chebyshev only");
    constraint.alpha = alpha->number();
  }
  readSurfaces(scene, json, constraint);
  constraint.quantity = quantityOf(json);
  constraint.observer = observerNamed(json, observers);
  if (constraint.observer != kNone && constraint.statistic != Statistic::kUgr)
    json.fail("\"observer\" belongs to ugr only");
  readPlanePart(json, constraint);
  if (const auto on = json.find("on"))
    constraint.onGrid = on->oneOf<bool>({{"patches", false}, {"grid", true}});
  return constraint;
}

/// Those that are written; where a ugr is asked for and none are, those of the room.
std::vector<Observer> askedObservers(const Scene& scene, const JsonField& json) {
  if (const auto observers = json.find("observers"))
    return observersFor(observersOf(*observers), scene.patches);
  const auto constraints = json.find("constraints");
  if (!constraints) return {};
  for (const JsonField& constraint : constraints->list(kMostEntries, "constraint"))
    if (statisticOf(constraint, false) == Statistic::kUgr) return observersInRoom(scene.patches);
  return {};
}

IntentionsFile intentionsOf(const Scene& scene, const JsonField& json, const ReadNamed& read) {
  json.requireKeys(
      {"luminaires", "arrangement", "goals", "constraints", "quantity", "observers", "taskAreas", "paint"});
  IntentionsFile asked;
  Intentions& intentions = asked.intentions;
  intentions.zones = scene.zones;
  intentions.observers = askedObservers(scene, json);
  if (const auto quantity = quantityOf(json)) intentions.quantity = *quantity;
  if (const auto luminaires = json.find("luminaires")) {
    intentions.luminaires = rulesOf(scene, *luminaires);
    if (const auto types = luminaires->find("types")) readTypes(scene, *luminaires, *types, read, asked);
    if (const auto fixed = luminaires->find("fixed")) readFixed(*fixed, asked);
  }
  if (const auto paint = json.find("paint")) asked.paint = paintOf(*paint);
  if (const auto arrangement = json.find("arrangement"))
    intentions.luminaires.arrangement = arrangementOf(*arrangement);
  if (const auto goals = json.find("goals"))
    for (const JsonField& goal : goals->list(kMostEntries, "goal"))
      intentions.goals.push_back(goalOf(scene, goal));
  if (const auto constraints = json.find("constraints"))
    for (const JsonField& constraint : constraints->list(kMostEntries, "constraint"))
      intentions.constraints.push_back(constraintOf(scene, intentions.observers, constraint));
  return asked;
}

/// `divided`: the room, which gets its task areas.
void divide(const Scene& room, const JsonField& json, Scene& divided) {
  const Result<std::vector<Zone>> zones = zonesOf(room, taskAreasOf(json));
  if (!zones) json.fail(zones.error().message);
  if (auto ok = takeZones(divided, *zones); !ok) json.fail(ok.error().message);
}

}  // namespace

Result<IntentionsFile> parseIntentionsFile(const Scene& room, const std::string& text,
                                           const ReadNamed& read) {
  IntentionsFile asked;
  std::optional<Scene> divided;  // the room where task areas divide it: they are named like surfaces
  const Result<Done> done = readJson(text, [&](const JsonField& json) {
    if (const auto areas = json.find("taskAreas")) divide(room, *areas, divided.emplace(room));
    asked = intentionsOf(divided ? *divided : room, json, read);
  });
  if (!done) return done.error();
  if (!asked.types.empty()) return asked;
  if (auto ok = checkIntentions(divided ? *divided : room, asked.intentions); !ok) return ok.error();
  return asked;
}

Result<IntentionsFile> readIntentionsFile(const Scene& room, const std::string& path) {
  return parsedFile(path, kLongestJson, [&](const std::string& text) {
    return parseIntentionsFile(room, text, filesBeside(path, "intentions file"));
  });
}

}  // namespace fiatlux
