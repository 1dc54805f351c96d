#define TINYGLTF_IMPLEMENTATION
#include "precompute/gltf/model.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "precompute/base/json_text.h"
#include "precompute/base/names.h"
#include "precompute/gltf/codes.h"
#include "precompute/gltf/refusal.h"

namespace fiatlux {
namespace {

double componentAt(const unsigned char* at, int type, bool normalized) {
  const auto read = [&](auto value) {
    std::memcpy(&value, at, sizeof value);
    return static_cast<double>(value);
  };
  switch (type) {
    case gltf::kByte:
      return normalized ? std::max(read(std::int8_t{}) / 127, -1.0) : read(std::int8_t{});
    case gltf::kUnsignedByte:
      return read(std::uint8_t{}) / (normalized ? 255 : 1);
    case gltf::kShort:
      return normalized ? std::max(read(std::int16_t{}) / 32767, -1.0) : read(std::int16_t{});
    case gltf::kUnsignedShort:
      return read(std::uint16_t{}) / (normalized ? 65535 : 1);
    case gltf::kUnsignedInt:
      return read(std::uint32_t{});
    default:
      return read(float{});
  }
}

}  // namespace

Model parseModel(GltfDocument& document) {
  // Buffers come from memory under made-up names.
  auto& json = document.json;
  json.erase("images");
  json.erase("animations");
  json.erase("cameras");
  for (std::size_t i = 0; i < document.buffers.size(); ++i)
    json["buffers"][i]["uri"] = "buffer-" + std::to_string(i);
  tinygltf::FsCallbacks files{};
  files.user_data = &document;
  files.FileExists = [](const std::string& name, void*) { return name.find("buffer-") != std::string::npos; };
  files.ExpandFilePath = [](const std::string& name, void*) { return name; };
  files.ReadWholeFile = [](std::vector<unsigned char>* out, std::string*, const std::string& name,
                           void* user) {
    auto& source = *static_cast<GltfDocument*>(user);
    const auto index = std::strtoul(name.c_str() + name.rfind('-') + 1, nullptr, 10);
    if (index >= source.buffers.size()) return false;
    *out = std::move(source.buffers[index]);
    out->resize(source.json["buffers"][index]["byteLength"].get<std::size_t>());
    return true;
  };
  files.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
    return false;
  };

  // note: tinygltf takes text alone. It gets our checked tree, in which no address is left, and not the
  // file's own.
  const std::string text = jsonText(json);
  tinygltf::TinyGLTF loader;
  loader.SetFsCallbacks(files);
  Model model;
  std::string error, warning;
  if (!loader.LoadASCIIFromString(&model, &error, &warning, text.c_str(), static_cast<unsigned>(text.size()),
                                  ""))
    throw GltfError("not understood: " + cleanText(error.substr(0, 400)) + "; export the file again");
  return model;
}

template <class T>
std::vector<T> readAccessor(const Model& model, int index) {
  const tinygltf::Accessor& accessor = model.accessors[index];
  const int width = tinygltf::GetNumComponentsInType(accessor.type);
  const int bytes = tinygltf::GetComponentSizeInBytes(accessor.componentType);
  std::vector<T> values(accessor.count * width, T{0});
  const auto copy = [&](const tinygltf::BufferView& view, std::size_t offset, std::size_t element,
                        std::size_t target) {
    const std::size_t stride = view.byteStride ? view.byteStride : std::size_t(width) * bytes;
    const unsigned char* at =
        model.buffers[view.buffer].data.data() + view.byteOffset + offset + element * stride;
    for (int c = 0; c < width; ++c)
      values[target * width + c] =
          static_cast<T>(componentAt(at + c * bytes, accessor.componentType, accessor.normalized));
  };

  // Its own elements.
  if (accessor.bufferView >= 0)
    for (std::size_t i = 0; i < accessor.count; ++i)
      copy(model.bufferViews[accessor.bufferView], accessor.byteOffset, i, i);
  if (!accessor.sparse.isSparse) return values;

  // Those that sparse storage puts in their place.
  const auto& sparse = accessor.sparse;
  const tinygltf::BufferView& view = model.bufferViews[sparse.indices.bufferView];
  const int indexBytes = tinygltf::GetComponentSizeInBytes(sparse.indices.componentType);
  for (int i = 0; i < sparse.count; ++i) {
    const unsigned char* at = model.buffers[view.buffer].data.data() + view.byteOffset +
                              sparse.indices.byteOffset + std::size_t(i) * indexBytes;
    const double target = componentAt(at, sparse.indices.componentType, false);
    if (target >= static_cast<double>(accessor.count))
      throw GltfError("accessor " + std::to_string(index) +
                      ": a sparse index is out of range; export the file again");
    copy(model.bufferViews[sparse.values.bufferView], sparse.values.byteOffset, i,
         static_cast<std::size_t>(target));
  }
  return values;
}

template std::vector<float> readAccessor(const Model&, int);
template std::vector<double> readAccessor(const Model&, int);
template std::vector<std::uint32_t> readAccessor(const Model&, int);

}  // namespace fiatlux
