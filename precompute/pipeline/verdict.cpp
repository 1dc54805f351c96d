#include "precompute/pipeline/verdict.h"

#include <algorithm>
#include <cmath>
#include <numeric>
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

OpeningAsk openingOf(const Room& room, const Transport& transport) {
  std::uint32_t asked = room.floor;
  for (std::uint32_t s = 0; s < room.surfaces.size(); ++s)
    if (room.surfaces[s].measuring && (asked == kNone || !room.surfaces[asked].measuring ||
                                       room.surfaces[s].area > room.surfaces[asked].area))
      asked = s;
  if (asked == kNone || room.sites.empty()) return {};
  const std::vector<double>& mean = transport.illuminance[asked].mean;
  const double each =
      kUsualFlux * std::accumulate(mean.begin(), mean.end(), 0.0) / static_cast<double>(mean.size());
  if (!(each > 0)) return {};
  const double most = std::min(kSensibleCount, static_cast<double>(room.sites.size()));
  const double count = std::clamp(std::ceil(kAskedMean / each), 1.0, most);
  OpeningAsk ask{room.surfaces[asked].name, kAskedMean, static_cast<std::uint32_t>(count)};
  if (count * each < kAskedMean) ask.mean = std::max(1.0, std::floor(kNearly * count * each));
  return ask;
}

}  // namespace fiatlux
