// Residuals of a prediction as bits for a range coder: a number is likely to be as large as its neighbours
// were (ResidualModel), or as it was where things stood alike (ResidualContexts). One function writes and
// reads, so that the two cannot drift apart.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "core/scene/range_coder.h"

namespace fiatlux {

/// Elias gamma: any 32-bit number.
template <class Coder>
std::uint32_t codeGamma(Coder& coder, std::uint32_t value) {
  const std::uint64_t from = std::uint64_t{value} + 1;
  const int extra = std::bit_width(from) - 1;
  int count = 0;
  while (count < 32 && coder.bits(1, count < extra)) ++count;
  const std::uint64_t rest = from - (std::uint64_t{1} << extra);
  const std::uint32_t low = coder.bits(count, static_cast<std::uint32_t>(rest));
  return static_cast<std::uint32_t>((std::uint64_t{1} << count) + low - 1);
}

/// 0 of 0, then two an octave: 1, 2, 3, 4, 6, 8, 12 ... begin a new one each.
inline std::uint32_t halfOctaveOf(std::uint32_t value) {
  if (value < 2) return value;
  const int width = std::bit_width(value);
  return 2 * static_cast<std::uint32_t>(width) - 2 + (value >> (width - 2) & 1);
}

class ResidualModel {
 public:
  /// What kOrdinary is to kDark, the caller decides: both learn apart.
  enum Kind : std::uint32_t { kOrdinary = 0, kDark = 1 };

  /// Writes `residual` (RangeEncoder) or reads it (RangeDecoder, which ignores the argument).
  /// `activity`: about 32 times the size that is expected. `lean` 0..2: three kinds of sign.
  template <class Coder>
  std::int32_t code(Coder& coder, std::uint32_t activity, Kind kind, std::uint32_t lean,
                    std::int32_t residual) {
    // Contexts are half octaves of the activity; where large numbers are expected, low bits go apart.
    const std::uint32_t scaled = std::min(activity, 0xffffffu) + 4;
    const int width = std::bit_width(scaled);
    const std::uint32_t half = scaled >> (width - 2) & 1;
    const std::uint32_t context =
        kind == kDark ? kContexts - 1
                      : std::min(2 * static_cast<std::uint32_t>(width) + half - 6, kContexts - 2);
    const int low = kind == kDark ? 0 : std::max(0, width - 7);

    const std::uint32_t size =
        residual < 0 ? 0u - static_cast<std::uint32_t>(residual) : static_cast<std::uint32_t>(residual);
    std::uint32_t high = 0;
    while (high < kSteps && coder.bit(steps_[context][high], size >> low > high)) ++high;
    if (high == kSteps) high += codeGamma(coder, (size >> low) - kSteps);
    std::uint32_t coded = high << low;
    if (low > 0) {
      const bool top = coder.bit(top_[context][std::min(high, 1u)], size >> (low - 1) & 1);
      coded |= static_cast<std::uint32_t>(top) << (low - 1);
      coded |= coder.bits(low - 1, size & ((1u << (low - 1)) - 1));
    }
    if (coded == 0) return 0;
    const bool negative = coder.bit(sign_[low == 0][lean], residual < 0);
    return static_cast<std::int32_t>(negative ? 0u - coded : coded);
  }

 private:
  static constexpr std::uint32_t kContexts = 44, kSteps = 16;
  std::array<std::array<AdaptiveBit, kSteps>, kContexts> steps_;
  std::array<std::array<AdaptiveBit, 2>, kContexts> top_;
  std::array<std::array<AdaptiveBit, 3>, 2> sign_;
};

/// Small residuals in contexts that the caller numbers: each learns its own zeros, signs and sizes.
class ResidualContexts {
 public:
  explicit ResidualContexts(std::uint32_t count) : contexts_(count) {}

  /// As ResidualModel::code. Residuals are in [-below, above], both at most 2^30.
  template <class Coder>
  std::int32_t code(Coder& coder, std::uint32_t context, std::int32_t residual, std::uint32_t below,
                    std::uint32_t above) {
    Context& bits = contexts_[context];
    if (below + above == 0 || !coder.bit(bits.any, residual != 0)) return 0;
    const bool isAbove = above > 0 && (below == 0 || coder.bit(bits.sign, residual > 0));
    const std::uint32_t most = isAbove ? above : below;
    const auto size = static_cast<std::uint32_t>(std::abs(residual));
    std::uint32_t coded = 1;
    while (coded < std::min(most, kFar) && coder.bit(bits.more[isAbove][coded - 1], size > coded)) ++coded;
    if (coded == kFar && most > kFar) coded += std::min(codeGamma(coder, size - kFar), most - kFar);
    return isAbove ? static_cast<std::int32_t>(coded) : -static_cast<std::int32_t>(coded);
  }

 private:
  static constexpr std::uint32_t kFar = 20;
  struct Context {
    AdaptiveBit any, sign;
    std::array<std::array<AdaptiveBit, kFar - 1>, 2> more;
  };
  std::vector<Context> contexts_;
};

}  // namespace fiatlux
