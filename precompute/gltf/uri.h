// The bytes behind an address in a glTF: data: inside the text, or a file beside it by a plain relative name.
// Nothing is fetched, and no name leads out of the file's own folder.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "precompute/gltf/refusal.h"
#include "precompute/gltf/source_scene.h"

namespace fiatlux {

struct MissingFile : GltfError {
  using GltfError::GltfError;
};

/// What `uri` means to a glTF whose siblings `resolve` knows (empty = it stands alone). `place` is for
/// messages; `budget` is what may still be read, bytes; `mimeType`, where wanted, becomes what a data:
/// address says of itself. Throws MissingFile where there is no such file, GltfError for everything else.
std::vector<std::uint8_t> bytesBehind(const std::string& uri, const Resolve& resolve,
                                      const std::string& place, std::size_t& budget,
                                      std::string* mimeType = nullptr);

}  // namespace fiatlux
