// Points by the rule, and the lattices of patches that they are read from; see calculation_grid.h.
#include "core/scene/calculation_grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "core/scene/zones.h"

namespace fiatlux {
namespace {

constexpr double kWidestRim = 0.5, kWidestSpacing = 10;  // m
constexpr double kRimShare = 0.15;                       // of the shorter side
constexpr double kFloorHeight = 0.1;                     // m above the lowest point: still floor
constexpr double kNarrowestFloor = 0.5;                  // m
constexpr double kLevel = 0.999;                         // least upward part of a level normal

/// The step from a neighbour of the same lattice to a patch, between the two largest cells that have one.
struct Step {
  Vec3 way;
  double area = 0;  // m2, of the smaller cell

  void take(const Patches& patches, std::uint32_t from, std::uint32_t to) {
    const double smaller = std::min(patches.area[from], patches.area[to]);
    if (smaller > area * (1 + 1e-9)) *this = {patches.center[to] - patches.center[from], smaller};
  }
};

/// A whole cell of a lattice, and the edges of its cells as vectors.
struct Cell {
  std::uint32_t patch = kNone;
  Vec3 u, v;
};

/// Of a single row or column of cells the other direction follows from the normal and the area.
Cell wholeCellOf(const Patches& patches, const std::vector<std::uint32_t>& members) {
  std::vector<char> isMember(patches.rows(), 0);
  for (const std::uint32_t p : members) isMember[p] = 1;
  Step along, across;
  std::uint32_t whole = members[0];
  for (const std::uint32_t p : members) {
    if (patches.left[p] != kNone && isMember[patches.left[p]]) along.take(patches, patches.left[p], p);
    if (patches.up[p] != kNone && isMember[patches.up[p]]) across.take(patches, patches.up[p], p);
    if (patches.area[p] > patches.area[whole] * (1 + 1e-9)) whole = p;
  }
  const Vec3 up = patches.normal[whole];
  const double area = patches.area[whole];
  if (along.area == 0 && across.area == 0) along = {std::sqrt(area) * normalized(cross({0, 0, 1}, up)), area};
  if (along.area == 0) along.way = area / length(across.way) * normalized(cross(across.way, up));
  if (across.area == 0) across.way = area / length(along.way) * normalized(cross(up, along.way));
  return {whole, along.way, across.way};
}

/// The lattice that the rows of one chart lie on. `members` is not empty.
PatchLattice latticeOf(const Patches& patches, const std::vector<std::uint32_t>& members) {
  const Cell whole = wholeCellOf(patches, members);
  const Vec3 middle = patches.center[whole.patch];
  PatchLattice lattice;
  lattice.surface = patches.surface[whole.patch];
  lattice.cellU = length(whole.u), lattice.cellV = length(whole.v);
  lattice.uAxis = normalized(whole.u), lattice.vAxis = normalized(whole.v);
  const auto cellOf = [&](std::uint32_t p) {
    const Vec3 way = patches.center[p] - middle;
    return std::array<long, 2>{std::lround(dot(way, lattice.uAxis) / lattice.cellU),
                               std::lround(dot(way, lattice.vAxis) / lattice.cellV)};
  };
  std::vector<std::array<long, 2>> cells;
  for (const std::uint32_t p : members) cells.push_back(cellOf(p));
  std::array<long, 2> first = {0, 0}, last = {0, 0};
  for (const std::array<long, 2>& cell : cells)
    for (const int axis : {0, 1}) {
      first[axis] = std::min(first[axis], cell[axis]);
      last[axis] = std::max(last[axis], cell[axis]);
    }
  lattice.columns = static_cast<std::uint32_t>(last[0] - first[0] + 1);
  lattice.rows = static_cast<std::uint32_t>(last[1] - first[1] + 1);
  lattice.origin = middle + (static_cast<double>(first[0]) - 0.5) * whole.u +
                   (static_cast<double>(first[1]) - 0.5) * whole.v;
  lattice.patchOfCell.assign(std::size_t{lattice.columns} * lattice.rows, kNone);
  for (std::size_t i = 0; i < cells.size(); ++i)
    lattice.patchOfCell[static_cast<std::size_t>(cells[i][1] - first[1]) * lattice.columns +
                        static_cast<std::size_t>(cells[i][0] - first[0])] = members[i];
  return lattice;
}

}  // namespace

GridRule gridRule(double length, double width, double border, bool hasRim) {
  assert(length > 0 && width > 0 && border >= 0);
  GridRule rule;
  const double whole = std::min(length, width) + 2 * border;  // the shorter side of what is measured
  if (hasRim) rule.rim = std::max(0.0, std::min(kWidestRim, kRimShare * whole) - border);
  const double inner = length - 2 * rule.rim, across = width - 2 * rule.rim;
  const double longer = std::max(inner, across), shorter = std::min(inner, across);
  const double d = longer >= 2 * shorter ? shorter : longer;
  rule.spacing = std::min(kWidestSpacing, 0.2 * std::pow(5.0, std::log10(d)));
  // note: a side that is a whole number of spacings must not get one more for the last bit of a sum.
  const auto count = [&](double side) {
    return static_cast<std::uint32_t>(std::max(1.0, std::ceil(side / rule.spacing - 1e-9)));
  };
  rule.columns = count(inner), rule.rows = count(across);
  return rule;
}

std::uint32_t PatchLattice::patchAt(double u, double v) const {
  if (u < 0 || v < 0) return kNone;
  const auto column = static_cast<std::uint32_t>(u / cellU), row = static_cast<std::uint32_t>(v / cellV);
  return column < columns && row < rows ? patchOfCell[std::size_t{row} * columns + column] : kNone;
}

CalculationGrid calculationGridOn(const PatchLattice& lattice, const Patches& patches, const Surface& surface,
                                  bool hasRim) {
  const double along = lattice.columns * lattice.cellU, across = lattice.rows * lattice.cellV;
  CalculationGrid grid{gridRule(along, across, surface.border, hasRim), {}};
  if (!surface.measuring && std::min(along, across) < kNarrowestFloor) return grid;
  const double rim = grid.rule.rim, r = 0.999 * rim;
  const std::uint32_t columns = grid.rule.columns, rows = grid.rule.rows;
  for (std::uint32_t row = 0; row < rows; ++row)
    for (std::uint32_t column = 0; column < columns; ++column) {
      const double u = rim + (column + 0.5) * (along - 2 * rim) / columns,
                   v = rim + (row + 0.5) * (across - 2 * rim) / rows;
      const auto isOff = [&](double du, double dv) { return lattice.patchAt(u + du, v + dv) == kNone; };
      if (isOff(0, 0) || isOff(-r, 0) || isOff(r, 0) || isOff(0, -r) || isOff(0, r)) continue;
      if (patches.counts(lattice.patchAt(u, v))) grid.points.push_back({u, v});
    }
  return grid;
}

bool wantsGrid(const Surface& surface, const Vec3& normal, double height, double lowest) {
  return normal.y >= kLevel && (surface.measuring || height <= lowest + kFloorHeight);
}

std::vector<PatchLattice> measuredLattices(const Scene& scene) {
  const Patches& patches = scene.patches;
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vec3& center : patches.center) lowest = std::min(lowest, center.y);
  // Where a file knows its charts, each is a lattice of its own; else each surface is one.
  const std::vector<std::uint32_t>& chartOf =
      scene.lightOperator ? scene.lightOperator->charts.ofRow : patches.surface;
  std::map<std::array<std::uint32_t, 2>, std::vector<std::uint32_t>> members;
  for (std::uint32_t p = 0; p < patches.rows(); ++p)
    if (wantsGrid(scene.surfaces[patches.surface[p]], patches.normal[p], patches.center[p].y, lowest))
      members[{patches.surface[p], chartOf[p]}].push_back(p);
  std::vector<PatchLattice> lattices;
  for (const auto& [of, rows] : members) lattices.push_back(latticeOf(patches, rows));
  return lattices;
}

std::vector<PatchLattice> zoneLattices(const Scene& scene) {
  std::vector<PatchLattice> lattices;
  for (std::size_t z = 0; z < scene.zones.size(); ++z) {
    const std::vector<std::uint32_t>& rows = scene.zones[z].rows;
    if (scene.patches.normal[rows[0]].y < kLevel) continue;
    lattices.push_back(latticeOf(scene.patches, rows));
    lattices.back().surface = firstZone(scene) + static_cast<std::uint32_t>(z);
  }
  return lattices;
}

std::vector<PatchShare> sharesAt(const PatchLattice& lattice, const Patches& patches,
                                 const std::array<double, 2>& point) {
  const double u = std::clamp(point[0] / lattice.cellU - 0.5, 0.0, lattice.columns - 1.0);
  const double v = std::clamp(point[1] / lattice.cellV - 0.5, 0.0, lattice.rows - 1.0);
  const auto column = static_cast<std::uint32_t>(u), row = static_cast<std::uint32_t>(v);
  std::vector<PatchShare> shares;
  double weights = 0;
  for (const std::uint32_t i : {0u, 1u})
    for (const std::uint32_t j : {0u, 1u}) {
      if (column + i >= lattice.columns || row + j >= lattice.rows) continue;
      const std::uint32_t p = lattice.patchOfCell[std::size_t{row + j} * lattice.columns + column + i];
      if (p == kNone || !patches.counts(p)) continue;
      shares.push_back({p, std::fabs(1.0 - i - (u - column)) * std::fabs(1.0 - j - (v - row))});
      weights += shares.back().share;
    }
  assert(weights > 0);
  for (PatchShare& share : shares) share.share /= weights;
  return shares;
}

GridReading gridReading(std::uint32_t surface, const CalculationGrid& grid, double border,
                        const std::vector<double>& values) {
  assert(!values.empty() && values.size() == grid.points.size());
  GridReading reading{surface, static_cast<std::uint32_t>(values.size()), grid.rule.spacing,
                      border + grid.rule.rim};
  reading.least = reading.most = values[0];
  for (const double value : values) {
    reading.mean += value / static_cast<double>(values.size());
    reading.least = std::min(reading.least, value);
    reading.most = std::max(reading.most, value);
  }
  return reading;
}

std::vector<std::vector<PatchShare>> gridPointsOf(const Scene& scene, std::uint32_t surface) {
  const bool isZone = surface >= firstZone(scene);
  std::vector<std::vector<PatchShare>> points;
  for (const PatchLattice& lattice : isZone ? zoneLattices(scene) : measuredLattices(scene)) {
    if (lattice.surface != surface) continue;
    const CalculationGrid grid = calculationGridOn(lattice, scene.patches, scene.surfaces[surface], !isZone);
    for (const auto& point : grid.points) points.push_back(sharesAt(lattice, scene.patches, point));
  }
  return points;
}

CalculationGrids::CalculationGrids(const Scene& scene) { add(scene, measuredLattices(scene), true); }

CalculationGrids CalculationGrids::ofZones(const Scene& scene) {
  CalculationGrids grids;
  grids.add(scene, zoneLattices(scene), false);
  return grids;
}

void CalculationGrids::add(const Scene& scene, const std::vector<PatchLattice>& lattices, bool hasRim) {
  for (const PatchLattice& lattice : lattices) {
    const Surface& surface = scene.surfaces[lattice.surface];
    Grid grid{
        lattice.surface, surface.border, calculationGridOn(lattice, scene.patches, surface, hasRim), {}};
    for (const auto& point : grid.of.points) grid.points.push_back(sharesAt(lattice, scene.patches, point));
    if (!grid.points.empty()) grids_.push_back(std::move(grid));
  }
}

std::vector<GridReading> CalculationGrids::read(const std::vector<float>& light) const {
  std::vector<GridReading> result;
  for (const Grid& grid : grids_) {
    std::vector<double> values;
    for (const std::vector<PatchShare>& point : grid.points) {
      double sum = 0;
      for (const PatchShare& share : point) sum += share.share * light[share.row];
      values.push_back(sum);
    }
    result.push_back(gridReading(grid.surface, grid.of, grid.border, values));
  }
  return result;
}

std::vector<GridReading> readGrids(const Scene& scene, const std::vector<float>& light) {
  std::vector<GridReading> readings = CalculationGrids(scene).read(light);
  const std::vector<GridReading> ofZones = CalculationGrids::ofZones(scene).read(light);
  readings.insert(readings.end(), ofZones.begin(), ofZones.end());
  return readings;
}

}  // namespace fiatlux
