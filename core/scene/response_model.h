// What encoder and decoder of responses know in common of the numbers that have passed: a linear prediction
// for each surface that learns as it goes (normalised least mean squares), as in the coding of spectral
// images, where a band is predicted from the bands before it. In single precision and one order of sums,
// without which two machines would predict differently.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/scene/patches.h"
#include "core/scene/residual_model.h"

namespace fiatlux {

struct ResponseScale;

inline constexpr std::int32_t kLargestNumber = 1 << 24;  // of a quantised response: still exact as a float

/// Two earlier columns that are like a column, or kNone.
using ResponseReferences = std::array<std::uint32_t, 2>;

/// Refers to the patches.
class ResponseModel {
 public:
  ResponseModel(const Patches& patches, std::uint32_t surfaces, std::vector<ResponseReferences> references);

  std::uint32_t rows() const { return patches_.rows(); }
  std::uint32_t columns() const { return static_cast<std::uint32_t>(references_.size()); }
  std::uint32_t next() const { return next_; }  // the column that comes next

  /// Codes the next column: writes `numbers`, one a row (RangeEncoder), or reads it (RangeDecoder, no
  /// numbers). False where a number that was read is out of range.
  template <class Coder>
  bool codeColumn(Coder& coder, const std::int32_t* numbers);

  /// Numbers x scales (columns x surfaces); the model is empty afterwards.
  std::vector<float> light(std::span<const ResponseScale> scales);

 private:
  static constexpr std::size_t kTaps = 8;
  using Taps = std::array<float, kTaps>;
  /// Rows left and up; where there is none, the row itself, whose number is still 0.
  struct Neighbours {
    std::uint32_t left, up;
  };
  /// A column as far as it is known, or zeros.
  struct Column {
    const float* number;
    const std::uint8_t* miss;
  };
  Column column(std::uint32_t index) const;
  static float sumOfProducts(const Taps& a, const Taps& b);
  static void learn(Taps& weights, const Taps& seen, float error);

  const Patches& patches_;
  std::vector<ResponseReferences> references_;
  std::vector<Neighbours> neighbours_;
  std::vector<Taps> weights_;       // of each surface
  std::vector<float> numbers_;      // column-major, rows x columns
  std::vector<std::uint8_t> miss_;  // how far each prediction was off, 255 at most
  std::vector<float> noNumbers_;    // of no column: zeros
  std::vector<std::uint8_t> noMiss_;
  ResidualModel residuals_;
  std::uint32_t next_ = 0;
};

}  // namespace fiatlux
