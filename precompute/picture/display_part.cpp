// Parts and materials of the picture -> accessors, meshes and nodes of a .glb.
#include "precompute/picture/display_part.h"

namespace fiatlux {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kMostShort = 65535;  // that 16 bits hold

template <class T, class Get>
int packAttribute(GlbWriter& glb, const Part& part, int componentType, bool normalized, const char* type,
                  Get get) {
  std::vector<T> values;
  values.reserve(part.vertices.size());
  for (const Vertex& vertex : part.vertices) values.push_back(get(vertex));
  const int view = glb.addView(values.data(), values.size() * sizeof(T), sizeof(T), gltf::kArrayBuffer);
  return glb.addAccessor(view, componentType, normalized, part.vertices.size(), type);
}

int packIndices(GlbWriter& glb, const Part& part) {
  const std::size_t count = part.indices.size();
  if (part.vertices.size() > kMostShort)
    return glb.addAccessor(glb.addView(part.indices.data(), 4 * count, 0, gltf::kElementArrayBuffer),
                           gltf::kUnsignedInt, false, count, "SCALAR");
  const std::vector<std::uint16_t> narrow(part.indices.begin(), part.indices.end());
  return glb.addAccessor(glb.addView(narrow.data(), 2 * count, 0, gltf::kElementArrayBuffer),
                         gltf::kUnsignedShort, false, count, "SCALAR");
}

}  // namespace

void packPart(GlbWriter& glb, const Part& part, int material, std::uint32_t rows, const std::string& name,
              ordered_json extras) {
  if (part.indices.empty()) return;
  // Geometry: glTF wants the extent of positions.
  ordered_json attributes;
  attributes["POSITION"] = packAttribute<std::array<float, 3>>(glb, part, gltf::kFloat, false, "VEC3",
                                                               [](const Vertex& v) { return v.position; });
  ordered_json &accessor = glb.json["accessors"].back(), low = part.vertices[0].position, high = low;
  for (const Vertex& v : part.vertices)
    for (int c = 0; c < 3; ++c) {
      low[c] = std::min(low[c].get<float>(), v.position[c]);
      high[c] = std::max(high[c].get<float>(), v.position[c]);
    }
  accessor["min"] = low, accessor["max"] = high;
  attributes["NORMAL"] = packAttribute<std::array<std::int8_t, 4>>(glb, part, gltf::kByte, true, "VEC3",
                                                                   [](const Vertex& v) { return v.normal; });

  // Colour, where there is any.
  if (part.textured)
    attributes["TEXCOORD_0"] = packAttribute<std::array<float, 2>>(glb, part, gltf::kFloat, false, "VEC2",
                                                                   [](const Vertex& v) { return v.uv; });
  if (part.colored)
    attributes["COLOR_0"] = packAttribute<std::array<std::uint8_t, 4>>(
        glb, part, gltf::kUnsignedByte, true, "VEC4", [](const Vertex& v) { return v.color; });

  // The patches that each vertex blends.
  if (part.lit) {
    const auto narrowed = [](const Vertex& v) {
      std::array<std::uint16_t, 4> patch{};
      for (int i = 0; i < 4; ++i) patch[i] = static_cast<std::uint16_t>(v.blend.patch[i]);
      return patch;
    };
    const auto wide = [](const Vertex& v) {
      std::array<float, 4> patch{};
      for (int i = 0; i < 4; ++i) patch[i] = static_cast<float>(v.blend.patch[i]);
      return patch;
    };
    attributes["_PATCHES"] =
        rows <= kMostShort + 1
            ? packAttribute<std::array<std::uint16_t, 4>>(glb, part, gltf::kUnsignedShort, false, "VEC4",
                                                          narrowed)
            : packAttribute<std::array<float, 4>>(glb, part, gltf::kFloat, false, "VEC4", wide);
    attributes["_WEIGHTS"] = packAttribute<std::array<std::uint8_t, 4>>(
        glb, part, gltf::kUnsignedByte, true, "VEC4", [](const Vertex& v) { return v.blend.share; });
  }

  ordered_json primitive = {{"attributes", attributes}, {"indices", packIndices(glb, part)}};
  if (material >= 0) primitive["material"] = material;
  const int mesh = glb.append("meshes", {{"name", name}, {"primitives", ordered_json::array({primitive})}});
  const int node = glb.append("nodes", {{"name", name}, {"mesh", mesh}, {"extras", std::move(extras)}});
  glb.json["scenes"][0]["nodes"].push_back(node);
}

void packMaterials(GlbWriter& glb, const SourceScene& source) {
  bool transformed = false;
  std::vector<int> imageOf(source.images.size(), -1);
  for (const SourceMaterial& material : source.materials) {
    ordered_json pbr = {{"baseColorFactor", material.baseColor},
                        {"metallicFactor", material.metallic},
                        {"roughnessFactor", material.roughness}};

    // Its texture: images are packed once, however many materials show them.
    if (material.image >= 0 && !source.images[material.image].encoded.empty()) {
      const SourceImage& image = source.images[material.image];
      int& packed = imageOf[material.image];
      if (packed < 0) {
        const int view = glb.addView(image.encoded.data(), image.encoded.size(), 0, 0);
        packed = glb.append("images", {{"bufferView", view}, {"mimeType", image.mimeType}});
      }
      const int sampler = glb.append("samplers", {{"wrapS", material.wrapS},
                                                  {"wrapT", material.wrapT},
                                                  {"magFilter", gltf::kLinear},
                                                  {"minFilter", gltf::kLinearMipmapLinear}});
      pbr["baseColorTexture"] = {
          {"index", glb.append("textures", {{"source", packed}, {"sampler", sampler}})}};
      const auto& t = material.uvTransform;
      if (t != std::array<double, 5>{0, 0, 1, 1, 0}) {
        transformed = true;
        pbr["baseColorTexture"]["extensions"]["KHR_texture_transform"] = {
            {"offset", {t[0], t[1]}}, {"scale", {t[2], t[3]}}, {"rotation", t[4]}};
      }
    }

    ordered_json entry = {{"name", material.name}, {"pbrMetallicRoughness", pbr}};
    if (material.alpha == SourceMaterial::Alpha::kBlend)
      entry["alphaMode"] = "BLEND", entry["doubleSided"] = true;
    if (material.alpha == SourceMaterial::Alpha::kMask) entry["alphaMode"] = "MASK";
    glb.append("materials", std::move(entry));
  }
  glb.json["extensionsUsed"] = {"KHR_mesh_quantization"};
  glb.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  if (transformed) glb.json["extensionsUsed"].push_back("KHR_texture_transform");
}

}  // namespace fiatlux
