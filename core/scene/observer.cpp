#include "core/scene/observer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fiatlux {
namespace {

constexpr double kUpwards = 0.9;     // of a normal's y: what one stands on or works at
constexpr double kLeastPitch = 1.5;  // m, between places
constexpr double kWiderPitch = 1.1;  // until there are few enough
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Rows of working planes that count; of all that faces up where there are none.
std::vector<std::uint32_t> rowsToSitAt(const Patches& patches) {
  std::vector<std::uint32_t> planes, floors;
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    if (patches.normal[p].y < kUpwards) continue;
    if (p < patches.count)
      floors.push_back(p);
    else if (patches.counts(p))
      planes.push_back(p);
  }
  return planes.empty() ? floors : planes;
}

/// At most `distance` apart on the plan; most of what is not is found out without a root.
bool isWithin(double distance, double x, double z) {
  return std::abs(x) <= distance && std::abs(z) <= distance && std::hypot(x, z) <= distance;
}

/// Places `pitch` apart, centred over the rows, each within a quarter of a pitch of one of them, as high as
/// that row.
std::vector<Vec3> placesAt(const Patches& patches, const std::vector<std::uint32_t>& rows, double pitch) {
  double lowX = kInfinity, highX = -kInfinity, lowZ = kInfinity, highZ = -kInfinity;
  for (const std::uint32_t p : rows) {
    lowX = std::min(lowX, patches.center[p].x), highX = std::max(highX, patches.center[p].x);
    lowZ = std::min(lowZ, patches.center[p].z), highZ = std::max(highZ, patches.center[p].z);
  }
  const auto columns = static_cast<std::uint32_t>((highX - lowX) / pitch) + 1,
             lines = static_cast<std::uint32_t>((highZ - lowZ) / pitch) + 1;
  const double startX = (lowX + highX - (columns - 1) * pitch) / 2,
               startZ = (lowZ + highZ - (lines - 1) * pitch) / 2;
  std::vector<Vec3> places;
  for (std::uint32_t i = 0; i < lines * columns; ++i) {
    const double x = startX + (i % columns) * pitch, z = startZ + (i / columns) * pitch;
    double nearest = pitch / 4;
    std::uint32_t at = kNone;
    for (const std::uint32_t p : rows) {
      const double besideX = patches.center[p].x - x, besideZ = patches.center[p].z - z;
      if (!isWithin(nearest, besideX, besideZ)) continue;
      const double apart = std::hypot(besideX, besideZ);
      if (apart < nearest) nearest = apart, at = p;
    }
    if (at != kNone) places.push_back({x, patches.center[at].y, z});
  }
  return places;
}

/// The lowest of what faces up beneath a place or beside it.
double floorBelow(const Patches& patches, const Vec3& place) {
  constexpr double kBeside = 1;  // m
  double floor = place.y;
  for (std::uint32_t p = 0; p < patches.count; ++p) {
    const Vec3& center = patches.center[p];
    if (patches.normal[p].y < kUpwards || !isWithin(kBeside, center.x - place.x, center.z - place.z))
      continue;
    floor = std::min(floor, center.y);
  }
  return floor;
}

}  // namespace

double glareRatio(const ObserverReading& reading) {
  if (!(reading.glare > 0)) return 0;
  return reading.background > 0 ? reading.glare / reading.background : kInfinity;
}

double ugrOf(double ratio) { return ratio > 0 ? 8 * std::log10(ratio) : -kInfinity; }

double ratioOf(double ugr) { return std::pow(10, ugr / 8); }

std::vector<ObserverReading> readObservers(const std::vector<ObserverRows>& observers, const Layout& layout) {
  std::vector<ObserverReading> readings;
  for (const ObserverRows& rows : observers) {
    ObserverReading reading;
    for (std::size_t i = 0; i < layout.sites.size(); ++i) {
      const double flux = layout.dimming * layout.flux[i];
      reading.glare += flux * flux * rows.glare[layout.sites[i]];
      reading.background += flux * rows.background[layout.sites[i]];
      reading.vertical += flux * rows.vertical[layout.sites[i]];
      reading.cylindrical += flux * rows.cylindrical[layout.sites[i]];
    }
    readings.push_back(reading);
  }
  return readings;
}

std::vector<Observer> observersInRoom(const Patches& patches) {
  const std::vector<std::uint32_t> rows = rowsToSitAt(patches);
  if (rows.empty()) return {};
  double pitch = kLeastPitch;
  std::vector<Vec3> places = placesAt(patches, rows, pitch);
  while (places.size() > kMostPlaces) places = placesAt(patches, rows, pitch *= kWiderPitch);
  std::vector<Observer> observers;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vec3 eye{places[i].x, floorBelow(patches, places[i]) + kEyeHeight, places[i].z};
    std::string name = "P";
    name += std::to_string(i + 1);
    observers.push_back({name + " +x", eye, {1, 0, 0}});
    observers.push_back({name + " -x", eye, {-1, 0, 0}});
    observers.push_back({name + " +z", eye, {0, 0, 1}});
    observers.push_back({name + " -z", eye, {0, 0, -1}});
  }
  return observers;
}

}  // namespace fiatlux
