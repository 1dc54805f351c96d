#include "precompute/light/open_shares.h"

#include <algorithm>
#include <cmath>

namespace fiatlux {

namespace {

constexpr float kLeastOpen = 0.01f;  // so that a cluster that nobody sees still has shares

/// First moment of a cluster's shares, in the units of its slopes.
ClusterParts::Place momentOf(const Room& room, const ClusterParts& clusters, const FormFactors& factors,
                             std::uint32_t cluster) {
  ClusterParts::Place moment{0, 0};
  for (const std::uint32_t q : clusters.membersOf(cluster)) {
    const auto [u, v] = clusters.placeOf(room, q);
    moment.u += kSlopeUnit * factors.share[q] * u;
    moment.v += kSlopeUnit * factors.share[q] * v;
  }
  return moment;
}

std::int8_t without(std::int8_t slope, double moment) {
  const double left = std::clamp(slope - moment, -double{kSlopeUnit}, double{kSlopeUnit});
  return static_cast<std::int8_t>(std::lround(left));
}

}  // namespace

void weighByOpenness(const Room& room, const ClusterParts& clusters, FormFactors& factors) {
  std::vector<ClusterParts::Place> moments;
  for (std::uint32_t c = 0; c < factors.clusters; ++c) {
    double sum = 0;
    for (const std::uint32_t q : clusters.membersOf(c))
      sum += factors.share[q] = room.patches.area[q] * std::max(factors.open[q], kLeastOpen);
    for (const std::uint32_t q : clusters.membersOf(c)) factors.share[q] /= sum;
    moments.push_back(momentOf(room, clusters, factors, c));
  }
  for (std::vector<ClusterSlope>& slopes : factors.slopes) {
    for (ClusterSlope& slope : slopes) {
      slope.u = without(slope.u, moments[slope.cluster].u);
      slope.v = without(slope.v, moments[slope.cluster].v);
    }
  }
}

}  // namespace fiatlux
