// From a checked file to a Scene, section by section: the caller inflates, the reader checks and assembles.
// The same code natively and in the page.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/scene/opening_light.h"
#include "core/scene/response_sections.h"
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

  /// The same for a file that is still on its way: see readSceneHead.
  static Result<SceneReader> openHead(std::span<const std::uint8_t> head, std::uint64_t fileBytes);

  const SceneTable& table() const { return table_; }
  /// Whether finish() wants this section.
  bool needed(std::uint32_t section) const;
  /// Whether finish() makes the scene's light operator of this section and others: of all of them or, where
  /// nobody wants it, of none.
  bool ofOperator(std::uint32_t section) const;
  /// Whether it tells of statistics, which searches among squares of light need, but none among luminaire
  /// types.
  bool ofStatistics(std::uint32_t section) const;
  /// Whether readOutline() wants it.
  bool early(std::uint32_t section) const;
  /// Size and checksum of a section's inflated bytes against the table.
  Result<Done> verify(std::uint32_t section, std::span<const std::uint8_t> bytes) const;
  /// verify(), then keeps the bytes for finish(); after readOutline() responses are decoded as they come, the
  /// light operator when all of it has.
  Result<Done> provide(std::uint32_t section, std::vector<std::uint8_t> bytes);
  /// Decodes and checks what is known of the room before its light: surfaces, patches and sites; and the
  /// opening light, where the file has one. Once only, when all early sections have been provided.
  Result<Done> readOutline();
  /// After readOutline() and before finish(); with the light operator once that is decoded.
  const Scene* outline() const { return outline_.get(); }
  const OpeningLight* opening() const { return opening_ ? &*opening_ : nullptr; }
  /// Decodes and checks everything: shapes against the counts, ranges of all indices, no NaN or infinity,
  /// areas > 0. Once only: it frees the sections as it goes.
  Result<Scene> finish();
  /// The light operator of a scene that finish() made before the sections of ofOperator() were there; all of
  /// them must be now. Without any the scene stays as it is.
  Result<Done> finishOperator(Scene& scene);
  /// finish() in two steps, of which the first wants no section of ofStatistics(): the scene has its
  /// operator, and no statistics until all of those sections are there, too, and the second is taken.
  Result<std::unique_ptr<Scene>> finishLight();
  Result<Done> finishStatistics(Scene& scene);

 private:
  explicit SceneReader(SceneTable table) : table_(std::move(table)), bytes_(table_.sections.size()) {}
  bool isOperatorThere() const;
  SceneTable table_;
  std::vector<std::vector<std::uint8_t>> bytes_;  // of each section, empty until provided
  std::unique_ptr<Scene> outline_;                // on the heap, for what decodes the responses refers to it
  std::unique_ptr<ResponseSections> responses_;   // from readOutline() to finish()
  std::optional<OpeningLight> opening_;
};

}  // namespace fiatlux
