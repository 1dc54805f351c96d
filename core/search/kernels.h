// The sums that the search spends its time in: how paper (8) and (10) (core/scene/layout_sums.h) change when
// luminaires move. Plain loops over plain arrays, float storage, double sums, one fixed order:
// the same bits natively and as Wasm. Each is small and never inlined, because V8 compiles a Wasm function
// well only from its second call on.
#pragma once

#include <cstdint>

#include "core/scene/layout_sums.h"

namespace fiatlux {

/// One entry of a sparse change of the site fluxes: `flux` lm are added at `site`.
struct FluxChange {
  std::uint32_t site = 0;
  double flux = 0;
};

/// Moves side by side: of each, how much goes from which candidate to which.
struct FluxMoves {
  const double* flux;  // lm
  const std::uint32_t *from, *to;
};

/// What a move adds to the worth that may not be made; whatever is added to it, more than any other does.
inline constexpr float kNoMove = 1e30f;

/// row = C x (m entries), from nothing.
FIATLUX_KERNEL void fillRow(const float* covariance, std::uint32_t m, const std::uint32_t* sites,
                            const double* flux, std::uint32_t count, double* row);

/// row += flux C[site, :].
FIATLUX_KERNEL void addToRow(const float* covariance, std::uint32_t m, std::uint32_t site, double flux,
                             double* row);

/// row += flux (C[to, :] - C[from, :]): one pass for a move.
FIATLUX_KERNEL void moveInRow(const float* covariance, std::uint32_t m, std::uint32_t from, std::uint32_t to,
                              double flux, double* row);

/// x^T (C x) from the cached row: N loads.
FIATLUX_KERNEL double varianceFromRow(const double* row, const std::uint32_t* sites, const double* flux,
                                      std::uint32_t count);

/// Means after moving `flux` lm from site `from` to each of `count` candidates: O(1) each.
FIATLUX_KERNEL void movedMeans(const double* mean, double current, std::uint32_t from, double flux,
                               const std::uint32_t* candidates, std::uint32_t count, double* out);

/// Means after each of `count` pairs of moves.
FIATLUX_KERNEL void pairedMeans(const double* mean, double current, const FluxMoves& moves,
                                const FluxMoves& others, std::uint32_t count, double* out);

/// Variances after moving `flux` lm from site `from` to each of `count` candidates: O(1) each by the cached
/// row C x. `diagonal` holds the m entries C[i, i].
FIATLUX_KERNEL void movedVariances(const float* covariance, const float* diagonal, std::uint32_t m,
                                   const double* row, double current, std::uint32_t from, double flux,
                                   const std::uint32_t* candidates, std::uint32_t count, double* out);

/// Variances after each of `count` pairs of moves: `flux` lm from `from` to `to`, and `otherFlux` lm from
/// `otherFrom` to `otherTo` at once.
FIATLUX_KERNEL void pairedVariances(const float* covariance, const float* diagonal, std::uint32_t m,
                                    const double* row, double current, const FluxMoves& moves,
                                    const FluxMoves& others, std::uint32_t count, double* out);

/// Variance after any sparse change d: x^T C x + 2 d^T (C x) + d^T C d.
FIATLUX_KERNEL double changedVariance(const float* covariance, std::uint32_t m, const double* row,
                                      double current, const FluxChange* changes, std::uint32_t count);

/// A factor of each entry of a row.
template <class Entry>
struct Scaled {
  const Entry* row;
  double factor;
};

/// line += means.
FIATLUX_KERNEL void addToLine(Scaled<double> means, std::uint32_t count, float* line);

/// line += means + sums + squares.
FIATLUX_KERNEL void addToLine(Scaled<double> means, Scaled<double> sums, Scaled<float> squares,
                              std::uint32_t count, float* line);

/// light += flux factor column, all of `rows` entries.
FIATLUX_KERNEL void addLight(const float* column, const double* factor, double flux, std::uint32_t rows,
                             double* light);

/// Sum of weight_i value_i^2.
FIATLUX_KERNEL double weightedSquares(const double* weight, const double* value, std::uint32_t rows);

/// Sum of column_i value_i.
FIATLUX_KERNEL double productOf(const float* column, const double* value, std::uint32_t rows);

}  // namespace fiatlux
