// Encoder and decoder are one walk through the numbers, with a coder that writes or reads.
#include "core/scene/statistics_codec.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "core/scene/range_coder.h"
#include "core/scene/residual_model.h"

namespace fiatlux {
namespace {

constexpr double kLargestDeviation = 1e15;  // keeps its square finite, in single precision too
constexpr double kLargestCorrelation = 2;   // nothing true is above 1, but for rounding

/// note: the library of the Wasm compiler has no std::bit_cast yet.
template <class To, class From>
To bitsAs(From from) {
  static_assert(sizeof(To) == sizeof(From));
  To to;
  std::memcpy(&to, &from, sizeof to);
  return to;
}

std::int32_t steps(double correlation) {
  if (std::isnan(correlation)) return 0;  // of responses too bright for single precision
  return static_cast<std::int32_t>(
      std::lround(std::clamp(correlation, -kLargestCorrelation, kLargestCorrelation) / kCorrelationUnit));
}

/// A running mean of sizes, in 1/16.
class Running {
 public:
  std::uint32_t sixteenfold() const { return sum_; }
  void add(std::int32_t residual) {
    sum_ += std::min(static_cast<std::uint32_t>(std::abs(std::int64_t{residual})), 1u << 20) - sum_ / 16;
  }

 private:
  std::uint32_t sum_ = 64;
};

/// Codes numbers >= 0 as floats: their bits are whole numbers in the same order. False where one that was
/// read is above `largest`.
template <class Coder>
bool codeFloats(Coder& coder, std::span<const double> expected, double largest, std::vector<double>& values) {
  ResidualModel model;
  Running running;
  const auto word = [](double value) {
    return bitsAs<std::int32_t>(static_cast<float>(std::max(0.0, value)));
  };
  for (std::size_t j = 0; j < expected.size(); ++j) {
    const std::int32_t from = word(expected[j]);
    const std::int32_t residual =
        model.code(coder, 2 * running.sixteenfold(), ResidualModel::kOrdinary, 0, word(values[j]) - from);
    const std::int64_t coded = std::int64_t{from} + residual;
    if (coded < 0 || coded > word(largest)) return false;
    values[j] = double{bitsAs<float>(static_cast<std::int32_t>(coded))};
    running.add(residual);
  }
  return true;
}

/// Codes the correlations off the diagonal; `scale`: the m standard deviations. False where one that was read
/// is out of range.
template <class Coder>
bool codeCorrelations(Coder& coder, std::span<const double> expected, std::span<const double> scale,
                      std::vector<double>& covariance) {
  const std::size_t m = scale.size();
  ResidualModel model;
  std::vector<Running> running(m);
  for (std::size_t i = 0; i < m; ++i) {
    covariance[i * m + i] = scale[i] * scale[i];
    for (std::size_t j = i + 1; j < m; ++j) {
      const double both = scale[i] * scale[j];
      const auto stepsOf = [&](double value) { return both > 0 ? steps(value / both) : 0; };
      const std::int32_t from = stepsOf(expected[i * m + j]);
      const std::int32_t residual =
          model.code(coder, running[i].sixteenfold() + running[j].sixteenfold(), ResidualModel::kOrdinary, 0,
                     stepsOf(covariance[i * m + j]) - from);
      const std::int64_t coded = std::int64_t{from} + residual;
      if (std::abs(coded) > steps(kLargestCorrelation)) return false;
      covariance[i * m + j] = covariance[j * m + i] = kCorrelationUnit * static_cast<double>(coded) * both;
      running[i].add(residual), running[j].add(residual);
    }
  }
  return true;
}

std::vector<double> deviationsOf(const SurfaceStatistics& statistics) {
  const std::size_t m = statistics.mean.size();
  std::vector<double> deviations(m);
  for (std::size_t i = 0; i < m; ++i)
    deviations[i] = std::sqrt(std::max(0.0, statistics.covariance[i * m + i]));
  return deviations;
}

/// `statistics` go in (encoder) and come back as the decoder will have them.
template <class Coder>
bool code(Coder& coder, const SurfaceStatistics& expected, double brightest, SurfaceStatistics& statistics) {
  std::vector<double> scale = deviationsOf(statistics);
  return codeFloats(coder, expected.mean, brightest, statistics.mean) &&
         codeFloats(coder, deviationsOf(expected), kLargestDeviation, scale) &&
         codeCorrelations(coder, expected.covariance, scale, statistics.covariance);
}

}  // namespace

float statisticsErrorBound() {
  constexpr double kFloatRounding = 0x1p-23;  // of both deviations of a product
  return static_cast<float>(0.5 * kCorrelationUnit + kFloatRounding);
}

SurfaceStatistics expectedStatistics(SurfaceStatistics stored, const SurfaceStatistics& otherStored,
                                     const SurfaceStatistics& otherTrue, double factor) {
  for (std::size_t i = 0; i < stored.mean.size(); ++i)
    stored.mean[i] += factor * (otherTrue.mean[i] - otherStored.mean[i]);
  for (std::size_t i = 0; i < stored.covariance.size(); ++i)
    stored.covariance[i] += factor * factor * (otherTrue.covariance[i] - otherStored.covariance[i]);
  return stored;
}

std::vector<std::uint8_t> encodeStatistics(SurfaceStatistics& statistics, const SurfaceStatistics& expected) {
  RangeEncoder coder;
  code(coder, expected, HUGE_VAL, statistics);
  return coder.finish();
}

std::string decodeStatistics(std::span<const std::uint8_t> bytes, const SurfaceStatistics& expected,
                             double brightest, SurfaceStatistics& statistics) {
  const std::size_t m = expected.mean.size();
  statistics = {std::vector<double>(m), std::vector<double>(m * m)};
  RangeDecoder coder(bytes);
  if (!code(coder, expected, brightest, statistics)) return "a value is out of range";
  return coder.ended() ? "" : "it does not have the length that the sites need";
}

}  // namespace fiatlux
