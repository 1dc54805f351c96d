// A model that is lit in a moment, with what a host must lend.
#pragma once

#include "precompute/files/scene_io.h"
#include "precompute/pipeline/pipeline.h"
#include "tests/precompute/gltf/gltf_builder.h"

namespace fiatlux::testing {

/// A closed box of 4 x 3 x 5 m with a mount of 20 sites.
inline ModelFile boxModel() { return {"rooms/box.glb", boxRoom({4, 3, 5}, 1).glb.bytes()}; }

inline SceneOptions quickOptions() {
  SceneOptions options;
  options.room.patch = 0.5;
  options.transport.rays = 32;
  return options;
}

inline Host plainHost() {
  Host host;
  host.deflate = zlibDeflate;
  return host;
}

}  // namespace fiatlux::testing
