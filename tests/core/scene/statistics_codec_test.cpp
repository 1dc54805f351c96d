// Statistics as corrections: within their bound of what they were made from, however wrong the expectation;
// and what both sides expect (stored_statistics).
#include "core/scene/statistics_codec.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "core/scene/response_codec.h"
#include "core/scene/stored_statistics.h"
#include "tests/core/synthetic_scene.h"

namespace fiatlux {
namespace {

constexpr double kBrightest = 1e12;

/// Codes `exact` against `expected`, and holds what comes back against both the bound and the encoder's word.
std::size_t expectWithinBound(const SurfaceStatistics& exact, const SurfaceStatistics& expected) {
  const std::size_t m = exact.mean.size();
  SurfaceStatistics promised = exact, back;
  const std::vector<std::uint8_t> bytes = encodeStatistics(promised, expected);
  EXPECT_EQ(decodeStatistics(bytes, expected, kBrightest, back), "");
  EXPECT_EQ(back.mean, promised.mean);
  EXPECT_EQ(back.covariance, promised.covariance);
  for (std::size_t i = 0; i < m; ++i) {
    EXPECT_NEAR(back.mean[i], exact.mean[i], 1e-7 * exact.mean[i]);
    for (std::size_t j = 0; j < m; ++j) {
      const double scale = std::sqrt(exact.covariance[i * m + i] * exact.covariance[j * m + j]);
      EXPECT_NEAR(back.covariance[i * m + j], exact.covariance[i * m + j],
                  1.01 * statisticsErrorBound() * scale)
          << i << " " << j;
      EXPECT_EQ(back.covariance[i * m + j], back.covariance[j * m + i]);
    }
  }
  return bytes.size();
}

SurfaceStatistics nothing(std::size_t m) { return {std::vector<double>(m), std::vector<double>(m * m)}; }

TEST(StatisticsCodec, BoundHoldsWhateverIsExpected) {
  const Scene scene = syntheticScene(64, 30);
  for (std::uint32_t s = 0; s < 3; ++s) {
    const std::size_t wild = expectWithinBound(scene.illuminance[s], nothing(30));
    SurfaceStatistics close = scene.illuminance[s];
    for (double& v : close.covariance) v *= 1 + 1e-6;
    EXPECT_LT(expectWithinBound(scene.illuminance[s], close), wild / 4) << "what is expected costs little";
  }
}

TEST(StatisticsCodec, SitesWithoutLightAndSurfacesWithoutSpread) {
  Scene scene = syntheticScene(16, 6);
  SurfaceStatistics dark = scene.illuminance[0], even = scene.illuminance[0];
  dark.mean[2] = 0;
  for (std::size_t i = 0; i < 6; ++i) dark.covariance[2 * 6 + i] = dark.covariance[i * 6 + 2] = 0;
  expectWithinBound(dark, scene.illuminance[0]);
  expectWithinBound(scene.illuminance[0], dark);
  even.covariance.assign(36, 0.0);
  expectWithinBound(even, scene.illuminance[0]);
  expectWithinBound(nothing(6), nothing(6));
}

TEST(StatisticsCodec, OneSite) { expectWithinBound({{0.5}, {0.25}}, nothing(1)); }

TEST(StatisticsCodec, DamageIsRefusedOrDecodesToSomethingSane) {
  const Scene scene = syntheticScene(16, 8);
  SurfaceStatistics statistics = scene.illuminance[1], back;
  const std::vector<std::uint8_t> bytes = encodeStatistics(statistics, nothing(8));
  for (std::size_t size = 0; size + 1 < bytes.size(); ++size)
    if (bytes[size] != 0) {
      ASSERT_NE(decodeStatistics({bytes.data(), size}, nothing(8), kBrightest, back), "") << size;
    }
  Random random(2);
  std::size_t refused = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    std::vector<std::uint8_t> damaged = bytes;
    damaged[random.below(static_cast<std::uint32_t>(bytes.size()))] ^=
        static_cast<std::uint8_t>(1 + random.below(255));
    if (!decodeStatistics(damaged, nothing(8), kBrightest, back).empty()) {
      ++refused;
      continue;
    }
    for (const double mean : back.mean) ASSERT_TRUE(mean >= 0 && mean <= kBrightest);
    for (const double covariance : back.covariance) ASSERT_TRUE(std::isfinite(covariance));
  }
  EXPECT_GT(refused, 1000u);
}

TEST(StoredStatistics, AreThoseOfThePatches) {
  const Scene scene = syntheticScene(50, 11);  // no whole number of tiles
  const auto rows = rowsOfSurfaces(scene.patches, 3);
  for (std::uint32_t s = 0; s < 3; ++s)
    for (const bool exitance : {false, true}) {
      if (exitance && s == 2) continue;
      const SurfaceStatistics exact = statisticsOf(scene, s, exitance);
      const SurfaceStatistics quick = storedStatistics(
          scene.patches, scene.responses, exitance ? Quantity::kExitance : Quantity::kIlluminance, rows[s]);
      for (std::size_t i = 0; i < 11; ++i) {
        EXPECT_NEAR(quick.mean[i], exact.mean[i], 1e-12);
        for (std::size_t j = 0; j < 11; ++j)
          EXPECT_NEAR(quick.covariance[i * 11 + j], exact.covariance[i * 11 + j],
                      2e-6 * std::sqrt(exact.covariance[i * 11 + i] * exact.covariance[j * 11 + j]));
      }
    }
}

TEST(StoredStatistics, CorrectionsOfOneQuantityForetellThoseOfTheOther) {
  // Quantised illuminance is a little off; with one reflectance, exitance is off by just as much.
  const Scene scene = syntheticScene(40, 12);
  const std::vector<double> steps(3, kResponseStep);
  const EncodedResponses encoded =
      encodeResponses(scene.responses, scene.patches, steps, nearestBefore(scene.sites));
  const auto rows = rowsOfSurfaces(scene.patches, 3);
  const auto stored = [&](Quantity quantity) {
    return storedStatistics(scene.patches, encoded.stored, quantity, rows[0]);
  };
  const SurfaceStatistics lit = stored(Quantity::kIlluminance), leaving = stored(Quantity::kExitance);
  const SurfaceStatistics exact = statisticsOf(scene, 0, true);
  const SurfaceStatistics expected =
      expectedStatistics(leaving, lit, scene.illuminance[0], scene.surfaces[0].reflectance);
  EXPECT_GT(std::abs(leaving.covariance[1] - exact.covariance[1]), 1e-6 * exact.covariance[0]);
  EXPECT_NEAR(expected.covariance[1], exact.covariance[1], 1e-6 * exact.covariance[0]);
  EXPECT_NEAR(expected.mean[3], exact.mean[3], 1e-7 * exact.mean[3]);
}

}  // namespace
}  // namespace fiatlux
