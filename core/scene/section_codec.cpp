// Differences and byte planes: neighbours in a table of numbers differ little, and in few of their bytes.
#include "core/scene/section_codec.h"

#include <cstring>

namespace fiatlux {
namespace {

std::uint32_t zigzag(std::uint32_t v) { return (v << 1) ^ (0u - (v >> 31)); }
std::uint32_t unzigzag(std::uint32_t v) { return (v >> 1) ^ (0u - (v & 1)); }

void putPlanes(std::uint8_t* bytes, std::size_t count, std::size_t i, std::uint32_t value) {
  for (int plane = 0; plane < 4; ++plane)
    bytes[plane * count + i] = static_cast<std::uint8_t>(value >> (8 * plane));
}

std::uint32_t getPlanes(const std::uint8_t* bytes, std::size_t count, std::size_t i) {
  return std::uint32_t{bytes[i]} | std::uint32_t{bytes[count + i]} << 8 |
         std::uint32_t{bytes[2 * count + i]} << 16 | std::uint32_t{bytes[3 * count + i]} << 24;
}

}  // namespace

std::vector<std::uint8_t> encodeDeltaPlanes(std::span<const std::uint32_t> values, std::uint32_t columns) {
  std::vector<std::uint8_t> bytes(values.size() * 4);
  std::size_t out = 0;
  for (std::uint32_t c = 0; c < columns; ++c) {
    std::uint32_t last = 0;
    for (std::size_t i = c; i < values.size(); i += columns) {
      putPlanes(bytes.data(), values.size(), out++, zigzag(values[i] - last));
      last = values[i];
    }
  }
  return bytes;
}

std::vector<std::uint32_t> decodeDeltaPlanes(std::span<const std::uint8_t> bytes, std::uint32_t columns) {
  std::vector<std::uint32_t> values(bytes.size() / 4);
  std::size_t in = 0;
  for (std::uint32_t c = 0; c < columns; ++c) {
    std::uint32_t last = 0;
    for (std::size_t i = c; i < values.size(); i += columns)
      values[i] = last += unzigzag(getPlanes(bytes.data(), values.size(), in++));
  }
  return values;
}

std::vector<std::uint8_t> encodePlanes(std::span<const std::uint32_t> values) {
  std::vector<std::uint8_t> bytes(values.size() * 4);
  for (std::size_t i = 0; i < values.size(); ++i)
    putPlanes(bytes.data(), values.size(), i, zigzag(values[i]));
  return bytes;
}

std::vector<std::uint32_t> decodePlanes(std::span<const std::uint8_t> bytes) {
  std::vector<std::uint32_t> values(bytes.size() / 4);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = unzigzag(getPlanes(bytes.data(), values.size(), i));
  return values;
}

std::vector<std::uint8_t> encodeFloatPlanes(std::span<const float> values) {
  std::vector<std::uint8_t> bytes(values.size() * 4);
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::uint32_t bits;
    std::memcpy(&bits, &values[i], 4);
    putPlanes(bytes.data(), values.size(), i, bits);
  }
  return bytes;
}

std::vector<float> decodeFloatPlanes(std::span<const std::uint8_t> bytes) {
  std::vector<float> values(bytes.size() / 4);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::uint32_t bits = getPlanes(bytes.data(), values.size(), i);
    std::memcpy(&values[i], &bits, 4);
  }
  return values;
}

}  // namespace fiatlux
