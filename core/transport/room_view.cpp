#include "core/transport/room_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/photometry/unified_glare.h"

namespace fiatlux {
namespace {

constexpr double kBesideSight = 0.02;  // of a sight's length: as near as what closes a slit between tiles
// Parts of a luminaire's edge that are looked for, and of one that is seen in part.
constexpr std::uint32_t kSeenParts = 4;
constexpr std::uint32_t kFineParts = 16;
constexpr double kLeastLuminousArea = 1e-9;  // m2

/// Evenly over the sphere (a spiral whose turns are the golden angle apart).
Vec3 sightDirection(std::uint32_t i, std::uint32_t count) {
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  const double y = 1 - (2 * i + 1.0) / count, r = std::sqrt(1 - y * y);
  return {r * std::cos(golden * i), y, r * std::sin(golden * i)};
}

/// What is seen along a direction, or right beside it: tiles of patches that are no whole cells leave slits,
/// through which a sight would go astray. kNone of nothing, and of a back: where the file has no patch for
/// it, what it reflects is not known.
std::uint32_t seenAlong(const TileTree& tree, const Patches& patches, const Vec3& from,
                        const Vec3& direction) {
  constexpr Vec3 kSides[] = {{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (const Vec3& side : kSides) {
    const Vec3 along = direction + kBesideSight * side;
    const std::uint32_t patch = tree.firstMet(from, along, std::numeric_limits<double>::infinity());
    if (patch != kNone && dot(along, patches.normal[patch]) < 0) return patch;
  }
  return kNone;
}

/// `direction` in the axes of a luminaire.
Vec3 seenFrom(const Luminaire& luminaire, const Vec3& direction) {
  return {dot(direction, luminaire.axis), dot(direction, cross(luminaire.normal, luminaire.axis)),
          dot(direction, luminaire.normal)};
}

/// cd along a unit direction in its axes.
double candelaOf(const Luminaire& luminaire, const Vec3& direction) {
  if (luminaire.distribution == Luminaire::Distribution::kPhotometric) return luminaire.intensity(direction);
  return luminaire.flux / std::numbers::pi * std::max(0.0, direction.z);
}

double luminousAreaOf(const Luminaire& luminaire, const Vec3& direction) {
  if (luminaire.luminousArea) return luminaire.luminousArea(direction);
  return luminaire.width * luminaire.height * std::abs(direction.z);
}

/// How much of a unit direction is level.
double levelOf(const Vec3& direction) {
  return std::sqrt(direction.x * direction.x + direction.z * direction.z);
}

/// 1 / p^2 of what lies `way` from an eye.
double guthWeight(const Vec3& way, const Vec3& sight) {
  const Vec3 up = std::abs(sight.y) < 0.999 ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
  const Vec3 beside = normalized(cross(sight, up)), above = cross(beside, sight);
  return positionWeight(std::abs(dot(way, above)), std::abs(dot(way, beside)), dot(way, sight));
}

}  // namespace

std::vector<SightLines::Sight> SightLines::met(const Vec3& position, std::uint32_t count) const {
  std::vector<Sight> sights;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vec3 direction = sightDirection(i, count);
    const std::uint32_t patch = seenAlong(tree_, room_.patches, position, direction);
    if (patch != kNone) sights.push_back({direction, patch});
  }
  std::stable_sort(sights.begin(), sights.end(),
                   [](const Sight& a, const Sight& b) { return a.patch < b.patch; });
  return sights;
}

std::shared_ptr<const std::vector<SightLines::Sight>> SightLines::from(const Vec3& position,
                                                                       std::uint32_t count) const {
  constexpr std::size_t kKept = 64;
  for (const Known& known : known_)
    if (known.count == count && length(known.position - position) == 0) return known.sights;
  if (known_.size() == kKept) known_.erase(known_.begin());
  known_.push_back({position, count, std::make_shared<const std::vector<Sight>>(met(position, count))});
  return known_.back().sights;
}

bool hasLuminousArea(const Luminaire& luminaire) {
  if (!luminaire.luminousArea) return luminaire.width > 0 && luminaire.height > 0;
  // note: a disc or a side may be seen from some directions only.
  for (const Vec3& direction : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
    if (luminaire.luminousArea(direction) > kLeastLuminousArea) return true;
  return false;
}

Result<Done> checkLuminousAreas(const std::vector<Luminaire>& luminaires) {
  for (std::size_t i = 0; i < luminaires.size(); ++i)
    if (!hasLuminousArea(luminaires[i]))
      return Error{"luminaires[" + std::to_string(i) +
                   "]: it has no luminous area, so nobody can say how it glares; give it a \"size\""};
  return Done{};
}

double glareOf(const Luminaire& luminaire, const Observer& observer) {
  const Vec3 way = luminaire.position - observer.position;
  const double weight = guthWeight(way, observer.direction), squared = dot(way, way);
  if (!(weight > 0) || !(squared > 0)) return 0;
  const Vec3 toEye = seenFrom(luminaire, (-1 / std::sqrt(squared)) * way);
  const double area = luminousAreaOf(luminaire, toEye);
  if (!(area > kLeastLuminousArea)) return 0;
  const double candela = candelaOf(luminaire, toEye);
  return 0.25 * candela * candela / (area * squared) * weight;
}

/// Calls `add` with the way from an eye to the middle of each of `split` x `split` parts of a luminaire that
/// it sees.
template <class Add>
void RoomView::visitParts(const Vec3& eye, const Luminaire& luminaire, std::uint32_t split,
                          const Add& add) const {
  const Vec3 across = cross(luminaire.normal, luminaire.axis);
  for (std::uint32_t i = 0; i < split * split; ++i) {
    const double u = (i % split + 0.5) / split - 0.5, v = (i / split + 0.5) / split - 0.5;
    const Vec3 part = luminaire.position + (u * luminaire.width) * luminaire.axis +
                      (v * luminaire.height) * across + kLuminaireClearance * luminaire.normal;
    if (!lines_->tree().isBlocked(eye, part)) add(part - eye);
  }
}

double RoomView::visibleShare(const Vec3& eye, const Luminaire& luminaire) const {
  const auto shareOf = [&](std::uint32_t split) {
    std::uint32_t seen = 0;
    visitParts(eye, luminaire, split, [&](const Vec3&) { ++seen; });
    return static_cast<double>(seen) / (split * split);
  };
  const double share = shareOf(kSeenParts);
  return share > 0 && share < 1 ? shareOf(kFineParts) : share;
}

UprightRows RoomView::upright(const Vec3& point, const std::vector<Vec3>& directions,
                              const std::vector<Luminaire>& luminaires, const Responses& responses) const {
  const std::size_t sites = responses.sites, count = directions.size();
  UprightRows rows;
  rows.cylindrical.resize(sites);
  rows.vertical.assign(count, std::vector<float>(sites));
  const auto sights = lines_->from(point, SightLines::kPointSights);
  // What each patch adds per lx on it: E = integral of L cos, L = rho E_patch / pi, one sight after the
  // other.
  std::vector<std::uint32_t> patches;
  std::vector<double> weights;  // of the cylinder and the vertical planes, patch by patch
  for (const Sight& sight : *sights) {
    if (patches.empty() || patches.back() != sight.patch) {
      patches.push_back(sight.patch);
      weights.resize(patches.size() * (1 + count));
    }
    double* of = &weights[(patches.size() - 1) * (1 + count)];
    const double share = 4.0 / SightLines::kPointSights * reflectance_[sight.patch];
    of[0] += share / std::numbers::pi * std::hypot(sight.direction.x, sight.direction.z);
    for (std::size_t d = 0; d < count; ++d)
      of[1 + d] += share * std::max(0.0, dot(sight.direction, directions[d]));
  }
  std::vector<double> sums(1 + count);
  for (std::uint32_t j = 0; j < sites; ++j) {
    std::fill(sums.begin(), sums.end(), 0.0);
    const float* light = responses.column(j);
    for (std::size_t k = 0; k < patches.size(); ++k)
      for (std::size_t d = 0; d <= count; ++d) sums[d] += weights[k * (1 + count) + d] * light[patches[k]];
    const auto addPart = [&](const Vec3& way) {
      const double squared = dot(way, way), distance = std::sqrt(squared);
      if (!(distance > 0)) return;
      const double candela = candelaOf(luminaires[j], seenFrom(luminaires[j], (-1 / distance) * way));
      const double strength = candela / (kSeenParts * kSeenParts) / (squared * distance);
      sums[0] += strength * std::hypot(way.x, way.z) / std::numbers::pi;
      for (std::size_t d = 0; d < count; ++d)
        sums[1 + d] += strength * std::max(0.0, dot(way, directions[d]));
    };
    if (j < luminaires.size()) visitParts(point, luminaires[j], kSeenParts, addPart);
    rows.cylindrical[j] = static_cast<float>(sums[0]);
    for (std::size_t d = 0; d < count; ++d) rows.vertical[d][j] = static_cast<float>(sums[1 + d]);
  }
  return rows;
}

RoomView::Place RoomView::placeOf(const Vec3& position, std::size_t luminaires) const {
  return {position, lines_->from(position), std::vector<double>(luminaires, -1)};
}

/// E = integral of L cos over the half space before the eye, L = rho E_patch / pi; L_b = E / pi. E_z =
/// integral of L sin(angle from the vertical) / pi over all directions.
std::vector<RoomView::Part> RoomView::reflectedOf(const Place& place, const Vec3& direction) const {
  std::vector<Part> parts;
  for (const Sight& sight : *place.sights) {
    if (parts.empty() || parts.back().patch != sight.patch) parts.push_back({sight.patch, 0, 0});
    const double share = 4.0 / SightLines::kEyeSights * reflectance_[sight.patch] / std::numbers::pi;
    parts.back().background += share * std::max(0.0, dot(sight.direction, direction));
    parts.back().cylindrical += share * levelOf(sight.direction);
  }
  return parts;
}

/// What patches add to the readings of observers at one place, who meet the same of them: a light is looked
/// up once for all, and their sums lie side by side.
class RoomView::Reflected {
 public:
  explicit Reflected(const std::vector<std::vector<Part>>& ofObservers)
      : observers_(ofObservers.size()), blocks_((observers_ + kBlock - 1) / kBlock) {
    for (std::size_t k = 0; k < ofObservers[0].size(); ++k) {
      patches_.push_back(ofObservers[0][k].patch);
      cylindrical_.push_back(ofObservers[0][k].cylindrical);
    }
    background_.resize(blocks_ * patches_.size() * kBlock);
    for (std::size_t o = 0; o < observers_; ++o)
      for (std::size_t k = 0; k < patches_.size(); ++k)
        background_[(o / kBlock * patches_.size() + k) * kBlock + o % kBlock] = ofObservers[o][k].background;
  }

  /// To a reading of each observer that has the direct light.
  void addTo(const float* illuminance, std::vector<ObserverReading>& readings) const {
    double cylindrical = 0;
    for (std::size_t k = 0; k < patches_.size(); ++k)
      cylindrical += cylindrical_[k] * illuminance[patches_[k]];
    for (std::size_t block = 0; block < blocks_; ++block) {
      const double* weights = background_.data() + block * patches_.size() * kBlock;
      double sums[kBlock] = {};
      for (std::size_t k = 0; k < patches_.size(); ++k)
        for (std::size_t i = 0; i < kBlock; ++i)
          sums[i] += weights[k * kBlock + i] * illuminance[patches_[k]];
      for (std::size_t o = block * kBlock; o < std::min(observers_, (block + 1) * kBlock); ++o) {
        ObserverReading& reading = readings[o];
        reading.background = sums[o % kBlock];
        reading.vertical += std::numbers::pi * reading.background;
        reading.cylindrical += cylindrical;
      }
    }
  }

 private:
  static constexpr std::size_t kBlock = 4;  // observers: so many look from each place of a grid
  std::size_t observers_, blocks_;
  std::vector<std::uint32_t> patches_;
  std::vector<double> background_, cylindrical_;  // per lx; the former by blocks, rows of kBlock
};

/// Of luminaire j, by what of it is seen.
ObserverReading RoomView::directAt(Place& place, const Observer& observer,
                                   const std::vector<Luminaire>& luminaires, std::size_t j) const {
  const Luminaire& luminaire = luminaires[j];
  const Vec3 way = luminaire.position - observer.position;
  const double squared = dot(way, way), distance = std::sqrt(squared);
  if (!(distance > 0)) return {};
  const double candela = candelaOf(luminaire, seenFrom(luminaire, (-1 / distance) * way));
  if (!(candela > 0)) return {};
  double& visible = place.visible[j];
  if (visible < 0) visible = visibleShare(place.position, luminaire);
  const double light = visible * candela / (squared * distance);
  return {visible * glareOf(luminaire, observer), 0, light * std::max(0.0, dot(way, observer.direction)),
          light * std::hypot(way.x, way.z) / std::numbers::pi};
}

std::vector<ObserverReading> RoomView::readings(const std::vector<Observer>& observers,
                                                const std::vector<Luminaire>& luminaires, double dimming,
                                                const std::vector<float>& illuminance) const {
  std::vector<ObserverReading> readings;
  Place place;  // shared by those who look from there one after the other
  for (const Observer& observer : observers) {
    if (readings.empty() || length(observer.position - place.position) > 0)
      place = placeOf(observer.position, luminaires.size());
    std::vector<ObserverReading> reading(1);
    for (std::size_t j = 0; j < luminaires.size(); ++j) {
      const ObserverReading direct = directAt(place, observer, luminaires, j);
      reading[0].glare += dimming * dimming * direct.glare;
      reading[0].vertical += dimming * direct.vertical;
      reading[0].cylindrical += dimming * direct.cylindrical;
    }
    Reflected({reflectedOf(place, observer.direction)}).addTo(illuminance.data(), reading);
    readings.push_back(reading[0]);
  }
  return readings;
}

std::vector<ObserverRows> RoomView::rows(const std::vector<Observer>& observers,
                                         const std::vector<Luminaire>& luminaires,
                                         const Responses& responses) const {
  std::vector<std::uint32_t> all(luminaires.size());
  std::iota(all.begin(), all.end(), 0u);
  return rows(observers, luminaires, responses, all);
}

std::vector<ObserverRows> RoomView::rows(const std::vector<Observer>& observers,
                                         const std::vector<Luminaire>& luminaires, const Responses& responses,
                                         const std::vector<std::uint32_t>& some) const {
  std::vector<ObserverRows> all;
  for (const Observer& observer : observers) all.push_back({observer, {}, {}, {}, {}});
  std::vector<ObserverReading> readings;
  for (std::size_t first = 0, last = 0; first < observers.size(); first = last) {
    const auto isElsewhere = [&](const Observer& other) {
      return length(other.position - observers[first].position) > 0;
    };
    const auto end =
        std::find_if(observers.begin() + static_cast<std::ptrdiff_t>(first), observers.end(), isElsewhere);
    last = static_cast<std::size_t>(end - observers.begin());
    Place place = placeOf(observers[first].position, luminaires.size());
    std::vector<std::vector<Part>> parts;
    for (std::size_t o = first; o < last; ++o) parts.push_back(reflectedOf(place, observers[o].direction));
    const Reflected reflected(parts);
    for (const std::uint32_t j : some) {
      readings.clear();
      for (std::size_t o = first; o < last; ++o)
        readings.push_back(directAt(place, observers[o], luminaires, j));
      reflected.addTo(responses.column(j), readings);
      for (std::size_t o = first; o < last; ++o) {
        all[o].glare.push_back(readings[o - first].glare);
        all[o].background.push_back(readings[o - first].background);
        all[o].vertical.push_back(readings[o - first].vertical);
        all[o].cylindrical.push_back(readings[o - first].cylindrical);
      }
    }
  }
  return all;
}

Result<Done> observe(Scene& scene, const std::vector<Observer>& observers) {
  const auto isThere = [](const ObserverRows& rows, const Observer& observer) {
    return rows.observer == observer;
  };
  if (std::equal(scene.observers.begin(), scene.observers.end(), observers.begin(), observers.end(), isThere))
    return Done{};
  if (observers.empty()) {
    scene.observers.clear();
    return Done{};
  }
  if (!scene.lightOperator)
    return Error{
        "this room's file does not tell what stands in the way of sight, so nobody can say what glares; make "
        "it again with fiatlux precompute, without --no-exchange"};
  std::vector<Luminaire> luminaires;
  for (const Site& site : scene.sites) luminaires.push_back(luminaireOf(site));
  scene.observers = RoomView(scene).rows(observers, luminaires, scene.responses);
  return Done{};
}

}  // namespace fiatlux
