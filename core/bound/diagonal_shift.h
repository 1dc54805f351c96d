// The diagonal d that may be moved out of a covariance, z_i^2 = z_i, without losing convexity: C - diag(d)
// stays positive semidefinite, proved by Cholesky. The larger d where the relaxed layout is split, the
// tighter the bound.
#pragma once

#include <cstdint>
#include <vector>

namespace fiatlux {

/// What must be added to the diagonal of a covariance (m x m, row-major) to make it surely positive
/// semidefinite: stored ones are so only up to their rounding. The least of a few sizes that Cholesky
/// approves.
double convexRidge(const std::vector<double>& covariance, std::uint32_t m);

/// Maximises sum w_j d_j + barrier log det(C - diag d) by Newton steps, the barrier shrinking; every accepted
/// d has passed Cholesky with room to spare.
class DiagonalShift {
 public:
  /// `matrix` m x m, row-major, symmetric, positive semidefinite up to rounding. ok() is false when it is
  /// not.
  DiagonalShift(std::uint32_t m, std::vector<double> matrix);
  bool ok() const { return ok_; }

  /// One Newton step, O(m^3), for weights w >= 0; false when there is nothing left to gain.
  bool step(const std::vector<double>& weights);

  const std::vector<double>& diagonal() const { return diagonal_; }
  /// C - diag(d).
  std::vector<double> shifted() const;

 private:
  bool positive(const std::vector<double>& diagonal) const;

  std::uint32_t m_;
  std::vector<double> matrix_, diagonal_;
  double scale_ = 0, barrier_ = 0;
  double floor_ = 0;  // d stays above: a larger negative entry would only loosen the bound
  bool ok_ = false;
};

}  // namespace fiatlux
