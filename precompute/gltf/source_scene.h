// A glTF 2.0 file, checked and flattened into world-space triangles with materials; the boundary beyond which
// no tinygltf type passes (model.h).
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/vec3.h"
#include "precompute/gltf/codes.h"

namespace fiatlux {

/// An image decoded to 8-bit RGBA, rows top to bottom; sRGB encoded.
struct SourceImage {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
  std::vector<std::uint8_t> encoded;  // the file's own PNG or JPEG bytes, for the display mesh
  std::string mimeType;
};

struct SourceMaterial {
  std::string name;
  std::array<double, 4> baseColor{1, 1, 1, 1};  // linear factor
  int image = -1;                               // index of the base-colour texture's image, -1 none
  int texCoord = 0;
  // Offset u, v, scale u, v, rotation (KHR_texture_transform).
  std::array<double, 5> uvTransform{0, 0, 1, 1, 0};
  int wrapS = gltf::kRepeat, wrapT = gltf::kRepeat;
  bool doubleSided = false, unlit = false;
  double roughness = 1, metallic = 0;  // for display only: all surfaces are diffuse to the solver
  enum class Alpha { kOpaque, kMask, kBlend } alpha = Alpha::kOpaque;
};

/// `extras.fiatlux` of a node.
struct NodeExtras {
  std::string surface;                // "" = none
  std::optional<double> reflectance;  // 0..0.95
  bool mount = false, measure = false;
  std::optional<double> siteSpacing;  // m
  std::optional<double> siteSize;     // m
  std::optional<double> drop;         // m, that luminaires hang below the mount
  std::optional<double> border;       // m, that a measuring plane stays away from what it measures' edges
};

/// One primitive of one node instance, in world space (metres after --scale), triangulated, mirrored
/// transforms undone so that counter-clockwise is the front.
struct SourceMesh {
  std::string node;             // plain name of the node ("node 7" where the file has none)
  std::uint32_t nodeIndex = 0;  // of the glTF; instances of one mesh on several nodes differ here
  int material = -1;            // -1 = glTF's default material
  NodeExtras extras;
  std::vector<Vec3> positions;
  std::vector<std::array<float, 3>> normals;  // unit, empty where the file has none
  std::vector<std::array<float, 2>> uv;       // set `texCoord` of the material, empty where absent
  std::vector<std::array<float, 4>> colors;   // COLOR_0, linear, empty where absent
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

struct SourceScene {
  std::vector<SourceMesh> meshes;
  std::vector<SourceMaterial> materials;
  std::vector<SourceImage> images;
  std::vector<std::string> warnings;
  std::string hash;  // 16 hex digits over the file, its buffers and its images
  std::string plan;  // JSON of the room plan that the file was made of; empty where it says none
};

/// The bytes of a file beside a .gltf. Its name is plain and relative to the .gltf's folder: no "..", no
/// scheme, not absolute. An empty optional where there is no such file; an error ends the sentence "'name',
/// which ..." with its cure.
using Resolve = std::function<Result<std::optional<std::vector<std::uint8_t>>>(const std::string& name)>;

/// Reads and checks the bytes of a .glb or .gltf; `name` is for messages. Without `resolve` a file that names
/// others is refused.
Result<SourceScene> readSourceScene(const std::vector<std::uint8_t>& bytes, const std::string& name,
                                    double scale, const Resolve& resolve = {});

}  // namespace fiatlux
