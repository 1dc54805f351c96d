#include "core/candidates/candidate_scene.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "core/candidates/candidate_list.h"
#include "core/candidates/mount_area.h"
#include "core/scene/zones.h"
#include "core/transport/direct_quadrature.h"
#include "core/transport/plane_light.h"
#include "core/transport/room_view.h"

namespace fiatlux {
namespace {

Result<Done> check(const Scene& room, const std::vector<CandidateType>& types,
                   const std::vector<Candidate>& candidates) {
  if (!room.lightOperator)
    return Error{
        "this room's file knows Lambertian squares only; make it again with fiatlux precompute for "
        "luminaires of photometric files"};
  if (candidates.empty())
    return Error{
        "none of the luminaire types fits anywhere in this room; take a smaller one, or allow a larger "
        "aiming angle"};
  if (candidates.size() > kMaxCandidates)
    return Error{"these types, turns and aims make " + std::to_string(candidates.size()) +
                 " candidates, more than " + std::to_string(kMaxCandidates) + "; allow fewer of them"};
  const std::size_t bytes = candidates.size() * room.responses.rows * sizeof(float);
  if (bytes > kMaxCandidateLight)
    return Error{"the light of " + std::to_string(candidates.size()) + " candidates on " +
                 std::to_string(room.responses.rows) + " patches takes " + std::to_string(bytes / 1'000'000) +
                 " MB, more than " + std::to_string(kMaxCandidateLight / 1'000'000) +
                 " MB; allow fewer types, turns and aims, or make the room with larger patches"};
  for (const Candidate& candidate : candidates)
    if (candidate.site >= room.sites.size() || candidate.type >= types.size())
      return Error{"a luminaire is asked for on site " + std::to_string(candidate.site) + " as type " +
                   std::to_string(candidate.type) + ", which are not both there"};
  return Done{};
}

bool isOf(const ObserverRows& rows, const Observer& observer) { return rows.observer == observer; }

}  // namespace

CandidateScene::CandidateScene(const Scene& room, std::vector<CandidateType> types,
                               std::vector<Candidate> candidates,
                               std::shared_ptr<const PhotometricLight> light,
                               std::shared_ptr<const Repaint> paint)
    : room_(&room),
      light_(std::move(light)),
      paint_(std::move(paint)),
      types_(std::move(types)),
      candidates_(std::move(candidates)),
      responses_(std::make_shared<Responses>()) {
  responses_->rows = room.responses.rows;
  responses_->sites = static_cast<std::uint32_t>(candidates_.size());
  responses_->illuminance.resize(std::size_t{responses_->rows} * responses_->sites);
  means_.assign(firstZone(room), {std::vector<double>(candidates_.size()), {}});
  for (std::uint32_t j = responses_->sites; j-- > 0;) left_.push_back(j);
  isDark_.resize(candidates_.size());
}

Result<CandidateScene> CandidateScene::begin(const Scene& room, std::vector<CandidateType> types,
                                             std::vector<Candidate> candidates,
                                             std::shared_ptr<const PhotometricLight> light,
                                             std::shared_ptr<const Repaint> paint) {
  const Result<Done> checked = check(room, types, candidates);
  if (!checked) return checked.error();
  if (!light) light = std::make_shared<const PhotometricLight>(room);
  return CandidateScene(room, std::move(types), std::move(candidates), std::move(light), std::move(paint));
}

Result<CandidateScene> CandidateScene::ofSquares(const Scene& room, const std::vector<std::uint32_t>& sites,
                                                 std::shared_ptr<const Repaint> paint) {
  if (sites.empty()) return Error{"no luminaire is asked for in the painted room"};
  std::vector<Candidate> candidates;
  for (const std::uint32_t site : sites) {
    if (site >= room.sites.size())
      return Error{"there is no site " + std::to_string(site) + " in the painted room"};
    candidates.push_back({site, 0, 0, 0, {}});
  }
  return CandidateScene(room, {}, std::move(candidates), nullptr, std::move(paint));
}

Luminaire CandidateScene::luminaireOf(const Candidate& candidate) const {
  const Site& site = room_->sites[candidate.site];
  if (types_.empty()) return fiatlux::luminaireOf(site);
  const CandidateType& type = types_[candidate.type];
  return mountedLuminaire(type.photometric, type.flux, site, mountingOf(candidate));
}

/// In the room as its file has it.
std::vector<float> CandidateScene::columnsOf(std::span<const std::uint32_t> some) const {
  if (!unpainted_ && !types_.empty()) {
    const std::vector<PhotometricCandidate> candidates = photometric(some);
    return light_->total(candidates, light_->direct(candidates));
  }
  std::vector<float> columns;
  for (const std::uint32_t j : some) {
    const float* column = unpainted_ ? unpainted_->column(j) : room_->responses.column(candidates_[j].site);
    columns.insert(columns.end(), column, column + room_->responses.rows);
  }
  return columns;
}

/// Precondition: they are of types.
std::vector<PhotometricCandidate> CandidateScene::photometric(std::span<const std::uint32_t> some) const {
  std::vector<PhotometricCandidate> candidates;
  for (const std::uint32_t j : some) {
    const Candidate& candidate = candidates_[j];
    const PhotometricType& photometric = types_[candidate.type].photometric;
    const double flux = types_[candidate.type].flux;
    const double scale = photometric.flux > 0 && flux > 0 ? flux / photometric.flux : 1;
    candidates.push_back(
        {candidate.site, luminaireOf(candidate), photometric.map, static_cast<float>(scale)});
  }
  return candidates;
}

void CandidateScene::take(const Scene& known, const std::vector<std::uint32_t>& there) {
  assert(there.size() == candidates_.size() && known.responses.rows == responses_->rows);
  const auto isThere = [&](std::uint32_t j) {
    if (there[j] == kNone) return false;
    const float* column = known.responses.column(there[j]);
    std::copy(
        column, column + responses_->rows,
        responses_->illuminance.begin() + static_cast<std::ptrdiff_t>(std::size_t{j} * responses_->rows));
    return true;
  };
  takeMeans(known.illuminance, there);
  left_.erase(std::remove_if(left_.begin(), left_.end(), isThere), left_.end());
  if (!known.observers.empty()) seen_.push_back({known.observers, there});
}

/// `there`: of each candidate its entry in mean rows of some, kNone where it has none.
void CandidateScene::takeMeans(const std::vector<SurfaceStatistics>& means,
                               const std::vector<std::uint32_t>& there) {
  for (std::size_t s = 0; s < means_.size(); ++s)
    for (std::size_t j = 0; j < there.size(); ++j)
      if (there[j] != kNone) means_[s].mean[j] = means[s].mean[there[j]];
}

void CandidateScene::leaveDark(const std::vector<std::uint32_t>& some) {
  for (const std::uint32_t j : some) isDark_[j] = 1;
  std::erase_if(left_, [&](std::uint32_t j) { return isDark_[j] != 0; });
}

Result<Done> CandidateScene::know(std::vector<float> columns) {
  const auto isLight = [](float value) { return value >= 0 && value < std::numeric_limits<float>::max(); };
  if (columns.size() != responses_->illuminance.size() ||
      !std::all_of(columns.begin(), columns.end(), isLight))
    return Error{"the light that was computed is not that of these luminaires in this room"};
  responses_->illuminance = std::move(columns);
  means_ = meanRows(room_->patches, means_.size(), *responses_, Quantity::kIlluminance);
  left_.clear();
  return Done{};
}

bool CandidateScene::advance(std::uint32_t count) {
  const std::size_t rows = responses_->rows;
  std::vector<std::uint32_t> some;
  while (!left_.empty() && some.size() < count) {
    some.push_back(left_.back());
    left_.pop_back();
  }
  if (!some.empty()) {
    std::vector<float> columns = columnsOf(some);
    if (paint_) columns = paint_->light(columns, static_cast<std::uint32_t>(some.size()));
    std::vector<std::uint32_t> there(candidates_.size(), kNone);
    for (std::uint32_t i = 0; i < some.size(); ++i) {
      std::copy(&columns[i * rows], &columns[i * rows] + rows, &responses_->illuminance[some[i] * rows]);
      there[some[i]] = i;
    }
    const Responses made{responses_->rows, static_cast<std::uint32_t>(some.size()), std::move(columns)};
    takeMeans(meanRows(room_->patches, means_.size(), made, Quantity::kIlluminance), there);
  }
  return left_.empty();
}

CandidateScene CandidateScene::repainted(std::shared_ptr<const Repaint> paint) const {
  assert(left_.empty() && !paint_);
  CandidateScene scene(*room_, types_, candidates_, light_, std::move(paint));
  scene.unpainted_ = responses_;
  std::vector<std::uint32_t> dark;
  for (std::uint32_t j = 0; j < isDark_.size(); ++j)
    if (isDark_[j]) dark.push_back(j);
  scene.leaveDark(dark);
  return scene;
}

std::vector<Luminaire> CandidateScene::luminaires() const {
  std::vector<Luminaire> luminaires;
  for (const Candidate& candidate : candidates_) luminaires.push_back(luminaireOf(candidate));
  return luminaires;
}

RoomView CandidateScene::view() const {
  return {*room_, paint_ ? paint_->reflectance() : room_->patches.reflectance,
          light_ ? light_->sightLines() : nullptr};
}

/// Of each candidate whose rows know it, and of which of these; the others are looked at.
std::vector<const CandidateScene::Seen*> CandidateScene::knownTo(
    const std::vector<Observer>& observers) const {
  std::vector<const Seen*> known(candidates_.size(), nullptr);
  for (const Seen& seen : seen_)
    if (std::equal(seen.rows.begin(), seen.rows.end(), observers.begin(), observers.end(), isOf))
      for (std::size_t j = 0; j < known.size(); ++j)
        if (seen.there[j] != kNone) known[j] = &seen;
  return known;
}

bool CandidateScene::look(const std::vector<Observer>& observers) {
  assert(left_.empty());
  const bool isOfThese = looked_.size() <= observers.size() &&
                         std::equal(looked_.begin(), looked_.end(), observers.begin(), isOf);
  if (!isOfThese) looked_.clear();
  const std::vector<const Seen*> known = knownTo(observers);
  std::vector<std::uint32_t> others;
  for (std::uint32_t j = 0; j < known.size(); ++j)
    if (!known[j] && !isDark_[j]) others.push_back(j);
  if (looked_.size() == observers.size() || others.empty()) return true;
  // Where lines of sight are not kept, all places share them now.
  const auto first = observers.begin() + static_cast<std::ptrdiff_t>(looked_.size());
  const auto last =
      light_
          ? std::find_if(first, observers.end(),
                         [&](const Observer& other) { return length(other.position - first->position) > 0; })
          : observers.end();
  std::vector<ObserverRows> rows = view().rows({first, last}, luminaires(), *responses_, others);
  std::move(rows.begin(), rows.end(), std::back_inserter(looked_));
  return looked_.size() == observers.size();
}

std::vector<ObserverRows> CandidateScene::seenBy(const std::vector<Observer>& observers) {
  while (!look(observers)) continue;
  const std::vector<const Seen*> known = knownTo(observers);
  std::vector<ObserverRows> all;
  for (std::size_t o = 0; o < observers.size(); ++o) {
    all.push_back({observers[o], {}, {}, {}, {}});
    for (const auto row : {&ObserverRows::glare, &ObserverRows::background, &ObserverRows::vertical,
                           &ObserverRows::cylindrical}) {
      std::size_t next = 0;
      for (std::size_t j = 0; j < known.size(); ++j)
        (all[o].*row)
            .push_back(known[j]     ? (known[j]->rows[o].*row)[known[j]->there[j]]
                       : isDark_[j] ? 0
                                    : (looked_[o].*row)[next++]);
    }
  }
  return all;
}

Result<std::vector<PlaneLight>> CandidateScene::planesOf(const std::vector<PlaneWish>& wishes) const {
  assert(left_.empty());
  if (wishes.empty()) return std::vector<PlaneLight>();
  for (const PlaneWish& wish : wishes)
    if (Result<Done> ok = checkPlane(*room_, wish.surface); !ok) return ok.error();
  std::vector<PlaneLight> planes = planeLight(*room_, view(), wishes, luminaires(), *responses_);
  if (Result<Done> lit = checkLit(*room_, planes); !lit) return lit.error();
  return planes;
}

DirectLight CandidateScene::directLight() const {
  constexpr std::size_t kTogether = 64;
  const std::uint32_t rows = room_->responses.rows;
  DirectLight direct{{rows, static_cast<std::uint32_t>(candidates_.size()), {}}, {}};
  std::vector<float>& columns = direct.responses.illuminance;
  if (types_.empty()) {
    const DirectQuadrature quadrature(*room_);
    columns.resize(std::size_t{rows} * candidates_.size());
    for (std::size_t i = 0; i < candidates_.size(); ++i)
      quadrature.lambertian(luminaireOf(candidates_[i]),
                            room_->lightOperator->visibility.column(candidates_[i].site), &columns[i * rows]);
  }
  std::vector<std::uint32_t> all(candidates_.size());
  std::iota(all.begin(), all.end(), 0u);
  for (std::size_t first = 0; first < candidates_.size() && !types_.empty(); first += kTogether) {
    const std::size_t count = std::min(kTogether, candidates_.size() - first);
    const std::vector<float> some = light_->direct(photometric({&all[first], count}));
    columns.insert(columns.end(), some.begin(), some.end());
  }
  direct.statistics = meanRows(room_->patches, firstZone(*room_), direct.responses, Quantity::kDirect);
  return direct;
}

Scene CandidateScene::finish(Quantity quantity) {
  assert(left_.empty());
  Scene scene;
  scene.identity = room_->identity;
  scene.patches = room_->patches;
  // Whoever asks for zones gives them anew.
  const std::uint32_t surfaces = firstZone(*room_);
  scene.surfaces.assign(room_->surfaces.begin(), room_->surfaces.begin() + surfaces);
  scene.errorBound = room_->errorBound;
  scene.errorBound.resize(std::min<std::size_t>(scene.errorBound.size(), surfaces));
  for (const Candidate& candidate : candidates_) {
    scene.sites.push_back(room_->sites[candidate.site]);
    if (!types_.empty())
      scene.hangings.push_back({candidate.site, candidate.type, candidate.way, types_[candidate.type].power,
                                bodyOf(luminaireOf(candidate), room_->sites[candidate.site])});
  }
  if (paint_) {
    std::copy(paint_->reflectance().begin(), paint_->reflectance().end(), scene.patches.reflectance.begin());
    for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s)
      if (!scene.surfaces[s].measuring) scene.surfaces[s].reflectance = paint_->meanReflectance(s);
  }
  scene.responses = responses_.use_count() > 1 ? *responses_ : std::move(*responses_);
  scene.illuminance = std::move(means_);
  if (quantity == Quantity::kExitance)
    scene.exitance = meanRows(scene.patches, surfaces, scene.responses, quantity);
  return scene;
}

}  // namespace fiatlux
