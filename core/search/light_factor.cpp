// The light of patches as a factor of its covariance; see light_factor.h.
#include "core/search/light_factor.h"

#include <numeric>

namespace fiatlux {

LightFactor::LightFactor(const Scene& scene, Quantity quantity, const SurfaceSet& surfaces)
    : responses_(&responsesOf(scene, quantity)) {
  const std::vector<std::uint32_t> rows = rowsOf(scene, surfaces);
  const Patches& patches = scene.patches;
  firstRow_ = rows.front();
  weight_.assign(rows.back() + 1 - firstRow_, 0.0);
  factor_.assign(weight_.size(), 1.0);
  double area = 0;
  for (const std::uint32_t p : rows) area += patches.area[p];
  for (const std::uint32_t p : rows) {
    weight_[p - firstRow_] += patches.area[p] / area;
    if (quantity == Quantity::kExitance) factor_[p - firstRow_] = patches.reflectance[p];
  }
  sites_.resize(responses_->sites);
  std::iota(sites_.begin(), sites_.end(), 0u);
  begin_.resize(sites_.size() + 1);
  std::iota(begin_.begin(), begin_.end(), 0u);
  measure(sites_.size());
}

LightFactor::LightFactor(const LightFactor& ofSites, const Ties& ties)
    : responses_(ofSites.responses_),
      firstRow_(ofSites.firstRow_),
      weight_(ofSites.weight_),
      factor_(ofSites.factor_),
      begin_{0} {
  for (const std::vector<std::uint32_t>& members : ties.members) {
    sites_.insert(sites_.end(), members.begin(), members.end());
    begin_.push_back(static_cast<std::uint32_t>(sites_.size()));
  }
  begin_.push_back(begin_.back());
  measure(begin_.size() - 1);
}

void LightFactor::measure(std::size_t candidates) {
  mean_.assign(candidates, 0.0);
  std::vector<double> deviation(weight_.size());
  for (std::uint32_t c = 0; c < candidates; ++c) {
    for (const std::uint32_t site : sitesOf(c)) {
      const float* light = column(site);
      for (std::size_t i = 0; i < weight_.size(); ++i) mean_[c] += weight_[i] * factor_[i] * light[i];
    }
    std::fill(deviation.begin(), deviation.end(), 0.0);
    add(c, 1, deviation.data());
    variance_.push_back(varianceOf(deviation.data()));
  }
}

void LightFactor::add(std::uint32_t candidate, double flux, double* deviation) const {
  const double mean = flux * mean_[candidate];
  for (std::size_t i = 0; i < weight_.size(); ++i) deviation[i] -= mean;
  for (const std::uint32_t site : sitesOf(candidate))
    addLight(column(site), factor_.data(), flux, rows(), deviation);
}

double LightFactor::varianceOf(const double* deviation) const {
  return weightedSquares(weight_.data(), deviation, rows());
}

void LightFactor::added(const double* deviation, double flux, const std::uint32_t* candidates,
                        std::uint32_t count, double* scratch, double* out) const {
  // Means of deviations are 0, so that of a candidate's does not count.
  for (std::size_t i = 0; i < weight_.size(); ++i) scratch[i] = weight_[i] * factor_[i] * deviation[i];
  const double rest = varianceOf(deviation);
  for (std::uint32_t k = 0; k < count; ++k) {
    double crossed = 0;
    for (const std::uint32_t site : sitesOf(candidates[k]))
      crossed += productOf(column(site), scratch, rows());
    out[k] = rest + flux * (2 * crossed + flux * variance_[candidates[k]]);
  }
}

}  // namespace fiatlux
