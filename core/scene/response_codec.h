// Responses in a file. A value is a whole multiple of a step that is a fixed share of the surface's mean
// response to that site; what is written is the difference to a prediction from the neighbours in the patch
// grid, sorted into streams by how restless the neighbourhood is, so that deflate finds even statistics in
// each. Uniform rounding errs by step / sqrt(12) RMS and step / 2 at most. Values that round to zero come
// back as their mean, so that dim corners keep their light.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/scene/patches.h"
#include "core/scene/scene.h"

namespace fiatlux {

/// Step of the quantisation as a share of the surface's mean response: 0.40 % RMS, less where it is dim.
inline constexpr double kResponseStep = 0.014;

/// How one site's column is scaled on one surface, both lx per lm: value = step x number, or floor where that
/// is 0.
struct ResponseScale {
  float step = 0;
  float floor = 0;  // 0..step / 2
};

/// Quantised columns of one room, in blocks of columns so that no section grows beyond its budget.
struct EncodedResponses {
  std::vector<ResponseScale> scales;  // columns x surfaces, row-major
  std::vector<std::vector<std::uint8_t>>
      blocks;                     // of responseBlockColumns() columns each, the last may have fewer
  std::vector<float> errorBound;  // per surface: largest |stored - true| over its mean, any column
  std::vector<float> rms;         // columns x surfaces: RMS error by area as a share of the mean
};

/// Columns in one block of responses with `rows` rows.
std::uint32_t responseBlockColumns(std::uint32_t rows);

/// Needs finite values >= 0; `surfaces` = number of surfaces. Column j of the result is responses' column j.
EncodedResponses encodeResponses(const Responses& responses, const Patches& patches, std::uint32_t surfaces,
                                 double step = kResponseStep);

/// Decodes one block of `columns` columns into out (column-major, rows x columns). Needs checked patches
/// (left, up smaller than their row or kNone; surface in range). `scales` are the block's, columns x
/// surfaces. Never negative.
/// "" or what does not fit.
std::string decodeResponses(std::span<const std::uint8_t> block, const Patches& patches,
                            std::span<const ResponseScale> scales, std::uint32_t columns, float* out);

}  // namespace fiatlux
