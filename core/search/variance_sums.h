// What is kept of a layout x on one surface set, so that the variance of a changed layout costs little: C x
// where the set has its covariance, the light L x where it has a factor of it (light_factor.h).
#pragma once

#include <cstdint>
#include <vector>

#include "core/search/kernels.h"
#include "core/search/prepared_scene.h"

namespace fiatlux {

class VarianceSums {
 public:
  /// The statistics must outlive it.
  explicit VarianceSums(const KernelStatistics& statistics);

  /// The sums of a layout, from nothing.
  void load(const std::uint32_t* sites, const double* flux, std::uint32_t count);
  /// `flux` lm go from one candidate to another.
  void move(std::uint32_t from, std::uint32_t to, double flux);
  /// Of the layout that the sums are of.
  double variance(const std::uint32_t* sites, const double* flux, std::uint32_t count) const;
  /// After moving `flux` lm from candidate `from` to each of `count`; `current` is variance().
  void moved(double current, std::uint32_t from, double flux, const std::uint32_t* candidates,
             std::uint32_t count, double* out);
  /// After each of `count` pairs of moves. Precondition: of a covariance, not of a factor.
  void movedPairs(double current, const FluxMoves& moves, const FluxMoves& others, std::uint32_t count,
                  double* out) const;
  /// C x, an entry a candidate. Precondition: of a covariance, not of a factor.
  const std::vector<double>& row() const { return sums_; }
  /// After any change.
  double changed(double current, const FluxChange* changes, std::uint32_t count);

 private:
  const KernelStatistics& statistics_;
  std::vector<double> sums_;
  std::vector<double> trial_, scratch_;  // of a factor
};

/// Variances of one layout after another, each of which has much of the one before: where there is a factor,
/// only what differs is added to its light.
class VarianceInTurn {
 public:
  explicit VarianceInTurn(const KernelStatistics& statistics) : statistics_(statistics) {}

  double of(const std::uint32_t* sites, const double* flux, std::uint32_t count);

 private:
  const KernelStatistics& statistics_;
  std::vector<double> flux_, deviation_;      // of a factor: of each candidate; what they light
  std::vector<std::uint32_t> lit_, touched_;  // candidates of the latest layout, each once; scratch
  std::uint32_t turns_ = 0;                   // since the light was summed from nothing
};

}  // namespace fiatlux
