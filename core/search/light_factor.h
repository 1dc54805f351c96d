// A covariance that is never made: C = L^T L, where L's rows are the patches' own, so that sigma = |L x| is
// read from the light of the patches. For thousands of candidates, whose m x m products would take longer to
// make than a search takes. A change of one candidate costs O(rows) instead of O(1).
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/scene.h"
#include "core/search/arrangements.h"
#include "core/search/kernels.h"

namespace fiatlux {

/// Of one surface set. What it calls a deviation is rows() numbers: the light of each row less the mean of
/// the set, 0 where all is dark.
class LightFactor {
 public:
  /// Each site is a candidate. `scene` must outlive it.
  LightFactor(const Scene& scene, Quantity quantity, const SurfaceSet& surfaces);
  /// Each tie is one, and after them comes one without light. `ties` must outlive it.
  LightFactor(const LightFactor& ofSites, const Ties& ties);

  std::uint32_t rows() const { return static_cast<std::uint32_t>(weight_.size()); }
  /// Mean of the set for each candidate at a flux of 1.
  const std::vector<double>& mean() const { return mean_; }
  /// Its variance for each candidate alone.
  const std::vector<double>& variance() const { return variance_; }

  /// Adds the light of `flux` on a candidate to a deviation.
  void add(std::uint32_t candidate, double flux, double* deviation) const;
  double varianceOf(const double* deviation) const;
  /// Variances of a deviation to which `flux` on each of `count` candidates is added. `scratch`: rows().
  void added(const double* deviation, double flux, const std::uint32_t* candidates, std::uint32_t count,
             double* scratch, double* out) const;

 private:
  /// The sites of a candidate.
  struct Sites {
    const std::uint32_t *first, *last;
    const std::uint32_t* begin() const { return first; }
    const std::uint32_t* end() const { return last; }
  };
  Sites sitesOf(std::uint32_t candidate) const {
    const std::uint32_t* first = sites_.data() + begin_[candidate];
    return {first, sites_.data() + begin_[candidate + 1]};
  }
  const float* column(std::uint32_t site) const { return responses_->column(site) + firstRow_; }
  void measure(std::size_t candidates);

  const Responses* responses_;
  std::uint32_t firstRow_ = 0;                // of the responses that is its row 0
  std::vector<double> weight_;                // of each row: its share of the set's area; 0: it is not of it
  std::vector<double> factor_;                // of each row: reflectance, of exitance; else 1
  std::vector<std::uint32_t> sites_, begin_;  // of candidate c: sites_[begin_[c]] up to begin_[c + 1]
  std::vector<double> mean_, variance_;
};

}  // namespace fiatlux
