#include "precompute/gltf/materials.h"

#include <algorithm>

#include "precompute/base/names.h"
#include "precompute/gltf/image_file.h"
#include "precompute/gltf/refusal.h"

namespace fiatlux {
namespace {

constexpr std::uint8_t kPngByte = 0x89;  // the first of every PNG; what decodes and is none is JPEG

double numberOf(const tinygltf::Value& value, double fallback) {
  return value.IsNumber() ? value.GetNumberAsDouble() : fallback;
}

void readTextureTransform(const tinygltf::ExtensionMap& extensions, SourceMaterial& material) {
  const auto found = extensions.find("KHR_texture_transform");
  if (found == extensions.end() || !found->second.IsObject()) return;
  const tinygltf::Value& value = found->second;
  const auto pair = [&](const char* key, int at) {
    if (!value.Has(key) || !value.Get(key).IsArray() || value.Get(key).ArrayLen() != 2) return;
    for (int i = 0; i < 2; ++i)
      material.uvTransform[at + i] = numberOf(value.Get(key).Get(i), material.uvTransform[at + i]);
  };
  pair("offset", 0), pair("scale", 2);
  material.uvTransform[4] = numberOf(value.Get("rotation"), 0);
  const double set = numberOf(value.Get("texCoord"), material.texCoord);
  if (set >= 0 && set < kMostTexCoords) material.texCoord = static_cast<int>(set);
}

/// Light that goes through is light that goes through, whichever way the file says so.
void readTransmission(const tinygltf::ExtensionMap& extensions, SourceMaterial& material) {
  constexpr double kMostly = 0.5, kTint = 0.2;  // of the light; of the colour, that the picture keeps
  const auto found = extensions.find("KHR_materials_transmission");
  if (found == extensions.end() || !found->second.IsObject()) return;
  if (!(numberOf(found->second.Get("transmissionFactor"), 0) >= kMostly)) return;
  material.alpha = SourceMaterial::Alpha::kBlend;
  material.baseColor[3] = std::min(material.baseColor[3], kTint);
}

/// "image 3 of material 'oak' and 2 more".
std::string imageOf(const std::vector<SourceMaterial>& materials, std::size_t image) {
  std::string text = "image " + std::to_string(image);
  std::size_t count = 0;
  for (const SourceMaterial& material : materials)
    if (material.image == static_cast<int>(image) && count++ == 0)
      text.append(" of material '").append(material.name).append("'");
  if (count > 1) text += " and " + std::to_string(count - 1) + " more";
  return text;
}

}  // namespace

std::vector<SourceMaterial> readMaterials(const Model& model, std::vector<std::string>& warnings) {
  std::vector<SourceMaterial> materials;
  for (const tinygltf::Material& from : model.materials) {
    SourceMaterial to;
    to.name = cleanName(from.name);
    if (to.name.empty()) to.name = "material " + std::to_string(materials.size());

    // What counts for the light: the base colour.
    const auto& pbr = from.pbrMetallicRoughness;
    bool odd = false;
    for (std::size_t c = 0; c < pbr.baseColorFactor.size() && c < 4; ++c) {
      to.baseColor[c] = std::clamp(pbr.baseColorFactor[c], 0.0, 1.0);
      odd = odd || to.baseColor[c] != pbr.baseColorFactor[c];
    }
    if (odd)
      warnings.push_back("material '" + to.name + "': its base colour lies outside 0..1 and is clamped");

    // What counts for the picture alone.
    to.roughness = pbr.roughnessFactor, to.metallic = pbr.metallicFactor;
    to.doubleSided = from.doubleSided;
    to.unlit = from.extensions.count("KHR_materials_unlit") != 0;
    to.alpha = from.alphaMode == "BLEND"  ? SourceMaterial::Alpha::kBlend
               : from.alphaMode == "MASK" ? SourceMaterial::Alpha::kMask
                                          : SourceMaterial::Alpha::kOpaque;
    readTransmission(from.extensions, to);
    if (const int texture = pbr.baseColorTexture.index; texture >= 0) {
      to.image = model.textures[texture].source;
      to.texCoord = pbr.baseColorTexture.texCoord;
      readTextureTransform(pbr.baseColorTexture.extensions, to);
      if (const int sampler = model.textures[texture].sampler; sampler >= 0)
        to.wrapS = model.samplers[sampler].wrapS, to.wrapT = model.samplers[sampler].wrapT;
    }
    materials.push_back(to);
  }
  return materials;
}

std::vector<SourceImage> readImages(GltfDocument& document, const std::vector<SourceMaterial>& materials,
                                    std::vector<std::string>& warnings) {
  std::vector<SourceImage> images(document.images.size());
  std::size_t pixels = 0;
  for (std::size_t i = 0; i < images.size(); ++i) {
    images[i].encoded = std::move(document.images[i].bytes);
    images[i].mimeType = document.images[i].mimeType;
    if (images[i].encoded.empty()) continue;
    std::string why;
    if (!decodeImage(images[i], why)) {
      warnings.push_back(imageOf(materials, i) + " " + why + ": it counts as the material's plain colour");
      images[i] = {};
      continue;
    }
    pixels += images[i].rgba.size() / 4;
    if (pixels > GltfBudget::kPixels)
      throw GltfError("its textures exceed " + std::to_string(GltfBudget::kPixels >> 20) +
                      " million pixels together; make them smaller");
    images[i].mimeType = images[i].encoded[0] == kPngByte ? "image/png" : "image/jpeg";
  }
  return images;
}

}  // namespace fiatlux
