// A glTF file as checked JSON with its bytes at hand: container, depth, sizes and addresses are verified
// here, before any glTF library sees them. Files named inside are opened only below the file's own folder.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace fiatlux {

/// Why a file is refused: one line with the place and the cure; the file's name is added by who catches it.
struct GltfError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

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

/// The largest sizes that are accepted.
struct GltfBudget {
  static constexpr std::size_t kBytes = std::size_t{256} << 20;  // the file and all that it names
  static constexpr int kDepth = 64;                              // of the JSON
  static constexpr std::size_t kValues = 16'000'000;             // of the JSON
  static constexpr std::size_t kNodes = 1'000'000;
  static constexpr std::size_t kTriangles = 5'000'000;  // after instancing
};

/// Reads a file whole; throws GltfError when it is not a plain file or too large.
std::vector<std::uint8_t> readWholeFile(const std::string& path);

/// Parses and checks. `folder` is where siblings may be opened; "" = nowhere. Throws GltfError.
GltfDocument readGltfDocument(const std::vector<std::uint8_t>& bytes, const std::string& folder);

/// Checks every count, index, extent and reference of the JSON (gltf_check.cpp). Throws GltfError.
void checkGltf(const nlohmann::json& json);

}  // namespace fiatlux
