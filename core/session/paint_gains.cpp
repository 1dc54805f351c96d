#include "core/session/paint_gains.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/scene/zones.h"
#include "core/search/shown.h"
#include "core/transport/surface_statistics.h"

namespace fiatlux {
namespace {

constexpr double kStep = 0.01;         // of reflectance, that the derivative is read over
constexpr double kTold = 0.1;          // of reflectance, that a gain is told for
constexpr std::size_t kTogether = 16;  // surfaces whose light is made in one go

/// The largest surfaces that can be painted, by their numbers.
std::vector<std::uint32_t> paintable(const Scene& room) {
  std::vector<std::uint32_t> surfaces;
  for (std::uint32_t s = 0; s < room.surfaces.size(); ++s)
    if (!room.surfaces[s].measuring) surfaces.push_back(s);
  std::stable_sort(surfaces.begin(), surfaces.end(), [&](std::uint32_t a, std::uint32_t b) {
    return room.surfaces[a].area > room.surfaces[b].area;
  });
  surfaces.resize(std::min(surfaces.size(), kMostGains));
  std::sort(surfaces.begin(), surfaces.end());
  return surfaces;
}

/// The room with one luminaire, which makes the light of a whole layout.
Scene litScene(const Scene& room, const Repaint& paint, const std::vector<float>& light) {
  Scene scene;
  scene.patches = room.patches;
  scene.surfaces.assign(room.surfaces.begin(), room.surfaces.begin() + firstZone(room));
  scene.sites = {Site{}};
  scene.responses = {static_cast<std::uint32_t>(light.size()), 1, light};
  std::copy(paint.reflectance().begin(), paint.reflectance().end(), scene.patches.reflectance.begin());
  return scene;
}

/// What is asked of its light alone; glare and power, which its one luminaire knows nothing of, direct light,
/// which no paint changes, and the points of planes are asked of nobody.
Intentions ofLightAlone(const Intentions& asked) {
  const auto isOfLight = [&](const auto& each) {
    return each.statistic != Statistic::kUgr && !traitsOf(each.statistic).ofPlanes &&
           quantityOf(asked, each) != Quantity::kDirect;
  };
  Intentions intentions;
  if (asked.quantity != Quantity::kDirect) intentions.quantity = asked.quantity;
  intentions.luminaires.count = 1;
  intentions.luminaires.flux = {1};
  intentions.goals = asked.goals;
  intentions.constraints = asked.constraints;
  intentions.zones = asked.zones;
  for (Constraint& constraint : intentions.constraints)
    if (!isOfLight(constraint)) {
      constraint = {};
      constraint.statistic = Statistic::kPower;
      constraint.lower = 0;
    }
  for (Goal& goal : intentions.goals)
    if (!isOfLight(goal)) goal = {Statistic::kPower, Sense::kMinimize, 1, {}, {}};
  return intentions;
}

PaintGain readingsOf(Scene& scene, const Intentions& asked) {
  (void)takeZones(scene, {});
  setMeanRows(asked.quantity, scene);
  (void)takeZones(scene, asked.zones);
  PreparedScene prepared(scene);
  const Shown shown = shownOf(prepared, asked, {{0}, {1}, 1});
  PaintGain readings{0, shown.goals, {}};
  for (const ConstraintReading& reading : shown.constraints) readings.constraints.push_back(reading.value);
  return readings;
}

std::vector<double> perTold(const std::vector<double>& after, const std::vector<double>& before) {
  std::vector<double> gains(after.size());
  for (std::size_t i = 0; i < after.size(); ++i) {
    const double gain = (after[i] - before[i]) * (kTold / kStep);
    gains[i] = std::isfinite(gain) ? gain : 0;
  }
  return gains;
}

}  // namespace

std::vector<PaintGain> paintGains(const Scene& room, const ExchangeOperator& exchange, const Repaint& paint,
                                  const std::vector<float>& light, const Intentions& asked) {
  const Intentions intentions = ofLightAlone(asked);
  Scene lit = litScene(room, paint, light);
  const PaintGain before = readingsOf(lit, intentions);
  const std::vector<std::uint32_t> surfaces = paintable(room);
  std::vector<PaintGain> gains;
  for (std::size_t first = 0; first < surfaces.size(); first += kTogether) {
    const std::vector<std::uint32_t> some(
        surfaces.begin() + static_cast<std::ptrdiff_t>(first),
        surfaces.begin() + static_cast<std::ptrdiff_t>(std::min(first + kTogether, surfaces.size())));
    const auto columns = static_cast<std::uint32_t>(some.size());
    const std::vector<float> more = paint.light(lightPerReflectance(room, exchange, light, some), columns);
    for (std::uint32_t j = 0; j < columns; ++j) {
      for (std::size_t p = 0; p < light.size(); ++p)
        lit.responses.illuminance[p] = light[p] + static_cast<float>(kStep) * more[j * light.size() + p];
      for (std::uint32_t p = 0; p < room.patches.count; ++p)
        lit.patches.reflectance[p] =
            paint.reflectance()[p] + (room.patches.surface[p] == some[j] ? static_cast<float>(kStep) : 0.0f);
      const PaintGain after = readingsOf(lit, intentions);
      gains.push_back(
          {some[j], perTold(after.goals, before.goals), perTold(after.constraints, before.constraints)});
    }
  }
  return gains;
}

}  // namespace fiatlux
