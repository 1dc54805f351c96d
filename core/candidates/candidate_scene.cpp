#include "core/candidates/candidate_scene.h"

#include <cassert>
#include <string>
#include <utility>

#include "core/candidates/candidate_list.h"
#include "core/transport/room_view.h"

namespace fiatlux {
namespace {

Result<Done> check(const Scene& room, const std::vector<CandidateType>& types,
                   const std::vector<Candidate>& candidates) {
  if (!room.lightOperator)
    return Error{
        "this room's file knows Lambertian squares only; make it again with fiatlux precompute for "
        "luminaires of photometric files"};
  if (candidates.empty()) return Error{"none of the luminaire types fits anywhere in this room"};
  if (candidates.size() > kMaxCandidates)
    return Error{"these types, turns and aims make " + std::to_string(candidates.size()) +
                 " candidates, more than " + std::to_string(kMaxCandidates) + "; allow fewer of them"};
  for (const Candidate& candidate : candidates)
    if (candidate.site >= room.sites.size() || candidate.type >= types.size())
      return Error{"a luminaire is asked for on site " + std::to_string(candidate.site) + " as type " +
                   std::to_string(candidate.type) + ", which are not both there"};
  return Done{};
}

/// Mean rows alone, over the patches that count.
void addMeans(Quantity quantity, Scene& scene) {
  const Patches& patches = scene.patches;
  const std::size_t m = scene.responses.sites, surfaces = scene.surfaces.size();
  const bool exitance = quantity == Quantity::kExitance;
  std::vector<SurfaceStatistics>& leaves = exitance ? scene.exitance : scene.illuminance;
  leaves.assign(surfaces, {std::vector<double>(m), {}});
  std::vector<double> area(surfaces);
  for (std::uint32_t p = 0; p < patches.rows(); ++p)
    if (patches.counts(p)) area[patches.surface[p]] += patches.area[p];
  for (std::uint32_t j = 0; j < m; ++j) {
    const float* column = scene.responses.column(j);
    for (std::uint32_t p = 0; p < patches.rows(); ++p) {
      if (!patches.counts(p)) continue;
      const double factor = exitance ? patches.reflectance[p] : 1.0;
      leaves[patches.surface[p]].mean[j] += factor * patches.area[p] / area[patches.surface[p]] * column[p];
    }
  }
}

}  // namespace

CandidateScene::CandidateScene(const Scene& room, std::vector<CandidateType> types,
                               std::vector<Candidate> candidates,
                               std::shared_ptr<const PhotometricLight> light)
    : room_(&room), light_(std::move(light)), types_(std::move(types)), candidates_(std::move(candidates)) {
  responses_.rows = room.responses.rows;
  responses_.sites = static_cast<std::uint32_t>(candidates_.size());
  responses_.illuminance.reserve(std::size_t{responses_.rows} * responses_.sites);
}

Result<CandidateScene> CandidateScene::begin(const Scene& room, std::vector<CandidateType> types,
                                             std::vector<Candidate> candidates,
                                             std::shared_ptr<const PhotometricLight> light) {
  const Result<Done> checked = check(room, types, candidates);
  if (!checked) return checked.error();
  if (!light) light = std::make_shared<const PhotometricLight>(room);
  return CandidateScene(room, std::move(types), std::move(candidates), std::move(light));
}

Luminaire CandidateScene::luminaireOf(const Candidate& candidate) const {
  const CandidateType& type = types_[candidate.type];
  return mountedLuminaire(type.photometric, type.flux, room_->sites[candidate.site], mountingOf(candidate));
}

bool CandidateScene::advance(std::uint32_t count) {
  std::vector<PhotometricCandidate> some;
  for (; some.size() < count && done_ < candidates_.size(); ++done_) {
    const Candidate& candidate = candidates_[done_];
    const PhotometricType& photometric = types_[candidate.type].photometric;
    const double flux = types_[candidate.type].flux;
    const double scale = photometric.flux > 0 && flux > 0 ? flux / photometric.flux : 1;
    some.push_back({candidate.site, luminaireOf(candidate), photometric.map, static_cast<float>(scale)});
  }
  if (!some.empty()) {
    const std::vector<float> columns = light_->total(some, light_->direct(some));
    responses_.illuminance.insert(responses_.illuminance.end(), columns.begin(), columns.end());
  }
  return done_ == candidates_.size();
}

std::vector<ObserverRows> CandidateScene::seenBy(const std::vector<Observer>& observers) const {
  if (observers.empty()) return {};
  std::vector<Luminaire> luminaires;
  for (const Candidate& candidate : candidates_) luminaires.push_back(luminaireOf(candidate));
  return RoomView(*room_).rows(observers, luminaires, responses_);
}

Scene CandidateScene::finish(Quantity quantity) {
  assert(done_ == candidates_.size());
  Scene scene;
  scene.identity = room_->identity;
  scene.patches = room_->patches;
  scene.surfaces = room_->surfaces;
  scene.errorBound = room_->errorBound;
  for (const Candidate& candidate : candidates_) {
    scene.sites.push_back(room_->sites[candidate.site]);
    scene.hangings.push_back({candidate.site, candidate.type, candidate.way, types_[candidate.type].power});
  }
  scene.responses = std::move(responses_);
  addMeans(quantity, scene);
  return scene;
}

}  // namespace fiatlux
