#include "core/scene/plane_points.h"

#include <algorithm>
#include <limits>

#include "core/scene/zones.h"

namespace fiatlux {
namespace {

bool isSame(const Vec3& a, const Vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

/// Of values at the points; one without a value leaves none.
MeanAndLeast summed(const std::vector<double>& values) {
  MeanAndLeast result{0, std::numeric_limits<double>::infinity()};
  for (const double value : values) {
    result.mean += value / static_cast<double>(values.size());
    if (!(value >= result.least)) result.least = value;
  }
  return result;
}

/// lx at the points.
std::vector<double> lightOf(const Responses& responses, const Layout& layout) {
  std::vector<double> light(responses.rows);
  for (std::size_t i = 0; i < layout.sites.size(); ++i) {
    const float* column = responses.column(layout.sites[i]);
    for (std::size_t p = 0; p < light.size(); ++p) light[p] += layout.dimming * layout.flux[i] * column[p];
  }
  return light;
}

}  // namespace

std::vector<PlanePoint> pointsOnPlane(const Scene& scene, std::uint32_t surface) {
  std::vector<PlanePoint> points;
  if (!scene.surfaces[surface].measuring) return points;
  for (const PatchLattice& lattice : measuredLattices(scene)) {
    if (lattice.surface != surface) continue;
    const CalculationGrid grid = calculationGridOn(lattice, scene.patches, scene.surfaces[surface]);
    for (const auto& point : grid.points)
      points.push_back({lattice.origin + point[0] * lattice.uAxis + point[1] * lattice.vAxis,
                        sharesAt(lattice, scene.patches, point)});
  }
  return points;
}

Result<Done> checkPlane(const Scene& scene, std::uint32_t surface) {
  const std::string name = "\"" + scene.surfaces[surface].name + "\"";
  if (surface >= firstZone(scene))
    return Error{name +
                 " is a part of a measuring plane, and this is told of whole ones only; name the plane"};
  if (!scene.surfaces[surface].measuring)
    return Error{name + " is no measuring plane, and this is told of one only; name a measuring plane"};
  if (pointsOnPlane(scene, surface).empty())
    return Error{name +
                 " has no point of an EN 12464-1 grid: it is not level, or covered; name another plane"};
  return Done{};
}

bool isToldBy(const std::vector<PlaneLight>& planes, const PlaneWish& wish) {
  const auto plane = std::find_if(planes.begin(), planes.end(),
                                  [&](const PlaneLight& each) { return each.surface == wish.surface; });
  if (plane == planes.end()) return false;
  return std::all_of(wish.directions.begin(), wish.directions.end(), [&](const Vec3& direction) {
    return std::any_of(plane->verticals.begin(), plane->verticals.end(),
                       [&](const PlaneLight::Vertical& each) { return isSame(each.direction, direction); });
  });
}

double modellingOf(double cylindrical, double horizontal) {
  if (horizontal > 0) return cylindrical / horizontal;
  constexpr auto kLimits = std::numeric_limits<double>();
  return cylindrical > 0 ? kLimits.infinity() : kLimits.quiet_NaN();
}

std::vector<PlaneReading> readPlanes(const std::vector<PlaneLight>& planes, const Layout& layout) {
  std::vector<PlaneReading> readings;
  for (const PlaneLight& plane : planes) {
    PlaneReading reading{plane.surface, plane.horizontal.rows, {}, {}, {}, {}};
    const std::vector<double> horizontal = lightOf(plane.horizontal, layout);
    std::vector<double> ratios = lightOf(plane.cylindrical, layout);
    reading.horizontal = summed(horizontal);
    reading.cylindrical = summed(ratios);
    for (std::size_t p = 0; p < ratios.size(); ++p) ratios[p] = modellingOf(ratios[p], horizontal[p]);
    reading.modelling = summed(ratios);
    for (const PlaneLight::Vertical& vertical : plane.verticals)
      reading.verticals.push_back({vertical.direction, summed(lightOf(vertical.light, layout))});
    readings.push_back(std::move(reading));
  }
  return readings;
}

}  // namespace fiatlux
