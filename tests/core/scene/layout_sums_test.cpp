// core/scene/layout_sums.h: mean and variance against the matrix products that they stand for.
#include "core/scene/layout_sums.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/base/random.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kSites = 9;

TEST(LayoutSums, AreTheProductsOfThePaper) {
  Random random(3);
  std::vector<double> mean(kSites), covariance(kSites * kSites);
  for (double& entry : mean) entry = random.unit();
  for (std::uint32_t i = 0; i < kSites; ++i)
    for (std::uint32_t j = 0; j <= i; ++j)
      covariance[i * kSites + j] = covariance[j * kSites + i] = random.unit() + (i == j ? kSites : 0);
  const std::vector<float> stored(covariance.begin(), covariance.end());

  const std::vector<std::uint32_t> sites = {4, 0, 8, 3, 4, 7};  // two luminaires on one site add up
  const std::vector<double> flux = {900, 1200, 300, 50, 700, 0};
  for (std::uint32_t count = 0; count <= sites.size(); ++count) {
    double mu = 0, square = 0, size = 1;
    for (std::uint32_t i = 0; i < count; ++i) {
      mu += flux[i] * mean[sites[i]];
      for (std::uint32_t j = 0; j < count; ++j)
        square += flux[i] * flux[j] * covariance[sites[i] * kSites + sites[j]];
    }
    size += square;
    EXPECT_NEAR(meanOf(mean.data(), sites.data(), flux.data(), count), mu, 1e-12 * (1 + mu)) << count;
    EXPECT_NEAR(varianceOf(covariance.data(), kSites, sites.data(), flux.data(), count), square, 1e-12 * size)
        << count;
    EXPECT_NEAR(varianceOf(stored.data(), kSites, sites.data(), flux.data(), count), square, 1e-6 * size)
        << count;
  }
}

}  // namespace
}  // namespace fiatlux
