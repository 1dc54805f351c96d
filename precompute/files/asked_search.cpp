// Intentions of the room to intentions of its candidates; see asked_search.h.
#include "precompute/files/asked_search.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numeric>

#include "core/base/short_number.h"
#include "core/photometry/photometric_values.h"
#include "core/scene/zones.h"
#include "core/search/plane_values.h"
#include "core/search/validate_intentions.h"
#include "core/transport/direct_part.h"
#include "core/transport/plane_light.h"
#include "core/transport/room_view.h"
#include "precompute/files/layout_json.h"
#include "precompute/files/solve_report.h"
#include "precompute/files/terminal.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kTogether = 64;  // candidates: all at once would be four times their light in memory

/// To a millionth, without the noise of sums.
double rounded(double value) { return std::round(1e6 * value) / 1e6; }

}  // namespace

AskedSearch::AskedSearch(const Scene& room, IntentionsFile asked)
    : room_(&room),
      intentions_(std::move(asked.intentions)),
      types_(std::move(asked.types)),
      paint_(std::move(asked.paint)) {
  for (const AskedType& type : types_)
    flux_.push_back(type.flux > 0 ? type.flux : rounded(integratedFlux(*type.photometry)));
}

Result<AskedSearch> AskedSearch::make(Scene& room, IntentionsFile asked) {
  AskedSearch search(room, std::move(asked));
  if (auto ok = takeZones(room, search.intentions_.zones); !ok) return ok.error();
  if (!search.hasCandidates()) {
    if (auto ok = observe(room, search.intentions_.observers); !ok) return ok.error();
    if (asksForDirect(search.intentions_))
      if (auto ok = addDirect(room); !ok) return ok.error();
    if (auto ok = addPlanes(room, planesAskedOf(search.intentions_)); !ok) return ok.error();
    return search;
  }
  if (auto ok = search.checkPower(); !ok) return ok.error();
  if (auto ok = search.checkGlare(); !ok) return ok.error();
  if (auto ok = search.makeCandidates(); !ok) return ok.error();
  if (search.isOfTypes())
    if (auto ok = search.takeSites(search.intentions_.luminaires); !ok) return ok.error();
  if (auto ok = checkIntentions(search.candidateScene_, search.intentions_); !ok) return ok.error();
  return search;
}

/// Watts are known of every type where anything is asked of the power.
Result<Done> AskedSearch::checkPower() const {
  const auto isOfPower = [](const auto& intention) { return intention.statistic == Statistic::kPower; };
  const std::vector<Goal>& goals = intentions_.goals;
  const std::vector<Constraint>& constraints = intentions_.constraints;
  if (std::none_of(goals.begin(), goals.end(), isOfPower) &&
      std::none_of(constraints.begin(), constraints.end(), isOfPower))
    return Done{};
  for (std::size_t t = 0; t < types_.size(); ++t)
    if (types_[t].watts == 0)
      return Error{"luminaires.types[" + std::to_string(t) + "]: power is asked for, but " +
                   printable(types_[t].name, 80) + " states no watts; give \"watts\""};
  return Done{};
}

Result<Done> AskedSearch::checkGlare() const {
  if (intentions_.observers.empty()) return Done{};
  for (std::size_t t = 0; t < types_.size(); ++t)
    if (!hasLuminousArea(photometricLuminaire(exactType(types_[t].photometry), flux_[t], 0, 0)))
      return Error{"luminaires.types[" + std::to_string(t) + "]: " + printable(types_[t].name, 80) +
                   " has no luminous area, so nobody can say how it glares; take another file, or leave "
                   "\"observers\" out"};
  return Done{};
}

/// nullptr where nothing is painted.
Result<std::shared_ptr<const Repaint>> AskedSearch::repaint(const PhotometricLight* light) const {
  if (paint_.empty()) return std::shared_ptr<const Repaint>();
  const Result<std::vector<SurfacePaint>> onLeaves = paintOnLeaves(paint_, room_->surfaces);
  if (!onLeaves) return onLeaves.error();
  if (auto ok = checkPaint(*room_, *onLeaves); !ok) return ok.error();
  return std::make_shared<const Repaint>(*room_, light->exchange(), paintedReflectance(*room_, *onLeaves));
}

/// `light`: nullptr in a room without light operator, which ends in an error.
Result<CandidateScene> AskedSearch::beginCandidates(std::shared_ptr<const PhotometricLight> light) {
  Result<std::shared_ptr<const Repaint>> paint = repaint(light.get());
  if (!paint) return paint.error();
  if (!isOfTypes()) {
    std::vector<std::uint32_t> sites(room_->sites.size());
    std::iota(sites.begin(), sites.end(), 0u);
    return CandidateScene::ofSquares(*room_, sites, std::move(*paint));
  }
  std::vector<CandidateType> types;
  std::vector<TypeWays> ways;
  for (std::size_t t = 0; t < types_.size(); ++t) {
    types.push_back({sampledType(types_[t].photometry), flux_[t], types_[t].watts});
    ways.push_back(types_[t].ways);
  }
  if (light) candidates_ = candidatesOf(*room_, types, ways);
  return CandidateScene::begin(*room_, std::move(types), candidates_, std::move(light), std::move(*paint));
}

Result<Done> AskedSearch::makeCandidates() {
  const auto light = room_->lightOperator ? std::make_shared<const PhotometricLight>(*room_) : nullptr;
  Result<CandidateScene> making = beginCandidates(light);
  if (!making) return making.error();
  while (!making->advance(kTogether)) continue;
  std::vector<ObserverRows> observers = making->seenBy(intentions_.observers);
  Result<std::vector<PlaneLight>> planes = making->planesOf(planesAskedOf(intentions_));
  if (!planes) return planes.error();
  std::optional<DirectLight> direct;
  if (asksForDirect(intentions_)) direct = making->directLight();
  candidateScene_ = making->finish(intentions_.quantity);
  candidateScene_.observers = std::move(observers);
  candidateScene_.planes = std::move(*planes);
  candidateScene_.direct = std::move(direct);
  return takeZones(candidateScene_, intentions_.zones);
}

/// Pinned and excluded sites become candidates: a pinned luminaire hangs in the first way that fits there, of
/// the type that it must be of and no more of a type than there may be.
Result<Done> AskedSearch::takeSites(const LuminaireRules& asked) {
  LuminaireRules rules = asked;
  rules.flux = {1};
  rules.minDistance = std::max(asked.minDistance, kCandidatesApart);
  rules.excluded.clear();
  for (std::uint32_t c = 0; c < candidates_.size(); ++c)
    if (std::find(asked.excluded.begin(), asked.excluded.end(), candidates_[c].site) != asked.excluded.end())
      rules.excluded.push_back(c);
  std::vector<std::uint32_t> left(types_.size());
  for (std::size_t t = 0; t < left.size(); ++t) left[t] = asked.types[t].most;
  for (std::size_t i = 0; i < asked.pinned.size(); ++i) {
    const std::uint32_t type = i < asked.ofType.size() ? asked.ofType[i] : kNone;
    const auto first = std::find_if(candidates_.begin(), candidates_.end(), [&](const Candidate& c) {
      return c.site == asked.pinned[i] && (type == kNone ? left[c.type] > 0 : c.type == type);
    });
    if (first == candidates_.end())
      return Error{"luminaires.pinned: no luminaire that may be used fits on site " +
                   std::to_string(asked.pinned[i])};
    rules.pinned[i] = static_cast<std::uint32_t>(first - candidates_.begin());
    --left[first->type];
  }
  intentions_.luminaires = std::move(rules);
  return Done{};
}

LightResults AskedSearch::lightResults(const Layout& layout) const {
  const Quantity light =
      intentions_.quantity == Quantity::kDirect ? Quantity::kDirect : Quantity::kIlluminance;
  if (!hasCandidates() && light != Quantity::kDirect) return fiatlux::lightResults(*room_, layout);
  return fiatlux::lightResults(scene(), illuminanceOf(scene(), layout, light));
}

nlohmann::ordered_json AskedSearch::layoutJson(const Layout& layout) const {
  nlohmann::ordered_json json = isOfTypes() ? typesJson(layout) : fiatlux::layoutJson(layout, *room_);
  for (const auto& [surface, reflectance] : paint_)
    json["paint"].push_back({{"surface", surface}, {"reflectance", reflectance}});
  return json;
}

nlohmann::ordered_json AskedSearch::typesJson(const Layout& layout) const {
  nlohmann::ordered_json luminaires = nlohmann::ordered_json::array();
  for (const std::uint32_t c : layout.sites) {
    const Candidate& hung = candidates_[c];
    nlohmann::ordered_json json =
        luminaireJson(hung.site, room_->sites[hung.site].position, flux_[hung.type]);
    json["photometry"] = types_[hung.type].name;
    if (hung.turn != 0) json["turn"] = hung.turn;
    if (hung.aim) json["aim"] = {rounded(hung.aim->x), rounded(hung.aim->y), rounded(hung.aim->z)};
    luminaires.push_back(std::move(json));
  }
  return {{"dimming", layout.dimming}, {"luminaires", std::move(luminaires)}};
}

Layout AskedSearch::onSites(const Layout& layout) const {
  if (!isOfTypes()) return layout;
  Layout hung{{}, {}, layout.dimming};
  for (const std::uint32_t c : layout.sites) {
    hung.sites.push_back(candidates_[c].site);
    hung.flux.push_back(flux_[candidates_[c].type]);
  }
  return hung;
}

std::string AskedSearch::luminaireLine(const Layout& layout, std::size_t i) const {
  const std::uint32_t c = layout.sites[i];
  const std::uint32_t site = isOfTypes() ? candidates_[c].site : c;
  const Vec3& at = room_->sites[site].position;
  char place[120];
  std::snprintf(place, sizeof place, "L%zu on site %u at (%.3f, %.3f, %.3f) m, ", i + 1, site, at.x, at.y,
                at.z);
  const double flux = isOfTypes() ? flux_[candidates_[c].type] : layout.flux[i];
  std::string line = place + shortNumber(flux, kReportDigits) + " lm";
  if (!isOfTypes()) return line;
  const Candidate& hung = candidates_[c];
  line += ", " + printable(types_[hung.type].name, 80);
  if (hung.turn != 0) line += ", turned by " + shortNumber(hung.turn, kReportDigits) + " degrees";
  if (!hung.aim) return line;
  std::snprintf(place, sizeof place, ", aimed at (%.3f, %.3f, %.3f) m", hung.aim->x, hung.aim->y,
                hung.aim->z);
  return line + place;
}

Result<Done> AskedSearch::nameFilesFrom(const std::string& to, const std::string& from) {
  for (AskedType& type : types_) {
    Result<std::string> name = nameSeenFrom(to, from, type.name);
    if (!name) return Error{to + ": " + name.error().message};
    type.name = std::move(*name);
  }
  return Done{};
}

}  // namespace fiatlux
