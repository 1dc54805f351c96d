// Paper (8) and (10) on sparse x; see kernels.h.
#include "core/search/kernels.h"

#include <cstddef>

namespace fiatlux {

double meanOf(const double* mean, const std::uint32_t* sites, const double* flux, std::uint32_t count) {
  double sum = 0;
  for (std::uint32_t i = 0; i < count; ++i) sum += flux[i] * mean[sites[i]];
  return sum;
}

// Two rows of the upper triangle at a time, so that each site and flux is loaded half as often: a third less
// as Wasm.
double varianceOf(const float* covariance, std::uint32_t m, const std::uint32_t* sites, const double* flux,
                  std::uint32_t count) {
  double half = 0;
  std::uint32_t i = 0;
  for (; i + 1 < count; i += 2) {
    const std::uint32_t a = sites[i], b = sites[i + 1];
    const float *rowA = covariance + std::size_t{a} * m, *rowB = covariance + std::size_t{b} * m;
    double crossedA = 0.5 * flux[i] * rowA[a] + flux[i + 1] * rowA[b], crossedB = 0.5 * flux[i + 1] * rowB[b];
    for (std::uint32_t j = i + 2; j < count; ++j) {
      const std::uint32_t site = sites[j];
      crossedA += flux[j] * rowA[site];
      crossedB += flux[j] * rowB[site];
    }
    half += flux[i] * crossedA;
    half += flux[i + 1] * crossedB;
  }
  if (i < count) half += 0.5 * flux[i] * flux[i] * covariance[std::size_t{sites[i]} * m + sites[i]];
  return 2 * half;
}

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
