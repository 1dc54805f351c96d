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

/// Calls `add` with the way from an eye to the middle of each of `split` x `split` parts of a luminaire that
/// it sees.
template <class Add>
void visitParts(const TileTree& tree, const Vec3& eye, const Luminaire& luminaire, std::uint32_t split,
                const Add& add) {
  const Vec3 across = cross(luminaire.normal, luminaire.axis);
  for (std::uint32_t i = 0; i < split * split; ++i) {
    const double u = (i % split + 0.5) / split - 0.5, v = (i / split + 0.5) / split - 0.5;
    const Vec3 part = luminaire.position + (u * luminaire.width) * luminaire.axis +
                      (v * luminaire.height) * across + kLuminaireClearance * luminaire.normal;
    if (!tree.isBlocked(eye, part)) add(part - eye);
  }
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

/// E = integral of L cos over the half space before the eye, L = rho E_patch / pi; L_b = E / pi. E_z =
/// integral of L sin(angle from the vertical) / pi over all directions.
SightLines::Outlook SightLines::outlookAt(const Vec3& position, const std::vector<Vec3>& directions,
                                          std::uint32_t count) const {
  Outlook outlook{position, directions, {}, {}, {}};
  const double share = 4.0 / count / std::numbers::pi;
  for (const Sight& sight : *from(position, count)) {
    if (outlook.patches.empty() || outlook.patches.back() != sight.patch) {
      outlook.patches.push_back(sight.patch);
      outlook.cylindrical.push_back(0);
      outlook.background.resize(outlook.background.size() + directions.size());
    }
    outlook.cylindrical.back() += share * levelOf(sight.direction);
    double* background = &outlook.background[outlook.background.size() - directions.size()];
    for (const Vec3& direction : directions)
      *background++ += share * std::max(0.0, dot(sight.direction, direction));
  }
  return outlook;
}

std::shared_ptr<const SightLines::Outlook> SightLines::outlook(const Vec3& position,
                                                               const std::vector<Vec3>& directions,
                                                               std::uint32_t count, Outlooks& kept,
                                                               std::size_t most) const {
  const auto isSame = [](const Vec3& a, const Vec3& b) { return length(a - b) == 0; };
  const auto isThis = [&](const std::shared_ptr<const Outlook>& known) {
    return isSame(known->position, position) && std::equal(known->directions.begin(), known->directions.end(),
                                                           directions.begin(), directions.end(), isSame);
  };
  const auto known = std::find_if(kept.begin(), kept.end(), isThis);
  if (known != kept.end()) return *known;
  if (kept.size() == most) kept.erase(kept.begin());
  return kept.emplace_back(std::make_shared<const Outlook>(outlookAt(position, directions, count)));
}

double SightLines::visibleShare(const Vec3& eye, const Luminaire& luminaire) const {
  constexpr std::size_t kKeptShares = 1 << 16;
  const Vec3 &p = luminaire.position, &n = luminaire.normal, &a = luminaire.axis;
  const Area area{eye.x, eye.y,           eye.z,           p.x, p.y, p.z, n.x, n.y, n.z, a.x, a.y,
                  a.z,   luminaire.width, luminaire.height};
  if (const auto known = shares_.find(area); known != shares_.end()) return known->second;
  const auto shareOf = [&](std::uint32_t split) {
    std::uint32_t seen = 0;
    visitParts(tree_, eye, luminaire, split, [&](const Vec3&) { ++seen; });
    return static_cast<double>(seen) / (split * split);
  };
  const double coarse = shareOf(kSeenParts), share = coarse > 0 && coarse < 1 ? shareOf(kFineParts) : coarse;
  if (shares_.size() == kKeptShares) shares_.clear();
  return shares_[area] = share;
}

UprightRows RoomView::upright(const Vec3& point, const std::vector<Vec3>& directions,
                              const std::vector<Luminaire>& luminaires, const Responses& responses) const {
  const std::size_t sites = responses.sites, count = directions.size();
  UprightRows rows;
  rows.cylindrical.resize(sites);
  rows.vertical.assign(count, std::vector<float>(sites));
  // What each patch adds per lx on it.
  const auto outlook = lines_->outlookOfPoint(point, directions);
  const std::vector<std::uint32_t>& patches = outlook->patches;
  std::vector<double> weights;  // of the cylinder and the vertical planes, patch by patch
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const double rho = reflectance_[patches[k]];
    weights.push_back(rho * outlook->cylindrical[k]);
    for (std::size_t d = 0; d < count; ++d)
      weights.push_back(std::numbers::pi * rho * outlook->background[k * count + d]);
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
    if (j < luminaires.size()) visitParts(lines_->tree(), point, luminaires[j], kSeenParts, addPart);
    rows.cylindrical[j] = static_cast<float>(sums[0]);
    for (std::size_t d = 0; d < count; ++d) rows.vertical[d][j] = static_cast<float>(sums[1 + d]);
  }
  return rows;
}

/// What patches add to the readings of observers at one place, who meet the same of them: a light is looked
/// up once for all, and their sums lie side by side, of as many patches as a processor adds at a time.
class RoomView::Reflected {
 public:
  Reflected(const SightLines::Outlook& outlook, const std::vector<float>& reflectance)
      : observers_(outlook.directions.size()),
        blocks_((observers_ + kBlock - 1) / kBlock),
        patches_(outlook.patches) {
    // Filled up with what adds nothing.
    patches_.resize((patches_.size() + kAbreast - 1) / kAbreast * kAbreast);
    cylindrical_.resize(patches_.size()), light_.resize(patches_.size());
    background_.resize(blocks_ * patches_.size() * kBlock);
    for (std::size_t k = 0; k < outlook.patches.size(); ++k) {
      const double rho = reflectance[outlook.patches[k]];
      cylindrical_[k] = rho * outlook.cylindrical[k];
      for (std::size_t o = 0; o < observers_; ++o)
        background_[(o / kBlock * patches_.size() + k) * kBlock + o % kBlock] =
            rho * outlook.background[k * observers_ + o];
    }
  }

  /// To a reading of each observer that has the direct light.
  void addTo(const float* illuminance, std::vector<ObserverReading>& readings) {
    for (std::size_t k = 0; k < patches_.size(); ++k) light_[k] = illuminance[patches_[k]];
    double cylindrical[kAbreast] = {};
    for (std::size_t k = 0; k < patches_.size(); k += kAbreast)
      for (std::size_t a = 0; a < kAbreast; ++a) cylindrical[a] += cylindrical_[k + a] * light_[k + a];
    for (std::size_t block = 0; block < blocks_; ++block) {
      const double* weights = background_.data() + block * patches_.size() * kBlock;
      double sums[kAbreast][kBlock] = {};
      for (std::size_t k = 0; k < patches_.size(); k += kAbreast)
        for (std::size_t a = 0; a < kAbreast; ++a)
          for (std::size_t i = 0; i < kBlock; ++i)
            sums[a][i] += weights[(k + a) * kBlock + i] * light_[k + a];
      for (std::size_t o = block * kBlock; o < std::min(observers_, (block + 1) * kBlock); ++o) {
        ObserverReading& reading = readings[o];
        for (std::size_t a = 0; a < kAbreast; ++a) reading.background += sums[a][o % kBlock];
        reading.vertical += std::numbers::pi * reading.background;
        for (const double part : cylindrical) reading.cylindrical += part;
      }
    }
  }

 private:
  static constexpr std::size_t kBlock = 4;  // observers: so many look from each place of a grid
  static constexpr std::size_t kAbreast = 4;
  std::size_t observers_, blocks_;
  std::vector<std::uint32_t> patches_;
  std::vector<double> background_, cylindrical_;  // per lx; the former by blocks, rows of kBlock
  std::vector<double> light_;                     // lx on the patches, latest
};

/// By what of the luminaire is seen.
ObserverReading RoomView::directAt(const Observer& observer, const Luminaire& luminaire) const {
  const Vec3 way = luminaire.position - observer.position;
  const double squared = dot(way, way), distance = std::sqrt(squared);
  if (!(distance > 0)) return {};
  const double candela = candelaOf(luminaire, seenFrom(luminaire, (-1 / distance) * way));
  if (!(candela > 0)) return {};
  const double visible = lines_->visibleShare(observer.position, luminaire);
  const double light = visible * candela / (squared * distance);
  return {visible * glareOf(luminaire, observer), 0, light * std::max(0.0, dot(way, observer.direction)),
          light * std::hypot(way.x, way.z) / std::numbers::pi};
}

std::vector<ObserverReading> RoomView::readings(const std::vector<Observer>& observers,
                                                const std::vector<Luminaire>& luminaires, double dimming,
                                                const std::vector<float>& illuminance) const {
  std::vector<ObserverReading> readings;
  for (const Observer& observer : observers) {
    std::vector<ObserverReading> reading(1);
    for (const Luminaire& luminaire : luminaires) {
      const ObserverReading direct = directAt(observer, luminaire);
      reading[0].glare += dimming * dimming * direct.glare;
      reading[0].vertical += dimming * direct.vertical;
      reading[0].cylindrical += dimming * direct.cylindrical;
    }
    Reflected(*lines_->outlookOfEye(observer.position, {observer.direction}), reflectance_)
        .addTo(illuminance.data(), reading);
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
    std::vector<Vec3> directions;
    for (std::size_t o = first; o < last; ++o) directions.push_back(observers[o].direction);
    Reflected reflected(*lines_->outlookOfEye(observers[first].position, directions), reflectance_);
    for (const std::uint32_t j : some) {
      readings.clear();
      for (std::size_t o = first; o < last; ++o) readings.push_back(directAt(observers[o], luminaires[j]));
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
