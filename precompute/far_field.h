// Form factors between patches and distant clusters, by the kernel cos cos / (pi r^2) and shadow rays. A
// cosine ray rarely meets a small bright spot far away, and one hit too many is a bright patch; this estimate
// has no such noise.
#pragma once

#include <cstdint>
#include <vector>

#include "precompute/patch_sampler.h"
#include "precompute/ray_sequence.h"
#include "precompute/ray_tracer.h"
#include "precompute/room.h"

namespace fiatlux {

/// Thread-safe once built. Room and tracer must outlive it.
class FarField {
 public:
  /// How a row sees a cluster: kNear by its rays alone; kMiddle: U from here, the light's spread within the
  /// cluster from the rays; kFar: U from here, the spread ignored.
  enum class Range : char { kNear, kMiddle, kFar };

  FarField(const Room& room, const RayTracer& tracer, std::uint64_t seed);

  /// ranges[c] and u[c] (k each) of row p; u is 0 for near clusters. effort: of effort.h, 1 to 16.
  void row(std::uint32_t p, std::uint32_t effort, const PatchSampler& sampler, std::vector<Range>& ranges,
           float* u) const;

 private:
  static constexpr std::size_t kShadowPoints = 256;  // that shadow rays start from or end in, at most
  static constexpr std::size_t kFewPoints = 16;      // that rows of effort 1 use

  struct Part {  // about a quarter of a cluster
    std::uint32_t cluster = 0;
    Vec3 center, normal;
    double area = 0;
  };
  struct Candidate {  // a part that faces the row
    std::uint32_t part;
    double kernel;          // form factor if nothing is between
    std::uint32_t visible;  // shadow rays that arrived
  };
  void addParts(std::uint32_t cluster, const std::vector<std::uint32_t>& members, std::uint64_t seed,
                std::vector<Vec3>& targets);
  std::size_t targetAt(std::size_t part, std::size_t point) const {
    return (point / kFewPoints * parts_.size() + part) * kFewPoints + point % kFewPoints;
  }
  void castShadows(std::uint64_t seed, std::uint32_t rays, const std::vector<Vec3>& origins,
                   std::size_t first, std::size_t last, std::vector<Candidate>& candidates) const;

  const Room& room_;
  const RayTracer& tracer_;
  std::uint64_t seed_;
  RaySequence sequence_;                  // kShadowPoints points
  std::vector<Part> parts_;               // by cluster
  std::vector<Vec3> targets_;             // where shadow rays end, at targetAt(part, point)
  std::vector<std::uint32_t> firstPart_;  // k + 1
  std::vector<Vec3> center_;              // k, m
  std::vector<double> reach_;             // k, m: edge of a square as large as the cluster
};

}  // namespace fiatlux
