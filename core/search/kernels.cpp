// Changes of paper (8) and (10); see kernels.h.
#include "core/search/kernels.h"

#include <cmath>
#include <cstddef>

namespace fiatlux {
void fillRow(const float* covariance, std::uint32_t m, const std::uint32_t* sites, const double* flux,
             std::uint32_t count, double* row) {
  for (std::uint32_t b = 0; b < m; ++b) row[b] = 0;
  for (std::uint32_t i = 0; i < count; ++i) addToRow(covariance, m, sites[i], flux[i], row);
}

void addToRow(const float* covariance, std::uint32_t m, std::uint32_t site, double flux, double* row) {
  const float* source = covariance + std::size_t{site} * m;
  for (std::uint32_t b = 0; b < m; ++b) row[b] += flux * source[b];
}

void moveInRow(const float* covariance, std::uint32_t m, std::uint32_t from, std::uint32_t to, double flux,
               double* row) {
  const float *source = covariance + std::size_t{from} * m, *target = covariance + std::size_t{to} * m;
  for (std::uint32_t j = 0; j < m; ++j)
    row[j] += flux * (static_cast<double>(target[j]) - static_cast<double>(source[j]));
}

double varianceFromRow(const double* row, const std::uint32_t* sites, const double* flux,
                       std::uint32_t count) {
  double sum = 0;
  for (std::uint32_t i = 0; i < count; ++i) sum += flux[i] * row[sites[i]];
  return sum;
}

void movedMeans(const double* mean, double current, std::uint32_t from, double flux,
                const std::uint32_t* candidates, std::uint32_t count, double* out) {
  const double rest = current - flux * mean[from];
  for (std::uint32_t k = 0; k < count; ++k) out[k] = rest + flux * mean[candidates[k]];
}

void movedVariances(const float* covariance, const float* diagonal, std::uint32_t m, const double* row,
                    double current, std::uint32_t from, double flux, const std::uint32_t* candidates,
                    std::uint32_t count, double* out) {
  const float* source = covariance + std::size_t{from} * m;
  const double rest = current - 2 * flux * row[from] + flux * flux * diagonal[from];
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t b = candidates[k];
    out[k] = rest + flux * (2 * row[b] + flux * (diagonal[b] - 2.0 * source[b]));
  }
}

void pairedMeans(const double* mean, double current, const FluxMoves& moves, const FluxMoves& others,
                 std::uint32_t count, double* out) {
  for (std::uint32_t k = 0; k < count; ++k)
    out[k] = current + moves.flux[k] * (mean[moves.to[k]] - mean[moves.from[k]]) +
             others.flux[k] * (mean[others.to[k]] - mean[others.from[k]]);
}

void pairedVariances(const float* covariance, const float* diagonal, std::uint32_t m, const double* row,
                     double current, const FluxMoves& moves, const FluxMoves& others, std::uint32_t count,
                     double* out) {
  for (std::uint32_t k = 0; k < count; ++k) {
    const std::uint32_t a = moves.from[k], b = moves.to[k], c = others.from[k], d = others.to[k];
    const double flux = moves.flux[k], otherFlux = others.flux[k];
    const float *left = covariance + std::size_t{a} * m, *taken = covariance + std::size_t{b} * m;
    const double leftToTaken = left[b], otherLeftToTaken = covariance[std::size_t{c} * m + d];
    const double own = 2 * (row[b] - row[a]) + flux * (diagonal[a] - 2 * leftToTaken + diagonal[b]);
    const double other =
        2 * (row[d] - row[c]) + otherFlux * (diagonal[c] - 2 * otherLeftToTaken + diagonal[d]);
    const double both = (static_cast<double>(taken[d]) - taken[c]) - (static_cast<double>(left[d]) - left[c]);
    out[k] = current + flux * own + otherFlux * other + 2 * flux * otherFlux * both;
  }
}

double changedVariance(const float* covariance, std::uint32_t m, const double* row, double current,
                       const FluxChange* changes, std::uint32_t count) {
  double sum = current;
  for (std::uint32_t k = 0; k < count; ++k) {
    const FluxChange& change = changes[k];
    const float* source = covariance + std::size_t{change.site} * m;
    double crossed = 0;
    for (std::uint32_t l = k + 1; l < count; ++l) crossed += changes[l].flux * source[changes[l].site];
    sum += change.flux * (2 * row[change.site] + change.flux * source[change.site] + 2 * crossed);
  }
  return sum;
}

void addToLine(Scaled<double> means, std::uint32_t count, float* __restrict line) {
  for (std::uint32_t c = 0; c < count; ++c) line[c] += static_cast<float>(means.factor * means.row[c]);
}

void addToLine(Scaled<double> means, Scaled<double> sums, Scaled<float> squares, std::uint32_t count,
               float* __restrict line) {
  for (std::uint32_t c = 0; c < count; ++c)
    line[c] += static_cast<float>(means.factor * means.row[c] + sums.factor * sums.row[c] +
                                  squares.factor * squares.row[c]);
}

void addLight(const float* column, const double* factor, double flux, std::uint32_t rows, double* light) {
  for (std::uint32_t i = 0; i < rows; ++i) light[i] += flux * factor[i] * column[i];
}

namespace {

constexpr std::uint32_t kLanes = 8;  // sums side by side, in an order that no compiler may choose

double sumOf(const double (&lanes)[kLanes]) {
  return ((lanes[0] + lanes[1]) + (lanes[2] + lanes[3])) + ((lanes[4] + lanes[5]) + (lanes[6] + lanes[7]));
}

}  // namespace

double weightedSquares(const double* weight, const double* value, std::uint32_t rows) {
  double lanes[kLanes] = {};
  const std::uint32_t even = rows / kLanes * kLanes;
  for (std::uint32_t i = 0; i < even; i += kLanes)
    for (std::uint32_t x = 0; x < kLanes; ++x) lanes[x] += weight[i + x] * value[i + x] * value[i + x];
  for (std::uint32_t i = even; i < rows; ++i) lanes[i - even] += weight[i] * value[i] * value[i];
  return sumOf(lanes);
}

double productOf(const float* column, const double* value, std::uint32_t rows) {
  double lanes[kLanes] = {};
  const std::uint32_t even = rows / kLanes * kLanes;
  for (std::uint32_t i = 0; i < even; i += kLanes)
    for (std::uint32_t x = 0; x < kLanes; ++x) lanes[x] += value[i + x] * column[i + x];
  for (std::uint32_t i = even; i < rows; ++i) lanes[i - even] += value[i] * column[i];
  return sumOf(lanes);
}

}  // namespace fiatlux
