// The problem with its one hard wish let go: luminaires may be split over sites (z in [0, 1], sum z = N, or
// that much flux; of ties sum w z = N or in a range, w a tie's number of luminaires), everything else convex.
// Frank-Wolfe (1956) steps and exchanges between two sites; what counts is not the value but the value less
// the duality gap, which no real layout can beat however early one stops.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/bound/exclusive_groups.h"
#include "core/search/intentions.h"

namespace fiatlux {

/// weight x^T M x, or weight sqrt(x^T M x) where `root`; M is m x m, row-major, symmetric, positive
/// semidefinite. weight >= 0.
struct ConvexTerm {
  std::shared_ptr<const std::vector<double>> matrix;
  double weight = 0;
  bool root = false;
};

/// constant + linear x + perDimming t + sum of terms, for fluxes x (lm a site, dimmed) and the dimming t.
struct ConvexObjective {
  double constant = 0, perDimming = 0;
  std::vector<double> linear;  // m
  std::vector<ConvexTerm> terms;
};

/// Minimises over the convex hull of all (x, t) that layouts under the rules give; of the minimum distance
/// and of ways to hang at one place only the groups are kept, and those only of luminaires of one flux.
class ConvexRelaxation {
 public:
  ConvexRelaxation(ExclusiveGroups groups, const LuminaireRules& rules);
  /// Over ties with so many luminaires each; the rules' sites are ties.
  ConvexRelaxation(std::vector<double> weights, const LuminaireRules& rules);

  /// A new objective with the matrices of the old one or others; keeps the point, forgets the bound.
  void setObjective(ConvexObjective objective);

  /// Among layouts of this dimming alone from now on; of the objective the bound is forgotten.
  void setDimming(double dimming);

  /// One Frank-Wolfe step with exact line search, and exchanges; false when the gap has closed.
  bool step();

  /// No layout under the rules has a smaller objective.
  double bound() const { return bound_; }
  double value() const { return value_; }
  const std::vector<double>& x() const { return x_; }
  double t() const { return t_; }

 private:
  struct Corner {
    std::vector<std::pair<std::uint32_t, double>> x;  // site, lm
    double t = 1;
  };
  /// `amount` lm may go from a site to another.
  struct Exchange {
    std::uint32_t from = 0, to = 0;
    double amount = 0, gain = 0;  // gain: at first, per lm
  };
  std::vector<double> gradient() const;
  bool exchange();
  void move(const Exchange& exchange);
  Corner bestCorner(const std::vector<double>& gradient, double perDimming) const;
  void takeSites(const std::vector<double>& gradient, Corner& corner) const;
  void takeTypes(const std::vector<std::uint32_t>& order, Corner& corner) const;
  void takeTies(const std::vector<double>& gradient, Corner& corner) const;
  double lineSearch(const std::vector<double>& productWithCorner, const std::vector<double>& squares,
                    double slope) const;
  void refreshProducts();

  std::uint32_t sites_;
  ExclusiveGroups groups_;
  std::vector<double> fluxes_;  // movable ones, largest first
  std::vector<std::pair<std::uint32_t, double>> pinned_;
  std::vector<char> usable_;
  std::vector<double> weights_;  // of ties; empty for sites
  double least_ = 0, most_ = 0;  // luminaires of the ties beside the pinned ones
  double low_, high_;
  ConvexObjective objective_;
  std::vector<double> x_;
  double t_ = 1, value_ = 0, bound_ = 0;
  std::vector<std::vector<double>> products_;  // M x of each term
  std::vector<double> quadratics_;             // x^T M x of each term
};

}  // namespace fiatlux
