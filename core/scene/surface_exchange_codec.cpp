#include "core/scene/surface_exchange_codec.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/scene/range_coder.h"
#include "core/scene/residual_model.h"

namespace fiatlux {
namespace {

constexpr double kLeast = 1e-7;       // 1/m2: less is nothing
constexpr double kMost = 1e6;         // beyond any room
constexpr double kLarge = 0.1;        // of the largest surface's area: what is smaller has coarser steps
constexpr double kSmallsStep = 3;     // times the step of large ones
constexpr std::uint32_t kUnsure = 7;  // how far numbers without neighbours are taken to be off

/// Columns of numbers, one a patch, through a coder, which writes (RangeEncoder) or reads (RangeDecoder)
/// them.
class LogarithmModel {
 public:
  LogarithmModel(const Patches& patches, bool isOlder)
      : patches_(patches),
        isOlder_(isOlder),
        number_(patches.count),
        miss_(patches.count),
        missBefore_(patches.count) {}

  /// Codes `number`, which a decoder ignores, of patch p; patches come in order, surface by surface.
  template <class Coder>
  std::int64_t code(Coder& coder, std::uint32_t p, std::int32_t number) {
    if (p == 0) std::swap(miss_, missBefore_), hasBefore_ = std::exchange(hasNow_, !isOlder_);
    const auto [prediction, activity] = expected(p);
    const std::int64_t coded = std::int64_t{prediction} +
                               model_.code(coder, activity, ResidualModel::kOrdinary, 0, number - prediction);
    number_[p] = static_cast<std::int32_t>(std::clamp<std::int64_t>(coded, 0, kLargest));
    miss_[p] = static_cast<std::uint32_t>(std::abs(number_[p] - prediction));
    return coded;
  }

  static constexpr std::int32_t kLargest = 1 << 24;

 private:
  struct Expected {
    std::int32_t number;
    std::uint32_t activity;
  };
  Expected expected(std::uint32_t p) const {
    const std::uint32_t left = patches_.left[p], up = patches_.up[p], before = missBefore_[p];
    if (left == kNone && up == kNone)
      return {p > 0 ? number_[p - 1] : 0, hasBefore_ ? 14 * (before + kUnsure) : 28 * kUnsure};
    const std::uint32_t beside = left == kNone ? 2 * miss_[up]
                                 : up == kNone ? 2 * miss_[left]
                                               : miss_[left] + miss_[up];
    return {planeAt(left, up), hasBefore_ ? (28 * (beside + before) + 1) / 3 : 14 * beside};
  }
  /// On a plane through the neighbours, but never beyond them.
  std::int32_t planeAt(std::uint32_t left, std::uint32_t up) const {
    if (left == kNone) return number_[up];
    if (up == kNone) return number_[left];
    const std::int32_t a = number_[left], b = number_[up];
    const std::uint32_t corner = patches_.left[up];
    return corner == kNone ? (a + b) / 2
                           : std::clamp(a + b - number_[corner], std::min(a, b), std::max(a, b));
  }

  const Patches& patches_;
  bool isOlder_, hasBefore_ = false, hasNow_ = false;  // whether there is a surface before
  std::vector<std::int32_t> number_;                   // patches
  std::vector<std::uint32_t> miss_, missBefore_;       // on this surface, and on the one before
  ResidualModel model_;
};

/// Of each surface.
std::vector<double> stepsOf(const Patches& patches, std::uint32_t surfaces, double step) {
  std::vector<double> area(surfaces, 0);
  for (std::uint32_t p = 0; p < patches.rows(); ++p)
    if (patches.surface[p] < surfaces) area[patches.surface[p]] += patches.area[p];
  const double largest = surfaces > 0 ? *std::max_element(area.begin(), area.end()) : 0;
  for (double& value : area) value = value >= kLarge * largest ? step : kSmallsStep * step;
  return area;
}

}  // namespace

std::vector<std::uint8_t> encodeSurfaceExchange(const Patches& patches, const SurfaceExchange& exchange) {
  const std::vector<double> steps = stepsOf(patches, exchange.surfaces, kSurfaceExchangeStep);
  RangeEncoder out;
  LogarithmModel model(patches, false);
  for (std::uint32_t s = 0; s < exchange.surfaces; ++s)
    for (std::uint32_t p = 0; p < patches.count; ++p) {
      const double mean = std::min<double>(exchange.means[std::size_t{p} * exchange.surfaces + s], kMost);
      const double number = mean > kLeast ? 1 + std::round(std::log(mean / kLeast) / steps[s]) : 0;
      model.code(out, p, static_cast<std::int32_t>(number));
    }
  return out.finish();
}

std::string decodeSurfaceExchange(std::span<const std::uint8_t> bytes, const Patches& patches,
                                  SurfaceExchange& exchange, double step, bool isOlder) {
  const std::vector<double> steps = stepsOf(patches, exchange.surfaces, step);
  exchange.means.assign(std::size_t{patches.count} * exchange.surfaces, 0.0f);
  RangeDecoder in(bytes);
  LogarithmModel model(patches, isOlder);
  for (std::uint32_t s = 0; s < exchange.surfaces; ++s)
    for (std::uint32_t p = 0; p < patches.count; ++p) {
      const std::int64_t number = model.code(in, p, 0);
      const double mean = number > 0 ? kLeast * std::exp(static_cast<double>(number - 1) * steps[s]) : 0;
      if (number < 0 || !(mean <= 2 * kMost)) return "a value is out of range";
      exchange.means[std::size_t{p} * exchange.surfaces + s] = static_cast<float>(mean);
    }
  return in.ended() ? "" : "its length does not fit its values";
}

}  // namespace fiatlux
