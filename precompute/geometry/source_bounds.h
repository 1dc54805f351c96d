// The box around all meshes of a scene as it was read.
#pragma once

#include "precompute/gltf/source_scene.h"
#include "precompute/room/bounds.h"

namespace fiatlux {

/// In the units of the scene's positions; empty where it has none.
inline Bounds boundsOf(const SourceScene& source) {
  Bounds bounds;
  for (const SourceMesh& mesh : source.meshes)
    for (const Vec3& p : mesh.positions) bounds.include(p);
  return bounds;
}

}  // namespace fiatlux
