// Quantised responses: the bounds that are stated hold, and damaged blocks are refused.
#include "core/scene/response_codec.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "tests/core/synthetic_scene.h"

namespace fiatlux {
namespace {

/// All blocks of an encoding, decoded.
std::vector<float> decoded(const EncodedResponses& encoded, const Patches& patches, std::uint32_t columns,
                           std::uint32_t surfaces) {
  const std::uint32_t perBlock = responseBlockColumns(patches.rows());
  std::vector<float> out(std::size_t{patches.rows()} * columns);
  for (std::uint32_t block = 0; block < encoded.blocks.size(); ++block) {
    const std::uint32_t first = block * perBlock, width = std::min(perBlock, columns - first);
    const auto scales =
        std::span(encoded.scales).subspan(std::size_t{first} * surfaces, std::size_t{width} * surfaces);
    EXPECT_EQ(decodeResponses(encoded.blocks[block], patches, scales, width,
                              &out[std::size_t{first} * patches.rows()]),
              "");
  }
  return out;
}

double meanOf(const Scene& scene, const float* column, std::uint32_t surface) {
  double sum = 0, area = 0;
  for (std::uint32_t p = 0; p < scene.patches.rows(); ++p)
    if (scene.patches.surface[p] == surface)
      sum += scene.patches.area[p] * column[p], area += scene.patches.area[p];
  return sum / area;
}

TEST(ResponseCodec, StatedBoundsHold) {
  // Seven columns: a whole group of lanes and a part of one.
  const Scene scene = syntheticScene(64, 7);
  const EncodedResponses encoded = encodeResponses(scene.responses, scene.patches, 3);
  const std::vector<float> back = decoded(encoded, scene.patches, 7, 3);
  for (std::uint32_t j = 0; j < 7; ++j)
    for (std::uint32_t s = 0; s < 3; ++s) {
      const float* column = scene.responses.column(j);
      const double mean = meanOf(scene, column, s);
      double squares = 0, area = 0;
      for (std::uint32_t p = 0; p < scene.patches.rows(); ++p) {
        if (scene.patches.surface[p] != s) continue;
        const float stored = back[std::size_t{j} * scene.patches.rows() + p];
        EXPECT_GE(stored, 0);
        EXPECT_LE(std::abs(stored - column[p]), encoded.errorBound[s] * mean);
        squares += scene.patches.area[p] * std::pow(stored - column[p], 2);
        area += scene.patches.area[p];
      }
      const double rms = std::sqrt(squares / area) / mean;
      EXPECT_NEAR(rms, encoded.rms[j * 3 + s], 1e-6);
      EXPECT_LT(rms, 1.2 * kResponseStep / std::sqrt(12));
    }
  for (float bound : encoded.errorBound) EXPECT_LE(bound, 0.5 * kResponseStep * 1.001);
}

TEST(ResponseCodec, DimPatchesKeepTheirLight) {
  // A bright end and a long dim one: every dim value is far below the step.
  Scene scene = syntheticScene(64, 1);
  for (std::uint32_t p = 0; p < scene.patches.rows(); ++p)
    scene.responses.illuminance[p] = p % 512 < 16 ? 1.0f : 1e-5f * (1 + p % 3);
  const EncodedResponses encoded = encodeResponses(scene.responses, scene.patches, 3);
  const std::vector<float> back = decoded(encoded, scene.patches, 1, 3);
  EXPECT_NEAR(back[300], 2e-5, 1e-6);
}

TEST(ResponseCodec, WhereNoLightArrivesNoneIsAdded) {
  Scene scene = syntheticScene(16, 2);
  for (std::uint32_t p = 0; p < scene.patches.rows(); p += 2) scene.responses.illuminance[p] = 0;
  for (std::uint32_t p = 0; p < scene.patches.rows(); ++p)
    scene.responses.illuminance[scene.patches.rows() + p] = 0;
  const EncodedResponses encoded = encodeResponses(scene.responses, scene.patches, 3);
  const std::vector<float> back = decoded(encoded, scene.patches, 2, 3);
  for (std::size_t i = 0; i < back.size(); ++i)
    ASSERT_TRUE(scene.responses.illuminance[i] != 0 || back[i] == 0) << i;
}

TEST(ResponseCodec, ExtremesComeBack) {
  // A peak of a million times the mean needs the long escapes.
  Scene scene = syntheticScene(512, 5);
  for (std::uint32_t j = 0; j < 5; ++j)
    for (std::uint32_t p = 0; p < scene.patches.rows(); ++p)
      scene.responses.illuminance[std::size_t{j} * scene.patches.rows() + p] = p == 77 * j ? 1e6f : 1e-3f;
  const EncodedResponses encoded = encodeResponses(scene.responses, scene.patches, 3);
  const std::vector<float> back = decoded(encoded, scene.patches, 5, 3);
  for (std::uint32_t j = 0; j < 5; ++j)
    EXPECT_NEAR(back[std::size_t{j} * scene.patches.rows() + 77 * j], 1e6, 10);
}

TEST(ResponseCodec, NoiseRoundTripsExactlyOnceQuantised) {
  // What was decoded lies on the grid of steps: encoding the whole numbers again loses nothing.
  Scene scene = syntheticScene(32, 6, 0.5);
  const EncodedResponses encoded = encodeResponses(scene.responses, scene.patches, 3);
  const std::vector<float> back = decoded(encoded, scene.patches, 6, 3);
  for (std::size_t i = 0; i < back.size(); ++i) {
    const std::uint32_t p = i % scene.patches.rows(), j = i / scene.patches.rows();
    const ResponseScale scale = encoded.scales[j * 3 + scene.patches.surface[p]];
    const double number = std::round(scene.responses.illuminance[i] / double{scale.step});
    EXPECT_NEAR(back[i], number > 0 ? number * scale.step : scale.floor, 1e-6 * back[i]);
  }
}

TEST(ResponseCodec, DamagedBlocksAreRefusedOrDecodeToSomethingSane) {
  const Scene scene = syntheticScene(8, 3);
  const EncodedResponses encoded = encodeResponses(scene.responses, scene.patches, 3);
  const std::vector<std::uint8_t>& block = encoded.blocks[0];
  std::vector<float> out(std::size_t{scene.patches.rows()} * 3);
  for (std::size_t bytes = 0; bytes < block.size(); ++bytes)
    ASSERT_NE(decodeResponses({block.data(), bytes}, scene.patches, encoded.scales, 3, out.data()), "")
        << bytes;
  Random random(3);
  std::size_t refused = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    std::vector<std::uint8_t> damaged = block;
    damaged[random.below(static_cast<std::uint32_t>(block.size()))] ^=
        static_cast<std::uint8_t>(1 + random.below(255));
    if (!decodeResponses(damaged, scene.patches, encoded.scales, 3, out.data()).empty()) {
      ++refused;
      continue;
    }
    for (float v : out) ASSERT_TRUE(v >= 0 && std::isfinite(v));
  }
  EXPECT_GT(refused, 1000u);
}

}  // namespace
}  // namespace fiatlux
