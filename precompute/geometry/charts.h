// Charts: pieces of a surface that are near enough to a plane to be cut by one grid.
#pragma once

#include <vector>

#include "precompute/geometry/room_options.h"
#include "precompute/geometry/surfaces.h"
#include "precompute/room/room.h"

namespace fiatlux {

/// A chart before its cells: frame and grid (Chart), and the faces that lie in it.
struct ChartDraft {
  Chart chart;
  std::vector<Face> faces;
  double area = 0;    // m2
  bool flat = false;  // one plane: cells that are whole are exact rectangles
};

/// Cuts each surface of `tree` into charts for patches of edge `patch`. Planes wider than a patch are charts
/// by themselves; the rest grows together up to 35 degrees from its mean normal. Surface indices are shifted
/// by `firstSurface`.
std::vector<ChartDraft> makeCharts(const WeldedMesh& mesh, const SurfaceTree& tree, double patch,
                                   std::uint32_t firstSurface);

/// How many patches charts will have, about.
double foreseenPatches(const std::vector<ChartDraft>& charts);

/// Refuses grids that are too fine for --memory, before they are cut, by a CommandError; `patch` in m, at
/// most `mostClusters` outside --paper.
void checkGrids(const std::vector<ChartDraft>& charts, const RoomOptions& options, double patch,
                std::uint32_t mostClusters);

}  // namespace fiatlux
