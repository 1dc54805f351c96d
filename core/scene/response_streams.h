// Responses as files of version 1 hold them: no longer written, still read.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "core/scene/patches.h"
#include "core/scene/response_codec.h"

namespace fiatlux {

/// Columns in one block of a file of version 1, but for the last.
std::uint32_t responseStreamColumns(std::uint32_t rows);

/// Decodes one block of `columns` columns into out (column-major, rows x columns). Needs checked patches
/// (left, up smaller than their row or kNone; surface in range). `scales` are the block's, columns x
/// surfaces. Never negative. "" or what does not fit.
std::string decodeResponseStreams(std::span<const std::uint8_t> block, const Patches& patches,
                                  std::span<const ResponseScale> scales, std::uint32_t columns, float* out);

}  // namespace fiatlux
