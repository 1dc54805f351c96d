// The container of a glTF file, GLB chunks or plain JSON, and its JSON as a tree of limited depth and size.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

namespace fiatlux {

/// Where the parts of a file lie; refers to the file's bytes.
struct GltfContainer {
  const char* text = nullptr;  // the JSON, in UTF-8
  std::size_t textSize = 0;
  std::size_t binOffset = 0, binSize = 0;  // of a GLB's first binary chunk; 0 = there is none
};

/// Throws GltfError where it is neither, or where lengths lie.
GltfContainer openContainer(const std::vector<std::uint8_t>& bytes);

/// The one time that the JSON is parsed for this program. Throws GltfError where it is broken, too deep or
/// too large; nothing of it is checked beyond that.
nlohmann::json parseGltfJson(const GltfContainer& container);

}  // namespace fiatlux
