// The sections of a scene file on their way to numbers: each of the shape it must have, each value in its
// range.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/scene/scene_file.h"
#include "core/scene/section_codec.h"

namespace fiatlux {

inline Error faultIn(std::string_view section, const std::string& what) {
  return Error{"section " + std::string(section) + ": " + what +
               "; the file is damaged: make it again with fiatlux precompute"};
}

/// Takes sections by name, checks their shapes, decodes them; remembers the first fault, after which what it
/// yields means nothing. Refers to the table and to the inflated bytes, which it takes section by section.
class CheckedSections {
 public:
  CheckedSections(const SceneTable& table, std::vector<std::vector<std::uint8_t>>& bytes)
      : table_(table), bytes_(bytes) {}

  bool ok() const { return fault_.message.empty(); }
  const Error& fault() const { return fault_; }
  void fail(std::string_view section, const std::string& what) {
    if (ok()) fault_ = faultIn(section, what);
  }
  bool has(std::string_view name) const { return table_.find(name) != nullptr; }
  bool isThere(std::string_view name) const {
    const SceneSection* section = table_.find(name);
    return section && !bytes_[static_cast<std::size_t>(section - table_.sections.data())].empty();
  }
  const SceneSection& line(std::string_view name) const { return *table_.find(name); }

  /// The section's bytes; it must have this type and encoding. kAnyRows leaves the number of rows open.
  static constexpr std::uint64_t kAnyRows = ~0ull;
  std::vector<std::uint8_t> take(std::string_view name, ElementType type, Encoding encoding,
                                 std::uint64_t rows, std::uint32_t columns) {
    const SceneSection* section = table_.find(name);
    if (!section) return fail(name, "it is missing"), std::vector<std::uint8_t>{};
    const bool fits = section->type == type && section->encoding == encoding && section->columns == columns &&
                      (rows == kAnyRows || section->rows == rows);
    if (!fits) return fail(name, "its shape does not fit the room's counts"), std::vector<std::uint8_t>{};
    return takeAny(name);
  }
  std::vector<std::uint8_t> takeAny(std::string_view name) {
    const std::size_t index = indexOf(name);
    if (bytes_[index].size() != table_.sections[index].inflatedBytes)
      return fail(name, "it was not provided"), std::vector<std::uint8_t>{};
    return std::move(bytes_[index]);
  }
  template <class T>
  std::vector<T> plain(std::string_view name, ElementType type, std::uint64_t rows, std::uint32_t columns) {
    const std::vector<std::uint8_t> bytes = take(name, type, Encoding::kPlain, rows, columns);
    std::vector<T> values(bytes.size() / sizeof(T));
    if (!values.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }
  /// Doubles, all finite and in [low, high].
  std::vector<double> doubles(std::string_view name, std::uint64_t rows, std::uint32_t columns, double low,
                              double high) {
    std::vector<double> values = plain<double>(name, ElementType::kFloat64, rows, columns);
    checkRange(name, values, low, high);
    return values;
  }
  std::vector<float> floats(std::string_view name, Encoding encoding, std::uint64_t rows,
                            std::uint32_t columns, double low, double high) {
    const std::vector<std::uint8_t> bytes = take(name, ElementType::kFloat32, encoding, rows, columns);
    std::vector<float> values = decodeFloatPlanes(bytes);
    checkRange(name, values, low, high);
    return values;
  }
  std::vector<std::uint32_t> integers(std::string_view name, std::uint64_t rows, std::uint32_t columns) {
    const std::vector<std::uint8_t> bytes =
        take(name, ElementType::kUint32, Encoding::kDeltaPlanes, rows, columns);
    return decodeDeltaPlanes(bytes, columns);
  }

 private:
  std::size_t indexOf(std::string_view name) const {
    return static_cast<std::size_t>(&line(name) - table_.sections.data());
  }
  template <class T>
  void checkRange(std::string_view name, const std::vector<T>& values, double low, double high) {
    for (T v : values)
      if (!(v >= low && v <= high)) return fail(name, "a value is no number or out of range");
  }
  const SceneTable& table_;
  std::vector<std::vector<std::uint8_t>>& bytes_;
  Error fault_;
};

}  // namespace fiatlux
