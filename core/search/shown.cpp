// Readings of one layout; see shown.h. Sums in one fixed order, as in the search.
#include "core/search/shown.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

#include "core/scene/surface_names.h"
#include "core/scene/zones.h"
#include "core/search/patch_extremes.h"
#include "core/search/plane_values.h"
#include "core/search/validate_intentions.h"

namespace fiatlux {
namespace {

/// A layout whose dimming is in its fluxes, and where it hangs.
struct Lit {
  PreparedScene& prepared;
  Layout layout;  // dimming 1

  Moments moments(Quantity quantity, const SurfaceSet& surfaces, bool withVariance = true) const {
    return momentsOf(*prepared.statistics(quantity, surfaces, withVariance), layout.sites.data(),
                     layout.flux.data(), static_cast<std::uint32_t>(layout.flux.size()), withVariance);
  }
  Extremes extremes(Quantity quantity, const SurfaceSet& surfaces) const {
    return extremesUnder(prepared.scene(), quantity, surfaces, layout);
  }
  /// Of one observer, or of whoever is worst off.
  double glare(std::uint32_t observer) const {
    const std::vector<ObserverReading> seen = readObservers(prepared.scene().observers, layout);
    if (observer != kNone) return glareRatio(seen[observer]);
    double largest = 0;
    for (const ObserverReading& reading : seen) largest = std::max(largest, glareRatio(reading));
    return largest;
  }
  double power() const {
    double sum = 0;
    for (std::size_t i = 0; i < layout.flux.size(); ++i)
      sum += layout.flux[i] * powerAt(prepared.scene(), layout.sites[i]);
    return sum;
  }
};

/// What one statistic reads of the layout.
struct Read {
  Moments at, over;
  Extremes extremes;
};

/// A layout as it is dimmed and as it would be at full flux.
struct LitEitherWay {
  Lit full, dimmed;

  LitEitherWay(PreparedScene& prepared, const Layout& layout)
      : full{prepared, {layout.sites, layout.flux, 1}}, dimmed(full) {
    for (double& flux : dimmed.layout.flux) flux *= layout.dimming;
    isDark = layout.dimming == 0;
  }
  /// A ratio does not change with the dimming: where that leaves no light, it is what it was before.
  const Lit& forA(Statistic statistic) const {
    return isDark && traitsOf(statistic).scaleFree() ? full : dimmed;
  }

 private:
  bool isDark = false;
};

/// Of what a goal asks, or a constraint of surfaces.
template <class Intention>
Read readFor(const Lit& lit, Quantity quantity, const Intention& of) {
  const StatisticTraits& traits = traitsOf(of.statistic);
  Read read;
  if (!traits.needsSurfaces) return read;
  read.at = lit.moments(quantity, of.surfaces, traits.needsVariance);
  if (traits.needsExtremes) read.extremes = lit.extremes(quantity, of.surfaces);
  if (traits.needsOver) read.over = lit.moments(quantity, of.over, false);
  return read;
}

double valueOf(const Lit& lit, Statistic statistic, const Read& read, Side side, double alpha) {
  return valueOf(statistic, {&read.at, &read.over, &read.extremes, lit.power()}, side, alpha);
}

ConstraintReading readConstraint(const Lit& lit, const Constraint& c, Quantity quantity) {
  const StatisticTraits& traits = traitsOf(c.statistic);
  if (c.statistic == Statistic::kUgr) {  // held against its bound as the search does: by the ratio
    const double ratio = lit.glare(c.observer), margin = marginTo(ratioOf(c.upper), Side::kUpper, ratio);
    const double above = std::max(0.0, -margin);
    return {ugrOf(ratio), above, margin, 0, above};
  }
  double below = 0, above = 0;
  if (isOfPoints(c)) {
    Constraint ofQuantity = c;
    ofQuantity.quantity = quantity;
    below = above = valueOf(c, planeValueUnder(lit.prepared, ofQuantity, lit.layout));
  } else {
    const Read read = readFor(lit, quantity, c);
    below = valueOf(lit, c.statistic, read, Side::kLower, c.alpha);
    above = valueOf(lit, c.statistic, read, Side::kUpper, c.alpha);
  }
  const double low = std::isfinite(c.lower) ? marginTo(c.lower, Side::kLower, below) : kUnbounded;
  const double high = std::isfinite(c.upper) ? marginTo(c.upper, Side::kUpper, above) : kUnbounded;
  ConstraintReading reading;
  reading.value = traits.needsAlpha ? (low <= high ? below : above) : (below + above) / 2;
  reading.below = std::max(0.0, -low);
  reading.above = std::max(0.0, -high);
  reading.violation = reading.below + reading.above;
  reading.margin = std::min(low, high);
  return reading;
}

std::vector<ConstraintReading> readConstraints(const LitEitherWay& lit, const Intentions& intentions) {
  std::vector<ConstraintReading> readings;
  for (const Constraint& constraint : intentions.constraints)
    readings.push_back(
        readConstraint(lit.forA(constraint.statistic), constraint, quantityOf(intentions, constraint)));
  return readings;
}

double readGoal(const Lit& lit, const Goal& goal, Quantity quantity) {
  const Read read = readFor(lit, quantity, goal);
  const double value = valueOf(lit, goal.statistic, read, Side::kLower, 0);
  return goal.sense == Sense::kNear ? distanceFrom(goal.target, value) : value;
}

/// Least and largest light of every leaf and of all of them, in one pass over the patches.
void readExtremes(const Scene& scene, Quantity quantity, Shown& shown) {
  const bool exitance = quantity == Quantity::kExitance;
  for (SurfaceReading& reading : shown.surfaces) reading = {0, 0, kUnbounded, -kUnbounded};
  const auto read = [&](SurfaceReading& reading, std::uint32_t p) {
    const double value =
        exitance ? shown.illuminance[p] * scene.patches.reflectance[p] : shown.illuminance[p];
    reading.minimum = std::min(reading.minimum, value);
    reading.maximum = std::max(reading.maximum, value);
  };
  for (std::uint32_t p = 0; p < shown.illuminance.size(); ++p)
    if (scene.patches.counts(p)) read(shown.surfaces[scene.patches.surface[p]], p);
  for (std::size_t z = 0; z < scene.zones.size(); ++z)
    for (const std::uint32_t p : scene.zones[z].rows) read(shown.surfaces[firstZone(scene) + z], p);
  SurfaceReading& all = shown.surfaces.back();
  for (std::uint32_t s : leavesOf(scene, {})) {
    all.minimum = std::min(all.minimum, shown.surfaces[s].minimum);
    all.maximum = std::max(all.maximum, shown.surfaces[s].maximum);
  }
}

/// Means and sigmas of all leaves and of their union, off the light itself.
void readLight(const Scene& scene, Quantity quantity, Shown& shown) {
  const std::size_t leaves = scene.surfaces.size();
  std::vector<double> area(leaves), sum(leaves), squares(leaves);
  const auto add = [&](std::size_t s, std::uint32_t p) {
    const double factor = quantity == Quantity::kExitance ? scene.patches.reflectance[p] : 1.0;
    const double weight = scene.patches.area[p], value = factor * shown.illuminance[p];
    area[s] += weight;
    sum[s] += weight * value;
    squares[s] += weight * value * value;
  };
  for (std::uint32_t p = 0; p < shown.illuminance.size(); ++p)
    if (scene.patches.counts(p)) add(scene.patches.surface[p], p);
  for (std::size_t z = 0; z < scene.zones.size(); ++z)
    for (const std::uint32_t p : scene.zones[z].rows) add(firstZone(scene) + z, p);
  double total = 0, all = 0, allSquares = 0;
  const auto read = [](SurfaceReading& reading, double weight, double first, double second) {
    if (weight <= 0) return;
    reading.mean = first / weight;
    reading.sigma = std::sqrt(std::max(0.0, second / weight - reading.mean * reading.mean));
  };
  for (std::size_t s = 0; s < leaves; ++s) read(shown.surfaces[s], area[s], sum[s], squares[s]);
  for (const std::uint32_t s : leavesOf(scene, {})) {
    total += area[s];
    all += sum[s];
    allSquares += squares[s];
  }
  read(shown.surfaces.back(), total, all, allSquares);
}

void readSurfaces(const Lit& lit, Quantity quantity, Shown& shown) {
  const Scene& scene = lit.prepared.scene();
  const std::vector<SurfaceStatistics>& leaves = leafStatistics(scene, quantity);
  shown.surfaces.resize(scene.surfaces.size() + 1);
  readExtremes(scene, quantity, shown);
  if (leaves[0].covariance.empty()) return readLight(scene, quantity, shown);
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    SurfaceReading& reading = shown.surfaces[s];
    if (quantity == Quantity::kExitance && scene.surfaces[s].measuring) {
      reading = {};
      continue;
    }
    const MeanAndSigma light = meanAndSigmaOf(leaves[s], lit.layout);
    reading.mean = light.mean;
    reading.sigma = light.sigma;
  }
  const Moments all = lit.moments(quantity, {});
  shown.surfaces.back().mean = all.mean;
  shown.surfaces.back().sigma = all.sigma();
}

}  // namespace

Shown shownOf(PreparedScene& prepared, const Intentions& intentions, const Layout& layout) {
  assert(checkLayout(prepared.scene(), layout) && checkIntentions(prepared.scene(), intentions));
  const LitEitherWay lit(prepared, layout);
  Shown shown;
  shown.layout = layout;
  shown.illuminance = illuminanceOf(prepared.scene(), layout, intentions.quantity);
  if (asksForDirect(intentions)) shown.direct = illuminanceOf(prepared.scene(), layout, Quantity::kDirect);
  readSurfaces(lit.dimmed, intentions.quantity, shown);
  for (const Goal& goal : intentions.goals)
    shown.goals.push_back(readGoal(lit.forA(goal.statistic), goal, quantityOf(intentions, goal)));
  shown.constraints = readConstraints(lit, intentions);
  shown.observers = readObservers(prepared.scene().observers, layout);
  shown.planes = readPlanes(prepared.scene().planes, layout);
  return shown;
}

std::vector<ConstraintReading> constraintReadings(PreparedScene& prepared, const Intentions& intentions,
                                                  const Layout& layout) {
  assert(checkLayout(prepared.scene(), layout) && checkIntentions(prepared.scene(), intentions));
  return readConstraints(LitEitherWay(prepared, layout), intentions);
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
