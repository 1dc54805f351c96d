#include "core/scene/response_quantiser.h"

#include <algorithm>
#include <cmath>

namespace fiatlux {

void Quantiser::quantise(const float* column, ResponseScale* scales, std::vector<std::int32_t>& numbers) {
  std::vector<double> peak(surfaces_), dimArea(surfaces_), dim(surfaces_), darkest(surfaces_, 1e300);
  mean_.assign(surfaces_, 0);
  for (std::uint32_t p = 0; p < patches_.rows(); ++p) {
    mean_[patches_.surface[p]] += patches_.area[p] * column[p] / area_[patches_.surface[p]];
    peak[patches_.surface[p]] = std::max<double>(peak[patches_.surface[p]], column[p]);
  }
  for (std::uint32_t s = 0; s < surfaces_; ++s)
    scales[s] = {static_cast<float>(std::max(steps_[s] * mean_[s], peak[s] / (kLargestNumber / 2))), 0};
  for (std::uint32_t p = 0; p < patches_.rows(); ++p) {
    const std::uint32_t s = patches_.surface[p];
    numbers[p] =
        scales[s].step > 0 ? static_cast<std::int32_t>(std::lround(double{column[p]} / scales[s].step)) : 0;
    if (numbers[p] > 0) continue;
    dimArea[s] += patches_.area[p];
    dim[s] += patches_.area[p] * column[p];
    darkest[s] = std::min<double>(darkest[s], column[p]);
  }
  // note: where no light at all arrives (a sealed corner), dim patches must not be given any.
  for (std::uint32_t s = 0; s < surfaces_; ++s)
    if (dimArea[s] > 0 && darkest[s] > 1e-4 * scales[s].step)
      scales[s].floor = static_cast<float>(std::min(dim[s] / dimArea[s], 0.5 * scales[s].step));
}

void Quantiser::judge(const float* column, const ResponseScale* scales,
                      const std::vector<std::int32_t>& numbers, float* rms, std::vector<float>& bound) const {
  std::vector<double> squares(surfaces_), worst(surfaces_);
  for (std::uint32_t p = 0; p < patches_.rows(); ++p) {
    const ResponseScale& scale = scales[patches_.surface[p]];
    const float stored = numbers[p] > 0 ? static_cast<float>(numbers[p]) * scale.step : scale.floor;
    const double error = std::abs(double{stored} - column[p]);
    squares[patches_.surface[p]] += patches_.area[p] * error * error;
    worst[patches_.surface[p]] = std::max(worst[patches_.surface[p]], error);
  }
  for (std::uint32_t s = 0; s < surfaces_; ++s) {
    if (!(mean_[s] > 0)) continue;
    rms[s] = static_cast<float>(std::sqrt(squares[s] / area_[s]) / mean_[s]);
    bound[s] = std::max(bound[s], static_cast<float>(worst[s] / mean_[s] * 1.000001));
  }
}

}  // namespace fiatlux
