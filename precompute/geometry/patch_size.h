// How long a patch is to be: as it is said, or so that a room has about 25 000 of them, none needlessly
// short.
#pragma once

#include <vector>

#include "precompute/geometry/charts.h"

namespace fiatlux {

/// A patch size and the charts for it.
struct Cut {
  double patch = 0;  // m
  std::vector<ChartDraft> charts;
};

/// options.patch, or the size that gives about 25 000 patches, between 0.1 and 0.5 m (huge rooms: up to 100
/// 000 patches), and where a mount's site spacing is known a whole fraction of it, so that squares of light
/// end where patches do.
Cut cutOf(const SourceScene& source, const WeldedMesh& mesh, const SurfaceTree& tree,
          const RoomOptions& options);

}  // namespace fiatlux
