#include "precompute/pipeline/verdict.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/short_number.h"

namespace fiatlux {
namespace {

constexpr double kAllLost = 0.02,
                 kDark = 0.05;     // shares of the flux: absorbed by all, falling on the most lit
constexpr double kBlack = 0.01;    // share of what falls on surfaces that they reflect
constexpr double kBalance = 1.05;  // of the flux: more cannot be absorbed but by rounding
constexpr double kMostError = 0.05, kMostResidual = 0.01;
constexpr double kAskedMean = 300, kUsualFlux = 3000;  // lx, lm
constexpr double kSensibleCount = 24;                  // luminaires
constexpr double kNearly = 0.9;                        // of what they reach on average
constexpr double kServes = 0.5;       // of the best site's light: others hang over other floors
constexpr double kApart = 0.8;        // of an even grid's pitch: so much leaves a choice of places
constexpr double kCloser = 0.85;      // at a time, where so many find no room
constexpr double kStepsOfMetre = 20;  // to which it is told
constexpr double kRoomForMore = 1.2;  // times as many must find room, for places are taken as they come

std::string inPercent(double share) {
  constexpr int kDigits = 2;
  return shortNumber(100 * share, share < 1 ? kDigits : kDigits + 1) + " %";
}

}  // namespace

LightBalance balanceOf(const Room& room, const Responses& responses) {
  LightBalance balance;
  if (responses.sites == 0) return balance;
  std::vector<double> most;
  std::vector<double> onSurface(room.surfaces.size());
  for (std::uint32_t j = 0; j < responses.sites; ++j) {
    std::fill(onSurface.begin(), onSurface.end(), 0);
    const float* light = responses.column(j);
    for (std::uint32_t p = 0; p < room.patches.count; ++p) {
      const double flux = room.patches.area[p] * light[p];
      onSurface[room.patches.surface[p]] += flux;
      balance.absorbed += (1 - room.patches.reflectance[p]) * flux / responses.sites;
      balance.reflected += room.patches.reflectance[p] * flux / responses.sites;
    }
    most.push_back(*std::max_element(onSurface.begin(), onSurface.end()));
  }
  std::nth_element(most.begin(), most.begin() + static_cast<std::ptrdiff_t>(most.size() / 2), most.end());
  balance.mostLit = most[most.size() / 2];
  return balance;
}

std::string uselessness(const Quality& quality) {
  const auto& [balance, residual, error] = quality;
  if (!std::isfinite(balance.absorbed) || balance.absorbed > kBalance)
    return "the balance of light does not close (" + inPercent(balance.absorbed) +
           " of what is emitted is absorbed): are faces drawn twice? pass more --rays";
  if (balance.absorbed < kAllLost)
    return "nearly all light is lost: the luminaires hang outdoors or look at backs; see fiatlux surfaces, "
           "then "
           "--mount, --ceiling or --double-sided";
  if (balance.mostLit < kDark)
    return "the room stays dark: no surface gets more than " + inPercent(balance.mostLit) +
           " of the light; the luminaires hang in a cavity; see fiatlux surfaces, then --mount or --ceiling";
  if (const double reflects = balance.reflected / (balance.reflected + balance.absorbed); reflects < kBlack)
    return "everything is black: surfaces reflect " + inPercent(reflects) +
           " of the light, as where colours were lost on export; pass --reflectance MATERIAL=0.5 for each";
  if (residual > kMostResidual)
    return "reflected light has not settled (" + inPercent(residual) +
           " is missing): pass --refine 100 or a smaller --cluster";
  if (error > kMostError)
    return "the file's numbers are off by up to " + inPercent(error) +
           ": surfaces that are nearly dark are too large a part of it; choose fewer places with --mount";
  return "";
}

std::string unsettled(double residual) {
  return "reflected light is settled to " + inPercent(residual) + " only, 0.1 % is usual: pass more --refine";
}

namespace {

/// m2, least distance of a site to others, squared; infinite where there are none.
double nearest(const Vec3& position, const std::vector<Vec3>& others) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& other : others)
    if (const Vec3 way = position - other; dot(way, way) > 0) least = std::min(least, dot(way, way));
  return least;
}

/// The pitch of an even grid of so many over all places, or less where so many, taken as they come, find no
/// room.
double spreadOf(const std::vector<Vec3>& places, double count) {
  double cell = 0;  // m2, of a place
  for (const Vec3& place : places) cell += nearest(place, places) / static_cast<double>(places.size());
  double apart = kApart * std::sqrt(cell * static_cast<double>(places.size()) / count);
  for (; count > 1 && apart * apart > cell; apart *= kCloser) {
    std::vector<Vec3> taken;
    for (const Vec3& place : places)
      if (nearest(place, taken) >= apart * apart) taken.push_back(place);
    if (static_cast<double>(taken.size()) >= kRoomForMore * count)
      return std::floor(kStepsOfMetre * apart) / kStepsOfMetre;
  }
  return 0;
}

}  // namespace

OpeningAsk openingOf(const Room& room, const Transport& transport) {
  std::uint32_t asked = room.floor;
  for (std::uint32_t s = 0; s < room.surfaces.size(); ++s)
    if (room.surfaces[s].measuring && (asked == kNone || !room.surfaces[asked].measuring ||
                                       room.surfaces[s].area > room.surfaces[asked].area))
      asked = s;
  if (asked == kNone || room.sites.empty()) return {};
  const std::vector<double>& mean = transport.illuminance[asked].mean;
  const double best = *std::max_element(mean.begin(), mean.end());
  if (!(best > 0)) return {};
  std::vector<Vec3> serving;  // the others hang over the floors of other storeys
  double sum = 0;
  for (std::size_t j = 0; j < mean.size(); ++j)
    if (mean[j] >= kServes * best) {
      serving.push_back(room.sites[j].position);
      sum += mean[j];
    }
  const double each = kUsualFlux * sum / static_cast<double>(serving.size());
  const double most = std::min(kSensibleCount, static_cast<double>(serving.size()));
  const double count = std::clamp(std::ceil(kAskedMean / each), 1.0, most);
  OpeningAsk ask{room.surfaces[asked].name, kAskedMean, static_cast<std::uint32_t>(count),
                 spreadOf(serving, count)};
  if (count * each < kAskedMean) ask.mean = std::max(1.0, std::floor(kNearly * count * each));
  return ask;
}

}  // namespace fiatlux
