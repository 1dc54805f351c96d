// Quantised responses (response_streams, response_model): the bounds that are stated hold, and damaged blocks
// are refused.
#include "core/scene/response_codec.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "tests/core/synthetic_scene.h"

namespace fiatlux {
namespace {

EncodedResponses encoded(const Scene& scene, double step = kResponseStep) {
  const std::vector<double> steps(scene.surfaces.size(), step);
  return encodeResponses(scene.responses, scene.patches, steps, nearestBefore(scene.sites));
}

/// All blocks of an encoding, decoded.
std::vector<float> decoded(const EncodedResponses& encoded, const Scene& scene) {
  ResponseDecoder decoder(scene.patches, static_cast<std::uint32_t>(scene.surfaces.size()),
                          nearestBefore(scene.sites));
  for (const std::vector<std::uint8_t>& block : encoded.blocks) EXPECT_EQ(decoder.decode(block), "");
  return decoder.finish(encoded.scales);
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
  const EncodedResponses packed = encoded(scene);
  const std::vector<float> back = decoded(packed, scene);
  for (std::uint32_t j = 0; j < 7; ++j)
    for (std::uint32_t s = 0; s < 3; ++s) {
      const float* column = scene.responses.column(j);
      const double mean = meanOf(scene, column, s);
      double squares = 0, area = 0;
      for (std::uint32_t p = 0; p < scene.patches.rows(); ++p) {
        if (scene.patches.surface[p] != s) continue;
        const float stored = back[std::size_t{j} * scene.patches.rows() + p];
        EXPECT_GE(stored, 0);
        EXPECT_LE(std::abs(stored - column[p]), packed.errorBound[s] * mean);
        squares += scene.patches.area[p] * std::pow(stored - column[p], 2);
        area += scene.patches.area[p];
      }
      const double rms = std::sqrt(squares / area) / mean;
      EXPECT_NEAR(rms, packed.rms[j * 3 + s], 1e-6);
      EXPECT_LT(rms, 1.2 * kResponseStep / std::sqrt(12));
    }
  for (float bound : packed.errorBound) EXPECT_LE(bound, 0.5 * kResponseStep * 1.001);
}

TEST(ResponseCodec, DimPatchesKeepTheirLight) {
  // A bright end and a long dim one: every dim value is far below the step.
  Scene scene = syntheticScene(64, 1);
  for (std::uint32_t p = 0; p < scene.patches.rows(); ++p)
    scene.responses.illuminance[p] = p % 512 < 16 ? 1.0f : 1e-5f * (1 + p % 3);
  const EncodedResponses packed = encoded(scene);
  const std::vector<float> back = decoded(packed, scene);
  EXPECT_NEAR(back[300], 2e-5, 1e-6);
}

TEST(ResponseCodec, WhereNoLightArrivesNoneIsAdded) {
  Scene scene = syntheticScene(16, 2);
  for (std::uint32_t p = 0; p < scene.patches.rows(); p += 2) scene.responses.illuminance[p] = 0;
  for (std::uint32_t p = 0; p < scene.patches.rows(); ++p)
    scene.responses.illuminance[scene.patches.rows() + p] = 0;
  const EncodedResponses packed = encoded(scene);
  const std::vector<float> back = decoded(packed, scene);
  for (std::size_t i = 0; i < back.size(); ++i)
    ASSERT_TRUE(scene.responses.illuminance[i] != 0 || back[i] == 0) << i;
}

TEST(ResponseCodec, ExtremesComeBack) {
  // A peak of a million times the mean needs the long escapes.
  Scene scene = syntheticScene(512, 5);
  for (std::uint32_t j = 0; j < 5; ++j)
    for (std::uint32_t p = 0; p < scene.patches.rows(); ++p)
      scene.responses.illuminance[std::size_t{j} * scene.patches.rows() + p] = p == 77 * j ? 1e6f : 1e-3f;
  const EncodedResponses packed = encoded(scene);
  const std::vector<float> back = decoded(packed, scene);
  for (std::uint32_t j = 0; j < 5; ++j)
    EXPECT_NEAR(back[std::size_t{j} * scene.patches.rows() + 77 * j], 1e6, 10);
}

TEST(ResponseCodec, NoiseRoundTripsExactlyOnceQuantised) {
  // What was decoded lies on the grid of steps: encoding the whole numbers again loses nothing.
  Scene scene = syntheticScene(32, 6, 0.5);
  const EncodedResponses packed = encoded(scene);
  const std::vector<float> back = decoded(packed, scene);
  for (std::size_t i = 0; i < back.size(); ++i) {
    const std::uint32_t p = i % scene.patches.rows(), j = i / scene.patches.rows();
    const ResponseScale scale = packed.scales[j * 3 + scene.patches.surface[p]];
    const double number = std::round(scene.responses.illuminance[i] / double{scale.step});
    EXPECT_NEAR(back[i], number > 0 ? number * scale.step : scale.floor, 1e-6 * back[i]);
  }
}

TEST(ResponseCodec, EncoderKnowsWhatTheDecoderYields) {
  // More than one block, and finer steps on one surface.
  const Scene scene = syntheticScene(3200, 17);
  ASSERT_LT(responseBlockColumns(scene.patches.rows()), 17u);
  const std::vector<double> steps = {kResponseStep, kResponseStep / 64, kResponseStep};
  const EncodedResponses packed =
      encodeResponses(scene.responses, scene.patches, steps, nearestBefore(scene.sites));
  EXPECT_EQ(packed.blocks.size(), 2u);
  EXPECT_EQ(decoded(packed, scene), packed.stored.illuminance);
  EXPECT_LE(packed.errorBound[1], 0.6 * kResponseStep / 64);
}

TEST(ResponseCodec, NeighboursNoiseIsNotPaidTwice) {
  // The same restless light under every site: after the first it is known.
  Scene scene = syntheticScene(640, 8);
  const std::uint32_t rows = scene.patches.rows();
  Random random(9);
  for (std::uint32_t p = 0; p < rows; ++p)
    for (std::uint32_t j = 0; j < 8; ++j)
      scene.responses.illuminance[j * rows + p] =
          j == 0 ? static_cast<float>(1 + random.unit()) : scene.responses.illuminance[p];
  const EncodedResponses packed = encoded(scene);
  Scene alone = scene;
  alone.sites.resize(1);
  alone.responses.sites = 1;
  EXPECT_LT(packed.blocks[0].size(), 3 * encoded(alone).blocks[0].size());
}

TEST(ResponseCodec, ShortBlocksAreFilledUp) {
  Scene scene = syntheticScene(64, 8);
  std::fill(scene.responses.illuminance.begin(), scene.responses.illuminance.end(), 0.0f);
  const EncodedResponses packed = encoded(scene);
  EXPECT_GE(packed.blocks[0].size() * kValuesPerByte, scene.responses.illuminance.size());
  EXPECT_EQ(decoded(packed, scene), scene.responses.illuminance);
}

TEST(NearestBefore, AreTheNearest) {
  Scene scene = syntheticScene(4, 5);
  for (std::uint32_t j = 0; j < 5; ++j)
    scene.sites[j].position = {std::vector<double>{0, 5, 1, 2, 4}[j], 3, 0};
  const std::vector<ResponseReferences> references = nearestBefore(scene.sites);
  EXPECT_EQ(references[0], (ResponseReferences{kNone, kNone}));
  EXPECT_EQ(references[1], (ResponseReferences{0, kNone}));
  EXPECT_EQ(references[2], (ResponseReferences{0, 1}));
  EXPECT_EQ(references[3], (ResponseReferences{2, 0}));
  EXPECT_EQ(references[4], (ResponseReferences{1, 3}));
}

TEST(ResponseCodec, DamagedBlocksAreRefusedOrDecodeToSomethingSane) {
  const Scene scene = syntheticScene(8, 3);
  const EncodedResponses packed = encoded(scene);
  const std::vector<std::uint8_t>& block = packed.blocks[0];
  const auto fault = [&](std::span<const std::uint8_t> bytes, std::vector<float>& out) {
    ResponseDecoder decoder(scene.patches, 3, nearestBefore(scene.sites));
    const std::string fault = decoder.decode(bytes);
    if (fault.empty()) out = decoder.finish(packed.scales);
    return fault;
  };
  std::vector<float> out;
  for (std::size_t bytes = 0; bytes < block.size(); ++bytes)
    if (block[bytes] != 0) {
      ASSERT_NE(fault({block.data(), bytes}, out), "") << bytes;
    }
  Random random(3);
  std::size_t refused = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    std::vector<std::uint8_t> damaged = block;
    damaged[random.below(static_cast<std::uint32_t>(block.size()))] ^=
        static_cast<std::uint8_t>(1 + random.below(255));
    if (!fault(damaged, out).empty()) {
      ++refused;
      continue;
    }
    for (float v : out) ASSERT_TRUE(v >= 0 && std::isfinite(v));
  }
  EXPECT_GT(refused, 1000u);
}

}  // namespace
}  // namespace fiatlux
