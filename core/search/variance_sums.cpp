// Sums of a covariance or of its factor; see variance_sums.h.
#include "core/search/variance_sums.h"

#include <algorithm>
#include <cassert>

namespace fiatlux {
namespace {

constexpr std::uint32_t kTurns = 256;  // until rounding is swept away

std::uint32_t strideOf(const KernelStatistics& statistics) {
  return static_cast<std::uint32_t>(statistics.mean.size());
}

}  // namespace

VarianceSums::VarianceSums(const KernelStatistics& statistics)
    : statistics_(statistics), sums_(statistics.factor ? statistics.factor->rows() : statistics.mean.size()) {
  if (!statistics.factor) return;
  trial_.resize(sums_.size());
  scratch_.resize(sums_.size());
}

void VarianceSums::load(const std::uint32_t* sites, const double* flux, std::uint32_t count) {
  if (!statistics_.factor)
    return fillRow(statistics_.covariance.data(), strideOf(statistics_), sites, flux, count, sums_.data());
  std::fill(sums_.begin(), sums_.end(), 0.0);
  for (std::uint32_t i = 0; i < count; ++i) statistics_.factor->add(sites[i], flux[i], sums_.data());
}

void VarianceSums::move(std::uint32_t from, std::uint32_t to, double flux) {
  if (!statistics_.factor)
    return moveInRow(statistics_.covariance.data(), strideOf(statistics_), from, to, flux, sums_.data());
  statistics_.factor->add(from, -flux, sums_.data());
  statistics_.factor->add(to, flux, sums_.data());
}

double VarianceSums::variance(const std::uint32_t* sites, const double* flux, std::uint32_t count) const {
  if (statistics_.factor) return statistics_.factor->varianceOf(sums_.data());
  return varianceFromRow(sums_.data(), sites, flux, count);
}

void VarianceSums::moved(double current, std::uint32_t from, double flux, const std::uint32_t* candidates,
                         std::uint32_t count, double* out) {
  if (!statistics_.factor)
    return movedVariances(statistics_.covariance.data(), statistics_.diagonal.data(), strideOf(statistics_),
                          sums_.data(), current, from, flux, candidates, count, out);
  std::copy(sums_.begin(), sums_.end(), trial_.begin());
  statistics_.factor->add(from, -flux, trial_.data());
  statistics_.factor->added(trial_.data(), flux, candidates, count, scratch_.data(), out);
}

void VarianceSums::movedPairs(double current, const FluxMoves& moves, const FluxMoves& others,
                              std::uint32_t count, double* out) const {
  assert(!statistics_.factor);
  pairedVariances(statistics_.covariance.data(), statistics_.diagonal.data(), strideOf(statistics_),
                  sums_.data(), current, moves, others, count, out);
}

double VarianceSums::changed(double current, const FluxChange* changes, std::uint32_t count) {
  if (!statistics_.factor)
    return changedVariance(statistics_.covariance.data(), strideOf(statistics_), sums_.data(), current,
                           changes, count);
  std::copy(sums_.begin(), sums_.end(), trial_.begin());
  for (std::uint32_t k = 0; k < count; ++k)
    statistics_.factor->add(changes[k].site, changes[k].flux, trial_.data());
  return statistics_.factor->varianceOf(trial_.data());
}

double VarianceInTurn::of(const std::uint32_t* sites, const double* flux, std::uint32_t count) {
  if (!statistics_.factor)
    return varianceOf(statistics_.covariance.data(), strideOf(statistics_), sites, flux, count);
  const LightFactor& factor = *statistics_.factor;
  if (turns_++ % kTurns == 0) {
    flux_.assign(statistics_.mean.size(), 0.0);
    deviation_.assign(factor.rows(), 0.0);
    lit_.clear();
  }
  // What each candidate has now less what it had, candidates in their order.
  touched_ = lit_;
  for (const std::uint32_t candidate : lit_) flux_[candidate] = -flux_[candidate];
  for (std::uint32_t i = 0; i < count; ++i) flux_[sites[i]] += flux[i];
  touched_.insert(touched_.end(), sites, sites + count);
  std::sort(touched_.begin(), touched_.end());
  touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
  for (const std::uint32_t candidate : touched_) {
    if (flux_[candidate] != 0) factor.add(candidate, flux_[candidate], deviation_.data());
    flux_[candidate] = 0;
  }
  for (std::uint32_t i = 0; i < count; ++i) flux_[sites[i]] += flux[i];
  lit_.assign(sites, sites + count);
  std::sort(lit_.begin(), lit_.end());
  lit_.erase(std::unique(lit_.begin(), lit_.end()), lit_.end());
  return factor.varianceOf(deviation_.data());
}

}  // namespace fiatlux
