// Well-spread points of the four-dimensional unit cube (Sobol', directions of Joe and Kuo 2008), shuffled
// anew for every patch by Owen's scrambling as a hash (Laine and Karras 2011): unbiased, and errors fall
// faster than 1/sqrt(N).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace fiatlux {

/// 64 bits into 64 well-mixed bits (splitmix64): seeds of patches from the seed of a run.
std::uint64_t mixBits(std::uint64_t bits);

/// Points of one scramble: [i] are four numbers in [0, 1). Depends on (count, seed) only.
class RaySequence {
 public:
  explicit RaySequence(std::uint32_t count);
  std::uint32_t count() const { return static_cast<std::uint32_t>(reversed_.size()); }
  /// Point i of the scramble that belongs to `seed`.
  std::array<double, 4> point(std::uint32_t i, const std::array<std::uint32_t, 4>& seed) const;
  static std::array<std::uint32_t, 4> scramble(std::uint64_t seed);

 private:
  std::vector<std::array<std::uint32_t, 4>> reversed_;  // Sobol' integers, bits reversed
};

}  // namespace fiatlux
