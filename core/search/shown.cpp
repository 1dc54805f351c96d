// Readings of one layout; see shown.h. Sums in one fixed order, as in the search.
#include "core/search/shown.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/search/patch_extremes.h"

namespace fiatlux {
namespace {

/// The layout as the kernels read it: dimming folded into the flux.
struct Lit {
  PreparedScene& prepared;
  Quantity quantity;
  const std::uint32_t* sites;
  std::vector<double> flux;  // dimmed, lm

  std::uint32_t count() const { return static_cast<std::uint32_t>(flux.size()); }

  double mean(const SurfaceSet& surfaces) const {
    return meanOf(prepared.statistics(quantity, surfaces)->mean.data(), sites, flux.data(), count());
  }
  double sigma(const SurfaceSet& surfaces) const {
    const auto statistics = prepared.statistics(quantity, surfaces);
    const double variance =
        varianceOf(statistics->covariance.data(), prepared.siteCount(), sites, flux.data(), count());
    return std::sqrt(std::max(0.0, variance));
  }
  Extremes extremes(const SurfaceSet& surfaces) const {
    PatchExtremes patches(prepared.scene(), quantity, surfaces);
    patches.load(sites, flux.data(), count());
    return patches.current();
  }
  double power() const {
    double sum = 0;
    for (double f : flux) sum += f;
    return sum;
  }
};

double ratio(double a, double b) { return b > 0 ? a / b : 0; }

/// What a constraint compares with its lower and with its upper bound.
struct Sides {
  double low = 0, high = 0;
};

Sides sidesOf(const Lit& lit, const Constraint& constraint) {
  const auto both = [](double value) { return Sides{value, value}; };
  switch (constraint.statistic) {
    case Statistic::kMean:
      return both(lit.mean(constraint.surfaces));
    case Statistic::kSigma:
      return both(lit.sigma(constraint.surfaces));
    case Statistic::kPower:
      return both(lit.power());
    case Statistic::kContrast:
      return both(ratio(lit.mean(constraint.surfaces), lit.mean(constraint.over)));
    case Statistic::kChebyshev: {
      const double mean = lit.mean(constraint.surfaces),
                   reach = constraint.alpha * lit.sigma(constraint.surfaces);
      return {mean - reach, mean + reach};
    }
    case Statistic::kMinimum: {
      const Extremes e = lit.extremes(constraint.surfaces);
      return {e.minimumLow, e.minimumHigh};
    }
    case Statistic::kMaximum: {
      const Extremes e = lit.extremes(constraint.surfaces);
      return {e.maximumLow, e.maximumHigh};
    }
    case Statistic::kUniformity: {
      const Extremes e = lit.extremes(constraint.surfaces);
      const double mean = lit.mean(constraint.surfaces);
      return {ratio(e.minimumLow, mean), ratio(e.minimumHigh, mean)};
    }
  }
  return {};
}

/// Signed distance to a bound, relative: positive inside.
double marginOf(double inside, double bound) { return bound != 0 ? inside / std::abs(bound) : inside; }

ConstraintReading readConstraint(const Lit& lit, const Constraint& constraint) {
  const Sides sides = sidesOf(lit, constraint);
  const bool below = std::isfinite(constraint.lower), above = std::isfinite(constraint.upper);
  const double low = below ? marginOf(sides.low - constraint.lower, constraint.lower) : kUnbounded;
  const double high = above ? marginOf(constraint.upper - sides.high, constraint.upper) : kUnbounded;
  ConstraintReading reading;
  reading.value = constraint.statistic == Statistic::kChebyshev ? (low <= high ? sides.low : sides.high)
                                                                : (sides.low + sides.high) / 2;
  reading.violation = std::max(0.0, -low) + std::max(0.0, -high);
  reading.margin = std::min(low, high);
  return reading;
}

double goalValue(const Lit& lit, const Goal& goal) {
  switch (goal.statistic) {
    case Statistic::kSigma:
      return lit.sigma(goal.surfaces);
    case Statistic::kPower:
      return lit.power();
    case Statistic::kContrast:
      return ratio(lit.mean(goal.surfaces), lit.mean(goal.over));
    default:
      return lit.mean(goal.surfaces);
  }
}

/// Least and largest light of every leaf and of all of them, in one pass over the patches.
void readExtremes(const Scene& scene, Quantity quantity, Shown& shown) {
  const bool exitance = quantity == Quantity::kExitance;
  for (SurfaceReading& reading : shown.surfaces) reading = {0, 0, kUnbounded, -kUnbounded};
  for (std::size_t p = 0; p < shown.illuminance.size(); ++p) {
    SurfaceReading& reading = shown.surfaces[scene.patches.surface[p]];
    const double value =
        exitance ? shown.illuminance[p] * scene.patches.reflectance[p] : shown.illuminance[p];
    reading.minimum = std::min(reading.minimum, value);
    reading.maximum = std::max(reading.maximum, value);
  }
  SurfaceReading& all = shown.surfaces.back();
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    if (scene.surfaces[s].measuring) continue;
    all.minimum = std::min(all.minimum, shown.surfaces[s].minimum);
    all.maximum = std::max(all.maximum, shown.surfaces[s].maximum);
  }
}

void readSurfaces(const Lit& lit, Shown& shown) {
  const Scene& scene = lit.prepared.scene();
  const auto& leaves = lit.quantity == Quantity::kIlluminance ? scene.illuminance : scene.exitance;
  const std::size_t m = scene.sites.size();
  shown.surfaces.resize(scene.surfaces.size() + 1);
  readExtremes(scene, lit.quantity, shown);
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    SurfaceReading& reading = shown.surfaces[s];
    if (lit.quantity == Quantity::kExitance && scene.surfaces[s].measuring) {
      reading = {};
      continue;
    }
    double variance = 0;
    for (std::uint32_t i = 0; i < lit.count(); ++i) {
      reading.mean += lit.flux[i] * leaves[s].mean[lit.sites[i]];
      const double* row = leaves[s].covariance.data() + lit.sites[i] * m;
      for (std::uint32_t j = 0; j < lit.count(); ++j)
        variance += lit.flux[i] * lit.flux[j] * row[lit.sites[j]];
    }
    reading.sigma = std::sqrt(std::max(0.0, variance));
  }
  shown.surfaces.back().mean = lit.mean({});
  shown.surfaces.back().sigma = lit.sigma({});
}

}  // namespace

Shown shownOf(PreparedScene& prepared, const Intentions& intentions, const Layout& layout) {
  Lit lit{prepared, intentions.quantity, layout.sites.data(), layout.flux};
  for (double& flux : lit.flux) flux *= layout.dimming;
  Shown shown;
  shown.layout = layout;
  shown.illuminance = illuminanceOf(prepared.scene(), layout);
  readSurfaces(lit, shown);
  for (const Goal& goal : intentions.goals) shown.goals.push_back(goalValue(lit, goal));
  for (const Constraint& constraint : intentions.constraints)
    shown.constraints.push_back(readConstraint(lit, constraint));
  return shown;
}

Result<Done> checkLayout(const Scene& scene, const Layout& layout) {
  const std::size_t m = scene.sites.size();
  if (layout.sites.size() != layout.flux.size())
    return Error{"layout: " + std::to_string(layout.sites.size()) + " sites but " +
                 std::to_string(layout.flux.size()) + " fluxes; give one flux a luminaire"};
  std::vector<char> taken(m, 0);
  for (std::uint32_t site : layout.sites) {
    if (site >= m)
      return Error{"layout: there is no site " + std::to_string(site) + "; this room has sites 0 to " +
                   std::to_string(m - 1)};
    if (taken[site]++)
      return Error{"layout: two luminaires on site " + std::to_string(site) + "; at most one a site"};
  }
  for (double flux : layout.flux)
    if (!(flux >= 0 && std::isfinite(flux)))
      return Error{"layout: a flux must be a number of lumens, 0 or more"};
  if (!(layout.dimming >= 0 && std::isfinite(layout.dimming)))
    return Error{"layout: the dimming must be a number, 0 or more"};
  return Done{};
}

StatisticsCheck checkStatistics(const Scene& scene, Quantity quantity, const Shown& shown) {
  std::vector<float> values = shown.illuminance;
  if (quantity == Quantity::kExitance)
    for (std::size_t p = 0; p < values.size(); ++p) values[p] *= scene.patches.reflectance[p];
  StatisticsCheck check;
  for (std::uint32_t s = 0; s < shown.surfaces.size(); ++s) {
    const bool all = s == scene.surfaces.size();
    if (!all && quantity == Quantity::kExitance && scene.surfaces[s].measuring) continue;
    const ExplicitStatistics truth = explicitStatistics(scene, values, all ? SurfaceSet{} : SurfaceSet{s});
    if (!(truth.mean > 0)) continue;
    const SurfaceReading& reading = shown.surfaces[s];
    const double difference =
        std::max(std::abs(reading.mean - truth.mean), std::abs(reading.sigma - truth.sigma)) / truth.mean;
    if (difference > check.largestDifference) check = {difference, s};
  }
  return check;
}

}  // namespace fiatlux
