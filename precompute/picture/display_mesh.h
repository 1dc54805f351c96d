// Room -> the picture's mesh: a .glb with the source's materials on triangles fine enough to carry the light.
#pragma once

#include <cstdint>
#include <vector>

#include "precompute/gltf/source_scene.h"
#include "precompute/room/room.h"

namespace fiatlux {

/// The bytes of a .glb for three's GLTFLoader. One node and mesh per leaf surface and material; its name is
/// the surface's, its extras {"surface": name, "surfaceIndex": i, "measuring": true on measuring planes}.
/// Attributes POSITION (m), NORMAL, TEXCOORD_0 where textured, COLOR_0 where the source has it, and
///   _PATCHES (VEC4, UNSIGNED_SHORT while indices fit, else FLOAT): up to four patches (or receivers) a
///   vertex blends, _WEIGHTS (VEC4, UNSIGNED_BYTE normalised): their shares, which sum to 1.
/// Light at a vertex = sum of share x light of patch: bilinear in a chart's grid, across smooth edges also
/// between charts, never across creases or surfaces. What carries no light (glass) follows with extras
/// {"lit": false}.
std::vector<std::uint8_t> displayMesh(const SourceScene& source, const Room& room);

}  // namespace fiatlux
