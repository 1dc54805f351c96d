// Kernel statistics of surface sets and nearest sites; see prepared_scene.h.
#include "core/search/prepared_scene.h"

#include <algorithm>

#include "core/search/kernels.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kNearSites = 48;
constexpr std::size_t kKeptSets = 64;

std::shared_ptr<const KernelStatistics> kernelStatistics(const Scene& scene, Quantity quantity,
                                                         const SurfaceSet& surfaces) {
  SurfaceStatistics exact = unionStatistics(scene, quantity, surfaces);
  auto result = std::make_shared<KernelStatistics>();
  const std::size_t m = exact.mean.size();
  result->mean = std::move(exact.mean);
  result->covariance.assign(exact.covariance.begin(), exact.covariance.end());
  result->diagonal.resize(m);
  for (std::size_t i = 0; i < m; ++i) result->diagonal[i] = result->covariance[i * m + i];
  return result;
}

}  // namespace

Moments momentsOf(const KernelStatistics& statistics, const std::uint32_t* sites, const double* flux,
                  std::uint32_t count, bool withVariance) {
  const auto m = static_cast<std::uint32_t>(statistics.mean.size());
  Moments moments{meanOf(statistics.mean.data(), sites, flux, count), 0};
  if (withVariance) moments.variance = varianceOf(statistics.covariance.data(), m, sites, flux, count);
  return moments;
}

PreparedScene::PreparedScene(const Scene& scene) : scene_(scene) {
  const std::uint32_t m = siteCount();
  nearCount_ = m == 0 ? 0 : std::min(m - 1, kNearSites);
  near_.reserve(std::size_t{m} * nearCount_);
  std::vector<std::pair<double, std::uint32_t>> order;
  for (std::uint32_t a = 0; a < m; ++a) {
    order.clear();
    for (std::uint32_t b = 0; b < m; ++b)
      if (b != a) order.emplace_back(distance(a, b), b);
    std::partial_sort(order.begin(), order.begin() + nearCount_, order.end());
    for (std::uint32_t k = 0; k < nearCount_; ++k) near_.push_back(order[k].second);
  }
}

std::shared_ptr<const KernelStatistics> PreparedScene::statistics(Quantity quantity,
                                                                  const SurfaceSet& surfaces) {
  for (const Entry& entry : entries_)
    if (entry.quantity == quantity && entry.surfaces == surfaces) return entry.statistics;
  if (entries_.size() == kKeptSets) entries_.erase(entries_.begin());
  entries_.push_back({quantity, surfaces, kernelStatistics(scene_, quantity, surfaces)});
  return entries_.back().statistics;
}

double PreparedScene::distance(std::uint32_t a, std::uint32_t b) const {
  return length(scene_.sites[a].position - scene_.sites[b].position);
}

}  // namespace fiatlux
