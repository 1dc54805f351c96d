#include "precompute/gltf/uri.h"

#include <algorithm>
#include <sstream>

#include "precompute/base/names.h"

namespace fiatlux {
namespace {

constexpr const char* kBeside = "; put the file beside the glTF and name it plainly, or export as .glb";

std::string inQuotes(const std::string& text) {
  std::string quoted = "'";
  return quoted.append(cleanText(text)).append("'");
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

/// The plain relative name that a uri means: no address, nothing absolute, nothing that leads upward.
std::string siblingName(const std::string& uri, const std::string& place) {
  const std::string name = percentDecoded(uri), shown = inQuotes(name);
  if (name.find("//") != std::string::npos || name.find(':') != std::string::npos)
    throw GltfError(place + " names the address " + shown + ", and nothing is fetched" + kBeside);
  if (name.empty() || name[0] == '/' || name[0] == '~' || name.find('\\') != std::string::npos ||
      name.find('\0') != std::string::npos)
    throw GltfError(place + " names " + shown + ", which is not a plain relative name" + kBeside);
  std::istringstream parts(name);
  for (std::string part; std::getline(parts, part, '/');)
    if (part == "..")
      throw GltfError(place + " names " + shown + ", which lies outside the file's folder" + kBeside);
  return name;
}

std::vector<std::uint8_t> readSibling(const std::string& uri, const Resolve& resolve,
                                      const std::string& place) {
  const std::string name = siblingName(uri, place), named = place + " names " + inQuotes(name);
  if (!resolve) throw GltfError(named + ", but this file stands alone; export as .glb");
  Result<std::optional<std::vector<std::uint8_t>>> found = resolve(name);
  if (!found) throw GltfError(named + ", which " + found.error().message);
  if (!*found) throw MissingFile(named + ", which is not there" + kBeside);
  return std::move(**found);
}

}  // namespace

std::vector<std::uint8_t> bytesBehind(const std::string& uri, const Resolve& resolve,
                                      const std::string& place, std::size_t& budget, std::string* mimeType) {
  auto bytes = uri.compare(0, 5, "data:") == 0 ? decodeDataUri(uri, place, mimeType)
                                               : readSibling(uri, resolve, place);
  if (bytes.size() > budget)
    throw GltfError(place + ": the file and what it names exceed " + megabytes(GltfBudget::kBytes) +
                    "; make the textures or meshes smaller");
  budget -= bytes.size();
  return bytes;
}

}  // namespace fiatlux
