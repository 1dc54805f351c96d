// Form factors: F ~ U V^T between patches and clusters, corrected where the light's spread within a cluster
// matters: by slopes, and nearby by the factors of single patches. Paper equations (1) and (3), section 2.4.
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/patches.h"

namespace fiatlux {

/// The form factor from a row to one patch.
struct NearPatch {
  std::uint32_t patch;
  float factor;
  bool operator==(const NearPatch&) const = default;
};

/// How the light that a row gets from one cluster leans over that cluster.
struct ClusterSlope {
  std::uint16_t cluster;
  std::int8_t u, v;  // along the cluster's two axes, in parts of 1 / kSlopeUnit
  bool operator==(const ClusterSlope&) const = default;
};
inline constexpr float kSlopeUnit = 127;

/// F_pq = share of the power leaving p that arrives at q. For every row p (n patches, then receivers) and
/// cluster c, U_pc = sum of F_pq over q in c; V spreads it over the cluster, and two things correct V where
/// the light's spread within a cluster matters: the single F_pq of patches q near p, and further away a
/// slope, F_pq = U_pc (share_q + slope . slopeShare_q). What p loses through openings and to back faces is
/// simply missing: sum of U_pc over c = 1 - lost_p.
struct FormFactors {
  std::uint32_t rows = 0;                         // patches and receivers
  std::uint32_t count = 0;                        // n, columns of F
  std::uint32_t clusters = 0;                     // k
  std::vector<float> u;                           // rows x k, row-major
  std::vector<std::uint32_t> cluster;             // n: V's only non-zero of row q is in this column,
  std::vector<double> share;                      // n: and is this; sums to 1 over a cluster
  std::vector<std::vector<NearPatch>> near;       // rows: patches ascending
  std::vector<std::vector<ClusterSlope>> slopes;  // rows: clusters ascending
  std::vector<float> slopeShare;                  // n x 2, row-major; sums to 0 over a cluster
  std::vector<float> lost;                        // rows: share of the rays that were lost
  std::vector<float> open;  // rows: share of distant clusters' light that nothing keeps away
};

/// V^T e: k x width from n x width, row-major; summed in double.
void reduce(const FormFactors& factors, const float* e, std::uint32_t width, float* x);

/// F b (rows x width) for b (n x width), row-major: the irradiance that exitances b cause. As
/// U V^T b + slopes + near patches' differences from their cluster's mean, so that nothing of size n x n is
/// ever needed.
void irradiance(const FormFactors& factors, const float* b, std::uint32_t width, float* out);

/// Adds to `out` what F b has beyond U x, given x = V^T b (k x width).
void addDetail(const FormFactors& factors, const float* b, const float* x, std::uint32_t width, float* out);

/// F^T w (n x kColumnBlock) for w (rows x kColumnBlock): how much what leaves a patch weighs where it
/// arrives.
void transposedIrradiance(const FormFactors& factors, const float* w, float* out);

}  // namespace fiatlux
