// The best of all moves of some luminaires, in one pass over the candidates. What a move adds to a worth is
// what going to its candidate adds, what leaving the other adds, and the product of the two in covariances;
// on top of that what lies beyond edges, which are sums of the same kind. In floats: + - * and comparisons
// only, each lane as a float is, so the same bits natively and as Wasm.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/search/kernels.h"

namespace fiatlux {

/// So many candidates are looked at side by side: there must be as many.
inline constexpr std::uint32_t kMoveLanes = 16;

/// factor x covariance (candidates x candidates); none where there is no covariance.
struct MoveProduct {
  const float* covariance = nullptr;
  float factor = 0;
};

/// What counts of it is above 0.
struct MoveEdge {
  const float* coming;  // to each candidate
  MoveProduct product;
};

struct MoveRows {
  std::uint32_t candidates;  // kMoveLanes at least
  const float* coming;       // what going to each candidate adds
  std::span<const MoveProduct> products;
  std::span<const MoveEdge> edges;
};

/// One of the luminaires by its number among those looked at.
struct RowMove {
  std::uint32_t luminaire = 0, candidate = 0;
  float worth = kNoMove;
};

/// The move that adds least, of luminaires on the candidates `from`. `leaving`: of each luminaire what
/// leaving adds, then the same of each edge. Of equals the first candidate, then the first luminaire.
FIATLUX_KERNEL RowMove leastMove(const MoveRows& rows, std::span<const std::uint32_t> from,
                                 const float* leaving);

}  // namespace fiatlux
