// Responses in a file. A value is a whole multiple of a step that is a fixed share of the surface's mean
// response to that site; what is written is the difference to a prediction from the neighbours in the patch
// grid. Uniform rounding errs by step / sqrt(12) RMS and step / 2 at most.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/patches.h"
#include "core/scene.h"

namespace fiatlux {

/// Step of the quantisation as a share of the surface's mean response: 0.46 % RMS.
inline constexpr double kResponseStep = 0.016;

/// Quantised columns of one room, in blocks of columns so that no section grows beyond its budget.
struct EncodedResponses {
  std::vector<float> steps;  // columns x surfaces, row-major: lx per lm
  std::vector<std::vector<std::uint8_t>>
      blocks;                     // of responseBlockColumns() columns each, the last may have fewer
  std::vector<float> errorBound;  // per surface: largest |stored - true| over its mean, any column
  std::vector<float> rms;         // columns x surfaces: RMS error by area as a share of the mean
};

/// Columns in one block of responses with `rows` rows.
std::uint32_t responseBlockColumns(std::uint32_t rows);

/// Needs finite values >= 0; `surfaces` = number of surfaces.
EncodedResponses encodeResponses(const Responses& responses, const Patches& patches, std::uint32_t surfaces,
                                 double step = kResponseStep);

/// Decodes one block of `columns` columns into out (column-major, rows x columns). Needs checked patches
/// (left, up smaller than their row or kNone; surface in range). `steps` are the block's, columns x surfaces.
/// Never negative.
/// "" or what does not fit.
std::string decodeResponses(std::span<const std::uint8_t> block, const Patches& patches,
                            std::span<const float> steps, std::uint32_t columns, float* out);

}  // namespace fiatlux
