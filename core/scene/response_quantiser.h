// Responses of one site -> whole numbers, and what the rounding does to each surface.
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/patches.h"
#include "core/scene/response_codec.h"

namespace fiatlux {

inline constexpr std::int32_t kLargestNumber = 1 << 24;  // of a quantised response: still exact as a float

/// Takes a room's columns one after the other; `step` as in response_codec.h.
class Quantiser {
 public:
  Quantiser(const Patches& patches, std::uint32_t surfaces, double step)
      : patches_(patches), surfaces_(surfaces), step_(step), area_(surfaces) {
    for (std::uint32_t p = 0; p < patches.rows(); ++p) area_[patches.surface[p]] += patches.area[p];
  }

  /// Sets the scales of a column and the numbers of its rows.
  void quantise(const float* column, ResponseScale* scales, std::vector<std::int32_t>& numbers);

  /// RMS error over the mean of each surface; raises the bounds.
  void judge(const float* column, const ResponseScale* scales, const std::vector<std::int32_t>& numbers,
             float* rms, std::vector<float>& bound) const;

 private:
  const Patches& patches_;
  std::uint32_t surfaces_;
  double step_;
  std::vector<double> area_, mean_;
};

}  // namespace fiatlux
