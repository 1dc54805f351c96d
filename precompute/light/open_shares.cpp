#include "precompute/light/open_shares.h"

#include <algorithm>
#include <cmath>

namespace fiatlux {

namespace {

constexpr float kLeastOpen = 0.01f;  // so that a cluster that nobody sees still has shares

/// First moment of a cluster's shares along its chart's axes, in the units of its slopes.
struct Moment {
  double u = 0, v = 0;
};

Moment momentOf(const Room& room, const ClusterParts& clusters, const FormFactors& factors,
                std::uint32_t cluster) {
  const auto members = clusters.membersOf(cluster);
  const Chart& chart = room.charts[room.chartOfPatch[members[0]]];
  const double unit = kSlopeUnit / clusters.reachOf(cluster);
  Moment moment;
  for (const std::uint32_t q : members) {
    const Vec3 d = room.patches.center[q] - clusters.centerOf(cluster);
    moment.u += factors.share[q] * unit * dot(d, chart.uAxis);
    moment.v += factors.share[q] * unit * dot(d, chart.vAxis);
  }
  return moment;
}

std::int8_t without(std::int8_t slope, double moment) {
  const double left = std::clamp(slope - moment, -double{kSlopeUnit}, double{kSlopeUnit});
  return static_cast<std::int8_t>(std::lround(left));
}

}  // namespace

void weighByOpenness(const Room& room, const ClusterParts& clusters, FormFactors& factors) {
  std::vector<Moment> moments;
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
