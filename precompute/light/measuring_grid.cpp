#include "precompute/light/measuring_grid.h"

#include <iterator>
#include <utility>

#include "precompute/rays/hemisphere.h"
#include "precompute/room/bounds.h"

namespace fiatlux {

namespace {

constexpr double kTouching = 0.02;  // m: what stands closer over a place hides it

/// Straight on and aslant: from within a body its inside is met in all of these directions.
constexpr Vec3 kLooks[] = {{0, 0, 1}, {1, 0, 1}, {-1, 0, 1}, {0, 1, 1}, {0, -1, 1}};

/// Whether a point is under what stands there, or in it.
bool isHidden(const Room& room, const RayTracer& tracer, const MeasuringPoint& point) {
  const Frame frame(point.normal);
  const Vec3 origin = point.position + tracer.offset() * point.normal;
  std::size_t insides = 0;
  for (const Vec3& look : kLooks) {
    const Vec3 direction = normalized(look.x * frame.x + look.y * frame.y + look.z * frame.z);
    const auto [triangle, distance] = tracer.firstHit(origin, direction);
    if (triangle == kNone) return false;
    if (&look == kLooks && distance < kTouching) return true;
    insides += room.patchMet(origin, direction, triangle, distance) == kNone;
  }
  return insides == std::size(kLooks);
}

/// What the patches around a point of a grid get, as a scene file tells it (calculation_grid.h).
double readBeside(const Room& room, const MeasuringGrid& grid, std::size_t point,
                  const std::vector<float>& illuminance) {
  double value = 0;
  for (const PatchShare& share : sharesAt(grid.lattice, room.patches, grid.grid.points[point]))
    value += share.share * illuminance[share.row];
  return value;
}

}  // namespace

std::vector<MeasuringGrid> measuringGrids(const Room& room) {
  const double lowest = boundsOf(room.positions).low.y;
  std::vector<MeasuringGrid> grids;
  for (const Chart& chart : room.charts) {
    if (!wantsGrid(room.surfaces[chart.surface], chart.normal, chart.origin.y, lowest)) continue;
    const PatchLattice lattice{chart.surface, chart.origin,  chart.uAxis, chart.vAxis,      chart.cellU,
                               chart.cellV,   chart.columns, chart.rows,  chart.patchOfCell};
    MeasuringGrid grid{
        chart.surface, lattice, calculationGridOn(lattice, room.patches, room.surfaces[chart.surface]), {}};
    for (const auto& [u, v] : grid.grid.points)
      grid.points.push_back({chart.origin + u * chart.uAxis + v * chart.vAxis, chart.normal});
    if (!grid.points.empty()) grids.push_back(std::move(grid));
  }
  return grids;
}

std::vector<GridReading> readGrids(const Room& room, const RayTracer& tracer,
                                   const std::vector<Luminaire>& luminaires,
                                   const std::vector<float>& radiosity, const std::vector<float>& illuminance,
                                   PointOptions options) {
  options.spatial = false;
  std::vector<GridReading> readings;
  for (const MeasuringGrid& grid : measuringGrids(room)) {
    std::vector<double> values;
    for (const PointReading& reading : readPoints(room, tracer, grid.points, luminaires, radiosity, options))
      values.push_back(reading.total);
    for (std::size_t i = 0; i < values.size(); ++i)
      if (isHidden(room, tracer, grid.points[i])) values[i] = readBeside(room, grid, i, illuminance);
    readings.push_back(gridReading(grid.surface, grid.grid, room.surfaces[grid.surface].border, values));
  }
  return readings;
}

}  // namespace fiatlux
