// The paper to the letter, to reproduce it: reflected radiosity -Y V^T E, mean rows and covariances over the
// k columns of -Y (equations 8, 10 and 11), and what they say about the sites.
#pragma once

#include <functional>

#include "core/low_rank_radiosity.h"
#include "precompute/ray_tracer.h"
#include "precompute/transport.h"

namespace fiatlux {

/// Fills `responses` (sized rows x sites) with the irradiance behind -Y V^T E, E being each site's 1 lm
/// spread evenly over the patches under it; exitance is reflectance times that.
PaperTransport paperTransport(const Room& room, const RayTracer& tracer, const FormFactors& factors,
                              const LowRankRadiosity& lowRank, unsigned threads, Responses& responses,
                              const std::function<void(double)>& progress);

}  // namespace fiatlux
