// Writes a .glb: binary views collected in one chunk, JSON around them.
#pragma once

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "precompute/base/json_text.h"
#include "precompute/gltf/codes.h"

namespace fiatlux {

class GlbWriter {
 public:
  nlohmann::ordered_json json = {{"asset", {{"version", "2.0"}, {"generator", "fiatlux"}}}};

  /// Appends bytes, 4-byte aligned; returns the view's index. `stride` 0 = tightly packed; `target` 0 = none.
  int addView(const void* bytes, std::size_t size, int stride, int target) {
    const auto* from = static_cast<const std::uint8_t*>(bytes);
    nlohmann::ordered_json view = {{"buffer", 0}, {"byteOffset", bin_.size()}, {"byteLength", size}};
    if (stride) view["byteStride"] = stride;
    if (target) view["target"] = target;
    bin_.insert(bin_.end(), from, from + size);
    bin_.resize((bin_.size() + 3) / 4 * 4, 0);
    return append("bufferViews", std::move(view));
  }

  int addAccessor(int view, int componentType, bool normalized, std::size_t count, const char* type) {
    nlohmann::ordered_json accessor = {
        {"bufferView", view}, {"componentType", componentType}, {"count", count}, {"type", type}};
    if (normalized) accessor["normalized"] = true;
    return append("accessors", std::move(accessor));
  }

  /// Appends to a top-level list, making it; returns the index.
  int append(const char* list, nlohmann::ordered_json entry) {
    json[list].push_back(std::move(entry));
    return static_cast<int>(json[list].size()) - 1;
  }

  std::vector<std::uint8_t> bytes() {
    if (!bin_.empty()) json["buffers"] = {{{"byteLength", bin_.size()}}};
    std::string text = jsonText(json);
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::vector<std::uint8_t> out;
    const auto word = [&](std::size_t value) {
      for (int i = 0; i < 4; ++i) out.push_back(static_cast<std::uint8_t>(value >> 8 * i));
    };
    word(gltf::kMagic), word(gltf::kGlbVersion);
    word(gltf::kGlbHeaderBytes + gltf::kChunkHeaderBytes + text.size() +
         (bin_.empty() ? 0 : gltf::kChunkHeaderBytes + bin_.size()));
    word(text.size()), word(gltf::kJsonChunk);
    out.insert(out.end(), text.begin(), text.end());
    if (!bin_.empty()) {
      word(bin_.size()), word(gltf::kBinaryChunk);
      out.insert(out.end(), bin_.begin(), bin_.end());
    }
    return out;
  }

 private:
  std::vector<std::uint8_t> bin_;
};

}  // namespace fiatlux
