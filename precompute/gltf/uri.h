// The bytes behind an address in a glTF: data: inside the text, or a file beside it. Nothing is fetched, and
// nothing outside the file's own folder is opened.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "precompute/gltf/refusal.h"

namespace fiatlux {

struct MissingFile : GltfError {
  using GltfError::GltfError;
};

/// Reads a file whole; throws GltfError when it is not a plain file or too large.
std::vector<std::uint8_t> readWholeFile(const std::string& path);

/// What `uri` means to a glTF in `folder` ("" = it stands alone). `place` is for messages; `budget` is what
/// may still be read, bytes; `mimeType`, where wanted, becomes what a data: address says of itself. Throws
/// MissingFile where there is no such file, GltfError for everything else.
std::vector<std::uint8_t> bytesBehind(const std::string& uri, const std::string& folder,
                                      const std::string& place, std::size_t& budget,
                                      std::string* mimeType = nullptr);

}  // namespace fiatlux
