// The order of things in a sitting; see session.h.
#include "core/session/session.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/alpha/guarantees.h"
#include "core/bound/evenness_limit.h"
#include "core/bound/pair_numbers.h"
#include "core/scene/zones.h"
#include "core/search/eased.h"
#include "core/search/identity.h"
#include "core/search/near_search.h"
#include "core/search/plane_values.h"
#include "core/search/start_layout.h"
#include "core/search/steady.h"
#include "core/search/validate_intentions.h"
#include "core/transport/direct_part.h"
#include "core/transport/plane_light.h"
#include "core/transport/room_view.h"

namespace fiatlux {
namespace {

/// Of what is asked for alone and missed; nothing where no limit is known.
std::optional<double> limitOf(PreparedScene& prepared, const Intentions& asked, const Evaluation& found) {
  if (!asked.goals.empty() || asked.constraints.size() != 1 || found.violation == 0) return std::nullopt;
  Constraint only = asked.constraints[0];
  if (!only.onGrid || only.statistic != Statistic::kUniformity) return std::nullopt;
  only.quantity = quantityOf(asked, only);
  return evennessLimit(prepared, only, asked.luminaires.excluded);
}

}  // namespace

Result<Done> Session::openTable(std::span<const std::uint8_t> file) {
  Result<SceneReader> reader = SceneReader::open(file);
  if (!reader) return reader.error();
  arrivingLight_.reset();
  reader_.emplace(std::move(*reader));
  return Done{};
}

Result<Done> Session::openHead(std::span<const std::uint8_t> head, std::uint64_t fileBytes) {
  Result<SceneReader> reader = SceneReader::openHead(head, fileBytes);
  if (!reader) return reader.error();
  arrivingLight_.reset();
  reader_.emplace(std::move(*reader));
  return Done{};
}

Result<Done> Session::readOutline() {
  if (!reader_) return Error{"no scene file is being opened"};
  return reader_->readOutline();
}

Result<Done> Session::verify(std::uint32_t section, std::span<const std::uint8_t> bytes) const {
  if (!reader_) return Error{"no scene file is being opened"};
  return reader_->verify(section, bytes);
}

Result<Done> Session::provide(std::uint32_t section, std::vector<std::uint8_t> bytes) {
  if (!reader_) return Error{"no scene file is being opened"};
  return reader_->provide(section, std::move(bytes));
}

Result<Done> Session::finish() {
  if (!reader_) return Error{"no scene file is being opened"};
  Result<Scene> scene = reader_->finish();
  arrivingLight_.reset();
  if (!scene) {
    reader_.reset();
    return scene.error();
  }
  adopt(std::move(*scene));
  return Done{};
}

Result<Done> Session::finishOperator() {
  if (!reader_ || !scene_) return Error{"no scene file is being opened"};
  const Result<Done> read = reader_->finishOperator(*scene_);
  reader_.reset();
  grids_.reset();  // the pieces of surfaces are known better now
  return read;
}

bool Session::prepareLight(bool looks, std::uint32_t count) {
  if (!reader_) return !scene_ || !scene_->lightOperator || photometricLight()->prepare(count);
  const Scene* room = outline();
  if (!room || !room->lightOperator) return true;
  if (!arrivingLight_) arrivingLight_ = std::make_shared<const PhotometricLight>(*room), looked_ = 0;
  const std::vector<Observer> observers = looks ? observersInRoom(room->patches) : std::vector<Observer>();
  if (looked_ >= observers.size()) return arrivingLight_->prepare(count);
  // Those at one place share what is seen from there.
  const Vec3 place = observers[looked_].position;
  (void)arrivingLight_->sightLines()->from(place);
  while (looked_ < observers.size() && length(observers[looked_].position - place) == 0) ++looked_;
  return false;
}

Result<Done> Session::finishLight() {
  if (!reader_) return Error{"no scene file is being opened"};
  Result<std::unique_ptr<Scene>> scene = reader_->finishLight();
  std::shared_ptr<const PhotometricLight> light = std::move(arrivingLight_);
  if (!scene) {
    reader_.reset();
    return scene.error();
  }
  adopt(std::move(*scene), nullptr);
  prepared_.reset();
  light_ = std::move(light);
  return Done{};
}

Result<Done> Session::finishStatistics() {
  if (!reader_ || !scene_ || prepared_) return Error{"no scene file is being opened"};
  const Result<Done> read = reader_->finishStatistics(*scene_);
  reader_.reset();
  if (!read) return read;
  prepared_ = std::make_unique<PreparedScene>(*scene_);
  return Done{};
}

void Session::adopt(Scene scene, Session* room) { adopt(std::make_unique<Scene>(std::move(scene)), room); }

void Session::adopt(std::unique_ptr<Scene> scene, Session* room) {
  search_.reset();
  eased_.reset();
  aside_.reset();
  alpha_.reset();
  bound_.reset();
  before_.reset();
  prepared_.reset();
  repaint_.reset();
  light_.reset();
  grids_ = room ? room->grids() : nullptr;
  observers_ = room ? room->observers() : nullptr;
  asked_ = false;
  intentions_ = {};
  scene_ = std::move(scene);
  prepared_ = std::make_unique<PreparedScene>(*scene_);
}

std::shared_ptr<const PhotometricLight> Session::photometricLight() {
  assert(scene_ && scene_->lightOperator);
  if (!light_) light_ = std::make_shared<const PhotometricLight>(*scene_);
  return light_;
}

Result<PhotometricType> Session::photometricType(std::span<const std::uint8_t> file) {
  constexpr std::size_t kKept = 16;
  for (const KnownType& known : types_)
    if (std::equal(file.begin(), file.end(), known.file.begin(), known.file.end())) return known.type;
  Result<Photometry> photometry = readPhotometry(file);
  if (!photometry) return photometry.error();
  if (types_.size() == kKept) types_.erase(types_.begin());
  types_.push_back(
      {{file.begin(), file.end()}, sampledType(std::make_shared<const Photometry>(std::move(*photometry)))});
  return types_.back().type;
}

Result<std::shared_ptr<const Repaint>> Session::repaint(const std::vector<SurfacePaint>& paint) {
  if (!scene_) return Error{"no scene is open"};
  const Result<Done> checked = checkPaint(*scene_, paint);
  if (!checked) return checked.error();
  if (!repaint_ || !(paint == paint_)) {
    repaint_ = std::make_shared<const Repaint>(*scene_, photometricLight()->exchange(),
                                               paintedReflectance(*scene_, paint));
    paint_ = paint;
  }
  return repaint_;
}

void Session::setPowers(const std::vector<double>& watts) {
  if (!scene_) return;
  for (Hanging& hanging : scene_->hangings)
    if (hanging.type < watts.size()) hanging.power = watts[hanging.type];
}

Result<Done> Session::setIntentions(const Intentions& intentions) {
  if (Result<Done> complete = isComplete(); !complete) return complete;
  std::vector<Zone> before = scene_->zones;
  const bool areZonesNew = !(intentions.zones == before);
  if (Result<Done> sound = areZonesNew ? takeZones(*scene_, intentions.zones) : Done{}; !sound) return sound;
  Result<Done> checked = checkIntentions(*scene_, intentions);
  if (checked) checked = observe(*scene_, intentions.observers);
  if (checked) checked = lightFor(intentions);
  if (!checked) {
    if (areZonesNew) (void)takeZones(*scene_, before);
    return checked;
  }
  search_.reset();
  eased_.reset();
  aside_.reset();
  alpha_.reset();
  bound_.reset();
  // What is prepared knows zones by their numbers.
  if (areZonesNew) prepared_ = std::make_unique<PreparedScene>(*scene_);
  intentions_ = intentions;
  asked_ = true;
  return Done{};
}

bool Session::hasRoom(const LuminaireRules& rules) const { return scene_ && checkRules(*scene_, rules); }

/// What they ask for beside all light on surfaces is made when it is asked for first.
Result<Done> Session::lightFor(const Intentions& intentions) {
  if (asksForDirect(intentions))
    if (Result<Done> lit = addDirect(*scene_); !lit) return lit;
  return addPlanes(*scene_, planesAskedOf(intentions));
}

Result<Done> Session::isComplete() const {
  if (!scene_) return Error{"no scene is open"};
  if (!prepared_) return Error{"the statistics of the room are not there yet"};
  return Done{};
}

Result<Done> Session::ready() const {
  if (Result<Done> complete = isComplete(); !complete) return complete;
  if (!asked_) return Error{"nothing is asked of the light yet"};
  return Done{};
}

bool Session::prepareSearch(std::size_t rows) {
  if (!ready()) return true;
  const auto areThere = [&](const auto& wish) {
    const StatisticTraits& traits = traitsOf(wish.statistic);
    const Quantity quantity = quantityOf(intentions_, wish);
    return !traits.needsVariance || prepared_->prepare(quantity, wish.surfaces, rows);
  };
  const std::vector<Goal>& goals = intentions_.goals;
  const std::vector<Constraint>& constraints = intentions_.constraints;
  return std::all_of(goals.begin(), goals.end(), areThere) &&
         std::all_of(constraints.begin(), constraints.end(),
                     [&](const Constraint& c) { return isOfPoints(c) || areThere(c); });
}

Result<Done> Session::start(std::uint64_t seed, const Layout* start) {
  Result<Done> can = ready();
  if (!can) return can;
  bound_.reset();
  before_.reset();
  told_.reset();
  eased_.reset();
  isNear_ = false;
  if (start) {
    pinAsIn(*start);
    if (isOfRoom(*start)) before_ = *start;
  }
  search_ = std::make_unique<LayoutSearch>(*prepared_, intentions_, seed, start);
  return Done{};
}

Result<Done> Session::startNear(std::uint64_t seed, const Layout& start,
                                const std::vector<std::uint32_t>& moved) {
  if (Result<Done> begun = this->start(seed, &start); !begun) return begun;
  const auto isThere = [&](std::uint32_t i) { return i < start.sites.size(); };
  if (!checkLayout(*scene_, start) || !std::all_of(moved.begin(), moved.end(), isThere)) return Done{};
  if (auto near = searchNear(*prepared_, intentions_, seed, start, moved)) {
    search_ = std::move(near);
    isNear_ = true;
  }
  return Done{};
}

bool Session::isOfRoom(const Layout& layout) const {
  return std::all_of(layout.sites.begin(), layout.sites.end(),
                     [&](std::uint32_t site) { return site < scene_->sites.size(); });
}

/// Those that hung before keep their numbers.
Layout Session::numberedSince(const Layout& before, const LuminaireRules& rules, const Layout& layout) const {
  return ofTypesAsked(*scene_, rules, numberedAs(*scene_, rules, layout, before));
}

/// Whoever hangs on a pinned site is the luminaire that is pinned.
void Session::pinAsIn(const Layout& layout) {
  intentions_.luminaires.pinned = pinsAsIn(intentions_.luminaires, layout.sites);
}

SearchProgress Session::advance(std::uint32_t evaluations) {
  if (!search_) return {};
  eased_.reset();
  search_->advance(evaluations);
  return {search_->evaluations(), search_->foundAt(), search_->evaluation(), search_->isProved()};
}

SearchProgress Session::settle(std::uint32_t evaluations) {
  if (!search_) return {};
  if (!eased_) {
    constexpr std::uint64_t kSeed = 1;
    const Layout best = search_->incumbent();
    const Intentions eased = easedToReach(intentions_, constraintReadings(*prepared_, intentions_, best));
    eased_ = std::make_unique<LayoutSearch>(*prepared_, eased, kSeed, &best);
  }
  eased_->advance(evaluations);
  return {eased_->evaluations(), eased_->foundAt(), eased_->evaluation(), eased_->isProved()};
}

Result<Done> Session::startAside(const Intentions& intentions, std::uint64_t seed, const Layout* start,
                                 std::uint32_t evaluations) {
  if (Result<Done> complete = isComplete(); !complete) return complete.error();
  Result<Done> checked = checkIntentions(*scene_, intentions);
  if (!checked) return checked.error();
  if (!(intentions.observers == intentions_.observers))
    return Error{"a trial has the observers of what is asked, and no others"};
  if (!(intentions.zones == scene_->zones))
    return Error{"a trial has the areas of what is asked, and no others"};
  for (const PlaneWish& wish : planesAskedOf(intentions))
    if (!isToldBy(scene_->planes, wish))
      return Error{"a trial has the measuring planes of what is asked, and no others"};
  if (asksForDirect(intentions))
    if (Result<Done> lit = addDirect(*scene_); !lit) return lit.error();
  Intentions asked = intentions;
  if (start) asked.luminaires.pinned = pinsAsIn(asked.luminaires, start->sites);
  aside_.reset(new Aside{
      asked, LayoutSearch(*prepared_, asked, seed, start, nullptr, Entering::kInSteps), evaluations, {}});
  if (start && isOfRoom(*start)) aside_->before = *start;
  return Done{};
}

Result<std::optional<Found>> Session::advanceAside(std::uint32_t evaluations) {
  if (!aside_) return Error{"nothing is tried beside what is asked"};
  auto& [asked, search, left, before] = *aside_;
  if (!search.enterNext()) return std::optional<Found>();
  const bool isOfFields = asked.luminaires.arrangement.rule == Rule::kField;
  const std::uint32_t spent = isOfFields ? evaluations : std::min(evaluations, left);
  search.advance(spent);
  left -= std::min(spent, left);
  if (left > 0 || (isOfFields && !search.isProved())) return std::optional<Found>();
  const Evaluation& reached = search.evaluation();
  Found found{search.incumbent(), reached, limitOf(*prepared_, asked, reached)};
  if (before) found.layout = numberedSince(*before, asked.luminaires, found.layout);
  aside_.reset();
  return std::optional<Found>(std::move(found));
}

Result<Shown> Session::incumbent() {
  if (!search_) return Error{"no search is running"};
  const bool isSettled = !isNear_ && eased_ && eased_->evaluation().violation == 0 &&
                         eased_->evaluation().goal < search_->evaluation().goal;
  const Layout best = (isSettled ? eased_ : search_)->incumbent();
  if (!before_) return shownOf(*prepared_, intentions_, best);
  const Layout numbered = numberedSince(*before_, intentions_.luminaires, best);
  if (isNear_) return shownOf(*prepared_, intentions_, numbered);  // few have left their places anyway
  const Steadied calm = steadied(*prepared_, intentions_, numbered, *before_);
  if (!isSettled) told_ = calm.evaluation;
  return shownOf(*prepared_, intentions_, calm.layout);
}

Result<Shown> Session::show(const Layout& layout) {
  Result<Done> can = ready();
  if (!can) return can.error();
  Result<Done> checked = checkLayout(*scene_, layout);
  if (!checked) return checked.error();
  return shownOf(*prepared_, intentions_, layout);
}

std::shared_ptr<const CalculationGrids> Session::grids() {
  assert(scene_);
  if (!grids_) grids_ = std::make_shared<const CalculationGrids>(*scene_);
  return grids_;
}

std::shared_ptr<const std::vector<Observer>> Session::observers() {
  if (!observers_)
    observers_ = std::make_shared<const std::vector<Observer>>(observersInRoom(scene_->patches));
  return observers_;
}

std::vector<GridReading> Session::gridsOf(const std::vector<float>& light) {
  std::vector<GridReading> readings = grids()->read(light);
  if (scene_->zones.empty()) return readings;
  const std::vector<GridReading> ofZones = CalculationGrids::ofZones(*scene_).read(light);
  readings.insert(readings.end(), ofZones.begin(), ofZones.end());
  return readings;
}

Result<Done> Session::startAlpha(std::uint64_t seed, const Layout* held) {
  Result<Done> can = ready();
  if (!can) return can;
  if (held) pinAsIn(*held);
  Result<Done> checked = checkAlphaIntentions(*scene_, intentions_);
  if (!checked) return checked;
  AlphaOptions options;
  options.seed = seed;
  alpha_ = std::make_unique<AlphaSearch>(*prepared_, intentions_, options);
  return Done{};
}

Result<Done> Session::startBound() {
  if (!search_) return Error{"no search is running that could be bounded"};
  bound_ = std::make_unique<LayoutBound>(*prepared_, intentions_, *search_);
  pairsAreTaken_ = false;
  return Done{};
}

std::vector<double> Session::takePairs() {
  if (!bound_) return {};
  const std::optional<PairGoal> pairs = bound_->takePairs();
  pairsAreTaken_ = pairsAreTaken_ || pairs;
  return pairs ? numbersOf(*pairs) : std::vector<double>();
}

void Session::provedByPairs(double goal) {
  if (bound_ && pairsAreTaken_) bound_->provedByPairs(goal);
}

std::optional<double> Session::boundGap() const {
  if (!search_ || !bound_ || !bound_->supported()) return std::nullopt;
  return bound_->within(told_ ? *told_ : search_->evaluation());
}

}  // namespace fiatlux
