#include "precompute/gltf/container.h"

#include <cstring>
#include <string>
#include <string_view>

#include "precompute/base/json_text.h"
#include "precompute/gltf/codes.h"
#include "precompute/gltf/refusal.h"

namespace fiatlux {
namespace {

using nlohmann::json;

constexpr std::size_t kLeastGlb = gltf::kGlbHeaderBytes + gltf::kChunkHeaderBytes;

/// A hostile nesting or number of values never becomes a tree.
void checkExtent(std::string_view text) {
  const JsonExtent extent = extentOfJson(text);
  if (extent.depth > GltfBudget::kDepth)
    throw GltfError("the JSON is nested more than " + std::to_string(GltfBudget::kDepth) +
                    " levels deep; no sound glTF is: export the file again");
  if (extent.values > GltfBudget::kValues)
    throw GltfError("the JSON holds more than " + std::to_string(GltfBudget::kValues / 1'000'000) +
                    " million values; merge or thin out the model before export");
}

std::uint32_t word(const std::vector<std::uint8_t>& bytes, std::size_t at) {
  return bytes[at] | bytes[at + 1] << 8 | bytes[at + 2] << 16 |
         static_cast<std::uint32_t>(bytes[at + 3]) << 24;
}

GltfContainer openGlb(const std::vector<std::uint8_t>& bytes) {
  if (bytes.size() < kLeastGlb) throw GltfError("the GLB is cut off; export it again");
  if (word(bytes, 4) != gltf::kGlbVersion)
    throw GltfError("GLB version " + std::to_string(word(bytes, 4)) + " is not 2; export as glTF 2.0");
  const std::size_t total = word(bytes, 8);
  if (total > bytes.size() || total < kLeastGlb)
    throw GltfError("the GLB says it has " + std::to_string(total) + " bytes but the file has " +
                    std::to_string(bytes.size()) + "; it is cut off or damaged, copy it again");
  GltfContainer found;
  for (std::size_t at = gltf::kGlbHeaderBytes; at + gltf::kChunkHeaderBytes <= total;) {
    const std::size_t size = word(bytes, at), type = word(bytes, at + 4);
    const std::size_t begin = at + gltf::kChunkHeaderBytes;
    const bool first = at == gltf::kGlbHeaderBytes;
    if (size > total - begin)
      throw GltfError("the GLB chunk at byte " + std::to_string(at) +
                      " is longer than the file; it is damaged, export it again");
    if (first && type != gltf::kJsonChunk)
      throw GltfError("the GLB does not start with JSON; export it again");
    if (first) {
      found.text = reinterpret_cast<const char*>(bytes.data()) + begin;
      found.textSize = size;
    } else if (type == gltf::kBinaryChunk && found.binOffset == 0) {
      found.binOffset = begin;
      found.binSize = size;
    }
    at = begin + size;
  }
  return found;
}

}  // namespace

GltfContainer openContainer(const std::vector<std::uint8_t>& bytes) {
  if (bytes.empty()) throw GltfError("the file is empty; export it again");
  if (bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0) return openGlb(bytes);
  GltfContainer found{reinterpret_cast<const char*>(bytes.data()), bytes.size(), 0, 0};
  if (bytes.size() >= 3 && std::memcmp(bytes.data(), "\xef\xbb\xbf", 3) == 0)
    found.text += 3, found.textSize -= 3;
  std::size_t first = 0;
  while (first < found.textSize && std::strchr(" \t\r\n", found.text[first]) && found.text[first]) ++first;
  if (first == found.textSize || found.text[first] != '{')
    throw GltfError("this is neither a GLB nor glTF JSON in UTF-8; export the room as .glb or .gltf");
  return found;
}

json parseGltfJson(const GltfContainer& container) {
  const char* end = container.text + container.textSize;
  while (end > container.text && (end[-1] == '\0' || end[-1] == ' ')) --end;  // padding of a GLB chunk

  checkExtent({container.text, static_cast<std::size_t>(end - container.text)});
  try {
    return json::parse(container.text, end);
  } catch (const json::parse_error& error) {
    throw GltfError("the JSON is broken near byte " + std::to_string(error.byte) + "; export the file again");
  } catch (const json::out_of_range&) {
    throw GltfError("a number of the JSON is out of range; export the file again");
  }
}

}  // namespace fiatlux
