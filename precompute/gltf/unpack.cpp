#include "precompute/gltf/unpack.h"

#include "precompute/gltf/fields.h"
#include "precompute/gltf/packed_mesh.h"

namespace fiatlux {
namespace {

using nlohmann::json;

/// The object `name` under `extensions`; null where there is none.
const json* extensionOf(const json& object, const char* name) {
  const auto extensions = object.find("extensions");
  if (extensions == object.end() || !extensions->is_object()) return nullptr;
  const auto found = extensions->find(name);
  return found != extensions->end() && found->is_object() ? &*found : nullptr;
}

/// The bytes [byteOffset, byteOffset + byteLength) of a buffer that `object` names.
std::span<const std::uint8_t> bytesOf(const json& object, const GltfDocument& document,
                                      const std::string& place) {
  checkIndex(object, "buffer", place, document.buffers.size(), true);
  const auto& buffer = document.buffers[object["buffer"].get<std::size_t>()];
  const std::size_t offset = whole(object, "byteOffset", place, buffer.size());
  const std::size_t length = whole(object, "byteLength", place, buffer.size() - offset, true);
  return {buffer.data() + offset, length};
}

void unpackViews(GltfDocument& document) {
  std::size_t index = 0;
  for (json& view : document.json["bufferViews"]) {
    const std::string place = placeOf("buffer view", index++);
    const json* packed = extensionOf(view, kMeshopt);
    auto& buffer = document.buffers[view["buffer"].get<std::size_t>()];
    const auto offset = view.value("byteOffset", std::size_t{0});
    const auto length = view["byteLength"].get<std::size_t>();
    if (packed) {
      if (buffer.size() < offset + length) buffer.resize(offset + length);
      unpackMeshopt(*packed, bytesOf(*packed, document, place), {buffer.data() + offset, length}, place);
      view.erase("extensions");
    } else if (buffer.size() < offset + length) {
      throw GltfError(place + " lies in a buffer that holds nothing" + kAgain);
    }
  }
}

/// Puts unpacked elements behind those of one buffer, as views and accessors of their own.
class Unpacked {
 public:
  explicit Unpacked(GltfDocument& document) : document_(document) {}

  std::size_t add(const MeshElements& elements, json accessor) {
    const std::size_t offset = (bytes_.size() + 3) / 4 * 4;
    if (offset + elements.bytes.size() > GltfBudget::kBytes)
      throw GltfError("its meshes unpack to more than " + megabytes(GltfBudget::kBytes) +
                      "; make them smaller");
    bytes_.resize(offset);
    bytes_.insert(bytes_.end(), elements.bytes.begin(), elements.bytes.end());
    json& views = document_.json["bufferViews"];
    json& accessors = document_.json["accessors"];
    views.push_back({{"buffer", document_.buffers.size()},
                     {"byteOffset", offset},
                     {"byteLength", elements.bytes.size()}});
    accessor.erase("byteOffset"), accessor.erase("sparse");
    accessor["bufferView"] = views.size() - 1;
    accessor["count"] = elements.count;
    accessors.push_back(std::move(accessor));
    return accessors.size() - 1;
  }

  void finish() {
    if (bytes_.empty()) return;
    document_.json["buffers"].push_back({{"byteLength", bytes_.size()}});
    document_.buffers.push_back(std::move(bytes_));
  }

 private:
  GltfDocument& document_;
  std::vector<std::uint8_t> bytes_;
};

/// Whether a primitive can do without Draco: its corners lie in the file as they are, too.
bool isThere(const json& primitive, const json& file) {
  const json& attributes = primitive["attributes"];
  return attributes.contains("POSITION") &&
         file["accessors"][attributes["POSITION"].get<std::size_t>()].contains("bufferView");
}

void unpackPrimitive(json& primitive, const json& packed, GltfDocument& document, Unpacked& unpacked,
                     const std::string& place) {
  const json& views = arrayOf(document.json, "bufferViews");
  checkIndex(packed, "bufferView", place, views.size(), true);
  checkObject(packed, "attributes", place);
  const DracoMesh mesh(bytesOf(views[packed["bufferView"].get<std::size_t>()], document, place), place);
  const auto accessorOf = [&](const json& index) {
    return document.json["accessors"][index.get<std::size_t>()];
  };
  const json attributes = packed.value("attributes", json::object());
  for (const auto& [name, id] : attributes.items()) {
    const auto found = primitive["attributes"].find(name);
    if (found == primitive["attributes"].end()) continue;
    if (!id.is_number_unsigned()) throw GltfError(place + ": an attribute has no whole number" + kAgain);
    const json accessor = accessorOf(*found);
    *found = unpacked.add(mesh.attribute(id.get<std::uint32_t>(), accessor, place), accessor);
  }
  json indices = {{"componentType", gltf::kUnsignedInt}, {"type", "SCALAR"}};
  primitive["indices"] = unpacked.add(mesh.indices(), std::move(indices));
  primitive["mode"] = gltf::kTriangles;
  primitive["extensions"].erase(kDraco);
}

}  // namespace

bool isUnpackedTo(const json& buffer) {
  const json* extension = extensionOf(buffer, kMeshopt);
  return extension && extension->value("fallback", json()) == true;
}

void unpackMeshes(GltfDocument& document) {
  if (document.json.contains("bufferViews")) unpackViews(document);
  Unpacked unpacked(document);
  if (!document.json.contains("meshes")) return;
  std::size_t index = 0;
  for (json& mesh : document.json["meshes"]) {
    const std::string place = placeOf("mesh", index++);
    for (json& primitive : mesh["primitives"])
      if (const json* packed = extensionOf(primitive, kDraco); packed && !isThere(primitive, document.json))
        unpackPrimitive(primitive, json(*packed), document, unpacked, place);
  }
  unpacked.finish();
}

}  // namespace fiatlux
