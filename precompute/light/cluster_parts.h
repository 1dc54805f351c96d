// Clusters in quarters, and the shape of the light on them: what kernel_factors.h needs to know of a cluster
// that is too far away to be seen patch by patch.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "precompute/room/room.h"

namespace fiatlux {

/// About a quarter of a cluster.
struct ClusterPart {
  std::vector<std::uint32_t> members;  // patches
  Vec3 center, normal;                 // center: m, spread so that the parts have the cluster's second moment
  double area = 0;                     // m2
  double u = 0, v = 0;                 // of the centre from the cluster's, in edges of the cluster
};

class ClusterParts {
 public:
  explicit ClusterParts(const Room& room);

  std::span<const std::uint32_t> membersOf(std::uint32_t cluster) const { return members_[cluster]; }
  const Vec3& centerOf(std::uint32_t cluster) const { return center_[cluster]; }
  /// m: edge of a square that is as large as the cluster, or reaches as far.
  double reachOf(std::uint32_t cluster) const { return reach_[cluster]; }

  /// Of a point of a cluster, or a patch's centre, from the cluster's along its chart's two axes, in edges of
  /// the cluster.
  struct Place {
    double u, v;
  };
  Place placeOf(const Room& room, std::uint32_t patch) const {
    return placeAt(room.patches.cluster[patch], room.patches.center[patch]);
  }
  Place placeAt(std::uint32_t cluster, const Vec3& point) const {
    const Vec3 d = point - center_[cluster];
    return {dot(d, axes_[cluster][0]), dot(d, axes_[cluster][1])};
  }

  /// Of all clusters.
  const std::vector<ClusterPart>& parts() const { return parts_; }
  /// The parts of a cluster are parts()[firstOf(c)] to before parts()[firstOf(c + 1)].
  std::uint32_t firstOf(std::uint32_t cluster) const { return firstPart_[cluster]; }

  /// FormFactors::slopeShare, n x 2.
  const std::vector<float>& slopeShare() const { return slopeShare_; }

 private:
  void measure(const Room& room, std::uint32_t cluster);
  void addParts(const Room& room, std::uint32_t cluster);
  void addSlopeShares(const Room& room, std::uint32_t cluster);

  std::vector<std::vector<std::uint32_t>> members_;  // k: patches, ascending
  std::vector<Vec3> center_;                         // k, m
  std::vector<std::array<Vec3, 2>> axes_;            // k, of the chart, over the cluster's edge
  std::vector<double> reach_;                        // k, m
  std::vector<ClusterPart> parts_;                   // by cluster
  std::vector<std::uint32_t> firstPart_;             // k + 1
  std::vector<float> slopeShare_;
};

/// Edge of a square that reaches as far as points at most `radius` from their centre, or is as large (m).
double squareReach(double area, double radius);

}  // namespace fiatlux
