// Form factors: F ~ U V^T between patches and clusters, and F itself through the rays cast nearby.
// Paper equations (1) and (3), section 2.4.
#pragma once

#include <cstdint>
#include <vector>

#include "core/patches.h"

namespace fiatlux {

/// F_pq = share of the power leaving p that arrives at q. For every row p (n patches, then receivers) and
/// cluster c, U_pc = sum of F_pq over q in c; V spreads it over the cluster. Where the light's spread within
/// a cluster matters, that is unless the cluster is far from p, the patches that p's cosine-distributed rays
/// met there ("hits") correct it. What p loses through openings and to back faces is simply missing: sum of
/// U_pc over c = 1 - lost_p.
struct FormFactors {
  std::uint32_t rows = 0;                // patches and receivers
  std::uint32_t count = 0;               // n, columns of F
  std::uint32_t clusters = 0;            // k
  std::uint32_t rays = 0;                // cast from each row
  std::vector<float> u;                  // rows x k, row-major
  std::vector<std::uint32_t> cluster;    // n: V's only non-zero of row q is in this column,
  std::vector<double> share;             // n: and is this: A_q / A_c
  std::vector<std::uint64_t> hitOffset;  // rows + 1: row p's places in hits; how many rays it cast
  std::vector<std::uint32_t> hits;       // patches met, ascending, then kNone up to the row's end
  std::vector<float> hitWeight;          // rows: the form factor that one hit stands for
  std::vector<float> lost;               // rows: share of the rays that were lost
};

/// V^T e: k x width from n x width, row-major; summed in double.
void reduce(const FormFactors& factors, const float* e, std::uint32_t width, float* x);

/// F b (rows x width) for b (n x width), row-major: the irradiance that exitances b cause. As
/// U V^T b + (hits of b - its mean over the cluster), so that nothing of size n x n is ever needed.
void irradiance(const FormFactors& factors, const float* b, std::uint32_t width, float* out);

}  // namespace fiatlux
