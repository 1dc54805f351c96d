// From a checked file to a Scene, section by section: the caller inflates, the reader checks and assembles.
// The same code natively and in the page.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/scene/scene.h"
#include "core/scene/scene_file.h"

namespace fiatlux {

/// Use: open(file); for every section with needed(i): inflate storedBytes() to exactly inflatedBytes (stop as
/// soon as more arrive) and provide() it; finish(). Sections that are not needed (the display room "room",
/// "provenance", the paper's matrices) may be checked with verify().
class SceneReader {
 public:
  /// Checks the whole file by readSceneTable; keeps nothing of it.
  static Result<SceneReader> open(std::span<const std::uint8_t> file);

  const SceneTable& table() const { return table_; }
  /// Whether finish() wants this section.
  bool needed(std::uint32_t section) const;
  /// Size and checksum of a section's inflated bytes against the table.
  Result<Done> verify(std::uint32_t section, std::span<const std::uint8_t> bytes) const;
  /// verify(), then keeps the bytes for finish().
  Result<Done> provide(std::uint32_t section, std::vector<std::uint8_t> bytes);
  /// Decodes and checks everything: shapes against the counts, ranges of all indices, no NaN or infinity,
  /// areas > 0. Once only: it frees the sections as it goes.
  Result<Scene> finish();

 private:
  explicit SceneReader(SceneTable table) : table_(std::move(table)), bytes_(table_.sections.size()) {}
  SceneTable table_;
  std::vector<std::vector<std::uint8_t>> bytes_;  // of each section, empty until provided
};

}  // namespace fiatlux
