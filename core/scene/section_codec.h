// Reversible rearrangements of numbers that help deflate: differences and byte planes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace fiatlux {

/// 32-bit integers, rows x columns, row-major -> their differences down each column (modulo 2^32), zigzag,
/// column after column, as four byte planes (lowest first). Same number of bytes.
std::vector<std::uint8_t> encodeDeltaPlanes(std::span<const std::uint32_t> values, std::uint32_t columns);
/// The inverse; bytes.size() is a multiple of 4 x columns.
std::vector<std::uint32_t> decodeDeltaPlanes(std::span<const std::uint8_t> bytes, std::uint32_t columns);

/// 32-bit integers, small ones of either sign preferred -> zigzag, four byte planes, lowest first.
std::vector<std::uint8_t> encodePlanes(std::span<const std::uint32_t> values);
/// The inverse; bytes.size() is a multiple of 4.
std::vector<std::uint32_t> decodePlanes(std::span<const std::uint8_t> bytes);

/// Floats -> four byte planes, lowest first.
std::vector<std::uint8_t> encodeFloatPlanes(std::span<const float> values);
/// The inverse; bytes.size() is a multiple of 4.
std::vector<float> decodeFloatPlanes(std::span<const std::uint8_t> bytes);

}  // namespace fiatlux
