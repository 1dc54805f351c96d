// Header (64 bytes), table (80 bytes a section), sections on multiples of 16 with zeros between; all little
// endian.
//   0 magic 8 | 8 version | 12 section count | 16 file bytes 8 | 24 identity 8 | 32 counts 6 x 4 | 56 zero |
//   60 CRC-32 of header (this field zero) and table
#include "core/scene/scene_file.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "core/scene/crc32.h"

namespace fiatlux {
namespace {

static_assert(std::endian::native == std::endian::little, "a scene file is little endian");

// Like PNG's: a byte above 127 and line ends, so that transfer as text shows at once.
constexpr std::uint8_t kMagic[8] = {0x89, 'F', 'L', 'U', 'X', '\r', '\n', 0x1a};
constexpr std::size_t kHeaderBytes = 64, kEntryBytes = 80, kNameBytes = 32;
constexpr std::uint32_t kMaxSections = 4096, kMaxCount = 1u << 21, kMaxSites = 1u << 14,
                        kMaxSurfaces = 1u << 16;
constexpr const char* kRemedy = "the file is damaged: make it again with fiatlux precompute";

template <class T>
T load(const std::uint8_t* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

template <class T>
void store(std::uint8_t* at, T value) {
  std::memcpy(at, &value, sizeof value);
}

std::uint64_t aligned(std::uint64_t offset) { return (offset + 15) & ~std::uint64_t{15}; }

std::string hex(std::uint64_t value) {
  std::string digits(16, '0');
  for (int i = 15; i >= 0; --i, value >>= 4) digits[i] = "0123456789abcdef"[value & 15];
  return digits;
}

std::uint32_t tableCrc(std::span<const std::uint8_t> file, std::uint32_t sections) {
  std::uint8_t header[kHeaderBytes];
  std::memcpy(header, file.data(), kHeaderBytes);
  store<std::uint32_t>(header + 60, 0);
  return crc32Of(file.subspan(kHeaderBytes, sections * kEntryBytes), crc32Of(header));
}

/// Magic, version, length and the checksum of header and table, which are all that `file` must hold of its
/// `fileBytes`; yields the number of sections.
Result<std::uint32_t> checkHeader(std::span<const std::uint8_t> file, std::uint64_t fileBytes) {
  if (file.size() < sizeof kMagic || std::memcmp(file.data(), kMagic, sizeof kMagic) != 0)
    return Error{"not a Fiat Lux scene file: make one with fiatlux precompute"};
  if (file.size() < kHeaderBytes)
    return Error{std::string("header: cut after ") + std::to_string(file.size()) + " bytes; " + kRemedy};
  const auto version = load<std::uint32_t>(&file[8]);
  if (version > kSceneFileVersion)
    return Error{"scene file of version " + std::to_string(version) +
                 ", but this program reads up to version " + std::to_string(kSceneFileVersion) +
                 ": use a newer Fiat Lux, or make the file again"};
  if (version == 0) return Error{std::string("scene file of version 0, which never was; ") + kRemedy};
  const auto bytes = load<std::uint64_t>(&file[16]);
  if (bytes != fileBytes)
    return Error{"the file has " + std::to_string(fileBytes) + " bytes where its header says " +
                 std::to_string(bytes) + "; " + kRemedy};
  const auto sections = load<std::uint32_t>(&file[12]);
  if (sections > kMaxSections || kHeaderBytes + std::uint64_t{sections} * kEntryBytes > file.size())
    return Error{"table: " + std::to_string(sections) + " sections do not fit the file; " + kRemedy};
  if (load<std::uint32_t>(&file[60]) != tableCrc(file, sections))
    return Error{std::string("table: checksum differs; ") + kRemedy};
  return sections;
}

Result<SceneCounts> checkCounts(const std::uint8_t* header) {
  const auto at = [&](int i) { return load<std::uint32_t>(header + 32 + 4 * i); };
  const SceneCounts counts{at(0), at(1), at(2), at(3), at(4), at(5)};
  const auto bad = [](const std::string& what) { return Error{"header: " + what + "; " + kRemedy}; };
  if (counts.patches < 1 || counts.patches > kMaxCount || counts.receivers > kMaxCount)
    return bad(std::to_string(counts.patches) + " patches and " + std::to_string(counts.receivers) +
               " receivers are out of range");
  if (counts.clusters > counts.patches)
    return bad(std::to_string(counts.clusters) + " clusters of only " + std::to_string(counts.patches) +
               " patches");
  if (std::uint64_t{counts.patches} * counts.clusters > (1ull << 32))
    return bad("patches x clusters is over 2^32");
  if (counts.sites < 1 || counts.sites > kMaxSites || counts.columns < 1 || counts.columns > kMaxSites)
    return bad(std::to_string(counts.sites) + " sites on " + std::to_string(counts.columns) +
               " columns are out of range");
  if (counts.surfaces < 1 || counts.surfaces > kMaxSurfaces)
    return bad(std::to_string(counts.surfaces) + " surfaces are out of range");
  if (std::uint64_t{counts.rows()} * std::max(counts.sites, counts.columns) > kMaxResponseValues)
    return bad("patches x sites is over 2^27");
  if (std::uint64_t{counts.surfaces} * counts.sites * counts.sites > kMaxCovarianceValues)
    return bad("surfaces x sites x sites is over 2^26");
  return counts;
}

/// Reads one line of the table; an Error says what is wrong with it, without the section's name.
Result<SceneSection> readEntry(const std::uint8_t* entry) {
  SceneSection section;
  const auto* name = reinterpret_cast<const char*>(entry);
  const std::size_t length = std::find(name, name + kNameBytes, '\0') - name;
  const bool printable = std::all_of(name, name + length, [](char c) { return c > 32 && c < 127; });
  const bool padded = std::all_of(name + length, name + kNameBytes, [](char c) { return c == 0; });
  if (length == 0 || length == kNameBytes || !printable || !padded)
    return Error{"its name is not plain text"};
  section.name.assign(name, length);
  if (entry[32] > 3 || entry[33] > 1 || entry[34] > 9 || entry[35] != 0)
    return Error{"unknown type, codec or encoding"};
  section.type = static_cast<ElementType>(entry[32]);
  section.codec = static_cast<Codec>(entry[33]);
  section.encoding = static_cast<Encoding>(entry[34]);
  section.rows = load<std::uint32_t>(entry + 36);
  section.columns = load<std::uint32_t>(entry + 40);
  section.errorBound = load<float>(entry + 44);
  section.storedCrc = load<std::uint32_t>(entry + 48);
  section.inflatedCrc = load<std::uint32_t>(entry + 52);
  section.offset = load<std::uint64_t>(entry + 56);
  section.storedBytes = load<std::uint64_t>(entry + 64);
  section.inflatedBytes = load<std::uint64_t>(entry + 72);
  return section;
}

/// Shape, sizes and budgets of one section, and its place behind `end`; "" when all is well.
std::string faultOf(const SceneSection& section, std::uint64_t fileBytes, std::uint64_t end) {
  // note: rows x columns of 32 bits each cannot overflow 64 bits; times 8 bytes an element could, hence the
  // division.
  const std::uint64_t elements = std::uint64_t{section.rows} * section.columns;
  if (section.inflatedBytes > kMaxInflatedBytes) return "more than 64 MB inflated";
  if (elements > kMaxInflatedBytes / sizeOf(section.type) ||
      elements * sizeOf(section.type) != section.inflatedBytes)
    return "its shape does not match its size";
  if (section.codec == Codec::kStored && section.storedBytes != section.inflatedBytes)
    return "its two sizes differ";
  if (section.inflatedBytes > kFreeInflatedBytes &&
      section.inflatedBytes / kMaxInflationRatio > section.storedBytes)
    return "it would inflate more than 200 times";
  if (!(section.errorBound >= 0) || !std::isfinite(section.errorBound)) return "its error bound is no number";
  if (section.offset != aligned(end)) return "it overlaps its neighbour or leaves a gap";
  if (section.offset > fileBytes || section.storedBytes > fileBytes - section.offset)
    return "it leaves the file";
  return "";
}

Error faultIn(const SceneSection& section, const std::string& fault) {
  return Error{"section " + section.name + ": " + fault + "; " + kRemedy};
}

}  // namespace

std::uint32_t sizeOf(ElementType type) {
  constexpr std::uint32_t kSizes[] = {1, 4, 4, 8};
  return kSizes[static_cast<std::uint8_t>(type)];
}

const SceneSection* SceneTable::find(std::string_view name) const {
  for (const SceneSection& section : sections)
    if (section.name == name) return &section;
  return nullptr;
}

std::uint64_t sceneHeadBytes(std::span<const std::uint8_t> file) {
  if (file.size() < 16) return kHeaderBytes;
  return kHeaderBytes + std::uint64_t{std::min(load<std::uint32_t>(&file[12]), kMaxSections)} * kEntryBytes;
}

Result<SceneTable> readSceneHead(std::span<const std::uint8_t> head, std::uint64_t fileBytes) {
  const Result<std::uint32_t> sections = checkHeader(head, fileBytes);
  if (!sections) return sections.error();
  const Result<SceneCounts> counts = checkCounts(head.data());
  if (!counts) return counts.error();

  SceneTable table;
  table.version = load<std::uint32_t>(&head[8]);
  table.identity = hex(load<std::uint64_t>(&head[24]));
  table.counts = counts.value();
  std::uint64_t end = kHeaderBytes + std::uint64_t{sections.value()} * kEntryBytes;
  for (std::uint32_t i = 0; i < sections.value(); ++i) {
    Result<SceneSection> section = readEntry(&head[kHeaderBytes + i * kEntryBytes]);
    if (!section)
      return Error{"section " + std::to_string(i) + ": " + section.error().message + "; " + kRemedy};
    if (table.find(section->name)) return faultIn(*section, "it is there twice");
    const std::string fault = faultOf(section.value(), fileBytes, end);
    if (!fault.empty()) return faultIn(*section, fault);
    end = section->offset + section->storedBytes;
    table.sections.push_back(std::move(section.value()));
  }
  if (end != fileBytes) return Error{std::string("the file goes on after its last section; ") + kRemedy};
  return table;
}

Result<SceneTable> readSceneTable(std::span<const std::uint8_t> file) {
  Result<SceneTable> table = readSceneHead(file, file.size());
  if (!table) return table;
  std::uint64_t end = kHeaderBytes + table->sections.size() * kEntryBytes;
  for (const SceneSection& section : table->sections) {
    for (std::uint64_t i = end; i < section.offset; ++i)
      if (file[i] != 0) return faultIn(section, "the padding before it is not zero");
    if (crc32Of(storedBytes(file, section)) != section.storedCrc) return faultIn(section, "checksum differs");
    end = section.offset + section.storedBytes;
  }
  return table;
}

std::span<const std::uint8_t> storedBytes(std::span<const std::uint8_t> file, const SceneSection& section) {
  return file.subspan(section.offset, section.storedBytes);
}

PlainSection plainSection(std::string name, ElementType type, Encoding encoding, std::uint32_t rows,
                          std::uint32_t columns, std::vector<std::uint8_t> bytes, float errorBound) {
  PlainSection plain;
  plain.section.name = std::move(name);
  plain.section.type = type;
  plain.section.encoding = encoding;
  plain.section.rows = rows;
  plain.section.columns = columns;
  plain.section.errorBound = errorBound;
  plain.section.inflatedBytes = bytes.size();
  plain.section.inflatedCrc = crc32Of(bytes);
  plain.bytes = std::move(bytes);
  return plain;
}

std::vector<std::uint8_t> assembleSceneFile(const std::string& identity, const SceneCounts& counts,
                                            const std::vector<StoredSection>& sections) {
  const std::size_t tableEnd = kHeaderBytes + sections.size() * kEntryBytes;
  std::vector<std::uint8_t> file(tableEnd);
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const SceneSection& section = sections[i].section;
    file.resize(aligned(file.size()));
    std::uint8_t* entry = &file[kHeaderBytes + i * kEntryBytes];
    std::memcpy(entry, section.name.data(), std::min(section.name.size(), kNameBytes - 1));
    entry[32] = static_cast<std::uint8_t>(section.type);
    entry[33] = static_cast<std::uint8_t>(section.codec);
    entry[34] = static_cast<std::uint8_t>(section.encoding);
    store<std::uint32_t>(entry + 36, section.rows);
    store<std::uint32_t>(entry + 40, section.columns);
    store<float>(entry + 44, section.errorBound);
    store<std::uint32_t>(entry + 48, crc32Of(sections[i].bytes));
    store<std::uint32_t>(entry + 52, section.inflatedCrc);
    store<std::uint64_t>(entry + 56, file.size());
    store<std::uint64_t>(entry + 64, sections[i].bytes.size());
    store<std::uint64_t>(entry + 72, section.inflatedBytes);
    file.insert(file.end(), sections[i].bytes.begin(), sections[i].bytes.end());
  }
  std::memcpy(file.data(), kMagic, sizeof kMagic);
  store<std::uint32_t>(&file[8], kSceneFileVersion);
  store<std::uint32_t>(&file[12], static_cast<std::uint32_t>(sections.size()));
  store<std::uint64_t>(&file[16], file.size());
  std::uint64_t id = 0;
  for (char c : identity) id = id << 4 | static_cast<std::uint64_t>(c <= '9' ? c - '0' : c - 'a' + 10);
  store<std::uint64_t>(&file[24], id);
  const std::uint32_t numbers[] = {counts.patches, counts.receivers, counts.clusters,
                                   counts.sites,   counts.columns,   counts.surfaces};
  std::memcpy(&file[32], numbers, sizeof numbers);
  store<std::uint32_t>(&file[60], tableCrc(file, static_cast<std::uint32_t>(sections.size())));
  return file;
}

std::string identityOf(std::string_view text) {
  std::uint64_t hash = 14695981039346656037ull;
  for (char c : text) hash = (hash ^ static_cast<std::uint8_t>(c)) * 1099511628211ull;
  return hex(hash);
}

}  // namespace fiatlux
