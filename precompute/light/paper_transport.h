// The paper to the letter, to reproduce it: reflected radiosity -Y V^T E, mean rows and covariances over the
// k columns of -Y (equations 8, 10 and 11), and what they say about the sites.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/scene/scene.h"
#include "core/transport/low_rank_radiosity.h"
#include "precompute/rays/ray_tracer.h"
#include "precompute/room/room.h"

namespace fiatlux {

/// Sparse rows: row i holds columns column[offset[i]..offset[i + 1]) with these weights.
struct SparseRows {
  std::vector<std::uint32_t> offset = {0}, column;
  std::vector<double> weight;
};

/// The paper's formulation, besides the site-level results that are derived from it.
struct PaperTransport {
  std::vector<float> y;  // Y, n x k row-major; V follows from patches.cluster and areas
  std::vector<SurfaceStatistics>
      exitance;             // per leaf surface, over k columns of -Y; empty for measuring planes
  SparseRows siteClusters;  // V^T E of each site at 1 lm: share of the site in cluster c / A_c
};

/// Fills `responses` (sized rows x sites) with the irradiance behind -Y V^T E, E being each site's 1 lm
/// spread evenly over the patches under it; exitance is reflectance times that.
PaperTransport paperTransport(const Room& room, const RayTracer& tracer, const FormFactors& factors,
                              const LowRankRadiosity& lowRank, unsigned threads, Responses& responses,
                              const std::function<void(double)>& progress);

}  // namespace fiatlux
