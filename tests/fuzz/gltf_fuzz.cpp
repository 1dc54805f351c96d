// Hostile files at the glTF door: reading, then building a room with small limits and its display mesh. A
// file is refused in one line or becomes a room; nothing may crash or run away. Changes are made to the JSON
// as a tree and to the binary chunk, with the container's lengths mended, so that most files come past the
// first checks.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "precompute/geometry/build_room.h"
#include "precompute/picture/display_mesh.h"
#include "tests/fuzz/json_mutation.h"
#include "tests/fuzz/one_line.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t largest);

namespace {

using Bytes = std::vector<std::uint8_t>;
using fiatlux::Random;

const std::vector<std::string> kWords = {"accessors",
                                         "bufferViews",
                                         "buffers",
                                         "meshes",
                                         "nodes",
                                         "scenes",
                                         "scene",
                                         "materials",
                                         "textures",
                                         "images",
                                         "samplers",
                                         "primitives",
                                         "attributes",
                                         "POSITION",
                                         "NORMAL",
                                         "TEXCOORD_0",
                                         "TEXCOORD_1",
                                         "COLOR_0",
                                         "indices",
                                         "material",
                                         "mode",
                                         "count",
                                         "componentType",
                                         "type",
                                         "SCALAR",
                                         "VEC2",
                                         "VEC3",
                                         "VEC4",
                                         "MAT4",
                                         "normalized",
                                         "sparse",
                                         "values",
                                         "bufferView",
                                         "byteOffset",
                                         "byteLength",
                                         "byteStride",
                                         "uri",
                                         "mimeType",
                                         "children",
                                         "mesh",
                                         "matrix",
                                         "translation",
                                         "rotation",
                                         "scale",
                                         "name",
                                         "extras",
                                         "fiatlux",
                                         "surface",
                                         "reflectance",
                                         "mount",
                                         "siteSpacing",
                                         "measure",
                                         "border",
                                         "pbrMetallicRoughness",
                                         "baseColorFactor",
                                         "baseColorTexture",
                                         "index",
                                         "texCoord",
                                         "alphaMode",
                                         "BLEND",
                                         "MASK",
                                         "OPAQUE",
                                         "doubleSided",
                                         "emissiveFactor",
                                         "extensions",
                                         "extensionsRequired",
                                         "extensionsUsed",
                                         "KHR_texture_transform",
                                         "KHR_mesh_quantization",
                                         "KHR_draco_mesh_compression",
                                         "KHR_materials_unlit",
                                         "offset",
                                         "wrapS",
                                         "wrapT",
                                         "source",
                                         "sampler",
                                         "skin",
                                         "animations",
                                         "asset",
                                         "version",
                                         "2.0",
                                         "ceiling",
                                         "min",
                                         "max"};

/// A .glb taken apart; plain JSON has no binary chunk.
struct Parts {
  bool glb = false;
  std::string text;
  Bytes bin;
};

std::uint32_t wordAt(const Bytes& file, std::size_t at) {
  std::uint32_t value;
  std::memcpy(&value, &file[at], 4);
  return value;
}

Parts partsOf(const Bytes& file) {
  Parts parts;
  parts.glb = file.size() >= 20 && std::memcmp(file.data(), "glTF", 4) == 0;
  if (!parts.glb) return parts.text.assign(file.begin(), file.end()), parts;
  const std::size_t text = std::min<std::size_t>(wordAt(file, 12), file.size() - 20);
  parts.text.assign(file.begin() + 20, file.begin() + 20 + static_cast<std::ptrdiff_t>(text));
  if (20 + text + 8 <= file.size())
    parts.bin.assign(file.begin() + 28 + static_cast<std::ptrdiff_t>(text), file.end());
  return parts;
}

Bytes fileOf(Parts parts) {
  if (!parts.glb) return {parts.text.begin(), parts.text.end()};
  parts.text.resize((parts.text.size() + 3) / 4 * 4, ' ');
  Bytes file;
  const auto word = [&](std::size_t value) {
    for (int i = 0; i < 4; ++i) file.push_back(static_cast<std::uint8_t>(value >> 8 * i));
  };
  word(0x46546c67), word(2), word(20 + parts.text.size() + (parts.bin.empty() ? 0 : 8 + parts.bin.size()));
  word(parts.text.size()), word(0x4e4f534a);
  file.insert(file.end(), parts.text.begin(), parts.text.end());
  if (parts.bin.empty()) return file;
  word(parts.bin.size()), word(0x004e4942);
  file.insert(file.end(), parts.bin.begin(), parts.bin.end());
  return file;
}

/// Some float of the chunk becomes one that geometry does not expect, or bytes change as libFuzzer likes.
void mutateBin(Bytes& bin, Random& random) {
  if (bin.size() >= 4 && random.below(2)) {
    const float values[] = {0, -0.0f, 1, 1e-7f, 1e9f, -1e30f, 3.4e38f, NAN, INFINITY, 1e-40f, 2.5f};
    std::memcpy(&bin[random.below(static_cast<std::uint32_t>(bin.size() / 4)) * 4], &values[random.below(11)],
                4);
    return;
  }
  const std::size_t size = bin.size();
  bin.resize(size + 64);
  bin.resize(LLVMFuzzerMutate(bin.data(), size, bin.size()));
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t largest,
                                               unsigned seed) {
  Random random(seed);
  Bytes file;
  Parts parts = partsOf(Bytes(data, data + size));
  const std::uint32_t way = random.below(10);
  if (way < 6) {
    parts.text = fiatlux::fuzz::mutated(parts.text, random, kWords);
    if (!parts.text.empty()) file = fileOf(std::move(parts));
  } else if (way < 9 && !parts.bin.empty()) {
    mutateBin(parts.bin, random);
    file = fileOf(std::move(parts));
  }
  if (file.empty() || file.size() > largest) return LLVMFuzzerMutate(data, size, largest);
  std::memcpy(data, file.data(), file.size());
  return file.size();
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // Patches that fit the room are small, so their rooms are made small too: a file costs milliseconds.
  const bool fit = size % 16 == 0;
  const auto scene = fiatlux::readSourceScene(Bytes(data, data + size), "fuzz.glb", fit ? 0.1 : 1);
  if (!scene) return fiatlux::fuzz::requireOneLine(scene.error().message), 0;
  std::size_t triangles = 0;
  for (const auto& mesh : scene->meshes) triangles += mesh.triangles.size();
  if (triangles > 2000) return 0;  // for speed: large files are tests of their own
  fiatlux::RoomOptions options;
  options.patch = fit ? 0 : 0.5;
  options.memory = 0.05;
  options.rays = 16;
  const auto room = fiatlux::buildRoom(*scene, options);
  if (!room) return fiatlux::fuzz::requireOneLine(room.error().message), 0;
  for (const std::string& warning : room->warnings) fiatlux::fuzz::requireOneLine(warning);
  for (std::uint32_t p = 0; p < room->patches.rows(); ++p)
    if (!(room->patches.area[p] > 0) || !std::isfinite(fiatlux::length(room->patches.center[p])) ||
        !(room->patches.reflectance[p] >= 0 && room->patches.reflectance[p] <= 0.95f))
      std::abort();
  if (room->patches.rows() < 20000) (void)fiatlux::displayMesh(*scene, *room);
  return 0;
}
