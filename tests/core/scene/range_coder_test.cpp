// What goes in comes out, takes about as many bits as it is surprising, and does not come out of fewer bytes;
// numbers by residual_model likewise.
#include "core/scene/range_coder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "core/scene/residual_model.h"

namespace fiatlux {
namespace {

/// `count` bits of which a share `ones` is 1.
std::vector<bool> randomBits(std::size_t count, double ones, std::uint64_t seed) {
  Random random(seed);
  std::vector<bool> bits(count);
  for (std::size_t i = 0; i < count; ++i) bits[i] = random.unit() < ones;
  return bits;
}

std::vector<std::uint8_t> encoded(const std::vector<bool>& bits) {
  RangeEncoder encoder;
  AdaptiveBit model;
  for (const bool bit : bits) encoder.bit(model, bit);
  return encoder.finish();
}

TEST(RangeCoder, BitsComeBackAndCostTheirEntropy) {
  for (const double ones : {0.0, 0.001, 0.1, 0.5, 0.98, 1.0}) {
    const std::vector<bool> bits = randomBits(100000, ones, 5);
    const std::vector<std::uint8_t> bytes = encoded(bits);
    RangeDecoder decoder(bytes);
    AdaptiveBit model;
    for (const bool bit : bits) ASSERT_EQ(decoder.bit(model), bit) << ones;
    EXPECT_TRUE(decoder.ended());
    const double entropy =
        ones > 0 && ones < 1 ? -ones * std::log2(ones) - (1 - ones) * std::log2(1 - ones) : 0;
    EXPECT_LT(static_cast<double>(bytes.size()) * 8, 100000 * (1.08 * entropy + 0.005) + 40) << ones;
  }
}

TEST(RangeCoder, CarriesRunThroughWaitingBytes) {
  // Always the upper end of the range: the encoder's low end climbs through runs of 255s.
  RangeEncoder encoder;
  for (int i = 0; i < 5000; ++i)
    encoder.bits(32, 0xffffffffu), encoder.bits(7, static_cast<std::uint32_t>(i));
  const std::vector<std::uint8_t> bytes = encoder.finish();
  RangeDecoder decoder(bytes);
  for (int i = 0; i < 5000; ++i) {
    ASSERT_EQ(decoder.bits(32), 0xffffffffu);
    ASSERT_EQ(decoder.bits(7), static_cast<std::uint32_t>(i) & 127);
  }
  EXPECT_TRUE(decoder.ended());
}

TEST(RangeCoder, MissingBytesAndStrangersAreSeen) {
  const std::vector<bool> bits = randomBits(1000, 0.3, 6);
  std::vector<std::uint8_t> bytes = encoded(bits);
  const auto ended = [&] {
    RangeDecoder decoder(bytes);
    AdaptiveBit model;
    for (std::size_t i = 0; i < bits.size(); ++i) decoder.bit(model);
    return decoder.ended();
  };
  EXPECT_TRUE(ended());
  bytes.push_back(0);
  EXPECT_TRUE(ended()) << "zeros fill up";
  bytes.push_back(1);
  EXPECT_FALSE(ended());
  bytes.resize(bytes.size() - 3);
  EXPECT_FALSE(ended());
}

TEST(ResidualModel, EveryNumberComesBack) {
  std::vector<std::int32_t> numbers = {0, 1, -1, 15, -16, 17, 2147483647, -2147483647, -2147483647 - 1};
  Random random(3);
  for (int i = 0; i < 20000; ++i)
    numbers.push_back(static_cast<std::int32_t>(random.next()) >> random.below(32));
  RangeEncoder encoder;
  ResidualModel writing, reading;
  const auto activity = [&](std::size_t i) {
    return static_cast<std::uint32_t>(i * 2654435761u >> (i % 32));
  };
  const auto kind = [](std::size_t i) { return i % 7 ? ResidualModel::kOrdinary : ResidualModel::kDark; };
  for (std::size_t i = 0; i < numbers.size(); ++i)
    writing.code(encoder, activity(i), kind(i), i % 3, numbers[i]);
  const std::vector<std::uint8_t> bytes = encoder.finish();
  RangeDecoder decoder(bytes);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    ASSERT_EQ(reading.code(decoder, activity(i), kind(i), i % 3, 0), numbers[i]) << i;
  EXPECT_TRUE(decoder.ended());
}

}  // namespace
}  // namespace fiatlux
