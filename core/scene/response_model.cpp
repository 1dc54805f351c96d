#include "core/scene/response_model.h"

#include <algorithm>
#include <cstdlib>

#include "core/scene/range_coder.h"
#include "core/scene/response_codec.h"

namespace fiatlux {
ResponseModel::ResponseModel(const Patches& patches, std::uint32_t surfaces,
                             std::vector<ResponseReferences> references)
    : patches_(patches),
      references_(std::move(references)),
      neighbours_(patches.rows()),
      weights_(surfaces, Taps{0.5f, 0.5f}),
      numbers_(std::size_t{patches.rows()} * references_.size()),
      miss_(numbers_.size()),
      noNumbers_(patches.rows()),
      noMiss_(patches.rows()) {
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    std::uint32_t left = patches.left[p], up = patches.up[p];
    // One neighbour stands for both. None: the row before.
    if (left == kNone && up == kNone && p > 0 && patches.surface[p - 1] == patches.surface[p]) left = p - 1;
    if (up == kNone) up = left;
    if (left == kNone) left = up;
    neighbours_[p] = {left == kNone ? p : left, up == kNone ? p : up};
  }
}

ResponseModel::Column ResponseModel::column(std::uint32_t index) const {
  if (index == kNone) return {noNumbers_.data(), noMiss_.data()};
  const std::size_t first = std::size_t{index} * patches_.rows();
  return {&numbers_[first], &miss_[first]};
}

float ResponseModel::sumOfProducts(const Taps& a, const Taps& b) {
  float lane[4];
  for (std::size_t i = 0; i < 4; ++i) lane[i] = a[i] * b[i] + a[4 + i] * b[4 + i];
  return (lane[0] + lane[1]) + (lane[2] + lane[3]);
}

void ResponseModel::learn(Taps& weights, const Taps& seen, float error) {
  // A part of the way down the gradient of error^2.
  constexpr float kPart = 0.045f, kLeastNorm = 256;
  const float change = kPart * error / (kLeastNorm + sumOfProducts(seen, seen));
  for (std::size_t i = 0; i < kTaps; ++i) weights[i] += change * seen[i];
}

template <class Coder>
bool ResponseModel::codeColumn(Coder& coder, const std::int32_t* numbers) {
  const std::size_t rows = neighbours_.size();
  float* const own = &numbers_[next_ * rows];
  std::uint8_t* const miss = &miss_[next_ * rows];
  const Column a = column(references_[next_][0]), b = column(references_[next_][1]);
  for (std::size_t p = 0; p < rows; ++p) {
    const auto [left, up] = neighbours_[p];
    Taps& weights = weights_[patches_.surface[p]];
    const Taps seen = {own[left],    own[up],     a.number[p],    a.number[left],
                       a.number[up], b.number[p], b.number[left], b.number[up]};
    const float predicted =
        std::min(std::max(sumOfProducts(weights, seen), 0.0f), static_cast<float>(kLargestNumber));
    const auto expected = static_cast<std::int32_t>(predicted + 0.5f);

    // How far off, and to which side, the prediction is likely to be.
    const std::uint32_t activity = 8u * (miss[left] + miss[up] + a.miss[p] + b.miss[p]);
    const bool dark = activity == 0 && seen[0] + seen[1] + a.number[p] + b.number[p] == 0;
    const float rest = predicted - static_cast<float>(expected);
    const std::uint32_t lean = rest > 1.0f / 6 ? 2 : rest < -1.0f / 6 ? 1 : 0;
    const std::int32_t residual =
        residuals_.code(coder, activity, dark ? ResidualModel::kDark : ResidualModel::kOrdinary, lean,
                        numbers ? numbers[p] - expected : 0);

    const std::int64_t number = std::int64_t{expected} + residual;
    if (number < 0 || number > kLargestNumber) return false;
    own[p] = static_cast<float>(number);
    miss[p] = static_cast<std::uint8_t>(std::min<std::int64_t>(std::abs(std::int64_t{residual}), 255));
    learn(weights, seen, own[p] - predicted);
  }
  ++next_;
  return true;
}

template bool ResponseModel::codeColumn(RangeEncoder&, const std::int32_t*);
template bool ResponseModel::codeColumn(RangeDecoder&, const std::int32_t*);

std::vector<float> ResponseModel::light(std::span<const ResponseScale> scales) {
  const std::size_t rows = neighbours_.size(), surfaces = weights_.size();
  for (std::size_t j = 0; j < references_.size(); ++j)
    for (std::size_t p = 0; p < rows; ++p) {
      const ResponseScale& scale = scales[j * surfaces + patches_.surface[p]];
      float& value = numbers_[j * rows + p];
      value = value > 0 ? value * scale.step : scale.floor;
    }
  return std::move(numbers_);
}

}  // namespace fiatlux
