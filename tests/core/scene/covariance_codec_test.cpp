// Covariances in both forms against the matrices they came from, within the bound that they state.
#include "core/scene/covariance_codec.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"

namespace fiatlux {
namespace {

/// G G^T of a random m x rank matrix whose rows have very different sizes.
std::vector<double> randomCovariance(std::uint32_t m, std::uint32_t rank) {
  Random random(11);
  std::vector<double> g(std::size_t{m} * rank), c(std::size_t{m} * m);
  for (std::uint32_t i = 0; i < m; ++i)
    for (std::uint32_t r = 0; r < rank; ++r)
      g[i * rank + r] = (random.unit() - 0.3) * std::pow(10.0, -double(i % 5));
  for (std::uint32_t i = 0; i < m; ++i)
    for (std::uint32_t j = 0; j < m; ++j)
      for (std::uint32_t r = 0; r < rank; ++r) c[i * m + j] += g[i * rank + r] * g[j * rank + r];
  return c;
}

void expectWithinBound(const std::vector<double>& c, std::uint32_t m, Encoding expected) {
  const PlainSection section = encodeCovariance("covariance", c, m, 1e-6);
  EXPECT_EQ(section.section.encoding, expected);
  std::vector<double> back;
  ASSERT_EQ(decodeCovariance(section.section, section.bytes, m, back), "");
  for (std::uint32_t i = 0; i < m; ++i)
    for (std::uint32_t j = 0; j < m; ++j) {
      const double scale = std::sqrt(c[i * m + i] * c[j * m + j]);
      ASSERT_NEAR(back[i * m + j], c[i * m + j], section.section.errorBound * scale) << i << " " << j;
      ASSERT_EQ(back[i * m + j], back[j * m + i]);
    }
}

TEST(CovarianceCodec, LowRankIsFactored) {
  expectWithinBound(randomCovariance(60, 4), 60, Encoding::kFactored);
}

TEST(CovarianceCodec, FullRankIsPacked) {
  expectWithinBound(randomCovariance(60, 80), 60, Encoding::kPacked);
}

TEST(CovarianceCodec, OneSite) { expectWithinBound({0.25}, 1, Encoding::kPacked); }

TEST(CovarianceCodec, DarkSurface) {
  expectWithinBound(std::vector<double>(49, 0.0), 7, Encoding::kFactored);
}

TEST(CovarianceCodec, SitesWithoutLightAmongOthers) {
  std::vector<double> c = randomCovariance(20, 30);
  for (std::uint32_t i = 0; i < 20; ++i) c[3 * 20 + i] = c[i * 20 + 3] = 0;
  expectWithinBound(c, 20, Encoding::kPacked);
}

TEST(CovarianceCodec, WrongShapesAreRefused) {
  const PlainSection section = encodeCovariance("covariance", randomCovariance(20, 30), 20, 1e-6);
  std::vector<double> back;
  EXPECT_NE(decodeCovariance(section.section, section.bytes, 21, back), "");
}

}  // namespace
}  // namespace fiatlux
