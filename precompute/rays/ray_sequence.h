// Well-spread points of the four-dimensional unit cube (Sobol', directions of Joe and Kuo 2008), shuffled
// anew for every patch by Owen's scrambling as a hash (Laine and Karras 2011): unbiased, and errors fall
// faster than 1/sqrt(N).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "precompute/rays/float8.h"

namespace fiatlux {

/// 64 bits into 64 well-mixed bits (splitmix64): seeds of patches from the seed of a run.
std::uint64_t mixBits(std::uint64_t bits);

/// Points of one scramble: [i] are four numbers in [0, 1). Depends on (count, seed) only.
class RaySequence {
 public:
  explicit RaySequence(std::uint32_t count);
  std::uint32_t count() const { return count_; }
  /// Point i of the scramble that belongs to `seed`.
  std::array<double, 4> point(std::uint32_t i, const std::array<std::uint32_t, 4>& seed) const;
  /// Points i to i + 7, a lane each, in single precision; i divisible by 8. Those from count() on are none.
  std::array<Float8, 4> eightPoints(std::uint32_t i, const std::array<std::uint32_t, 4>& seed) const;
  /// The first two numbers of any eight points.
  std::array<Float8, 2> eightPairs(const std::uint32_t (&of)[8],
                                   const std::array<std::uint32_t, 4>& seed) const;
  static std::array<std::uint32_t, 4> scramble(std::uint64_t seed);

 private:
  struct alignas(32) Eight {
    std::uint32_t of[4][8];
  };
  std::uint32_t count_;
  std::vector<Eight> reversed_;  // Sobol' integers, bits reversed
};

}  // namespace fiatlux
