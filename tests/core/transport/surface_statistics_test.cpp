// Mean rows and covariances against sums written out.
#include "core/transport/surface_statistics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"

namespace fiatlux {
namespace {

TEST(SurfaceStatistics, AreasWeighTheMeanAndThePopulationSigma) {
  const float values[2] = {2, 6};
  const double areas[2] = {1, 3};
  const SurfaceStatistics s = surfaceStatistics(values, areas, 2, 1);
  EXPECT_DOUBLE_EQ(s.mean[0], 5);
  EXPECT_NEAR(std::sqrt(s.covariance[0]), 1.7320508075688772, 1e-12);
}

TEST(SurfaceStatistics, QuadraticFormEqualsTheVarianceOfTheSum) {
  constexpr std::uint32_t kRows = 1500, kColumns = 5;  // more than one block of rows
  Random random(11);
  std::vector<float> values(kRows * kColumns);
  std::vector<double> areas(kRows);
  for (float& value : values)
    value = static_cast<float>(random.unit() + 100);  // far from 0: digits must not cancel
  for (double& area : areas) area = 0.1 + random.unit();
  const SurfaceStatistics s = surfaceStatistics(values.data(), areas.data(), kRows, kColumns);
  const double x[kColumns] = {1, -2, 0.5, 3, 0.25};
  double area = 0, mean = 0, variance = 0, form = 0, dotMean = 0;
  const auto sum = [&](std::uint32_t i) {
    double total = 0;
    for (std::uint32_t j = 0; j < kColumns; ++j) total += x[j] * values[i * kColumns + j];
    return total;
  };
  for (std::uint32_t i = 0; i < kRows; ++i) {
    area += areas[i];
    mean += areas[i] * sum(i);
  }
  mean /= area;
  for (std::uint32_t i = 0; i < kRows; ++i) variance += areas[i] / area * std::pow(sum(i) - mean, 2);
  for (std::uint32_t i = 0; i < kColumns; ++i) {
    dotMean += x[i] * s.mean[i];
    for (std::uint32_t j = 0; j < kColumns; ++j) form += x[i] * x[j] * s.covariance[i * kColumns + j];
  }
  EXPECT_NEAR(dotMean, mean, 1e-10 * std::abs(mean));
  EXPECT_NEAR(form, variance, 1e-9 * variance);
}

TEST(SurfaceStatistics, ExitanceIsReflectanceTimesIlluminanceAndReceiversHaveNone) {
  Patches patches;
  patches.count = 2;
  patches.area = {1, 1, 2};
  patches.reflectance = {0.5f, 0.25f, 0.0f};
  patches.surface = {0, 0, 1};
  const Responses responses = {3, 1, {10, 20, 30}};
  EXPECT_NEAR(responseStatistics(patches, responses, Quantity::kIlluminance, 0).mean[0], 15, 1e-12);
  EXPECT_NEAR(responseStatistics(patches, responses, Quantity::kExitance, 0).mean[0], 5, 1e-12);
  EXPECT_NEAR(responseStatistics(patches, responses, Quantity::kIlluminance, 1).mean[0], 30, 1e-12);
  EXPECT_TRUE(responseStatistics(patches, responses, Quantity::kExitance, 1).mean.empty());
}

}  // namespace
}  // namespace fiatlux
