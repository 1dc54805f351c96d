#include "precompute/light/measuring_grid.h"

#include <utility>

#include "precompute/room/bounds.h"

namespace fiatlux {

std::vector<MeasuringGrid> measuringGrids(const Room& room) {
  const double lowest = boundsOf(room.positions).low.y;
  std::vector<MeasuringGrid> grids;
  for (const Chart& chart : room.charts) {
    if (!wantsGrid(room.surfaces[chart.surface], chart.normal, chart.origin.y, lowest)) continue;
    const PatchLattice lattice{chart.surface, chart.origin,  chart.uAxis, chart.vAxis,      chart.cellU,
                               chart.cellV,   chart.columns, chart.rows,  chart.patchOfCell};
    MeasuringGrid grid{
        chart.surface, calculationGridOn(lattice, room.patches, room.surfaces[chart.surface]), {}};
    for (const auto& [u, v] : grid.grid.points)
      grid.points.push_back({chart.origin + u * chart.uAxis + v * chart.vAxis, chart.normal});
    if (!grid.points.empty()) grids.push_back(std::move(grid));
  }
  return grids;
}

std::vector<GridReading> readGrids(const Room& room, const RayTracer& tracer,
                                   const std::vector<Luminaire>& luminaires,
                                   const std::vector<float>& radiosity, PointOptions options) {
  options.spatial = false;
  std::vector<GridReading> readings;
  for (const MeasuringGrid& grid : measuringGrids(room)) {
    std::vector<double> values;
    for (const PointReading& reading : readPoints(room, tracer, grid.points, luminaires, radiosity, options))
      values.push_back(reading.total);
    readings.push_back(gridReading(grid.surface, grid.grid, room.surfaces[grid.surface].border, values));
  }
  return readings;
}

}  // namespace fiatlux
