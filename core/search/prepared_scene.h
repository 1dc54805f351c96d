// What a search needs of a scene beyond the scene itself, computed once and shared by every search in it:
// statistics of surface sets in the form that the kernels read, and each site's nearest sites.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/scene/scene.h"
#include "core/search/statistics.h"

namespace fiatlux {

/// Statistics of one surface set: `mean` m entries, `covariance` m x m row-major and symmetric, `diagonal`
/// its m diagonal entries. Means stay in double, so that the N largest of a row are exactly that.
struct KernelStatistics {
  std::vector<double> mean;
  std::vector<float> covariance, diagonal;
};

/// Mean and variance under a layout of `count` luminaires, by the kernels; the variance only where asked for,
/// else 0.
Moments momentsOf(const KernelStatistics& statistics, const std::uint32_t* sites, const double* flux,
                  std::uint32_t count, bool withVariance = true);

/// Refers to the scene, which must outlive it.
class PreparedScene {
 public:
  explicit PreparedScene(const Scene& scene);

  const Scene& scene() const { return scene_; }
  std::uint32_t siteCount() const { return static_cast<std::uint32_t>(scene_.sites.size()); }

  /// Of a set of leaves (empty = all), made at first use and kept (the 64 latest).
  std::shared_ptr<const KernelStatistics> statistics(Quantity quantity, const SurfaceSet& surfaces);

  /// The `nearCount()` sites nearest to `site`, itself left out, nearest first, ties by index.
  const std::uint32_t* nearSites(std::uint32_t site) const {
    return near_.data() + std::size_t{site} * nearCount_;
  }
  std::uint32_t nearCount() const { return nearCount_; }

  /// Distance between the centres of two sites, m.
  double distance(std::uint32_t a, std::uint32_t b) const;

 private:
  struct Entry {
    Quantity quantity;
    SurfaceSet surfaces;
    std::shared_ptr<const KernelStatistics> statistics;
  };
  const Scene& scene_;
  std::vector<Entry> entries_;
  std::uint32_t nearCount_ = 0;
  std::vector<std::uint32_t> near_;
};

}  // namespace fiatlux
