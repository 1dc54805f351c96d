#include "core/photometry/photometric_values.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/photometry/degrees.h"
#include "core/photometry/intensity.h"

namespace fiatlux {
namespace {

/// Lamps that give less than their table holds, or ten times more, were stated or multiplied wrongly.
constexpr double kMostOutput = 1.02, kLeastOutput = 0.1;

/// int I(gamma) sin(gamma) dgamma of one plane over the part of the table above `least` degrees; I linear
/// between.
double planeIntegral(const Photometry& photometry, std::size_t plane, double least) {
  double sum = 0;
  for (std::size_t g = 0; g + 1 < photometry.gamma.size(); ++g) {
    double from = photometry.gamma[g], first = photometry.at(plane, g);
    const double to = photometry.gamma[g + 1], last = photometry.at(plane, g + 1);
    if (to <= least) continue;
    if (from < least) {
      first += (last - first) * (least - from) / (to - from);
      from = least;
    }
    const double a = from * kDegree, b = to * kDegree;
    sum += first * std::cos(a) - last * std::cos(b) + (last - first) / (b - a) * (std::sin(b) - std::sin(a));
  }
  return sum;
}

/// lm above `least` degrees of gamma.
double fluxAbove(const Photometry& photometry, double least) {
  if (photometry.c.size() == 1) return 2 * std::numbers::pi * planeIntegral(photometry, 0, least);
  double sum = 0, before = planeIntegral(photometry, 0, least);
  for (std::size_t plane = 1; plane < photometry.c.size(); ++plane) {
    const double here = planeIntegral(photometry, plane, least);
    sum += (photometry.c[plane] - photometry.c[plane - 1]) * kDegree * (before + here) / 2;
    before = here;
  }
  return sum * 360 / (photometry.c.back() - photometry.c.front());
}

/// One half plane from a pole of the light outwards: angle from that pole, cd.
struct Profile {
  std::vector<double> angle, candela;
};

Profile profileOf(const Photometry& photometry, double c, bool fromAbove) {
  Profile profile;
  for (const double gamma : photometry.gamma) {
    profile.angle.push_back(fromAbove ? 180 - gamma : gamma);
    profile.candela.push_back(intensityAt(photometry, c, gamma));
  }
  if (fromAbove) {
    std::reverse(profile.angle.begin(), profile.angle.end());
    std::reverse(profile.candela.begin(), profile.candela.end());
  }
  return profile;
}

struct Reach {
  double inner = 0, outer = 0;  // degrees from the pole
  bool any = false;
};

/// From the first to the last direction with at least `least` cd within 90 degrees of the pole, and on from
/// there without a gap.
Reach reachOf(const Profile& profile, double least) {
  Reach reach;
  for (std::size_t i = 0; i < profile.angle.size(); ++i) {
    const bool bright = profile.candela[i] >= least;
    const bool brightBefore = i > 0 && profile.candela[i - 1] >= least;
    if (bright == brightBefore) continue;
    // Where the light, linear between the nodes, crosses the least.
    double crossing = profile.angle[i];
    if (i > 0)
      crossing -= (profile.candela[i] - least) / (profile.candela[i] - profile.candela[i - 1]) *
                  (profile.angle[i] - profile.angle[i - 1]);
    if (bright && crossing > 90) break;
    if (bright && !reach.any) reach = {crossing, crossing, true};
    if (bright) reach.outer = profile.angle.back();
    if (!bright) reach.outer = crossing;
  }
  return reach;
}

/// The full angle in the plane of c and c + 180; none where nothing there has `least` cd.
std::optional<double> openingIn(const Photometry& photometry, double c, bool fromAbove, double least) {
  const Reach one = reachOf(profileOf(photometry, c, fromAbove), least);
  const Reach other = reachOf(profileOf(photometry, c + 180, fromAbove), least);
  if (one.any && other.any) return one.outer + other.outer;
  if (one.any || other.any) return one.any ? one.outer - one.inner : other.outer - other.inner;
  return {};
}

}  // namespace

double integratedFlux(const Photometry& photometry) { return fluxAbove(photometry, 0); }

bool isFluxDisputed(const Photometry& photometry, double flux) {
  return photometry.format != PhotometricFormat::kEulumdat && photometry.flux > 0 &&
         (flux > kMostOutput * photometry.flux || flux < kLeastOutput * photometry.flux);
}

double upwardShare(const Photometry& photometry) {
  const double flux = integratedFlux(photometry);
  return flux > 0 ? std::clamp(fluxAbove(photometry, 90) / flux, 0.0, 1.0) : 0;
}

double maxCandela(const Photometry& photometry) {
  return *std::max_element(photometry.candela.begin(), photometry.candela.end());
}

double openingAngle(const Photometry& photometry, double share) {
  const auto brightest = std::max_element(photometry.candela.begin(), photometry.candela.end());
  if (*brightest <= 0) return 0;
  const auto index = static_cast<std::size_t>(brightest - photometry.candela.begin());
  const bool fromAbove = photometry.gamma[index % photometry.gamma.size()] > 90;
  const auto opening = [&](double c) { return openingIn(photometry, c, fromAbove, share * *brightest); };
  const std::optional<double> along = opening(0), across = opening(90);
  if (along && across) return (*along + *across) / 2;
  if (along || across) return along ? *along : *across;
  return opening(photometry.c[index / photometry.gamma.size()]).value_or(0);
}

std::optional<double> efficacy(const Photometry& photometry) {
  if (!(photometry.watts > 0)) return {};
  return integratedFlux(photometry) / photometry.watts;
}

}  // namespace fiatlux
