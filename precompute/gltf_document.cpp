// Opening of a glTF container: GLB chunks or plain JSON, a depth-limited parse, and the bytes behind each
// uri.
#include "precompute/gltf_document.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>

#include "precompute/names.h"

namespace fiatlux {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct MissingFile : GltfError {
  using GltfError::GltfError;
};

/// Counts depth and values while the text streams by, so that a hostile nesting never becomes a tree.
struct DepthGuard : json::json_sax_t {
  int depth = 0;
  std::size_t values = 0;
  std::string problem;

  bool count() {
    if (++values <= GltfBudget::kValues) return true;
    problem = "the JSON holds more than 16 million values; merge or thin out the model before export";
    return false;
  }
  bool enter() {
    if (++depth > GltfBudget::kDepth) {
      problem = "the JSON is nested more than 64 levels deep; no sound glTF is: export the file again";
      return false;
    }
    return count();
  }
  bool null() override { return count(); }
  bool boolean(bool) override { return count(); }
  bool number_integer(number_integer_t) override { return count(); }
  bool number_unsigned(number_unsigned_t) override { return count(); }
  bool number_float(number_float_t, const string_t&) override { return count(); }
  bool string(string_t&) override { return count(); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return enter(); }
  bool key(string_t&) override { return true; }
  bool end_object() override { return --depth, true; }
  bool start_array(std::size_t) override { return enter(); }
  bool end_array() override { return --depth, true; }
  bool parse_error(std::size_t position, const std::string&, const json::exception& error) override {
    problem = std::strstr(error.what(), "out_of_range") ? "a number of the JSON is out of range near byte "
                                                        : "the JSON is broken near byte ";
    problem += std::to_string(position) + "; export the file again";
    return false;
  }
};

std::uint32_t word(const std::vector<std::uint8_t>& bytes, std::size_t at) {
  return bytes[at] | bytes[at + 1] << 8 | bytes[at + 2] << 16 |
         static_cast<std::uint32_t>(bytes[at + 3]) << 24;
}

struct Container {
  const char* text = nullptr;
  std::size_t textSize = 0;
  std::size_t binOffset = 0, binSize = 0;
};

Container openGlb(const std::vector<std::uint8_t>& bytes) {
  if (bytes.size() < 20) throw GltfError("the GLB is cut off; export it again");
  if (word(bytes, 4) != 2)
    throw GltfError("GLB version " + std::to_string(word(bytes, 4)) + " is not 2; export as glTF 2.0");
  const std::size_t total = word(bytes, 8);
  if (total > bytes.size() || total < 20)
    throw GltfError("the GLB says it has " + std::to_string(total) + " bytes but the file has " +
                    std::to_string(bytes.size()) + "; it is cut off or damaged, copy it again");
  Container found;
  for (std::size_t at = 12; at + 8 <= total;) {
    const std::size_t size = word(bytes, at), type = word(bytes, at + 4);
    if (size > total - at - 8)
      throw GltfError("the GLB chunk at byte " + std::to_string(at) +
                      " is longer than the file; it is damaged, export it again");
    if (at == 12 && type != 0x4e4f534a) throw GltfError("the GLB does not start with JSON; export it again");
    if (at == 12) {
      found.text = reinterpret_cast<const char*>(bytes.data()) + 20;
      found.textSize = size;
    } else if (type == 0x004e4942 && found.binOffset == 0) {
      found.binOffset = at + 8;
      found.binSize = size;
    }
    at += 8 + size;
  }
  return found;
}

Container openContainer(const std::vector<std::uint8_t>& bytes) {
  if (bytes.empty()) throw GltfError("the file is empty; export it again");
  if (bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0) return openGlb(bytes);
  Container found{reinterpret_cast<const char*>(bytes.data()), bytes.size(), 0, 0};
  if (bytes.size() >= 3 && std::memcmp(bytes.data(), "\xef\xbb\xbf", 3) == 0)
    found.text += 3, found.textSize -= 3;
  std::size_t first = 0;
  while (first < found.textSize && std::strchr(" \t\r\n", found.text[first]) && found.text[first]) ++first;
  if (first == found.textSize || found.text[first] != '{')
    throw GltfError("this is neither a GLB nor glTF JSON in UTF-8; export the room as .glb or .gltf");
  return found;
}

int base64Value(unsigned char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  return c == '+' || c == '-' ? 62 : c == '/' || c == '_' ? 63 : -1;
}

std::vector<std::uint8_t> decodeDataUri(const std::string& uri, const std::string& place,
                                        std::string* mimeType) {
  const std::size_t comma = uri.find(',');
  const std::string head = uri.substr(0, std::min<std::size_t>(comma, 100));
  if (comma == std::string::npos || head.find(";base64") == std::string::npos)
    throw GltfError(place + ": its data: address is not base64; export the file again");
  if (mimeType) *mimeType = cleanText(head.substr(5, head.find(';') - 5));
  std::size_t end = uri.size();
  while (end > comma + 1 && uri[end - 1] == '=' && uri.size() - end < 2) --end;
  std::vector<std::uint8_t> bytes;
  bytes.reserve((end - comma) * 3 / 4);
  std::uint32_t bits = 0;
  int count = 0;
  for (std::size_t i = comma + 1; i < end; ++i) {
    const int value = base64Value(uri[i]);
    if (value < 0)
      throw GltfError(place + ": bad base64 at character " + std::to_string(i) + "; export the file again");
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    if ((count += 6) >= 8) bytes.push_back(static_cast<std::uint8_t>(bits >> (count -= 8)));
  }
  if (count >= 6) throw GltfError(place + ": its base64 is cut off; export the file again");
  return bytes;
}

std::string percentDecoded(const std::string& uri) {
  std::string text;
  const auto hex = [](char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
  };
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] == '%' && i + 2 < uri.size() && hex(uri[i + 1]) >= 0 && hex(uri[i + 2]) >= 0) {
      text += static_cast<char>(hex(uri[i + 1]) * 16 + hex(uri[i + 2]));
      i += 2;
    } else {
      text += uri[i];
    }
  }
  return text;
}

/// The file behind a relative uri; only below `folder`, also after links are followed.
std::string siblingPath(const std::string& uri, const std::string& folder, const std::string& place) {
  const std::string name = percentDecoded(uri), shown = "'" + cleanText(name) + "'";
  const std::string cure = "; put the file beside the glTF and name it plainly, or export as .glb";
  if (name.find("//") != std::string::npos || name.find(':') != std::string::npos)
    throw GltfError(place + " names the address " + shown + ", and nothing is fetched" + cure);
  if (name.empty() || name[0] == '/' || name[0] == '~' || name.find('\\') != std::string::npos ||
      name.find('\0') != std::string::npos)
    throw GltfError(place + " names " + shown + ", which is not a plain relative name" + cure);
  for (const fs::path& part : fs::path(name))
    if (part == "..")
      throw GltfError(place + " names " + shown + ", which lies outside the file's folder" + cure);
  if (folder.empty())
    throw GltfError(place + " names " + shown + ", but this file stands alone; export as .glb");
  std::error_code error;
  const fs::path root = fs::canonical(folder, error), path = fs::canonical(root / name, error);
  if (error) throw MissingFile(place + " names " + shown + ", which is not there" + cure);
  if (std::mismatch(root.begin(), root.end(), path.begin(), path.end()).first != root.end())
    throw GltfError(place + " names " + shown + ", which links to outside the file's folder" + cure);
  return path.string();
}

std::string placeOf(const char* kind, std::size_t index) {
  return std::string(kind) + " " + std::to_string(index);
}

std::vector<std::uint8_t> bytesBehind(const std::string& uri, const std::string& folder,
                                      const std::string& place, std::size_t& budget,
                                      std::string* mimeType = nullptr) {
  auto bytes = uri.compare(0, 5, "data:") == 0 ? decodeDataUri(uri, place, mimeType)
                                               : readWholeFile(siblingPath(uri, folder, place));
  if (bytes.size() > budget)
    throw GltfError(place +
                    ": the file and what it names exceed 256 MB; make the textures or meshes smaller");
  budget -= bytes.size();
  return bytes;
}

void loadBuffers(GltfDocument& document, const std::vector<std::uint8_t>& file, const Container& container,
                 const std::string& folder, std::size_t& budget) {
  if (!document.json.contains("buffers")) return;
  std::size_t index = 0;
  for (json& buffer : document.json["buffers"]) {
    const std::string place = placeOf("buffer", index);
    const auto length = buffer["byteLength"].get<std::size_t>();
    std::vector<std::uint8_t> bytes;
    if (buffer.contains("uri")) {
      bytes = bytesBehind(buffer["uri"].get<std::string>(), folder, place, budget);
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

void loadImages(GltfDocument& document, const std::string& folder, std::size_t& budget) {
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
          loaded.bytes = bytesBehind(image["uri"], folder, place, budget, &loaded.mimeType);
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

std::vector<std::uint8_t> readWholeFile(const std::string& path) {
  std::error_code error;
  const std::string shown = "'" + cleanText(path) + "'";
  if (!fs::exists(path, error)) throw GltfError(shown + " does not exist; check the name");
  if (!fs::is_regular_file(path, error)) throw GltfError(shown + " is not a file; name a .glb or .gltf file");
  const auto size = fs::file_size(path, error);
  if (error || size > GltfBudget::kBytes)
    throw GltfError(shown + " has " + std::to_string(size >> 20) +
                    " MB, and 256 MB are accepted; make the textures or meshes smaller");
  std::ifstream file(path, std::ios::binary);
  std::vector<std::uint8_t> bytes(size);
  if (!file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size)) && size > 0)
    throw GltfError(shown + " cannot be read; check its permissions");
  return bytes;
}

GltfDocument readGltfDocument(const std::vector<std::uint8_t>& bytes, const std::string& folder) {
  if (bytes.size() > GltfBudget::kBytes)
    throw GltfError("more than 256 MB; make the textures or meshes smaller");
  const Container container = openContainer(bytes);
  const char* end = container.text + container.textSize;
  while (end > container.text && (end[-1] == '\0' || end[-1] == ' ')) --end;  // padding of a GLB chunk

  DepthGuard guard;
  if (!json::sax_parse(container.text, end, &guard))
    throw GltfError(guard.problem.empty() ? "the JSON is broken; export the file again" : guard.problem);

  GltfDocument document;
  document.json = json::parse(container.text, end);
  checkGltf(document.json);
  std::size_t budget = GltfBudget::kBytes;
  loadBuffers(document, bytes, container, folder, budget);
  loadImages(document, folder, budget);

  Fnv hash;
  hash.add(bytes.data(), bytes.size());
  if (container.binOffset == 0 || document.buffers.size() > 1)
    for (const auto& buffer : document.buffers) hash.add(buffer.data(), buffer.size());
  for (const auto& image : document.images) hash.add(image.bytes.data(), image.bytes.size());
  document.hash = hash.hex();
  return document;
}

}  // namespace fiatlux
