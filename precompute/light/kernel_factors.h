// Form factors to all but the closest patches, by the kernel cos cos / (pi r^2) and shadow rays: patch by
// patch nearby, further away by quarters of clusters. A cosine ray rarely meets a small bright spot, and one
// hit too many is a bright patch; where nothing stands between, this estimate has no such noise. Clusters
// that nothing stands between, or a whole wall, need no rays; others get as many as they may give light, and
// where that is less than one, as much of it arrives as of others beside it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "core/transport/form_factors.h"
#include "precompute/light/cluster_parts.h"
#include "precompute/light/part_kernels.h"
#include "precompute/rays/patch_sampler.h"
#include "precompute/rays/patch_sets.h"
#include "precompute/rays/places.h"
#include "precompute/rays/ray_sequence.h"
#include "precompute/rays/ray_tracer.h"
#include "precompute/room/room.h"

namespace fiatlux {

/// Thread-safe once built. Room and tracer must outlive it.
class KernelFactors {
 public:
  /// ofRay: the form factor that one shadow ray tells of, for rows of effort 1 and a cluster as bright as the
  /// others.
  KernelFactors(const Room& room, const RayTracer& tracer, std::uint64_t seed, double ofRay);

  /// What one row gets from everything that is not too close.
  struct Row {
    std::vector<float> u;              // k: of distant clusters; 0 for those that are seen patch by patch
    std::vector<ClusterSlope> slopes;  // of distant clusters, except far ones
    std::vector<NearPatch> near;       // patches of the other clusters
    float open = 1;                    // share of what distant clusters would send that arrives
  };
  /// effort: of effort.h, 1 to kMostEffort.
  void row(std::uint32_t p, std::uint32_t effort, const PatchSampler& sampler, Row& row) const;

  /// Whether patch q is too close to row p for this estimate: then only rays tell.
  bool tooClose(std::uint32_t p, std::uint32_t q) const;
  /// m: no point of a patch that is too close is further than this from any of the row's.
  double closeReach(std::uint32_t p) const;

  const ClusterParts& clusters() const { return clusters_; }
  /// FormFactors::slopeShare, n x 2.
  const std::vector<float>& slopeShare() const { return clusters_.slopeShare(); }

 private:
  static constexpr std::uint32_t kGauss = 4;  // points of a patch for the kernel

  struct Candidate {             // a part or a patch that faces the row
    std::uint32_t item;          // part, or firstPatch_ + patch
    float kernel;                // form factor if nothing is between
    std::uint32_t asked = 0;     // shadow rays
    std::uint32_t visible = 0;   // of these arrived
    float arrived = 0;           // sum of the form factors that these stand for
    float leanU = 0, leanV = 0;  // of these, times where in the cluster they come from
  };
  struct Group {  // what of one cluster faces the row
    std::uint32_t cluster;
    std::size_t first, last;  // candidates
    double kernel = 0;        // of them together
    std::uint32_t rays = 0;   // to them; 0 where nothing is between, too
    bool isHidden = false;    // in part, as rays tell
    bool isAlike = false;     // no ray tells: as much arrives as of others
    double open = 1;          // what arrives then, over the kernel
  };
  class ShadowRays;
  struct Faced {
    std::vector<Candidate> candidates;
    std::vector<Group> groups;
  };

  Between between(std::uint32_t p, std::uint32_t cluster) const;
  void addCandidates(std::uint32_t p, const std::vector<PatchPoint>& points,
                     const std::vector<float>& ofParts, std::uint32_t c,
                     std::vector<Candidate>& candidates) const;
  double raysTo(const Group& group, std::uint32_t effort) const;
  void ask(Group& group, std::uint32_t effort, double& due) const;
  Faced facedBy(std::uint32_t p, std::uint32_t effort, const PatchSampler& sampler) const;
  void castShadows(std::uint32_t p, Faced& faced) const;
  static double arrivingOf(const Faced& faced, const Group& group);
  static void lendOpenness(Faced& faced);
  static double factorOf(const Candidate& candidate, const Group& group);
  void write(const Faced& faced, const Group& group, std::uint32_t p, Row& row) const;
  float openOf(const Faced& faced) const;

  /// Whether a row is nearer to a cluster than this, in edges of both.
  bool isWithin(double edges, std::uint32_t p, std::uint32_t cluster) const;
  /// Of two patches, in edges of both.
  bool areWithin(double edges, std::uint32_t p, std::uint32_t q) const;
  double areaOf(std::uint32_t item) const {
    return item < firstPatch_ ? clusters_.parts()[item].area : room_.patches.area[item - firstPatch_];
  }

  const Room& room_;
  const RayTracer& tracer_;
  std::uint64_t seed_;
  double ofRay_;
  RaySequence sequence_;
  ClusterParts clusters_;
  std::vector<double> brightness_;  // k, that may be, relative to the mean
  BetweenPlaces between_;           // clusters
  PartKernels partKernels_;
  PatchSets points_;                                   // items, then receivers
  std::uint32_t firstPatch_;                           // items: parts, from here on patches
  std::vector<double> edge_;                           // rows, m: of a square as large
  std::vector<double> patchReach_;                     // rows, m: squareReach of patches
  double mostReach_ = 0;                               // m: of patches
  std::vector<std::array<PatchPoint, kGauss>> gauss_;  // n, points for the kernel
};

}  // namespace fiatlux
