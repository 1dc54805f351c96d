#include "precompute/light/measuring_grid.h"

#include <algorithm>
#include <cmath>

#include "precompute/room/bounds.h"

namespace fiatlux {

namespace {

constexpr double kRim = 0.5;          // m
constexpr double kRoomEdge = 2;       // m: a smaller area is a task, not a room, and keeps its rim
constexpr double kFloorHeight = 0.1;  // m above the lowest point: still floor

/// The patch at (u, v) of a chart, or kNone.
std::uint32_t patchOn(const Chart& chart, double u, double v) {
  if (u < 0 || v < 0) return kNone;
  const auto column = static_cast<std::uint32_t>(u / chart.cellU),
             row = static_cast<std::uint32_t>(v / chart.cellV);
  return column < chart.columns && row < chart.rows ? chart.patchOfCell[row * chart.columns + column] : kNone;
}

/// Points of one chart that are not covered and whose rim lies on the chart too.
void addPoints(const Chart& chart, const Patches& patches, MeasuringGrid& grid) {
  const double length = chart.columns * chart.cellU, width = chart.rows * chart.cellV;
  grid.rim = std::min(length, width) > kRoomEdge ? kRim : 0;
  const double inner = length - 2 * grid.rim, across = width - 2 * grid.rim;
  grid.spacing = gridSpacing(inner, across);
  const auto columns = static_cast<std::uint32_t>(std::ceil(inner / grid.spacing));
  const auto rows = static_cast<std::uint32_t>(std::ceil(across / grid.spacing));
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      const double u = grid.rim + (column + 0.5) * inner / columns,
                   v = grid.rim + (row + 0.5) * across / rows;
      const double r = 0.999 * grid.rim;
      const auto isOff = [&](double du, double dv) { return patchOn(chart, u + du, v + dv) == kNone; };
      if (isOff(0, 0) || isOff(-r, 0) || isOff(r, 0) || isOff(0, -r) || isOff(0, r)) continue;
      if (!patches.counts(patchOn(chart, u, v))) continue;
      grid.points.push_back({chart.origin + u * chart.uAxis + v * chart.vAxis, chart.normal});
    }
  }
}

}  // namespace

double gridSpacing(double length, double width) {
  const double longer = std::max(length, width), shorter = std::min(length, width);
  const double d = longer >= 2 * shorter ? shorter : longer;
  return std::min(10.0, 0.2 * std::pow(5.0, std::log10(d)));
}

std::vector<MeasuringGrid> measuringGrids(const Room& room) {
  const double lowest = boundsOf(room.positions).low.y;
  std::vector<MeasuringGrid> grids;
  for (const Chart& chart : room.charts) {
    const bool measuring = room.surfaces[chart.surface].measuring;
    if (chart.normal.y < 0.999 || (!measuring && chart.origin.y > lowest + kFloorHeight)) continue;
    MeasuringGrid grid;
    grid.surface = chart.surface;
    addPoints(chart, room.patches, grid);
    if (!grid.points.empty()) grids.push_back(std::move(grid));
  }
  return grids;
}

std::vector<GridReading> readGrids(const Room& room, const RayTracer& tracer,
                                   const std::vector<Luminaire>& luminaires,
                                   const std::vector<float>& radiosity, PointOptions options) {
  options.spatial = false;
  std::vector<GridReading> results;
  for (MeasuringGrid& grid : measuringGrids(room)) {
    const std::vector<PointReading> readings =
        readPoints(room, tracer, grid.points, luminaires, radiosity, options);
    GridReading result{std::move(grid), 0, readings[0].total};
    for (const PointReading& reading : readings) {
      result.mean += reading.total / static_cast<double>(readings.size());
      result.least = std::min(result.least, reading.total);
    }
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace fiatlux
