// One pass over the candidates, sixteen side by side; see move_rows.h.
#include "core/search/move_rows.h"

#include <algorithm>
#include <cassert>

#if defined(__AVX__)
#include <immintrin.h>
#endif

namespace fiatlux {
namespace {

// note: named, for compilers make single floats of loops over them.
using Floats = float __attribute__((vector_size(32)));
using UnalignedFloats = float __attribute__((vector_size(32), aligned(4), may_alias));
using Numbers8 = std::int32_t __attribute__((vector_size(32)));

/// As many candidates side by side as keep the machine busy.
struct Lanes {
  Floats low, high;
};

Lanes operator+(const Lanes& a, const Lanes& b) { return {a.low + b.low, a.high + b.high}; }
Lanes operator+(const Lanes& a, float b) { return {a.low + b, a.high + b}; }
Lanes operator*(float a, const Lanes& b) { return {a * b.low, a * b.high}; }

Floats above0(const Floats& a) {
#if defined(__AVX__)
  return _mm256_max_ps(a, Floats{});
#else
  return a > 0 ? a : Floats{};
#endif
}
Floats lesser(const Floats& a, const Floats& b) {
#if defined(__AVX__)
  return _mm256_min_ps(a, b);
#else
  return a < b ? a : b;
#endif
}
Lanes above0(const Lanes& a) { return {above0(a.low), above0(a.high)}; }
float above0(float a) { return a > 0 ? a : 0; }
Lanes lesser(const Lanes& a, const Lanes& b) { return {lesser(a.low, b.low), lesser(a.high, b.high)}; }

template <class Value>
Value at(const float* row);
template <>
inline float at<float>(const float* row) {
  return *row;
}
template <>
inline Lanes at<Lanes>(const float* row) {
  const auto* parts = reinterpret_cast<const UnalignedFloats*>(row);
  return {parts[0], parts[1]};
}

/// What a move to candidate `to`, or to those from there on, adds for one luminaire.
template <class Value>
Value worthOf(const MoveRows& rows, std::uint32_t from, std::size_t to, const float* leaving) {
  const std::size_t place = std::size_t{from} * rows.candidates + to;
  Value worth = at<Value>(rows.coming + to) + *leaving;
  for (const auto& [covariance, factor] : rows.products)
    worth = worth + factor * at<Value>(covariance + place);
  for (const auto& [coming, product] : rows.edges) {
    Value beyond = at<Value>(coming + to) + *++leaving;
    if (product.covariance) beyond = beyond + product.factor * at<Value>(product.covariance + place);
    worth = worth + above0(beyond);
  }
  return worth;
}

/// The least worths so far, side by side, and the candidates that those beside each other began at.
struct Least {
  Floats worth = Floats{} + kNoMove;
  Numbers8 first = {};

  void offer(const Floats& other, std::size_t candidate) {
    first = other < worth ? Numbers8{} + static_cast<std::int32_t>(candidate) : first;
    worth = lesser(other, worth);
  }

  void choose(RowMove& best) const {
    for (std::uint32_t lane = 0; lane < kMoveLanes / 2; ++lane) {
      const auto candidate = static_cast<std::uint32_t>(first[lane]) + lane;
      if (worth[lane] < best.worth || (worth[lane] == best.worth && candidate < best.candidate))
        best = {0, candidate, worth[lane]};
    }
  }
};

}  // namespace

RowMove leastMove(const MoveRows& rows, std::span<const std::uint32_t> from, const float* leaving) {
  assert(rows.candidates >= kMoveLanes);
  const std::size_t stride = 1 + rows.edges.size();
  Least low, high;
  for (std::size_t next = 0; next < rows.candidates; next += kMoveLanes) {
    const std::size_t to = std::min<std::size_t>(next, rows.candidates - kMoveLanes);  // some of them again
    Lanes least{Floats{} + kNoMove, Floats{} + kNoMove};
    for (std::size_t i = 0; i < from.size(); ++i)
      least = lesser(worthOf<Lanes>(rows, from[i], to, leaving + i * stride), least);
    low.offer(least.low, to);
    high.offer(least.high, to + kMoveLanes / 2);
  }
  RowMove best;
  for (const Least& part : {low, high}) part.choose(best);
  if (!(best.worth < kNoMove)) return best;
  const auto isOf = [&](std::uint32_t i) {
    return worthOf<float>(rows, from[i], best.candidate, leaving + i * stride) == best.worth;
  };
  while (best.luminaire + 1 < from.size() && !isOf(best.luminaire)) ++best.luminaire;
  return best;
}

}  // namespace fiatlux
