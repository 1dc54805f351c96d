// What a small piece of surface would get from each part of each cluster if nothing stood between: of all at
// once.
#pragma once

#include <vector>

#include "precompute/light/cluster_parts.h"

namespace fiatlux {

class PartKernels {
 public:
  explicit PartKernels(const ClusterParts& clusters);

  /// Form factors to each part by its centre, cos cos / (pi r^2) times its area; 0 where they face away.
  void at(const Vec3& position, const Vec3& normal, std::vector<float>& kernels) const;

 private:
  enum Column { kX, kY, kZ, kNormalX, kNormalY, kNormalZ, kArea, kColumns };  // m, from base_; m2
  struct alignas(32) Eight {
    float value[kColumns][8];
  };
  Vec3 base_;                  // m
  std::vector<Eight> eights_;  // of parts
};

}  // namespace fiatlux
