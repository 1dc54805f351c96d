// Layouts as matrices X_ij = z_i z_j, "i and j both hold a luminaire": positive semidefinite, never negative,
// zero where two may not be there at once, and every linear form l(z) = a z - b that is known of layouts told
// of its products with each z_i too. In X a variance is linear, convex or not. Solved by alternating
// directions (Sun, Toh and Yang 2015); what counts are certificates, multipliers that Newton steps move until
// Cholesky approves of what they leave over.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace fiatlux {

/// What is known of (a z - b) z_i, for each i: its multiplier p_i may be from `least` to `most`. Both
/// infinite: it is 0. From 0: it is never negative. Finite: it costs least or most a unit, below and above 0.
/// b is fixed + inverse / t, t the common dimming.
struct PairForm {
  std::vector<double> a;  // m
  double fixed = 0, inverse = 0, least = 0, most = 0;
};

/// Sites of which layouts hold at least and at most so many.
struct PairKind {
  std::vector<std::uint32_t> sites;
  double least = 0, most = 0;
};

/// Layouts of `count` of m sites.
struct PairProblem {
  std::uint32_t sites = 0;  // m
  double count = 0;
  std::vector<PairKind> kinds;  // each site is of one
  std::vector<PairForm> forms;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> apart;  // sites that are never both used, i < j
};

class PairRelaxation {
 public:
  explicit PairRelaxation(const PairProblem& problem);
  ~PairRelaxation();

  /// Least <Q, X> from now on, Q m x m, row-major, symmetric, of any signature, of layouts of one dimming, of
  /// which 1 / t is told; what is known of X stays.
  void setCost(const std::vector<double>& cost, double inverse);

  /// One step of alternating directions, O(m^3).
  void step();

  /// One Newton step towards a certificate for the multipliers so far, O(m^3 + (forms x m)^3); false when it
  /// is as good as it gets. The next step() ends it.
  bool certify();

  /// No layout costs less; -infinity until it has been certified.
  double bound() const;

  /// The certificate's multipliers, times this, still are within their limits; infinite where none has any.
  double slack() const;

  /// Where 1 / t is larger by e, layouts cost no less than the bound + e drift z.
  std::vector<double> drift() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace fiatlux
