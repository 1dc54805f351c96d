// The door to the decoders of meshes: the only file that includes them is packed_mesh.cpp. As Wasm there are
// none, and what they should decode is refused.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

namespace fiatlux {

inline constexpr const char* kDraco = "KHR_draco_mesh_compression";
inline constexpr const char* kMeshopt = "EXT_meshopt_compression";

/// Decodes a buffer view's bytes as its extension `packed` says (checked here) into `bytes`, which is the
/// view's place; `place` is for messages. Throws GltfError.
void unpackMeshopt(const nlohmann::json& packed, std::span<const std::uint8_t> data,
                   std::span<std::uint8_t> bytes, const std::string& place);

/// Elements side by side, as an accessor without a stride finds them.
struct MeshElements {
  std::vector<std::uint8_t> bytes;
  std::size_t count = 0;
};

/// A primitive out of Draco's bytes: a list of triangles.
class DracoMesh {
 public:
  /// Throws GltfError where the bytes are damaged or hold too much.
  DracoMesh(std::span<const std::uint8_t> data, const std::string& place);
  ~DracoMesh();

  /// The attribute of a unique id, with the accessor's type of components and number of them. Throws
  /// GltfError where there is none.
  MeshElements attribute(std::uint32_t id, const nlohmann::json& accessor, const std::string& place) const;
  /// Three 32-bit corners per triangle.
  MeshElements indices() const;

 private:
  struct Decoded;
  std::unique_ptr<Decoded> decoded_;
};

}  // namespace fiatlux
