// A glTF file as checked JSON with its bytes at hand: container, depth, sizes and addresses are verified
// here, before any glTF library sees them. Files named inside are opened only below the file's own folder.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace fiatlux {

struct GltfDocument {
  nlohmann::json json;                             // counts, indices and extents checked; uris removed
  std::vector<std::vector<std::uint8_t>> buffers;  // at least byteLength bytes each
  struct Image {
    std::vector<std::uint8_t> bytes;  // encoded; empty when no material needs it or it could not be read
    std::string mimeType;
  };
  std::vector<Image> images;
  std::vector<std::string> warnings;
  std::string hash;  // 16 hex digits over the file, its buffers and the images in use
};

/// Parses and checks. `folder` is where siblings may be opened; "" = nowhere. Throws GltfError
/// (gltf_refusal.h).
GltfDocument readGltfDocument(const std::vector<std::uint8_t>& bytes, const std::string& folder);

}  // namespace fiatlux
