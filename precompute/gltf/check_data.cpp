// Buffers, their views and accessors (glTF 2.0, section 3.6): nothing reaches beyond the bytes it is in.
#include <algorithm>
#include <cstdint>
#include <string>

#include "precompute/gltf/check.h"
#include "precompute/gltf/codes.h"
#include "precompute/gltf/fields.h"

namespace fiatlux {
namespace {

using nlohmann::json;

// The largest whole number that both JSON (53 bits) and this machine (32, as Wasm) hold.
constexpr auto kLargestWhole =
    static_cast<std::size_t>(std::min<std::uint64_t>(SIZE_MAX, std::uint64_t{1} << 53));
constexpr std::size_t kMostStride = 252;  // bytes, glTF 2.0, section 5.11

void checkBuffers(const json& file) {
  std::size_t index = 0, total = 0;
  for (const json& buffer : arrayOf(file, "buffers")) {
    const std::string place = placeOf("buffer", index++);
    total += whole(buffer, "byteLength", place, GltfBudget::kBytes, true);
    if (total > GltfBudget::kBytes)
      throw GltfError("its buffers exceed " + megabytes(GltfBudget::kBytes) +
                      " together; make the meshes or textures smaller");
    checkString(buffer, "uri", place);
  }
  const json& buffers = arrayOf(file, "buffers");
  index = 0;
  for (const json& view : arrayOf(file, "bufferViews")) {
    const std::string place = placeOf("buffer view", index++);
    checkIndex(view, "buffer", place, buffers.size(), true);
    const auto size = buffers[view["buffer"].get<std::size_t>()]["byteLength"].get<std::size_t>();
    const std::size_t offset = whole(view, "byteOffset", place, kLargestWhole);
    const std::size_t length = whole(view, "byteLength", place, kLargestWhole, true);
    if (offset > size || length > size - offset)
      throw GltfError(place + " reaches beyond its buffer of " + std::to_string(size) + " bytes" + kAgain);
    if (view.contains("byteStride")) {
      const std::size_t stride = whole(view, "byteStride", place, kMostStride);
      if (stride < 1) throw GltfError(place + ": 'byteStride' is 0" + kAgain);
    }
  }
}

std::size_t componentBytes(std::size_t type) {
  switch (type) {
    case gltf::kByte:
    case gltf::kUnsignedByte:
      return 1;
    case gltf::kShort:
    case gltf::kUnsignedShort:
      return 2;
    case gltf::kUnsignedInt:
    case gltf::kFloat:
      return 4;
    default:
      return 0;
  }
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
  const std::size_t offset = whole(object, "byteOffset", place, kLargestWhole);
  const std::size_t stride = view.contains("byteStride") ? view["byteStride"].get<std::size_t>() : element;
  if (stride < element) throw GltfError(place + ": its elements overlap in the buffer view" + kAgain);
  if (offset > length || element > length - offset || (count - 1) > (length - offset - element) / stride)
    throw GltfError(place + ": " + std::to_string(count) + " elements do not fit into its buffer view" +
                    kAgain);
}

void checkAccessors(const json& file) {
  const json& views = arrayOf(file, "bufferViews");
  std::size_t index = 0;
  for (const json& accessor : arrayOf(file, "accessors")) {
    // Its own elements.
    const std::string place = placeOf("accessor", index++);
    const std::size_t count = whole(accessor, "count", place, GltfBudget::kBytes, true);
    if (count == 0) throw GltfError(place + ": 'count' is 0" + kAgain);
    const std::size_t component = componentBytes(whole(accessor, "componentType", place, gltf::kFloat, true));
    checkString(accessor, "type", place);
    const std::size_t element = accessor.contains("type") ? elementBytes(accessor["type"], component) : 0;
    if (component == 0 || element == 0) throw GltfError(place + " has an unknown type" + kAgain);
    if (accessor.contains("normalized") && !accessor["normalized"].is_boolean())
      throw GltfError(place + ": 'normalized' is neither true nor false" + kAgain);
    if (accessor.contains("bufferView"))
      checkExtent(accessor, views, place, count, element);
    else if (count > 3 * GltfBudget::kTriangles)
      throw GltfError(place + ": " + std::to_string(count) + " elements without data" + kAgain);

    // Those that sparse storage puts in their place.
    if (!accessor.contains("sparse")) continue;
    checkObject(accessor, "sparse", place);
    const json& sparse = accessor["sparse"];
    const std::size_t changed = whole(sparse, "count", place + " (sparse)", count, true);
    checkObject(sparse, "indices", place), checkObject(sparse, "values", place);
    if (changed == 0 || !sparse.contains("indices") || !sparse.contains("values"))
      throw GltfError(place + ": its sparse part lacks indices or values" + kAgain);
    const std::size_t type =
        whole(sparse["indices"], "componentType", place + " (sparse)", gltf::kFloat, true);
    if (!isUnsigned(type)) throw GltfError(place + ": its sparse indices have a wrong type" + kAgain);
    checkExtent(sparse["indices"], views, place + " (sparse indices)", changed, componentBytes(type));
    checkExtent(sparse["values"], views, place + " (sparse values)", changed, element);
  }
}

}  // namespace

void checkGltfData(const json& file) {
  checkBuffers(file);
  checkAccessors(file);
}

}  // namespace fiatlux
