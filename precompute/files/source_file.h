// A model on the disk: its bytes, and the files beside it that it may name. Nothing outside its own folder is
// opened.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "precompute/gltf/source_scene.h"

namespace fiatlux {

/// The whole of a .glb or .gltf; an error where it is no plain file, or larger than what is accepted.
Result<std::vector<std::uint8_t>> readModelFile(const std::string& path);

/// The files in the folder of the model at `path`, and below; not what links lead to outside of it.
Resolve siblingsOf(const std::string& path);

}  // namespace fiatlux
