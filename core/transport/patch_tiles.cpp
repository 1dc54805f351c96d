#include "core/transport/patch_tiles.h"

#include <cmath>

namespace fiatlux {

std::vector<PatchTile> patchTiles(const Patches& patches, const Charts& charts) {
  std::vector<PatchTile> tiles;
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    const Charts::Frame& frame = charts.frames[charts.ofRow[p]];
    const double part = std::sqrt(patches.area[p] / (frame.cellU * frame.cellV));
    const double longer = charts.aspect.empty() ? 1 : std::sqrt(Charts::aspectOf(charts.aspect[p]));
    const double u = part * frame.cellU * longer, v = part * frame.cellV / longer;
    tiles.push_back({u * frame.uAxis, v * frame.vAxis, u, v});
  }
  return tiles;
}

}  // namespace fiatlux
