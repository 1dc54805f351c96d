#include "core/transport/patch_tiles.h"

#include <cmath>

namespace fiatlux {

std::vector<PatchTile> patchTiles(const Patches& patches, const Charts& charts) {
  std::vector<PatchTile> tiles;
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    const Charts::Frame& frame = charts.frames[charts.ofRow[p]];
    const double part = std::sqrt(patches.area[p] / (frame.cellU * frame.cellV));
    const double u = part * frame.cellU, v = part * frame.cellV;
    tiles.push_back({u * frame.uAxis, v * frame.vAxis, u, v});
  }
  return tiles;
}

}  // namespace fiatlux
