// The edges of the cells of floors beyond which there is no floor; see floor_plan.h.
#include "core/scene/floor_plan.h"

#include <algorithm>
#include <cmath>

#include "core/scene/calculation_grid.h"

namespace fiatlux {
namespace {

constexpr double kNarrowest = 0.5;  // m: narrower pieces are thresholds and feet

bool holds(const PatchLattice& lattice, const Vec3& place) {
  const Vec3 way = place - lattice.origin;
  return lattice.patchAt(dot(way, lattice.uAxis), dot(way, lattice.vAxis)) != kNone;
}

}  // namespace

double distance(const PlanPoint& point, const PlanSegment& segment) {
  const auto& [from, to] = segment;
  const double x = to[0] - from[0], z = to[1] - from[1], squared = x * x + z * z;
  const double along = squared > 0 ? ((point[0] - from[0]) * x + (point[1] - from[1]) * z) / squared : 0;
  const double share = std::clamp(along, 0.0, 1.0);
  return std::hypot(from[0] + share * x - point[0], from[1] + share * z - point[1]);
}

std::vector<PlanSegment> floorEdges(const Scene& scene) {
  std::vector<PatchLattice> floors = measuredLattices(scene);
  const auto isNoFloor = [&](const PatchLattice& each) {
    return scene.surfaces[each.surface].measuring ||
           std::min(each.columns * each.cellU, each.rows * each.cellV) < kNarrowest;
  };
  floors.erase(std::remove_if(floors.begin(), floors.end(), isNoFloor), floors.end());

  std::vector<PlanSegment> edges;
  for (const PatchLattice& floor : floors)
    for (std::size_t cell = 0; cell < floor.patchOfCell.size(); ++cell) {
      if (floor.patchOfCell[cell] == kNone) continue;
      const Vec3 u = floor.cellU * floor.uAxis, v = floor.cellV * floor.vAxis;
      const Vec3 middle = floor.origin + (static_cast<double>(cell % floor.columns) + 0.5) * u +
                          (static_cast<double>(cell / floor.columns) + 0.5) * v;
      for (const auto& [out, along] : {std::array{u, v}, {-u, v}, {v, u}, {-v, u}}) {
        const bool goesOn =
            std::any_of(floors.begin(), floors.end(),
                        [&, beyond = middle + out](const PatchLattice& each) { return holds(each, beyond); });
        const Vec3 from = middle + 0.5 * out - 0.5 * along, to = from + along;
        if (!goesOn) edges.push_back({{from.x, from.z}, {to.x, to.z}});
      }
    }
  return edges;
}

}  // namespace fiatlux
