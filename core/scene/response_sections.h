// The responses of a scene file on their way to numbers. Blocks build on each other, so each is decoded as
// soon as it and those before it are there: of a file on a slow line most is done when its end arrives.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/scene/checked_sections.h"
#include "core/scene/patches.h"
#include "core/scene/response_codec.h"

namespace fiatlux {

/// Of light in a file, lx for 1 lm: sums and squares of what is below stay finite, as floats too.
inline constexpr double kBrightestMean = 1e12;

class ResponseSections {
 public:
  /// Takes and decodes the blocks that are there and whose turn it is. Refers to the patches until columns().
  void advance(CheckedSections& in, const SceneCounts& counts, const Patches& patches);

  /// The columns as stored, rows x counts.columns, column-major; nothing where `in` has a fault. Wants every
  /// section; once only.
  std::vector<float> columns(CheckedSections& in, const SceneCounts& counts, const Patches& patches);

 private:
  void open(CheckedSections& in, const SceneCounts& counts, const Patches& patches);
  std::optional<ResponseDecoder> decoder_;
  std::vector<std::string> blocks_;  // names of the sections
  std::size_t next_ = 0;             // of the blocks
};

}  // namespace fiatlux
