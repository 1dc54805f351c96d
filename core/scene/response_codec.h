// Responses in a file. A value is a whole multiple of a step that is a fixed share of the surface's mean
// response to that site; what is written is the difference to a prediction from the neighbours in the patch
// grid and from the same patches' light of two nearby sites, whose noise is much the same. Uniform rounding
// errs by step / sqrt(12) RMS and step / 2 at most. Values that round to zero come back as their mean, so
// that dim corners keep their light.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/scene/patches.h"
#include "core/scene/response_model.h"
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

/// For each site the two nearest among those before it, the nearest first.
std::vector<ResponseReferences> nearestBefore(const std::vector<Site>& sites);

/// Quantised columns of one room, in blocks of columns.
struct EncodedResponses {
  std::vector<ResponseScale> scales;  // columns x surfaces, row-major
  std::vector<std::vector<std::uint8_t>>
      blocks;                     // of responseBlockColumns() columns each, the last may have fewer
  std::vector<float> errorBound;  // per surface: largest |stored - true| over its mean, any column
  std::vector<float> rms;         // columns x surfaces: RMS error by area as a share of the mean
  Responses stored;               // what the decoder will yield
};

/// Columns in one block of responses with `rows` rows: about a million values.
std::uint32_t responseBlockColumns(std::uint32_t rows);

/// A block has a byte for each so many values at least (zeros fill it up), so that a short file cannot ask
/// for much memory.
inline constexpr std::uint32_t kValuesPerByte = 64;

/// Needs finite values >= 0; `steps`: one a surface, as shares of its mean; a reference lies before its
/// column. Column j of the result is responses' column j.
EncodedResponses encodeResponses(const Responses& responses, const Patches& patches,
                                 std::span<const double> steps,
                                 const std::vector<ResponseReferences>& references);

/// Decodes the blocks one after the other, for they build on each other. Needs checked patches (left, up
/// smaller than their row or kNone; surface in range). Refers to the patches.
class ResponseDecoder {
 public:
  ResponseDecoder(const Patches& patches, std::uint32_t surfaces, std::vector<ResponseReferences> references)
      : model_(patches, surfaces, std::move(references)) {}

  /// "" or what does not fit.
  std::string decode(std::span<const std::uint8_t> block);
  /// All columns, column-major, rows x columns, never negative; after the last block. `scales`: columns x
  /// surfaces.
  std::vector<float> finish(std::span<const ResponseScale> scales) { return model_.light(scales); }

 private:
  ResponseModel model_;
};

}  // namespace fiatlux
