#include "precompute/light/plane_points_light.h"

#include "precompute/light/measuring_grid.h"

namespace fiatlux {
namespace {

std::vector<MeasuringPoint> pointsOf(const std::vector<MeasuringGrid>& grids, std::uint32_t surface) {
  std::vector<MeasuringPoint> points;
  for (const MeasuringGrid& grid : grids)
    if (grid.surface == surface) points.insert(points.end(), grid.points.begin(), grid.points.end());
  return points;
}

/// One value a point, as the column of the one layout.
template <class ValueOf>
Responses columnOf(const std::vector<PointReading>& readings, const ValueOf& valueOf) {
  Responses column{static_cast<std::uint32_t>(readings.size()), 1, {}};
  for (const PointReading& reading : readings)
    column.illuminance.push_back(static_cast<float>(valueOf(reading)));
  return column;
}

}  // namespace

Result<std::vector<PlaneReading>> planeReadings(const Room& room, const RayTracer& tracer,
                                                const std::vector<PlaneWish>& wishes,
                                                const std::vector<Luminaire>& luminaires,
                                                const std::vector<float>& radiosity, PointOptions options) {
  const auto total = [](const PointReading& reading) { return reading.total; };
  std::vector<PlaneLight> planes;
  if (wishes.empty()) return std::vector<PlaneReading>{};
  const std::vector<MeasuringGrid> grids = measuringGrids(room);
  for (const PlaneWish& wish : wishes) {
    std::vector<MeasuringPoint> points = pointsOf(grids, wish.surface);
    if (points.empty())
      return Error{"planes: \"" + room.surfaces[wish.surface].name + "\" has no point of an EN 12464-1 grid"};
    options.spatial = true;
    const std::vector<PointReading> readings =
        readPoints(room, tracer, points, luminaires, radiosity, options);
    PlaneLight plane{wish.surface,
                     columnOf(readings, total),
                     columnOf(readings, [](const PointReading& reading) { return reading.cylindrical; }),
                     {}};
    options.spatial = false;
    for (const Vec3& direction : wish.directions) {
      for (MeasuringPoint& point : points) point.normal = direction;
      plane.verticals.push_back(
          {direction, columnOf(readPoints(room, tracer, points, luminaires, radiosity, options), total)});
    }
    planes.push_back(std::move(plane));
  }
  return readPlanes(planes, {{0}, {1}, 1});
}

}  // namespace fiatlux
