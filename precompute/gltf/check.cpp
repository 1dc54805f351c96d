// What a glTF's JSON says of scenes, nodes, meshes, skins and materials: each reference leads to something of
// the right kind (glTF 2.0, sections 3.5 scenes, 3.7 geometry, 3.9 materials and 3.12 extensions).
#include "precompute/gltf/check.h"

#include <array>
#include <string>
#include <vector>

#include "precompute/base/names.h"
#include "precompute/gltf/codes.h"
#include "precompute/gltf/fields.h"

namespace fiatlux {
namespace {

using nlohmann::json;

/// What a file may require: what is read, and what changes neither a mesh nor a base colour.
constexpr std::array kAcceptedExtensions = {"KHR_mesh_quantization",
                                            "KHR_draco_mesh_compression",
                                            "EXT_meshopt_compression",
                                            "KHR_texture_transform",
                                            "KHR_texture_basisu",
                                            "EXT_texture_webp",
                                            "EXT_texture_avif",
                                            "KHR_lights_punctual",
                                            "KHR_xmp_json_ld",
                                            "KHR_materials_unlit",
                                            "KHR_materials_emissive_strength",
                                            "KHR_materials_anisotropy",
                                            "KHR_materials_clearcoat",
                                            "KHR_materials_dispersion",
                                            "KHR_materials_ior",
                                            "KHR_materials_iridescence",
                                            "KHR_materials_sheen",
                                            "KHR_materials_specular",
                                            "KHR_materials_transmission",
                                            "KHR_materials_volume"};

void checkAssetAndExtensions(const json& file) {
  const json* asset = file.contains("asset") && file["asset"].is_object() ? &file["asset"] : nullptr;
  if (!asset || !asset->contains("version") || !(*asset)["version"].is_string())
    throw GltfError("it does not say which glTF version it is ('asset.version'); export as glTF 2.0");
  const std::string version = (*asset)["version"];
  if (version.compare(0, 2, "2.") != 0)
    throw GltfError("glTF version '" + cleanText(version.substr(0, 200)) +
                    "' is not 2.0; export as glTF 2.0");
  if (!file.contains("extensionsRequired")) return;
  if (!file["extensionsRequired"].is_array())
    throw GltfError(std::string("'extensionsRequired' is not a list") + kAgain);
  for (const json& name : file["extensionsRequired"]) {
    const std::string text = name.is_string() ? name.get<std::string>() : "?";
    bool accepted = false;
    for (const char* known : kAcceptedExtensions) accepted = accepted || text == known;
    if (accepted) continue;
    const bool packed = text.find("compression") != std::string::npos;
    throw GltfError("it requires the extension '" + cleanText(text.substr(0, 400)) +
                    "', which is not understood; export without " + (packed ? "compression" : "it"));
  }
}

constexpr std::size_t kLargestCode = 65535;  // of those that WebGL has for a sampler

/// Checks that an accessor holds unsigned whole numbers.
void checkUnsigned(const json& accessor, const std::string& place, const std::string& what) {
  if (!isUnsigned(accessor["componentType"].get<std::size_t>()))
    throw GltfError(place + ": " + what + " are not unsigned whole numbers" + kAgain);
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
      throw GltfError(place + ": " + name + " is not three numbers per vertex" + kAgain);
    const bool skins = name.rfind("JOINTS_", 0) == 0 || name.rfind("WEIGHTS_", 0) == 0;
    if (skins && accessor["type"] != "VEC4")
      throw GltfError(place + ": " + cleanText(name) + " is not four numbers per vertex" + kAgain);
    if (name.rfind("JOINTS_", 0) == 0) checkUnsigned(accessor, place, cleanText(name));
  }
}

void checkSkins(const json& file) {
  const json& accessors = arrayOf(file, "accessors");
  const std::size_t nodes = arrayOf(file, "nodes").size();
  std::size_t index = 0;
  for (const json& skin : arrayOf(file, "skins")) {
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
    if (accessor["type"] != "MAT4" || accessor["componentType"] != gltf::kFloat ||
        accessor["count"].get<std::size_t>() < skin["joints"].size())
      throw GltfError(place + ": it has not a matrix for every joint" + kAgain);
  }
}

void checkMeshes(const json& file) {
  const json& accessors = arrayOf(file, "accessors");
  const std::size_t materials = arrayOf(file, "materials").size();
  std::size_t index = 0;
  for (const json& mesh : arrayOf(file, "meshes")) {
    const std::string place = placeOf("mesh", index++);
    checkString(mesh, "name", place);
    checkNumbers(mesh, "weights", place);
    if (!mesh.contains("primitives")) throw GltfError(place + " lacks its 'primitives'" + kAgain);
    for (const json& primitive : arrayOf(mesh, "primitives")) {
      whole(primitive, "mode", place, gltf::kTriangleFan);
      checkIndex(primitive, "material", place, materials);
      checkIndex(primitive, "indices", place, accessors.size());
      checkObject(primitive, "attributes", place);
      if (!primitive.contains("attributes")) throw GltfError(place + " lacks its 'attributes'" + kAgain);
      std::size_t count = 0;
      checkAttributes(primitive["attributes"], accessors, place, count);
      for (const json& target : arrayOf(primitive, "targets"))
        checkAttributes(target, accessors, place, count);
      if (!primitive.contains("indices")) continue;
      const json& indices = accessors[primitive["indices"].get<std::size_t>()];
      if (indices["type"] != "SCALAR")
        throw GltfError(place + ": its indices are not single numbers" + kAgain);
      checkUnsigned(indices, place, "its indices");
    }
  }
}

void checkTextures(const json& file) {
  const std::size_t images = arrayOf(file, "images").size(), samplers = arrayOf(file, "samplers").size();
  std::size_t index = 0;
  for (const json& image : arrayOf(file, "images")) {
    const std::string place = placeOf("image", index++);
    checkString(image, "uri", place), checkString(image, "mimeType", place);
    checkIndex(image, "bufferView", place, arrayOf(file, "bufferViews").size());
  }
  index = 0;
  for (const json& sampler : arrayOf(file, "samplers")) {
    const std::string place = placeOf("sampler", index++);
    whole(sampler, "wrapS", place, kLargestCode), whole(sampler, "wrapT", place, kLargestCode);
  }
  index = 0;
  for (const json& texture : arrayOf(file, "textures")) {
    const std::string place = placeOf("texture", index++);
    checkIndex(texture, "source", place, images), checkIndex(texture, "sampler", place, samplers);
    checkObject(texture, "extensions", place);
    for (const char* kind : kPictureExtensions) {
      const json other = texture.value("extensions", json::object()).value(kind, json::object());
      if (other.is_object()) checkIndex(other, "source", place, images);
    }
  }
}

void checkMaterials(const json& file) {
  const std::size_t textures = arrayOf(file, "textures").size();
  std::size_t index = 0;
  for (const json& material : arrayOf(file, "materials")) {
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
    whole(pbr["baseColorTexture"], "texCoord", place, kMostTexCoords - 1);
    checkObject(pbr["baseColorTexture"], "extensions", place);
  }
}

/// Every node has at most one parent, so that a walk from the roots meets each node once and ends.
void checkNodes(const json& file) {
  const json& nodes = arrayOf(file, "nodes");
  if (nodes.size() > GltfBudget::kNodes)
    throw GltfError("more than " + std::to_string(GltfBudget::kNodes / 1'000'000) +
                    " million nodes; join meshes before export");
  std::vector<std::uint32_t> parent(nodes.size(), UINT32_MAX);
  const std::size_t meshes = arrayOf(file, "meshes").size(), skins = arrayOf(file, "skins").size();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const json& node = nodes[i];
    const std::string place = placeOf("node", i);
    checkString(node, "name", place);
    checkIndex(node, "mesh", place, meshes);
    checkIndex(node, "skin", place, skins);
    checkNumbers(node, "weights", place);
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
  for (const json& scene : arrayOf(file, "scenes")) {
    const std::string place = placeOf("scene", index++);
    if (!scene.contains("nodes")) continue;
    if (!scene["nodes"].is_array()) throw GltfError(place + ": 'nodes' is not a list" + kAgain);
    for (const json& root : scene["nodes"])
      if (!root.is_number_unsigned() || root.get<std::size_t>() >= nodes.size())
        throw GltfError(place + " names a node that is not there" + kAgain);
  }
  checkIndex(file, "scene", "the file", arrayOf(file, "scenes").size());
}

}  // namespace

void checkGltf(const json& file) {
  if (!file.is_object()) throw GltfError(std::string("the JSON is not an object") + kAgain);
  checkAssetAndExtensions(file);
  checkGltfData(file);
  checkTextures(file);
  checkMaterials(file);
  checkMeshes(file);
  checkSkins(file);
  checkNodes(file);
}

}  // namespace fiatlux
