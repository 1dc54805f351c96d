// How a glTF file is refused, and the largest sizes that are accepted.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace fiatlux {

/// Why a file is refused: one line with the place and the cure; the file's name is added by who catches it.
struct GltfError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The largest sizes that are accepted.
struct GltfBudget {
  static constexpr std::size_t kBytes = std::size_t{256} << 20;  // the file and all that it names
  static constexpr int kDepth = 64;                              // of the JSON
  static constexpr std::size_t kValues = 16'000'000;             // of the JSON
  static constexpr std::size_t kNodes = 1'000'000;
  static constexpr std::size_t kTriangles = 5'000'000;            // after instancing
  static constexpr int kImageEdge = 8192;                         // pixels
  static constexpr std::size_t kPixels = std::size_t{256} << 20;  // of all images
};

/// Sets of texture coordinates that are told apart.
inline constexpr int kMostTexCoords = 64;

/// "256 MB", as budgets are told.
inline std::string megabytes(std::size_t bytes) { return std::to_string(bytes >> 20) + " MB"; }

}  // namespace fiatlux
