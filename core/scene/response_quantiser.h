// Responses of one site -> whole numbers, and what the rounding does to each surface.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/scene/patches.h"
#include "core/scene/response_codec.h"

namespace fiatlux {

/// Takes a room's columns one after the other; `steps`: one a surface, as shares of its mean response.
class Quantiser {
 public:
  Quantiser(const Patches& patches, std::span<const double> steps)
      : patches_(patches),
        surfaces_(static_cast<std::uint32_t>(steps.size())),
        steps_(steps),
        area_(steps.size()) {
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
  std::span<const double> steps_;
  std::vector<double> area_, mean_;
};

}  // namespace fiatlux
