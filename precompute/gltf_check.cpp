// Every count, index, extent and reference of a glTF's JSON, checked before a library trusts them.
// glTF 2.0 specification, sections 3.6 (buffers, accessors), 3.7 (geometry), 3.5 (scenes) and 3.12
// (extensions).
#include <array>
#include <cmath>
#include <cstring>

#include "precompute/gltf_document.h"
#include "precompute/names.h"

namespace fiatlux {
namespace {

using nlohmann::json;

constexpr const char* kAgain = "; export the file again";
constexpr std::array kAcceptedExtensions = {"KHR_mesh_quantization", "KHR_materials_unlit",
                                            "KHR_texture_transform", "KHR_lights_punctual",
                                            "KHR_materials_emissive_strength"};

std::string placeOf(const char* kind, std::size_t index) {
  return std::string(kind) + " " + std::to_string(index);
}

/// A whole number of `object`, at most `most`; `fallback` when absent, or an error when `required`.
std::size_t whole(const json& object, const char* key, const std::string& place, std::size_t most,
                  bool required = false, std::size_t fallback = 0) {
  const auto found = object.find(key);
  if (found == object.end()) {
    if (required) throw GltfError(place + " lacks its '" + key + "'" + kAgain);
    return fallback;
  }
  const bool exact = found->is_number_unsigned() ||
                     (found->is_number_float() && found->get<double>() >= 0 && found->get<double>() < 9e15 &&
                      std::floor(found->get<double>()) == found->get<double>());
  if (!exact) throw GltfError(place + ": '" + key + "' is not a whole number" + kAgain);
  const double value = found->get<double>();
  if (value > static_cast<double>(most)) {
    char text[32];
    std::snprintf(text, sizeof text, "%.0f", value);
    throw GltfError(place + ": '" + key + "' is " + text + ", beyond " + std::to_string(most) + kAgain);
  }
  return static_cast<std::size_t>(value);
}

/// The array under `key` (empty when absent), all of whose entries are objects.
const json& arrayOf(const json& object, const char* key) {
  static const json kEmpty = json::array();
  const auto found = object.find(key);
  if (found == object.end()) return kEmpty;
  if (!found->is_array()) throw GltfError(std::string("'") + key + "' is not a list" + kAgain);
  for (const json& entry : *found)
    if (!entry.is_object())
      throw GltfError(std::string("'") + key + "' holds something that is not an object" + kAgain);
  return *found;
}

/// Checks that `key`, where present, is the index of one of `count` things.
void checkIndex(const json& object, const char* key, const std::string& place, std::size_t count,
                bool required = false) {
  if (!object.contains(key) && !required) return;
  if (count == 0)
    throw GltfError(place + ": '" + key + "' points at something the file does not have" + kAgain);
  whole(object, key, place, count - 1, required);
}

void checkNumbers(const json& object, const char* key, const std::string& place, std::size_t count) {
  const auto found = object.find(key);
  if (found == object.end()) return;
  bool good = found->is_array() && found->size() == count;
  if (good)
    for (const json& number : *found) good = good && number.is_number();
  if (!good) throw GltfError(place + ": '" + key + "' is not " + std::to_string(count) + " numbers" + kAgain);
}

void checkString(const json& object, const char* key, const std::string& place) {
  if (object.contains(key) && !object[key].is_string())
    throw GltfError(place + ": '" + key + "' is not text" + kAgain);
}

void checkObject(const json& object, const char* key, const std::string& place) {
  if (object.contains(key) && !object[key].is_object())
    throw GltfError(place + ": '" + key + "' is not an object" + kAgain);
}

void checkAssetAndExtensions(const json& gltf) {
  const json* asset = gltf.contains("asset") && gltf["asset"].is_object() ? &gltf["asset"] : nullptr;
  if (!asset || !asset->contains("version") || !(*asset)["version"].is_string())
    throw GltfError("it does not say which glTF version it is ('asset.version'); export as glTF 2.0");
  const std::string version = (*asset)["version"];
  if (version.compare(0, 2, "2.") != 0)
    throw GltfError("glTF version '" + cleanText(version.substr(0, 200)) +
                    "' is not 2.0; export as glTF 2.0");
  if (!gltf.contains("extensionsRequired")) return;
  if (!gltf["extensionsRequired"].is_array())
    throw GltfError(std::string("'extensionsRequired' is not a list") + kAgain);
  for (const json& name : gltf["extensionsRequired"]) {
    const std::string text = name.is_string() ? name.get<std::string>() : "?";
    bool accepted = false;
    for (const char* known : kAcceptedExtensions) accepted = accepted || text == known;
    if (accepted) continue;
    const bool packed = text.find("draco") != std::string::npos || text.find("meshopt") != std::string::npos;
    throw GltfError("it requires the extension '" + cleanText(text.substr(0, 400)) +
                    "', which is not understood; export without " + (packed ? "compression" : "it"));
  }
}

void checkBuffers(const json& gltf) {
  std::size_t index = 0, total = 0;
  for (const json& buffer : arrayOf(gltf, "buffers")) {
    const std::string place = placeOf("buffer", index++);
    total += whole(buffer, "byteLength", place, GltfBudget::kBytes, true);
    if (total > GltfBudget::kBytes)
      throw GltfError("its buffers exceed 256 MB together; make the meshes or textures smaller");
    checkString(buffer, "uri", place);
  }
  const json& buffers = arrayOf(gltf, "buffers");
  index = 0;
  for (const json& view : arrayOf(gltf, "bufferViews")) {
    const std::string place = placeOf("buffer view", index++);
    checkIndex(view, "buffer", place, buffers.size(), true);
    const auto size = buffers[view["buffer"].get<std::size_t>()]["byteLength"].get<std::size_t>();
    const std::size_t offset = whole(view, "byteOffset", place, std::size_t{1} << 53);
    const std::size_t length = whole(view, "byteLength", place, std::size_t{1} << 53, true);
    if (offset > size || length > size - offset)
      throw GltfError(place + " reaches beyond its buffer of " + std::to_string(size) + " bytes" + kAgain);
    if (view.contains("byteStride")) {
      const std::size_t stride = whole(view, "byteStride", place, 252);
      if (stride < 1) throw GltfError(place + ": 'byteStride' is 0" + kAgain);
    }
  }
}

std::size_t componentBytes(std::size_t type) {
  return type == 5120 || type == 5121   ? 1
         : type == 5122 || type == 5123 ? 2
         : type == 5125 || type == 5126 ? 4
                                        : 0;
}

std::size_t elementBytes(const std::string& type, std::size_t component) {
  if (type == "SCALAR") return component;
  if (type == "VEC2") return 2 * component;
  if (type == "VEC3") return 3 * component;
  if (type == "VEC4") return 4 * component;
  // note: columns of small matrices are padded to four bytes
  if (type == "MAT2") return 2 * ((2 * component + 3) / 4 * 4);
  if (type == "MAT3") return 3 * ((3 * component + 3) / 4 * 4);
  return type == "MAT4" ? 16 * component : 0;
}

/// Checks that `count` elements fit into the view that `object` names.
void checkExtent(const json& object, const json& views, const std::string& place, std::size_t count,
                 std::size_t element) {
  checkIndex(object, "bufferView", place, views.size(), true);
  const json& view = views[object["bufferView"].get<std::size_t>()];
  const auto length = view["byteLength"].get<std::size_t>();
  const std::size_t offset = whole(object, "byteOffset", place, std::size_t{1} << 53);
  const std::size_t stride = view.contains("byteStride") ? view["byteStride"].get<std::size_t>() : element;
  if (stride < element) throw GltfError(place + ": its elements overlap in the buffer view" + kAgain);
  if (offset > length || element > length - offset || (count - 1) > (length - offset - element) / stride)
    throw GltfError(place + ": " + std::to_string(count) + " elements do not fit into its buffer view" +
                    kAgain);
}

void checkAccessors(const json& gltf) {
  const json& views = arrayOf(gltf, "bufferViews");
  std::size_t index = 0;
  for (const json& accessor : arrayOf(gltf, "accessors")) {
    const std::string place = placeOf("accessor", index++);
    const std::size_t count = whole(accessor, "count", place, GltfBudget::kBytes, true);
    if (count == 0) throw GltfError(place + ": 'count' is 0" + kAgain);
    const std::size_t component = componentBytes(whole(accessor, "componentType", place, 5126, true));
    checkString(accessor, "type", place);
    const std::size_t element = accessor.contains("type") ? elementBytes(accessor["type"], component) : 0;
    if (component == 0 || element == 0) throw GltfError(place + " has an unknown type" + kAgain);
    if (accessor.contains("normalized") && !accessor["normalized"].is_boolean())
      throw GltfError(place + ": 'normalized' is neither true nor false" + kAgain);
    if (accessor.contains("bufferView"))
      checkExtent(accessor, views, place, count, element);
    else if (count > 3 * GltfBudget::kTriangles)
      throw GltfError(place + ": " + std::to_string(count) + " elements without data" + kAgain);
    if (!accessor.contains("sparse")) continue;
    checkObject(accessor, "sparse", place);
    const json& sparse = accessor["sparse"];
    const std::size_t changed = whole(sparse, "count", place + " (sparse)", count, true);
    checkObject(sparse, "indices", place), checkObject(sparse, "values", place);
    if (changed == 0 || !sparse.contains("indices") || !sparse.contains("values"))
      throw GltfError(place + ": its sparse part lacks indices or values" + kAgain);
    const std::size_t type = whole(sparse["indices"], "componentType", place + " (sparse)", 5126, true);
    if (type != 5121 && type != 5123 && type != 5125)
      throw GltfError(place + ": its sparse indices have a wrong type" + kAgain);
    checkExtent(sparse["indices"], views, place + " (sparse indices)", changed, componentBytes(type));
    checkExtent(sparse["values"], views, place + " (sparse values)", changed, element);
  }
}

/// A list of numbers of any length under `key`, where present.
void checkList(const json& object, const char* key, const std::string& place) {
  if (object.contains(key)) checkNumbers(object, key, place, object[key].size());
}

/// Accessors of one count (0: not known yet) and of the shapes that are relied on.
void checkAttributes(const json& attributes, const json& accessors, const std::string& place,
                     std::size_t& count) {
  for (const auto& [name, value] : attributes.items()) {
    checkIndex(attributes, name.c_str(), place, accessors.size());
    const json& accessor = accessors[value.get<std::size_t>()];
    if (count != 0 && accessor["count"] != count)
      throw GltfError(place + ": its attributes have different counts" + kAgain);
    count = accessor["count"].get<std::size_t>();
    if ((name == "POSITION" || name == "NORMAL") && accessor["type"] != "VEC3")
      throw GltfError(place + ": " + name + " is not three numbers a vertex" + kAgain);
    const bool skins = name.rfind("JOINTS_", 0) == 0 || name.rfind("WEIGHTS_", 0) == 0;
    if (skins && accessor["type"] != "VEC4")
      throw GltfError(place + ": " + cleanText(name) + " is not four numbers a vertex" + kAgain);
  }
}

void checkSkins(const json& gltf) {
  const json& accessors = arrayOf(gltf, "accessors");
  const std::size_t nodes = arrayOf(gltf, "nodes").size();
  std::size_t index = 0;
  for (const json& skin : arrayOf(gltf, "skins")) {
    const std::string place = placeOf("skin", index++);
    if (!skin.contains("joints") || !skin["joints"].is_array() || skin["joints"].empty())
      throw GltfError(place + " has no joints" + kAgain);
    for (const json& joint : skin["joints"])
      if (!joint.is_number_unsigned() || joint.get<std::size_t>() >= nodes)
        throw GltfError(place + ": 'joints' names a node that is not there" + kAgain);
    checkIndex(skin, "inverseBindMatrices", place, accessors.size());
    checkIndex(skin, "skeleton", place, nodes);
    if (!skin.contains("inverseBindMatrices")) continue;
    const json& accessor = accessors[skin["inverseBindMatrices"].get<std::size_t>()];
    if (accessor["type"] != "MAT4" || accessor["componentType"] != 5126 ||
        accessor["count"].get<std::size_t>() < skin["joints"].size())
      throw GltfError(place + ": it has not a matrix for every joint" + kAgain);
  }
}

void checkMeshes(const json& gltf) {
  const json& accessors = arrayOf(gltf, "accessors");
  const std::size_t materials = arrayOf(gltf, "materials").size();
  std::size_t index = 0;
  for (const json& mesh : arrayOf(gltf, "meshes")) {
    const std::string place = placeOf("mesh", index++);
    checkString(mesh, "name", place);
    checkList(mesh, "weights", place);
    if (!mesh.contains("primitives")) throw GltfError(place + " lacks its 'primitives'" + kAgain);
    for (const json& primitive : arrayOf(mesh, "primitives")) {
      whole(primitive, "mode", place, 6);
      checkIndex(primitive, "material", place, materials);
      checkIndex(primitive, "indices", place, accessors.size());
      checkObject(primitive, "attributes", place);
      if (!primitive.contains("attributes")) throw GltfError(place + " lacks its 'attributes'" + kAgain);
      std::size_t count = 0;
      checkAttributes(primitive["attributes"], accessors, place, count);
      for (const json& target : arrayOf(primitive, "targets"))
        checkAttributes(target, accessors, place, count);
      if (primitive.contains("indices") &&
          accessors[primitive["indices"].get<std::size_t>()]["type"] != "SCALAR")
        throw GltfError(place + ": its indices are not single numbers" + kAgain);
    }
  }
}

void checkTextures(const json& gltf) {
  const std::size_t images = arrayOf(gltf, "images").size(), samplers = arrayOf(gltf, "samplers").size();
  std::size_t index = 0;
  for (const json& image : arrayOf(gltf, "images")) {
    const std::string place = placeOf("image", index++);
    checkString(image, "uri", place), checkString(image, "mimeType", place);
    checkIndex(image, "bufferView", place, arrayOf(gltf, "bufferViews").size());
  }
  index = 0;
  for (const json& sampler : arrayOf(gltf, "samplers")) {
    const std::string place = placeOf("sampler", index++);
    whole(sampler, "wrapS", place, 65535), whole(sampler, "wrapT", place, 65535);
  }
  index = 0;
  for (const json& texture : arrayOf(gltf, "textures")) {
    const std::string place = placeOf("texture", index++);
    checkIndex(texture, "source", place, images), checkIndex(texture, "sampler", place, samplers);
  }
}

void checkMaterials(const json& gltf) {
  const std::size_t textures = arrayOf(gltf, "textures").size();
  std::size_t index = 0;
  for (const json& material : arrayOf(gltf, "materials")) {
    const std::string place = placeOf("material", index++);
    checkString(material, "name", place), checkString(material, "alphaMode", place);
    checkNumbers(material, "emissiveFactor", place, 3);
    checkObject(material, "pbrMetallicRoughness", place), checkObject(material, "extensions", place);
    if (!material.contains("pbrMetallicRoughness")) continue;
    const json& pbr = material["pbrMetallicRoughness"];
    checkNumbers(pbr, "baseColorFactor", place, 4);
    checkObject(pbr, "baseColorTexture", place);
    if (!pbr.contains("baseColorTexture")) continue;
    checkIndex(pbr["baseColorTexture"], "index", place, textures, true);
    whole(pbr["baseColorTexture"], "texCoord", place, 63);
    checkObject(pbr["baseColorTexture"], "extensions", place);
  }
}

/// Every node has at most one parent, so that a walk from the roots meets each node once and ends.
void checkNodes(const json& gltf) {
  const json& nodes = arrayOf(gltf, "nodes");
  if (nodes.size() > GltfBudget::kNodes)
    throw GltfError("more than a million nodes; join meshes before export");
  std::vector<std::uint32_t> parent(nodes.size(), UINT32_MAX);
  const std::size_t meshes = arrayOf(gltf, "meshes").size(), skins = arrayOf(gltf, "skins").size();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const json& node = nodes[i];
    const std::string place = placeOf("node", i);
    checkString(node, "name", place);
    checkIndex(node, "mesh", place, meshes);
    checkIndex(node, "skin", place, skins);
    checkList(node, "weights", place);
    checkNumbers(node, "matrix", place, 16), checkNumbers(node, "translation", place, 3);
    checkNumbers(node, "rotation", place, 4), checkNumbers(node, "scale", place, 3);
    if (!node.contains("children")) continue;
    if (!node["children"].is_array()) throw GltfError(place + ": 'children' is not a list" + kAgain);
    for (const json& child : node["children"]) {
      if (!child.is_number_unsigned() || child.get<std::size_t>() >= nodes.size())
        throw GltfError(place + ": 'children' names a node that is not there" + kAgain);
      auto& up = parent[child.get<std::size_t>()];
      if (up != UINT32_MAX)
        throw GltfError(placeOf("node", child.get<std::size_t>()) + " has two parents" + kAgain);
      up = static_cast<std::uint32_t>(i);
    }
  }
  // Climb from each node, marking as we go: meeting this climb's own mark is a cycle.
  std::vector<std::uint32_t> mark(nodes.size(), UINT32_MAX);
  for (std::uint32_t i = 0; i < nodes.size(); ++i)
    for (std::uint32_t at = i; at != UINT32_MAX && mark[at] != i; at = parent[at]) {
      if (mark[at] != UINT32_MAX) break;
      mark[at] = i;
      if (parent[at] != UINT32_MAX && mark[parent[at]] == i)
        throw GltfError(placeOf("node", at) +
                        " is its own ancestor; untie the cycle in the modelling program");
    }
  std::size_t index = 0;
  for (const json& scene : arrayOf(gltf, "scenes")) {
    const std::string place = placeOf("scene", index++);
    if (!scene.contains("nodes")) continue;
    if (!scene["nodes"].is_array()) throw GltfError(place + ": 'nodes' is not a list" + kAgain);
    for (const json& root : scene["nodes"])
      if (!root.is_number_unsigned() || root.get<std::size_t>() >= nodes.size())
        throw GltfError(place + " names a node that is not there" + kAgain);
  }
  checkIndex(gltf, "scene", "the file", arrayOf(gltf, "scenes").size());
}

}  // namespace

void checkGltf(const json& gltf) {
  if (!gltf.is_object()) throw GltfError(std::string("the JSON is not an object") + kAgain);
  checkAssetAndExtensions(gltf);
  checkBuffers(gltf);
  checkAccessors(gltf);
  checkTextures(gltf);
  checkMaterials(gltf);
  checkMeshes(gltf);
  checkSkins(gltf);
  checkNodes(gltf);
}

}  // namespace fiatlux
