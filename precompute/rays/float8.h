// Eight floats at once: AVX natively, two registers of Wasm's SIMD; elsewhere what the compiler makes of it.
// Each lane is computed as a float is, so results are the same on every machine.
#pragma once

#include <cstdint>
#include <cstring>

#if defined(__AVX__)
#include <immintrin.h>
#elif defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

namespace fiatlux {

using Float8 = float __attribute__((vector_size(32)));
using Mask8 = std::int32_t __attribute__((vector_size(32)));  // -1 where true, as comparisons give it

using Bits8 = std::uint32_t __attribute__((vector_size(32)));

/// `from`: eight floats, aligned to 32 bytes.
inline Float8 load8(const float* from) { return *reinterpret_cast<const Float8*>(from); }

/// The same, aligned as floats are.
inline Float8 unaligned8(const float* from) {
  Float8 eight;
  std::memcpy(&eight, from, sizeof eight);
  return eight;
}

inline Bits8 loadBits8(const std::uint32_t* from) { return *reinterpret_cast<const Bits8*>(from); }

inline Float8 all8(float value) { return Float8{} + value; }

/// Of a NaN and a number: b, as `a < b ? a : b` says.
inline Float8 min8(Float8 a, Float8 b) {
#if defined(__AVX__)
  return _mm256_min_ps(a, b);
#else
  return a < b ? a : b;
#endif
}

inline Float8 max8(Float8 a, Float8 b) {
#if defined(__AVX__)
  return _mm256_max_ps(a, b);
#else
  return a > b ? a : b;
#endif
}

inline float laneSum(Float8 a) { return ((a[0] + a[1]) + (a[2] + a[3])) + ((a[4] + a[5]) + (a[6] + a[7])); }

/// Bit i: lane i is true.
inline unsigned bitsOf(Mask8 mask) {
#if defined(__AVX__)
  return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<Float8>(mask)));
#elif defined(__wasm_simd128__)
  v128_t half[2];
  std::memcpy(half, &mask, sizeof mask);
  return wasm_i32x4_bitmask(half[0]) | wasm_i32x4_bitmask(half[1]) << 4;
#else
  unsigned bits = 0;
  for (int i = 0; i < 8; ++i) bits |= mask[i] ? 1u << i : 0u;
  return bits;
#endif
}

}  // namespace fiatlux
