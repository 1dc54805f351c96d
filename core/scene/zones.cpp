#include "core/scene/zones.h"

#include <algorithm>
#include <set>

#include "core/scene/stored_statistics.h"

namespace fiatlux {
namespace {

Result<Done> check(const Scene& scene, const std::vector<Zone>& zones) {
  std::set<std::string> names = {"all"};
  for (std::uint32_t s = 0; s < firstZone(scene); ++s) names.insert(scene.surfaces[s].name);
  for (const Zone& zone : zones) {
    const std::string what = "area \"" + zone.name + "\": ";
    if (!names.insert(zone.name).second) return Error{what + "something else has that name; choose another"};
    if (zone.leaf >= firstZone(scene)) return Error{what + "it is of no surface of this room"};
    if (zone.rows.empty())
      return Error{what + "it holds no point of \"" + scene.surfaces[zone.leaf].name + "\"; make it larger"};
    for (std::size_t i = 0; i < zone.rows.size(); ++i) {
      const std::uint32_t p = zone.rows[i];
      if (p >= scene.patches.rows() || scene.patches.surface[p] != zone.leaf || !scene.patches.counts(p) ||
          (i > 0 && zone.rows[i - 1] >= p))
        return Error{what + "its rows are not those of its surface"};
    }
  }
  return Done{};
}

void drop(Scene& scene) {
  const std::uint32_t first = firstZone(scene);
  scene.surfaces.resize(first);
  if (scene.errorBound.size() > first) scene.errorBound.resize(first);
  if (scene.illuminance.size() > first) scene.illuminance.resize(first);
  if (scene.exitance.size() > first) scene.exitance.resize(first);
  if (scene.direct) scene.direct->statistics.resize(first);
  scene.zones.clear();
}

}  // namespace

SurfaceStatistics zoneMeans(const Scene& scene, const Responses& responses, const Zone& zone) {
  return {storedStatistics(scene.patches, responses, Quantity::kIlluminance, zone.rows).mean, {}};
}

Result<Done> takeZones(Scene& scene, const std::vector<Zone>& zones) {
  if (Result<Done> sound = check(scene, zones); !sound) return sound;
  drop(scene);
  // A scene of candidates makes covariances where they are asked for; of exitance it has no illuminance.
  const bool withCovariance = !scene.illuminance.empty() && !scene.illuminance[0].covariance.empty();
  for (const Zone& zone : zones) {
    Surface surface;
    surface.name = zone.name;
    for (const std::uint32_t p : zone.rows) surface.area += scene.patches.area[p];
    surface.patches = static_cast<std::uint32_t>(zone.rows.size());
    surface.measuring = true;
    surface.lost = scene.surfaces[zone.leaf].lost;
    scene.surfaces.push_back(std::move(surface));
    if (!scene.errorBound.empty()) scene.errorBound.push_back(scene.errorBound[zone.leaf]);
    if (!scene.exitance.empty()) scene.exitance.emplace_back();
    if (scene.direct) scene.direct->statistics.push_back(zoneMeans(scene, scene.direct->responses, zone));
    if (scene.illuminance.empty()) continue;
    SurfaceStatistics statistics =
        storedStatistics(scene.patches, scene.responses, Quantity::kIlluminance, zone.rows);
    if (!withCovariance) statistics.covariance.clear();
    scene.illuminance.push_back(std::move(statistics));
  }
  scene.zones = zones;
  return Done{};
}

}  // namespace fiatlux
