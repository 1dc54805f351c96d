#include "precompute/light/brightest.h"

#include <algorithm>

namespace fiatlux {

namespace {

constexpr double kLeastBright = 0.5, kMostBright = 30;  // what rows see of the others is not to be forgotten

/// Illuminance of a part by a site, but for a factor that all share; 0 where they face away.
double lightOf(const Site& site, const ClusterPart& part) {
  const Vec3 d = part.center - site.position;
  const double out = dot(d, site.normal), in = -dot(d, part.normal);
  if (out <= 0 || in <= 0) return 0;
  const double squared = dot(d, d) + 0.5 * (part.area + site.size * site.size);  // neither is a point
  return out * in / (squared * squared);
}

}  // namespace

std::vector<double> brightestByMean(const Room& room, const ClusterParts& clusters) {
  const std::uint32_t count = room.patches.clusterCount;
  std::vector<double> brightest(count, 0.0);
  double sum = 0, area = 0;
  for (std::uint32_t c = 0; c < count; ++c) {
    double ofCluster = 0;
    for (std::uint32_t i = clusters.firstOf(c); i < clusters.firstOf(c + 1); ++i) {
      const ClusterPart& part = clusters.parts()[i];
      ofCluster += part.area;
      for (const Site& site : room.sites) brightest[c] = std::max(brightest[c], lightOf(site, part));
    }
    sum += ofCluster * brightest[c];
    area += ofCluster;
  }
  if (!(sum > 0)) return std::vector<double>(count, 1.0);
  for (double& value : brightest) value = std::clamp(value * area / sum, kLeastBright, kMostBright);
  return brightest;
}

}  // namespace fiatlux
