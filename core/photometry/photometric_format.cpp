#include "core/photometry/photometric_format.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "core/photometry/photometric_text.h"

namespace fiatlux {
namespace {

using std::string_view;

constexpr std::size_t kLooked = 4096, kMostNames = 5;  // bytes of a head; names in one sentence

struct Magic {
  string_view start, kind;
};

constexpr std::array<Magic, 8> kPictures = {{{"\x89PNG", "a PNG picture"},
                                             {"\xff\xd8\xff", "a JPEG picture"},
                                             {"GIF8", "a GIF picture"},
                                             {"RIFF", "a WebP picture or a sound"},
                                             {"BM", "a BMP picture"},
                                             {"II*", "a TIFF picture"},
                                             {"%PDF", "a PDF document"},
                                             {"glTF", "a 3D model"}}};

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c; }

/// Is `word` (lower case) anywhere in `text`?
bool names(string_view text, string_view word) {
  return std::search(text.begin(), text.end(), word.begin(), word.end(),
                     [](char a, char b) { return lower(a) == b; }) != text.end();
}

bool isPhotometricName(string_view name) {
  if (name.size() < 5) return false;
  std::string end(name.substr(name.size() - 4));
  std::transform(end.begin(), end.end(), end.begin(), lower);
  return end == ".ldt" || end == ".ies";
}

/// "a.ldt, b.ies and others".
std::string listed(const std::vector<string_view>& files) {
  std::string list;
  for (std::size_t i = 0; i < std::min(files.size(), kMostNames); ++i)
    list.append(i ? ", " : "").append(shortText(files[i].substr(0, 80)));
  return list + (files.size() > kMostNames ? " and others" : "");
}

void add(std::vector<string_view>& files, string_view name) {
  if (isPhotometricName(name) && std::find(files.begin(), files.end(), name) == files.end())
    files.push_back(name);
}

/// Names in a zip's central directory; nothing is inflated.
std::vector<string_view> photometricFilesOfZip(string_view bytes) {
  std::vector<string_view> files;
  const auto byte = [&](std::size_t i) {
    return static_cast<std::size_t>(static_cast<std::uint8_t>(bytes[i]));
  };
  for (std::size_t at = bytes.find("PK\x01\x02"); at != bytes.npos; at = bytes.find("PK\x01\x02", at + 4)) {
    if (at + 46 > bytes.size() || files.size() > kMostNames) break;
    const std::size_t size = byte(at + 28) | byte(at + 29) << 8;
    if (at + 46 + size <= bytes.size()) add(files, bytes.substr(at + 46, size));
  }
  return files;
}

/// Names that an XML text mentions, between tags or quotes.
std::vector<string_view> photometricFilesOfXml(string_view text) {
  std::vector<string_view> files;
  const auto bounds = [](char c) { return c == '>' || c == '<' || c == '"' || c == '\'' || c == '\n'; };
  for (std::size_t start = 0; start < text.size() && files.size() <= kMostNames;) {
    std::size_t end = start;
    while (end < text.size() && !bounds(text[end])) ++end;
    add(files, trimmed(text.substr(start, end - start)));
    start = end + 1;
  }
  return files;
}

std::string refusalOfZip(string_view bytes) {
  const bool gldf = bytes.find("product.xml") != bytes.npos;
  const std::string kind = gldf ? "this is a GLDF container" : "this is a zip container";
  const std::vector<string_view> files = photometricFilesOfZip(bytes);
  if (files.empty()) return kind + " without an .ldt or .ies file in it; ask its maker for one of these";
  return kind + "; unzip it and take out " + listed(files);
}

std::string refusalOfXml(string_view text) {
  const std::vector<string_view> files = photometricFilesOfXml(text);
  const string_view head = text.substr(0, kLooked);
  if (names(head, "<html") || names(head, "<!doctype html"))
    return "this is a web page; download the photometric file that it links to";
  if (!files.empty())
    return "this is the XML description of a GLDF product; take the file that it names: " + listed(files);
  if (names(head, "iestm33") || names(head, "tm-33") || names(head, "atla"))
    return "this is TM-33 / ATLA S001 XML, which only the page opens; here, take its maker's .ies or .ldt "
           "file";
  return "this is XML and names no .ies or .ldt file; take its maker's .ies or .ldt file";
}

}  // namespace

std::optional<std::string> refusalOfForeignFile(std::span<const std::uint8_t> bytes) {
  const string_view all(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const string_view head = all.substr(0, kLooked);
  const bool zeros = head.find('\0') != head.npos;
  // note: zeros fill the last block of an old text, often after its end mark
  const bool binary = zeros && head.find('\0') <= head.find_last_not_of('\0');
  for (const Magic& magic : kPictures)
    if (head.substr(0, magic.start.size()) == magic.start && (zeros || magic.start.size() > 2))
      return "this is " + std::string(magic.kind) +
             ", not a photometric file; take the luminaire's .ies or .ldt file";
  if (head.substr(0, 4) == "PK\x03\x04" || head.substr(0, 4) == "PK\x05\x06") return refusalOfZip(all);
  if (head.substr(0, 2) == "\x1f\x8b") return "this is a gzip container; unpack it first";
  if (head.substr(0, 2) == "\xff\xfe" || head.substr(0, 2) == "\xfe\xff")
    return "this text is UTF-16; save it as plain text (ANSI or UTF-8)";
  string_view start = head.substr(0, 3) == "\xef\xbb\xbf" ? head.substr(3) : head;
  start = trimmed(start);
  if (!start.empty() && start[0] == '<') return refusalOfXml(all);
  const bool ofDialux = names(head.substr(0, 64), "uld") || names(head, "dialux");
  const bool ofRelux = names(head.substr(0, 64), "rolf") || names(head, "relux");
  if (binary && ofDialux)
    return "this is DIALux's own format (ULD), which is closed; export it as EULUMDAT (.ldt)";
  if (binary && ofRelux)
    return "this is Relux's own format (ROLF), which is closed; export it as EULUMDAT (.ldt)";
  if (binary)
    return "this is binary, not a photometric text; of a .uld or .rolf file (closed formats), export "
           "EULUMDAT (.ldt)";
  return {};
}

}  // namespace fiatlux
