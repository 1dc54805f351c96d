#include "precompute/gltf/packed_mesh.h"

#include <cstring>
#include <nlohmann/json.hpp>

#include "precompute/gltf/fields.h"

#ifndef __EMSCRIPTEN__
#include <draco/compression/decode.h>
#include <meshoptimizer.h>
#endif

namespace fiatlux {

using nlohmann::json;

#ifdef __EMSCRIPTEN__

namespace {

[[noreturn]] void refuse(const std::string& place, const char* packing) {
  throw GltfError(place + " is compressed with " + packing + "; export without compression");
}

}  // namespace

struct DracoMesh::Decoded {};

void unpackMeshopt(const json&, std::span<const std::uint8_t>, std::span<std::uint8_t>,
                   const std::string& place) {
  refuse(place, kMeshopt);
}

DracoMesh::DracoMesh(std::span<const std::uint8_t>, const std::string& place) { refuse(place, kDraco); }
MeshElements DracoMesh::attribute(std::uint32_t, const json&, const std::string&) const { return {}; }
MeshElements DracoMesh::indices() const { return {}; }

#else

namespace {

constexpr std::size_t kMostPackedStride = 256;  // bytes, that meshopt knows

std::string textIn(const json& object, const char* key, const std::string& place, const char* fallback) {
  checkString(object, key, place);
  return object.value(key, std::string(fallback));
}

/// What the encoder did to numbers, undone; false where the filter does not fit.
bool undoFilter(const std::string& filter, std::uint8_t* bytes, std::size_t count, std::size_t stride) {
  if (filter == "NONE") return true;
  if (filter == "OCTAHEDRAL" && (stride == 4 || stride == 8))
    return meshopt_decodeFilterOct(bytes, count, stride), true;
  if (filter == "QUATERNION" && stride == 8) return meshopt_decodeFilterQuat(bytes, count, stride), true;
  if (filter == "EXPONENTIAL" && stride % 4 == 0) return meshopt_decodeFilterExp(bytes, count, stride), true;
  return false;
}

template <class T>
void convert(const draco::Mesh& mesh, const draco::PointAttribute& attribute, std::size_t width,
             std::vector<std::uint8_t>& bytes) {
  bytes.resize(mesh.num_points() * width * sizeof(T));
  T values[16] = {};
  for (std::uint32_t point = 0; point < mesh.num_points(); ++point) {
    const draco::AttributeValueIndex at = attribute.mapped_index(draco::PointIndex(point));
    attribute.ConvertValue<T>(at, static_cast<std::int8_t>(width), values);
    std::memcpy(bytes.data() + point * width * sizeof(T), values, width * sizeof(T));
  }
}

std::size_t widthOf(const std::string& type) {
  if (type == "SCALAR") return 1;
  return type == "VEC2" ? 2 : type == "VEC3" ? 3 : type == "VEC4" ? 4 : 16;
}

}  // namespace

void unpackMeshopt(const json& packed, std::span<const std::uint8_t> data, std::span<std::uint8_t> bytes,
                   const std::string& place) {
  const std::size_t stride = whole(packed, "byteStride", place, kMostPackedStride, true);
  const std::size_t count = whole(packed, "count", place, GltfBudget::kBytes, true);
  const std::string mode = textIn(packed, "mode", place, ""),
                    filter = textIn(packed, "filter", place, "NONE");
  if (stride == 0 || count == 0 || count > bytes.size() / stride)
    throw GltfError(place + " unpacks to more than it has room for" + kAgain);
  int fault = -1;
  if (mode == "ATTRIBUTES" && stride % 4 == 0)
    fault = meshopt_decodeVertexBuffer(bytes.data(), count, stride, data.data(), data.size());
  else if (mode == "TRIANGLES" && count % 3 == 0 && (stride == 2 || stride == 4))
    fault = meshopt_decodeIndexBuffer(bytes.data(), count, stride, data.data(), data.size());
  else if (mode == "INDICES" && (stride == 2 || stride == 4))
    fault = meshopt_decodeIndexSequence(bytes.data(), count, stride, data.data(), data.size());
  if (fault != 0 || !undoFilter(filter, bytes.data(), count, stride))
    throw GltfError(place +
                    ": its compressed mesh is damaged or of a newer kind; export it again, or "
                    "without compression");
}

struct DracoMesh::Decoded {
  std::unique_ptr<draco::Mesh> mesh;
};

DracoMesh::DracoMesh(std::span<const std::uint8_t> data, const std::string& place)
    : decoded_(std::make_unique<Decoded>()) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(data.data()), data.size());
  draco::Decoder decoder;
  auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok())
    throw GltfError(place + ": its compressed mesh is damaged; export it again, or without compression");
  decoded_->mesh = std::move(decoded).value();
  if (decoded_->mesh->num_faces() > GltfBudget::kTriangles)
    throw GltfError(place + " unpacks to " + std::to_string(decoded_->mesh->num_faces()) +
                    " triangles; simplify it");
}

MeshElements DracoMesh::attribute(std::uint32_t id, const json& accessor, const std::string& place) const {
  const draco::Mesh& mesh = *decoded_->mesh;
  const draco::PointAttribute* found = mesh.GetAttributeByUniqueId(id);
  if (!found || mesh.num_points() == 0)
    throw GltfError(place + ": an attribute of its compressed mesh is missing" + kAgain);
  MeshElements elements;
  elements.count = mesh.num_points();
  const std::size_t width = widthOf(accessor["type"].get<std::string>());
  const auto fill = [&](auto kind) { convert<decltype(kind)>(mesh, *found, width, elements.bytes); };
  switch (accessor["componentType"].get<int>()) {
    case gltf::kByte:
      fill(std::int8_t{});
      break;
    case gltf::kUnsignedByte:
      fill(std::uint8_t{});
      break;
    case gltf::kShort:
      fill(std::int16_t{});
      break;
    case gltf::kUnsignedShort:
      fill(std::uint16_t{});
      break;
    case gltf::kUnsignedInt:
      fill(std::uint32_t{});
      break;
    default:
      fill(float{});
  }
  return elements;
}

MeshElements DracoMesh::indices() const {
  const draco::Mesh& mesh = *decoded_->mesh;
  MeshElements elements;
  elements.count = std::size_t{3} * mesh.num_faces();
  elements.bytes.resize(elements.count * sizeof(std::uint32_t));
  std::size_t at = 0;
  for (std::uint32_t face = 0; face < mesh.num_faces(); ++face)
    for (int corner = 0; corner < 3; ++corner, at += sizeof(std::uint32_t)) {
      const std::uint32_t point = mesh.face(draco::FaceIndex(face))[corner].value();
      std::memcpy(elements.bytes.data() + at, &point, sizeof point);
    }
  return elements;
}

#endif

DracoMesh::~DracoMesh() = default;

}  // namespace fiatlux
