#include "precompute/rays/ray_sequence.h"

#include <cassert>

namespace fiatlux {

namespace {

/// Of a number, or of eight.
template <class Bits>
Bits reverseBits(Bits x) {
  x = (x << 16) | (x >> 16);
  x = ((x & 0x00ff00ffu) << 8) | ((x >> 8) & 0x00ff00ffu);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
  x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
  return ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
}

/// Every bit is flipped depending on the bits below it: on reversed bits, Owen's nested scrambling.
template <class Bits>
Bits scrambleReversed(Bits x, std::uint32_t seed) {
  x += seed;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  x ^= x * 0x8d22f6e6u;
  return x;
}

/// Eight numbers in [0, 1).
Float8 inUnit(Bits8 reversed, std::uint32_t seed) {
  return __builtin_convertvector(reverseBits(scrambleReversed(reversed, seed)) >> 8, Float8) * 0x1p-24f;
}

using Directions = std::array<std::uint32_t, 32>;

/// Direction numbers from a primitive polynomial of degree s with inner coefficients a and initial m_1..m_s.
Directions directions(std::uint32_t s, std::uint32_t a, std::array<std::uint32_t, 3> m) {
  Directions v{};
  for (std::uint32_t i = 0; i < 32; ++i) {
    if (s == 0) {
      v[i] = 1u << (31 - i);
    } else if (i < s) {
      v[i] = m[i] << (31 - i);
    } else {
      v[i] = v[i - s] ^ (v[i - s] >> s);
      for (std::uint32_t j = 1; j < s; ++j) v[i] ^= ((a >> (s - 1 - j)) & 1u) * v[i - j];
    }
  }
  return v;
}

}  // namespace

std::uint64_t mixBits(std::uint64_t bits) {
  bits += 0x9e3779b97f4a7c15ull;
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9ull;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebull;
  return bits ^ (bits >> 31);
}

RaySequence::RaySequence(std::uint32_t count) : count_(count), reversed_((count + 7) / 8) {
  const std::array<Directions, 4> v = {directions(0, 0, {}), directions(1, 0, {1}), directions(2, 1, {1, 3}),
                                       directions(3, 1, {1, 3, 1})};
  for (std::uint32_t i = 0; i < count; ++i) {
    for (std::uint32_t d = 0; d < 4; ++d) {
      std::uint32_t x = 0;
      for (std::uint32_t bit = 0; bit < 32; ++bit) x ^= ((i >> bit) & 1u) * v[d][bit];
      reversed_[i / 8].of[d][i % 8] = reverseBits(x);
    }
  }
}

std::array<std::uint32_t, 4> RaySequence::scramble(std::uint64_t seed) {
  const std::uint64_t a = mixBits(seed), b = mixBits(a);
  return {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(a >> 32), static_cast<std::uint32_t>(b),
          static_cast<std::uint32_t>(b >> 32)};
}

std::array<double, 4> RaySequence::point(std::uint32_t i, const std::array<std::uint32_t, 4>& seed) const {
  assert(i < count());
  std::array<double, 4> result;
  for (std::uint32_t d = 0; d < 4; ++d) {
    result[d] = reverseBits(scrambleReversed(reversed_[i / 8].of[d][i % 8], seed[d])) * 0x1p-32;
  }
  return result;
}

std::array<Float8, 4> RaySequence::eightPoints(std::uint32_t i,
                                               const std::array<std::uint32_t, 4>& seed) const {
  assert(i % 8 == 0 && i < count());
  std::array<Float8, 4> result;
  for (std::uint32_t d = 0; d < 4; ++d) result[d] = inUnit(loadBits8(reversed_[i / 8].of[d]), seed[d]);
  return result;
}

std::array<Float8, 2> RaySequence::eightPairs(const std::uint32_t (&of)[8],
                                              const std::array<std::uint32_t, 4>& seed) const {
  std::array<Float8, 2> result;
  for (std::uint32_t d = 0; d < 2; ++d) {
    alignas(32) std::uint32_t reversed[8];
    for (int lane = 0; lane < 8; ++lane) reversed[lane] = reversed_[of[lane] / 8].of[d][of[lane] % 8];
    result[d] = inUnit(loadBits8(reversed), seed[d]);
  }
  return result;
}

}  // namespace fiatlux
