// A glTF file as checked JSON with its bytes at hand: container, depth, sizes and addresses are verified
// here, before any glTF library sees them.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "precompute/gltf/source_scene.h"

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

/// Parses and checks; siblings come from `resolve` (empty: it has none). Throws GltfError (refusal.h).
GltfDocument readGltfDocument(const std::vector<std::uint8_t>& bytes, const Resolve& resolve);

}  // namespace fiatlux
