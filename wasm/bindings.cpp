// The only Emscripten code: binds the core's Session as one class for the page's worker. Conversions only;
// every decision is in core/session/session.h. The TypeScript face with shapes and units is
// web/solver/core.ts. Arrays are copied in and come back as fresh copies; an error comes back as one line, ''
// where all is well.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <memory>
#include <optional>
#include <utility>

#include "core/bound/pair_bound.h"
#include "core/bound/pair_numbers.h"
#include "core/candidates/candidate_scene.h"
#include "core/photometry/photometric_description.h"
#include "core/search/plane_values.h"
#include "core/search/validate_intentions.h"
#include "core/session/paint_gains.h"
#include "core/session/session.h"
#include "core/transport/colored_light.h"

namespace fiatlux {
namespace {

using emscripten::val;

template <class T>
val copied(const std::vector<T>& values) {
  return val(emscripten::typed_memory_view(values.size(), values.data())).call<val>("slice");
}

template <class T>
std::vector<T> vectorOf(const val& array) {
  return emscripten::convertJSArrayToNumberVector<T>(array);
}

template <class T>
std::string errorOf(const Result<T>& result) {
  return result ? std::string() : result.error().message;
}

Layout layoutOf(const val& sites, const val& flux, double dimming) {
  return {vectorOf<std::uint32_t>(sites), vectorOf<double>(flux), dimming};
}

val valueOf(const Layout& layout) {
  val result = val::object();
  result.set("sites", copied(layout.sites));
  result.set("flux", copied(layout.flux));
  result.set("dimming", layout.dimming);
  result.set("ties", copied(layout.ties));
  return result;
}

/// Nine numbers an observer: eye, direction, UGR (-infinity where nothing glares), background and
/// cylindrical illuminance.
val valueOf(const std::vector<ObserverRows>& observers, const std::vector<ObserverReading>& readings) {
  std::vector<double> numbers;
  val names = val::array();
  for (std::size_t o = 0; o < readings.size(); ++o) {
    const auto& [name, p, d] = observers[o].observer;
    numbers.insert(numbers.end(), {p.x, p.y, p.z, d.x, d.y, d.z, ugrOf(glareRatio(readings[o])),
                                   readings[o].background, readings[o].cylindrical});
    names.set(o, name);
  }
  val result = val::object();
  result.set("names", names);
  result.set("numbers", copied(numbers));
  return result;
}

/// Seven numbers a grid: surface, points, spacing, rim, E_m, E_min and E_max.
val valueOf(const std::vector<GridReading>& grids) {
  std::vector<double> numbers;
  for (const GridReading& g : grids)
    numbers.insert(numbers.end(), {static_cast<double>(g.surface), static_cast<double>(g.points), g.spacing,
                                   g.rim, g.mean, g.least, g.most});
  return copied(numbers);
}

/// Eight numbers a plane: its surface, points, mean and least of horizontal, cylindrical and modelling; then
/// five of each vertical: direction, mean and least.
val valueOf(const std::vector<PlaneReading>& planes) {
  val result = val::array();
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const PlaneReading& plane = planes[i];
    std::vector<double> numbers = {static_cast<double>(plane.surface), static_cast<double>(plane.points)};
    for (const MeanAndLeast& each : {plane.horizontal, plane.cylindrical, plane.modelling})
      numbers.insert(numbers.end(), {each.mean, each.least});
    for (const auto& [d, light] : plane.verticals)
      numbers.insert(numbers.end(), {d.x, d.y, d.z, light.mean, light.least});
    result.set(i, copied(numbers));
  }
  return result;
}

val valueOf(Session& session, const Shown& shown) {
  std::vector<double> surfaces, constraints;
  for (const SurfaceReading& s : shown.surfaces)
    surfaces.insert(surfaces.end(), {s.mean, s.sigma, s.minimum, s.maximum});
  for (const ConstraintReading& c : shown.constraints)
    constraints.insert(constraints.end(), {c.value, c.violation, c.margin});
  val result = val::object();
  result.set("layout", valueOf(shown.layout));
  result.set("illuminance", copied(shown.illuminance));
  result.set("surfaces", copied(surfaces));
  result.set("goals", copied(shown.goals));
  result.set("constraints", copied(constraints));
  result.set("observers", valueOf(session.scene()->observers, shown.observers));
  result.set("grids", valueOf(session.gridsOf(shown.illuminance)));
  result.set("planes", valueOf(shown.planes));
  result.set("direct", shown.direct.empty() ? val::null() : copied(shown.direct));
  return result;
}

val valueOf(Session& session, const Result<Shown>& shown) {
  if (shown) return valueOf(session, *shown);
  return val(shown.error().message);
}

// --- the scene

val sectionsOf(const Session& session) {
  val sections = val::array();
  const SceneTable& table = *session.table();
  for (std::uint32_t i = 0; i < table.sections.size(); ++i) {
    const SceneSection& section = table.sections[i];
    val line = val::object();
    line.set("index", i);
    line.set("name", section.name);
    line.set("offset", static_cast<double>(section.offset));
    line.set("storedBytes", static_cast<double>(section.storedBytes));
    line.set("inflatedBytes", static_cast<double>(section.inflatedBytes));
    line.set("deflated", section.codec == Codec::kDeflate);
    line.set("needed", session.needed(i));
    line.set("early", session.early(i));
    line.set("ofOperator", session.ofOperator(i));
    line.set("ofStatistics", session.ofStatistics(i));
    sections.set(i, line);
  }
  return sections;
}

val openTable(Session& session, val file) {
  const std::vector<std::uint8_t> bytes = vectorOf<std::uint8_t>(file);
  const Result<Done> opened = session.openTable(bytes);
  return opened ? sectionsOf(session) : val(opened.error().message);
}

val openHead(Session& session, val head, double fileBytes) {
  const std::vector<std::uint8_t> bytes = vectorOf<std::uint8_t>(head);
  const Result<Done> opened = session.openHead(bytes, static_cast<std::uint64_t>(fileBytes));
  return opened ? sectionsOf(session) : val(opened.error().message);
}

std::string verify(const Session& session, std::uint32_t section, val bytes) {
  return errorOf(session.verify(section, vectorOf<std::uint8_t>(bytes)));
}

std::string provide(Session& session, std::uint32_t section, val bytes) {
  return errorOf(session.provide(section, vectorOf<std::uint8_t>(bytes)));
}

std::string finish(Session& session) { return errorOf(session.finish()); }

std::string finishOperator(Session& session) { return errorOf(session.finishOperator()); }

bool prepareLight(Session& session, bool looks, std::uint32_t count) {
  return session.prepareLight(looks, count);
}

std::string finishLight(Session& session) { return errorOf(session.finishLight()); }

std::string finishStatistics(Session& session) { return errorOf(session.finishStatistics()); }

val surfacesOf(const Scene& scene) {
  val surfaces = val::array();
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    const Surface& surface = scene.surfaces[s];
    val line = val::object();
    line.set("name", surface.name);
    line.set("area", surface.area);
    line.set("patches", surface.patches);
    line.set("reflectance", surface.reflectance);
    line.set("measuring", surface.measuring);
    line.set("border", surface.border);
    line.set("lost", surface.lost);
    surfaces.set(s, line);
  }
  return surfaces;
}

void append(std::vector<float>& to, const Vec3& v) {
  to.insert(to.end(), {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
}

val infoOf(const Scene& scene) {
  std::vector<float> position, normal, axis, size, center;
  for (const Site& site : scene.sites) {
    append(position, site.position);
    append(normal, site.normal);
    append(axis, site.axis);
    size.push_back(static_cast<float>(site.size));
  }
  for (const Vec3& c : scene.patches.center) append(center, c);
  val result = val::object();
  result.set("identity", scene.identity);
  result.set("patches", scene.patches.count);
  result.set("receivers", scene.patches.rows() - scene.patches.count);
  result.set("clusters", scene.patches.clusterCount);
  result.set("surfaces", surfacesOf(scene));
  result.set("sitePosition", copied(position));
  result.set("siteNormal", copied(normal));
  result.set("siteAxis", copied(axis));
  result.set("siteSize", copied(size));
  result.set("surfaceOfPatch", copied(scene.patches.surface));
  result.set("patchArea", copied(std::vector<float>(scene.patches.area.begin(), scene.patches.area.end())));
  result.set("patchCenter", copied(center));
  result.set("patchReflectance", copied(scene.patches.reflectance));
  result.set("patchCovered", copied(scene.patches.covered));
  return result;
}

val info(const Session& session) { return session.scene() ? infoOf(*session.scene()) : val::null(); }

val outline(Session& session) {
  const Result<Done> read = session.readOutline();
  return read ? infoOf(*session.outline()) : val(read.error().message);
}

val opening(const Session& session) {
  if (!session.opening()) return val::null();
  val result = val::object();
  result.set("layout", valueOf(session.opening()->layout));
  result.set("illuminance", copied(session.opening()->illuminance));
  return result;
}

// --- intentions

/// The page's words in the order of their numbers.
template <class Names>
val inOrder(const Names& names) {
  val list = val::array();
  for (std::size_t code = 0; code < std::size(names); ++code) list.set(code, std::string(names[code]));
  return list;
}

val codes() {
  std::vector<const char*> statistics;
  for (const StatisticTraits& traits : kStatistics) statistics.push_back(traits.name);
  val result = val::object();
  result.set("statistic", inOrder(statistics));
  result.set("sense", inOrder(kSenseNames));
  result.set("quantity", inOrder(kQuantityNames));
  result.set("rule", inOrder(kRuleNames));
  result.set("axis", inOrder(kPlanAxisNames));
  return result;
}

template <class E>
E enumOf(const val& object, const char* key) {
  return static_cast<E>(object[key].as<int>());
}

/// Zero where there is none.
Vec3 vec3Of(const val& v) {
  if (v.isNull()) return {};
  return normalized({v[0].as<double>(), v[1].as<double>(), v[2].as<double>()});
}

/// Nothing where it is that of all that is asked.
std::optional<Quantity> quantityOf(const val& v) {
  return v["quantity"].isNull() ? std::nullopt : std::optional(enumOf<Quantity>(v, "quantity"));
}

Goal goalOf(const val& v) {
  return {enumOf<Statistic>(v, "statistic"),
          enumOf<Sense>(v, "sense"),
          v["weight"].as<double>(),
          vectorOf<std::uint32_t>(v["surfaces"]),
          vectorOf<std::uint32_t>(v["over"]),
          v["target"].as<double>(),
          quantityOf(v)};
}

Constraint constraintOf(const val& v) {
  return {enumOf<Statistic>(v, "statistic"),
          v["lower"].as<double>(),
          v["upper"].as<double>(),
          v["alpha"].as<double>(),
          vectorOf<std::uint32_t>(v["surfaces"]),
          vectorOf<std::uint32_t>(v["over"]),
          kNone,
          quantityOf(v),
          v["isLeast"].as<bool>(),
          vec3Of(v["direction"]),
          v["onGrid"].as<bool>()};
}

/// Who looks: nobody where `asked` is null; those of the room, or six numbers each: eye and direction.
std::vector<Observer> observersOf(const val& asked, Session& room) {
  if (asked.isNull()) return {};
  if (asked["inRoom"].as<bool>()) return *room.observers();
  const std::vector<double> numbers = vectorOf<double>(asked["observers"]);
  std::vector<Observer> observers;
  for (std::size_t i = 0; i + 6 <= numbers.size(); i += 6) {
    const double* n = &numbers[i];
    observers.push_back(
        {asked["names"][i / 6].as<std::string>(), {n[0], n[1], n[2]}, normalized({n[3], n[4], n[5]})});
  }
  return observers;
}

std::vector<Zone> zonesOf(const val& asked) {
  std::vector<Zone> zones;
  for (unsigned z = 0, count = asked["length"].as<unsigned>(); z < count; ++z)
    zones.push_back({asked[z]["name"].as<std::string>(), asked[z]["leaf"].as<std::uint32_t>(),
                     vectorOf<std::uint32_t>(asked[z]["rows"])});
  return zones;
}

LuminaireRules rulesOf(const val& v) {
  LuminaireRules rules;
  rules.count = v["count"].as<std::uint32_t>();
  rules.countHigh = v["countHigh"].as<std::uint32_t>();
  rules.arrangement = {enumOf<Rule>(v, "rule"), enumOf<PlanAxis>(v, "axis"),
                       v["leastInRow"].as<std::uint32_t>()};
  rules.flux = vectorOf<double>(v["flux"]);
  rules.dimmingLow = v["dimmingLow"].as<double>();
  rules.dimmingHigh = v["dimmingHigh"].as<double>();
  rules.pinned = vectorOf<std::uint32_t>(v["pinned"]);
  rules.excluded = vectorOf<std::uint32_t>(v["excluded"]);
  rules.minDistance = v["minDistance"].as<double>();
  const val types = v["types"];
  for (unsigned t = 0, count = types["length"].as<unsigned>(); t < count; ++t)
    rules.types.push_back({types[t]["least"].as<std::uint32_t>(), types[t]["most"].as<std::uint32_t>(),
                           types[t]["name"].as<std::string>()});
  rules.ofType = vectorOf<std::uint32_t>(v["ofType"]);
  return rules;
}

Intentions intentionsOf(const val& asked, Session& session) {
  Intentions intentions;
  intentions.quantity = enumOf<Quantity>(asked, "quantity");
  intentions.luminaires = rulesOf(asked["luminaires"]);
  const val goals = asked["goals"], constraints = asked["constraints"];
  for (unsigned i = 0, count = goals["length"].as<unsigned>(); i < count; ++i)
    intentions.goals.push_back(goalOf(goals[i]));
  for (unsigned i = 0, count = constraints["length"].as<unsigned>(); i < count; ++i)
    intentions.constraints.push_back(constraintOf(constraints[i]));
  intentions.zones = zonesOf(asked["zones"]);
  if (session.scene()) intentions.observers = observersOf(asked["glare"], session);
  return intentions;
}

void setPowers(Session& session, val watts) { session.setPowers(vectorOf<double>(watts)); }

std::string setIntentions(Session& session, val asked) {
  return errorOf(session.setIntentions(intentionsOf(asked, session)));
}

bool roomFor(const Session& session, val luminaires) { return session.hasRoom(rulesOf(luminaires)); }

// --- search

std::string start(Session& session, std::uint32_t seed) { return errorOf(session.start(seed, nullptr)); }

std::string startFrom(Session& session, std::uint32_t seed, val sites, val flux, double dimming) {
  const Layout layout = layoutOf(sites, flux, dimming);
  return errorOf(session.start(seed, &layout));
}

std::string startNear(Session& session, std::uint32_t seed, val sites, val flux, double dimming, val moved) {
  return errorOf(session.startNear(seed, layoutOf(sites, flux, dimming), vectorOf<std::uint32_t>(moved)));
}

val valueOf(const SearchProgress& progress) {
  val result = val::object();
  result.set("evaluations", static_cast<double>(progress.evaluations));
  result.set("foundAt", static_cast<double>(progress.foundAt));
  result.set("violation", progress.evaluation.violation);
  result.set("goal", progress.evaluation.goal);
  result.set("proved", progress.proved);
  return result;
}

val advance(Session& session, std::uint32_t evaluations) { return valueOf(session.advance(evaluations)); }

val settle(Session& session, std::uint32_t evaluations) { return valueOf(session.settle(evaluations)); }

std::string startAside(Session& session, val asked, std::uint32_t seed, val sites,
                       std::uint32_t evaluations) {
  const Layout start{vectorOf<std::uint32_t>(sites), {}, 1};
  return errorOf(session.startAside(intentionsOf(asked, session), seed,
                                    start.sites.empty() ? nullptr : &start, evaluations));
}

val advanceAside(Session& session, std::uint32_t evaluations) {
  const Result<std::optional<Found>> found = session.advanceAside(evaluations);
  if (!found) return val(found.error().message);
  if (!*found) return val::null();
  const Found& trial = **found;
  val result = val::object();
  result.set("layout", valueOf(trial.layout));
  result.set("violation", trial.evaluation.violation);
  result.set("goal", trial.evaluation.goal);
  result.set("limit", trial.limit ? val(*trial.limit) : val::null());
  return result;
}

val incumbent(Session& session) { return valueOf(session, session.incumbent()); }

val show(Session& session, val sites, val flux, double dimming) {
  return valueOf(session, session.show(layoutOf(sites, flux, dimming)));
}

val check(Session& session, val sites, val flux, double dimming) {
  const Result<Shown> shown = session.show(layoutOf(sites, flux, dimming));
  if (!shown) return val(shown.error().message);
  const StatisticsCheck checked = checkStatistics(*session.scene(), session.intentions().quantity, *shown);
  val result = val::object();
  result.set("largestDifference", checked.largestDifference);
  result.set("surface", checked.surface);
  std::vector<double> margins;
  for (const ConstraintReading& reading : shown->constraints) margins.push_back(reading.margin);
  result.set("margins", copied(margins));
  return result;
}

// --- candidates: luminaires of photometric files on sites

void expectType(Session& room, val file) { (void)room.photometricType(vectorOf<std::uint8_t>(file)); }

Result<std::vector<CandidateType>> typesOf(Session& room, const val& files, const val& flux) {
  const std::vector<double> lumens = vectorOf<double>(flux);
  std::vector<CandidateType> types;
  for (std::size_t i = 0; i < lumens.size(); ++i) {
    const std::vector<std::uint8_t> bytes = vectorOf<std::uint8_t>(files[i]);
    Result<PhotometricType> type = room.photometricType(bytes);
    if (!type) return type.error();
    types.push_back({std::move(*type), lumens[i]});
  }
  return types;
}

/// `asked`: four numbers a candidate (site, type, way, turn) and three of its aim, NaN for none.
std::vector<Candidate> candidatesOf(const val& asked) {
  const std::vector<double> numbers = vectorOf<double>(asked);
  std::vector<Candidate> candidates(numbers.size() / 7);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const double* n = &numbers[7 * i];
    const auto whole = [&](int k) { return static_cast<std::uint32_t>(n[k]); };
    candidates[i] = {whole(0), whole(1), whole(2), n[3], {}};
    if (n[4] == n[4]) candidates[i].aim = Vec3{n[4], n[5], n[6]};
  }
  return candidates;
}

/// A CandidateScene that may not have begun yet, for a class that the page makes without arguments.
struct Candidates {
  Session* session = nullptr;  // of the room
  std::optional<CandidateScene> scene;
  std::vector<Observer> observers;  // who will be asked for
};

/// Two numbers a painted surface: its index and its reflectance.
std::vector<SurfacePaint> paintOf(const val& asked) {
  const std::vector<double> numbers = vectorOf<double>(asked);
  std::vector<SurfacePaint> paint;
  for (std::size_t i = 0; i + 2 <= numbers.size(); i += 2)
    paint.push_back({static_cast<std::uint32_t>(numbers[i]), numbers[i + 1]});
  return paint;
}

/// nullptr where nothing is painted.
Result<std::shared_ptr<const Repaint>> repaintOf(Session& room, const val& asked) {
  const std::vector<SurfacePaint> paint = paintOf(asked);
  if (paint.empty()) return std::shared_ptr<const Repaint>();
  return room.repaint(paint);
}

std::string taken(Candidates& candidates, Session& room, Result<CandidateScene> begun) {
  if (!begun) return begun.error().message;
  candidates.session = &room;
  candidates.scene.emplace(std::move(*begun));
  return {};
}

std::string begin(Candidates& candidates, Session& room, val files, val flux, val asked, val paint) {
  if (!room.scene()) return "no scene is open";
  Result<std::vector<CandidateType>> types = typesOf(room, files, flux);
  if (!types) return types.error().message;
  const Result<std::shared_ptr<const Repaint>> painted = repaintOf(room, paint);
  if (!painted) return painted.error().message;
  return taken(
      candidates, room,
      CandidateScene::begin(*room.scene(), std::move(*types), candidatesOf(asked),
                            room.scene()->lightOperator ? room.photometricLight() : nullptr, *painted));
}

/// `there`: of each candidate its index in the scene of `known`, or `none`.
void takeCandidates(Candidates& candidates, const Session& known, val there) {
  if (candidates.scene && known.scene())
    candidates.scene->take(*known.scene(), vectorOf<std::uint32_t>(there));
}

/// `some`: indices of candidates.
void leaveDark(Candidates& candidates, val some) {
  if (candidates.scene) candidates.scene->leaveDark(vectorOf<std::uint32_t>(some));
}

std::string beginPainted(Candidates& candidates, const Candidates& base, Session& room, val paint) {
  const Result<std::shared_ptr<const Repaint>> painted = room.repaint(paintOf(paint));
  if (!painted) return painted.error().message;
  candidates.session = &room;
  candidates.scene.emplace(base.scene->repainted(*painted));
  return {};
}

std::string beginSquares(Candidates& candidates, Session& room, val sites, val paint) {
  if (!room.scene()) return "no scene is open";
  const Result<std::shared_ptr<const Repaint>> painted = repaintOf(room, paint);
  if (!painted) return painted.error().message;
  return taken(candidates, room,
               CandidateScene::ofSquares(*room.scene(), vectorOf<std::uint32_t>(sites), *painted));
}

std::string knowCandidates(Candidates& candidates, val columns) {
  if (!candidates.scene) return "no candidates were begun";
  const Result<Done> known = candidates.scene->know(vectorOf<float>(columns));
  return known ? std::string() : known.error().message;
}

void observeCandidates(Candidates& candidates, val asked) {
  candidates.observers = intentionsOf(asked, *candidates.session).observers;
}

bool advanceCandidates(Candidates& candidates, std::uint32_t count) {
  return candidates.scene && candidates.scene->advance(count) && candidates.scene->look(candidates.observers);
}

/// Its scene becomes the session's, with what the observers see that are asked for and what is asked of
/// measuring planes; there is nothing left of it.
std::string adopt(Session& session, Candidates& candidates, val asked) {
  Session& room = *candidates.session;
  const Intentions intentions = intentionsOf(asked, room);
  std::vector<ObserverRows> rows = candidates.scene->seenBy(intentions.observers);
  Result<std::vector<PlaneLight>> planes = candidates.scene->planesOf(planesAskedOf(intentions));
  if (!planes) return planes.error().message;
  std::optional<DirectLight> direct;
  if (asksForDirect(intentions) && candidates.scene->room().lightOperator)
    direct = candidates.scene->directLight();
  Scene scene = candidates.scene->finish(intentions.quantity);
  scene.direct = std::move(direct);
  scene.observers = std::move(rows);
  scene.planes = std::move(*planes);
  session.adopt(std::move(scene), &room);
  candidates.scene.reset();
  return {};
}

// --- the colour that light takes, for the picture

/// A ColoredLight that may not have begun yet, as Candidates.
struct RoomColor {
  std::optional<ColoredLight> light;
};

std::string beginColor(RoomColor& color, Session& room, val colors, val paint) {
  if (!room.scene() || !room.scene()->lightOperator) return "no room with a light operator is open";
  const Result<std::shared_ptr<const Repaint>> painted = repaintOf(room, paint);
  if (!painted) return painted.error().message;
  const std::vector<float> linear = vectorOf<float>(colors);
  if (linear.size() != std::size_t{3} * room.scene()->patches.count) return "the colours are of another room";
  color.light.emplace(*room.scene(), linear,
                      *painted ? (*painted)->reflectance() : room.scene()->patches.reflectance);
  return {};
}

bool isGrey(const RoomColor& color) { return !color.light || color.light->isGrey(); }

val colorsOf(const RoomColor& color, val illuminance) {
  return copied(color.light->of(vectorOf<float>(illuminance)));
}

// --- which paint helps

/// Of each surface: its index, then what every goal and every constraint gains. Or one line. `lit` has the
/// layout; it is the session of the room, or one that has adopted candidates in it.
val paintGainsOf(Session& lit, Session& room, val asked, val paint, val sites, val flux, double dimming) {
  if (!room.scene() || !lit.scene()) return val(std::string("no scene is open"));
  const Result<std::shared_ptr<const Repaint>> painted = room.repaint(paintOf(paint));
  if (!painted) return val(painted.error().message);
  const Result<std::vector<PaintGain>> gains =
      paintGains(*room.scene(), *room.photometricLight(), **painted,
                 {*lit.scene(), layoutOf(sites, flux, dimming)}, intentionsOf(asked, lit));
  if (!gains) return val(gains.error().message);
  std::vector<double> numbers;
  for (const PaintGain& gain : *gains) {
    numbers.push_back(gain.surface);
    numbers.insert(numbers.end(), gain.goals.begin(), gain.goals.end());
    numbers.insert(numbers.end(), gain.constraints.begin(), gain.constraints.end());
  }
  return copied(numbers);
}

// --- the alpha-search

std::string startAlpha(Session& session, std::uint32_t seed, val held) {
  const Layout layout{vectorOf<std::uint32_t>(held), {}, 1};
  return errorOf(session.startAlpha(seed, layout.sites.empty() ? nullptr : &layout));
}

val valueOf(const AlphaIteration& step) {
  val result = val::object();
  result.set("alpha", step.alpha);
  result.set("low", step.low);
  result.set("high", step.high);
  result.set("region", std::string(regionName(step.region)));
  result.set("mean", step.mean);
  result.set("sigma", step.sigma);
  result.set("minimum", step.minimum);
  result.set("phi", step.phi);
  return result;
}

/// What the search has, and its iterations from number `from` on.
val advanceAlpha(Session& session, std::uint32_t evaluations, std::uint32_t from) {
  AlphaSearch* alpha = session.alpha();
  if (!alpha) return val(std::string("no alpha-search is running"));
  alpha->advance(evaluations);
  val steps = val::array();
  for (std::size_t i = from; i < alpha->iterations().size(); ++i)
    steps.set(i - from, valueOf(alpha->iterations()[i]));
  const AlphaIteration* solution = alpha->solution();
  val result = val::object();
  result.set("done", alpha->done());
  result.set("steps", steps);
  result.set("verdict", alpha->verdict());
  result.set("alpha", solution ? val(solution->alpha) : val::null());
  result.set("feasibleBound", alpha->fallback() ? val(alpha->feasibleBound()) : val::null());
  const Layout* layout = solution ? &solution->layout : alpha->fallback() ? &*alpha->fallback() : nullptr;
  result.set("layout", layout ? valueOf(*layout) : val::null());
  return result;
}

// --- the bound

std::string startBound(Session& session) { return errorOf(session.startBound()); }

val takePairs(Session& session) { return copied(session.takePairs()); }

/// A stage of a bound, gone through in a module of its own.
class PairProof {
 public:
  /// False where `pairs` are not what takePairs told.
  bool begin(const val& pairs) {
    std::optional<PairGoal> goal = pairGoalFrom(vectorOf<double>(pairs));
    if (goal) bound_ = std::make_unique<PairBound>(std::move(*goal));
    return bound_ != nullptr;
  }
  /// One step; true when it was the last.
  bool advance() {
    if (!bound_) return true;
    bound_->advance();
    return bound_->done();
  }
  double goal() const { return bound_ ? bound_->goal() : -kUnbounded; }

 private:
  std::unique_ptr<PairBound> bound_;
};

val advanceBound(Session& session, std::uint32_t steps) {
  LayoutBound* bound = session.bound();
  if (!bound) return val(std::string("no bound is being looked for"));
  bound->advance(steps);
  const std::optional<double> gap = session.boundGap();
  val result = val::object();
  result.set("done", bound->done());
  result.set("goal", bound->goal());
  result.set("gap", gap ? val(*gap) : val::null());
  return result;
}

// --- photometric files

val orNull(const std::optional<double>& value) { return value ? val(*value) : val::null(); }

val valueOf(const LuminousArea& area) {
  val result = val::object();
  result.set("length", area.length);
  result.set("width", area.width);
  result.set("height", area.height);
  result.set("round", area.round);
  return result;
}

val describePhotometry(val file) {
  const std::vector<std::uint8_t> bytes = vectorOf<std::uint8_t>(file);
  const Result<Photometry> photometry = readPhotometry(bytes);
  if (!photometry) return val(photometry.error().message);
  const PhotometricDescription description = describe(*photometry);
  val result = val::object();
  result.set("name", photometry->name);
  result.set("maker", photometry->maker);
  result.set("format", std::string(nameOf(photometry->format)));
  result.set("flux", photometry->flux);
  result.set("integratedFlux", description.integratedFlux);
  result.set("disputed", description.disputed);
  result.set("watts", photometry->watts);
  result.set("efficacy", orNull(description.efficacy));
  result.set("cct", orNull(photometry->cct));
  result.set("luminous", valueOf(photometry->luminous));
  result.set("longAxis", std::string(photometry->longAxis == PhotometricAxis::kC0 ? "C0" : "C90"));
  result.set("symmetry", std::string(nameOf(photometry->symmetry)));
  result.set("maxCandela", description.maxCandela);
  result.set("beamAngle", description.beamAngle);
  result.set("fieldAngle", description.fieldAngle);
  result.set("upwardShare", description.upwardShare);
  result.set("ugr4h8h", orNull(description.ugr4h8h));
  val warnings = val::array();
  for (std::size_t i = 0; i < photometry->warnings.size(); ++i) warnings.set(i, photometry->warnings[i]);
  result.set("warnings", warnings);
  result.set("candela", copied(sampledIntensities(*photometry)));
  return result;
}

}  // namespace

EMSCRIPTEN_BINDINGS(core) {
  emscripten::function("codes", &codes);
  emscripten::function("describePhotometry", &describePhotometry);
  emscripten::class_<Candidates>("Candidates")
      .constructor<>()
      .function("begin", &begin)
      .function("beginPainted", &beginPainted)
      .function("beginSquares", &beginSquares)
      .function("take", &takeCandidates)
      .function("leaveDark", &leaveDark)
      .function("know", &knowCandidates)
      .function("observe", &observeCandidates)
      .function("advance", &advanceCandidates);
  emscripten::class_<RoomColor>("ColoredLight")
      .constructor<>()
      .function("begin", &beginColor)
      .function("isGrey", &isGrey)
      .function("of", &colorsOf);
  emscripten::class_<PairProof>("PairProof")
      .constructor<>()
      .function("begin", &PairProof::begin)
      .function("advance", &PairProof::advance)
      .function("goal", &PairProof::goal);
}

EMSCRIPTEN_BINDINGS(session) {
  emscripten::class_<Session>("Session")
      .constructor<>()
      .function("openTable", &openTable)
      .function("openHead", &openHead)
      .function("outline", &outline)
      .function("opening", &opening)
      .function("verify", &verify)
      .function("provide", &provide)
      .function("finish", &finish)
      .function("finishOperator", &finishOperator)
      .function("prepareLight", &prepareLight)
      .function("expectType", &expectType)
      .function("finishLight", &finishLight)
      .function("finishStatistics", &finishStatistics)
      .function("info", &info)
      .function("setPowers", &setPowers)
      .function("setIntentions", &setIntentions)
      .function("hasRoom", &roomFor)
      .function("prepareSearch", &Session::prepareSearch)
      .function("start", &start)
      .function("startFrom", &startFrom)
      .function("startNear", &startNear)
      .function("advance", &advance)
      .function("settle", &settle)
      .function("startAside", &startAside)
      .function("enterAside", &Session::enterAside)
      .function("advanceAside", &advanceAside)
      .function("incumbent", &incumbent)
      .function("show", &show)
      .function("check", &check)
      .function("paintGains", &paintGainsOf)
      .function("adopt", &adopt)
      .function("startAlpha", &startAlpha)
      .function("advanceAlpha", &advanceAlpha)
      .function("startBound", &startBound)
      .function("advanceBound", &advanceBound)
      .function("takePairs", &takePairs)
      .function("provedByPairs", &Session::provedByPairs);
}

}  // namespace fiatlux
