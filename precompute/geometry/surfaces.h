// The surface tree: which faces a person would point at together, and what they are called.
// node -> node/material -> node/material/region; `extras.fiatlux.surface` overrides; backs of sheets are
// their own.
#pragma once

#include <string>
#include <vector>

#include "precompute/base/names.h"
#include "precompute/geometry/flat_regions.h"
#include "precompute/geometry/small_parts.h"

namespace fiatlux {

/// Faces that may share charts (one node and material, or one named surface), with the leaf of each planar
/// region.
struct SurfaceGroup {
  FaceSet set;
  std::vector<Region> regions;
  std::vector<std::uint32_t> leafOfRegion;  // index into SurfaceTree::names
};

struct SurfaceTree {
  std::vector<std::string> names;  // of the leaves, unique
  std::vector<SurfaceGroup> groups;
  std::vector<std::string> warnings;
};

/// Of all regions together, m2.
double areaOf(const SurfaceTree& tree);

/// Groups all `faces` (fronts, and backs of sheets) of a welded mesh. `regionShare` of the whole area makes a
/// plane a surface of its own; 0 = never (measuring planes). Names are taken from `names`; those of the small
/// nodes of a crowded scene come from `smallParts`, without them they are all one surface.
SurfaceTree findSurfaces(const SourceScene& source, const WeldedMesh& mesh, const std::vector<Face>& faces,
                         double regionShare, UniqueNames& names, SmallParts* smallParts = nullptr);

}  // namespace fiatlux
