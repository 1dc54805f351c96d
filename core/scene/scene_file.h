// The container of a scene (.flux): a header, a table of named sections, the sections. Bytes in, bytes out:
// who inflates a section (zlib in the command, DecompressionStream in the browser) is outside. Nothing of a
// file is believed before it is checked: see readSceneTable.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace fiatlux {

inline constexpr std::uint32_t kSceneFileVersion = 2;

// Budgets: what a file may ask of the reader before its numbers have proved themselves.
inline constexpr std::uint64_t kMaxInflatedBytes = 64ull << 20;  // a section
inline constexpr std::uint64_t kFreeInflatedBytes = 1ull << 20;  // up to here any ratio of inflation is fine
inline constexpr std::uint64_t kMaxInflationRatio = 200;         // beyond it
inline constexpr std::uint64_t kMaxResponseValues = 1ull << 27;  // rows x sites
inline constexpr std::uint64_t kMaxResponseProducts = 1ull << 30;  // rows x weights of columns
inline constexpr std::uint64_t kMaxCovarianceValues = 1ull << 26;  // surfaces x sites x sites
inline constexpr std::uint64_t kMaxDerivedProducts = 1ull << 32;   // rows x sites x sites

enum class ElementType : std::uint8_t { kUint8 = 0, kUint32 = 1, kFloat32 = 2, kFloat64 = 3 };
enum class Codec : std::uint8_t { kStored = 0, kDeflate = 1 };  // kDeflate: the zlib format (RFC 1950)

/// What the inflated bytes of a section mean (section_codec.h, response_codec.h, statistics_codec.h,
/// covariance_codec.h).
enum class Encoding : std::uint8_t {
  kPlain = 0,        // little-endian elements, row-major
  kDeltaPlanes = 1,  // 32-bit integers: differences down each column, zigzag, split into byte planes
  kFloatPlanes = 2,  // 32-bit floats split into byte planes
  kResponses = 3,    // quantised responses of version 1 (response_streams.h)
  kPacked = 4,       // symmetric matrix, upper triangle, in fixed point
  kFactored = 5,     // L (rank x m) with C = L^T L, byte planes of floats
  kPredicted = 6,    // quantised responses
  kCorrections = 7,  // statistics, as what they differ from those of the responses by
  kStepped = 8,      // range coded numbers, counted in steps of the section's errorBound
  kBeside = 9,       // the same, by what lies beside them in the room
};

std::uint32_t sizeOf(ElementType type);  // bytes of one element

/// One line of the table. `rows` x `columns` elements of `type` are `inflatedBytes` bytes.
struct SceneSection {
  std::string name;  // 1..31 printable ASCII characters, unique in a file
  ElementType type = ElementType::kUint8;
  Codec codec = Codec::kStored;
  Encoding encoding = Encoding::kPlain;
  std::uint32_t rows = 0, columns = 0;
  float errorBound = 0;           // of a lossy section, in the terms of its encoding; 0 = lossless
  std::uint32_t storedCrc = 0;    // CRC-32 of the bytes in the file
  std::uint32_t inflatedCrc = 0;  // CRC-32 after inflating
  std::uint64_t offset = 0;       // from the start of the file, a multiple of 16
  std::uint64_t storedBytes = 0, inflatedBytes = 0;
};

struct SceneCounts {
  std::uint32_t patches = 0;    // n
  std::uint32_t receivers = 0;  // patches of measuring planes
  std::uint32_t clusters = 0;   // k <= n
  std::uint32_t sites = 0;      // m
  std::uint32_t columns = 0;    // of `responses`; m unless sites share columns
  std::uint32_t surfaces = 0;
  std::uint32_t rows() const { return patches + receivers; }
};

struct SceneTable {
  std::uint32_t version = kSceneFileVersion;
  std::string identity;  // 16 hex digits
  SceneCounts counts;
  std::vector<SceneSection> sections;  // in the order of their offsets

  const SceneSection* find(std::string_view name) const;  // nullptr where absent
};

/// Checks a whole file: magic, version, length, the checksums of the table and of every section's stored
/// bytes, the counts, and each section's shape, place and budgets. No allocation is sized by an unchecked
/// number, and every byte of the file is covered by a check. Errors are one line without the file's name.
Result<SceneTable> readSceneTable(std::span<const std::uint8_t> file);

/// Bytes of header and table, from the first 16 bytes of a file: what readSceneHead needs of it.
std::uint64_t sceneHeadBytes(std::span<const std::uint8_t> file);

/// The same checks of what can be known from header and table alone (`head`, sceneHeadBytes of a file of
/// `fileBytes`), for a file that is still on its way: the sections' stored bytes are not looked at, and who
/// inflates them relies on the checksum of what comes out.
Result<SceneTable> readSceneHead(std::span<const std::uint8_t> head, std::uint64_t fileBytes);

/// The bytes of a section as they lie in the file (readSceneTable has checked that they do).
std::span<const std::uint8_t> storedBytes(std::span<const std::uint8_t> file, const SceneSection& section);

/// A section on its way into a file: the table's line (name, type, encoding, shape, error bound) and plain
/// bytes.
struct PlainSection {
  SceneSection section;
  std::vector<std::uint8_t> bytes;  // sizeOf(type) x rows x columns
};

/// `section` with its sizes and inner checksum filled in, ready for assembleSceneFile, from its inflated
/// bytes.
PlainSection plainSection(std::string name, ElementType type, Encoding encoding, std::uint32_t rows,
                          std::uint32_t columns, std::vector<std::uint8_t> bytes, float errorBound = 0);

/// A section's stored bytes with its line: `bytes` are deflated where section.codec says so.
struct StoredSection {
  SceneSection section;
  std::vector<std::uint8_t> bytes;
};

/// Lays the sections out behind header and table; fills in offsets, sizes and checksums of stored bytes.
std::vector<std::uint8_t> assembleSceneFile(const std::string& identity, const SceneCounts& counts,
                                            const std::vector<StoredSection>& sections);

/// 16 hex digits of a 64-bit hash (FNV-1a) of `text`: a room's identity is made of its source's hash, the
/// options that change the light and the method's version.
std::string identityOf(std::string_view text);

}  // namespace fiatlux
