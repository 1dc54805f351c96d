// Buffers and images brought to hand, and the hash of all that was read.
#include "precompute/gltf/document.h"

#include <cstdio>
#include <set>

#include "precompute/base/names.h"
#include "precompute/gltf/check.h"
#include "precompute/gltf/container.h"
#include "precompute/gltf/fields.h"
#include "precompute/gltf/unpack.h"
#include "precompute/gltf/uri.h"

namespace fiatlux {
namespace {

using nlohmann::json;

void loadBuffers(GltfDocument& document, const std::vector<std::uint8_t>& file,
                 const GltfContainer& container, const Resolve& resolve, std::size_t& budget) {
  if (!document.json.contains("buffers")) return;
  std::size_t index = 0;
  for (json& buffer : document.json["buffers"]) {
    const std::string place = placeOf("buffer", index);
    const auto length = buffer["byteLength"].get<std::size_t>();
    std::vector<std::uint8_t> bytes;
    if (isUnpackedTo(buffer)) {
      buffer.erase("uri");
      document.buffers.emplace_back();
      ++index;
      continue;
    }
    if (buffer.contains("uri")) {
      bytes = bytesBehind(buffer["uri"].get<std::string>(), resolve, place, budget);
      buffer.erase("uri");
    } else if (index == 0 && container.binSize > 0) {
      bytes.assign(file.begin() + container.binOffset,
                   file.begin() + container.binOffset + container.binSize);
    } else {
      throw GltfError(place + " has neither an address nor a GLB chunk; export the file again");
    }
    if (bytes.size() < length)
      throw GltfError(place + " should have " + std::to_string(length) + " bytes but has " +
                      std::to_string(bytes.size()) + "; the file is cut off, copy or export it again");
    document.buffers.push_back(std::move(bytes));
    ++index;
  }
}

/// The picture of another kind that a texture has instead of PNG or JPEG, so that it is read or named.
void takeOtherSources(json& gltf) {
  if (!gltf.contains("textures")) return;
  for (json& texture : gltf["textures"])
    for (const char* kind : kPictureExtensions) {
      const json::json_pointer at = json::json_pointer("/extensions") / kind / "source";
      if (!texture.contains("source") && texture.contains(at)) texture["source"] = texture[at];
    }
}

/// Images that a base colour needs; the others (normal maps...) do not reach the light and are never opened.
std::set<std::size_t> imagesInUse(const json& gltf) {
  std::set<std::size_t> used;
  if (!gltf.contains("materials")) return used;
  for (const json& material : gltf["materials"]) {
    const json texture =
        material.value("pbrMetallicRoughness", json::object()).value("baseColorTexture", json::object());
    if (!texture.contains("index")) continue;
    const json& entry = gltf["textures"][texture["index"].get<std::size_t>()];
    if (entry.contains("source")) used.insert(entry["source"].get<std::size_t>());
  }
  return used;
}

void loadImages(GltfDocument& document, const Resolve& resolve, std::size_t& budget) {
  const std::set<std::size_t> used = imagesInUse(document.json);
  if (!document.json.contains("images")) return;
  std::size_t index = 0;
  for (json& image : document.json["images"]) {
    GltfDocument::Image loaded;
    const std::string place = placeOf("image", index);
    loaded.mimeType = image.contains("mimeType") ? cleanText(image["mimeType"].get<std::string>()) : "";
    if (image.contains("uri")) {
      try {
        if (used.count(index))
          loaded.bytes = bytesBehind(image["uri"], resolve, place, budget, &loaded.mimeType);
      } catch (const MissingFile& missing) {
        document.warnings.push_back(std::string(missing.what()) +
                                    " (its colour is taken without the picture)");
      }
    } else if (image.contains("bufferView") && used.count(index)) {
      const json& view = document.json["bufferViews"][image["bufferView"].get<std::size_t>()];
      const auto& buffer = document.buffers[view["buffer"].get<std::size_t>()];
      const auto begin =
          buffer.begin() + static_cast<std::ptrdiff_t>(view.value("byteOffset", std::size_t{0}));
      loaded.bytes.assign(begin, begin + static_cast<std::ptrdiff_t>(view["byteLength"].get<std::size_t>()));
    }
    document.images.push_back(std::move(loaded));
    ++index;
  }
}

struct Fnv {
  std::uint64_t state = 0xcbf29ce484222325ull;
  void add(const std::uint8_t* bytes, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) state = (state ^ bytes[i]) * 0x100000001b3ull;
  }
  std::string hex() const {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(state));
    return text;
  }
};

}  // namespace

GltfDocument readGltfDocument(const std::vector<std::uint8_t>& bytes, const Resolve& resolve) {
  if (bytes.size() > GltfBudget::kBytes)
    throw GltfError("more than " + megabytes(GltfBudget::kBytes) + "; make the textures or meshes smaller");
  const GltfContainer container = openContainer(bytes);
  GltfDocument document;
  document.json = parseGltfJson(container);
  checkGltf(document.json);
  std::size_t budget = GltfBudget::kBytes;
  loadBuffers(document, bytes, container, resolve, budget);
  takeOtherSources(document.json);
  loadImages(document, resolve, budget);

  Fnv hash;
  hash.add(bytes.data(), bytes.size());
  if (container.binOffset == 0 || document.buffers.size() > 1)
    for (const auto& buffer : document.buffers) hash.add(buffer.data(), buffer.size());
  for (const auto& image : document.images) hash.add(image.bytes.data(), image.bytes.size());
  document.hash = hash.hex();
  unpackMeshes(document);
  return document;
}

}  // namespace fiatlux
