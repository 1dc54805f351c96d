// F and U by cosine-distributed rays, stratified over the patch and over the hemisphere at once (paper
// section 2.4).
#pragma once

#include <cstdint>
#include <functional>

#include "core/form_factors.h"
#include "precompute/ray_tracer.h"
#include "precompute/room.h"

namespace fiatlux {

struct CastOptions {
  std::uint32_t rays = 1024;  // from every patch and receiver
  std::uint64_t seed = 1;
  unsigned threads = 0;  // 0: all cores
  std::function<void(double)> progress;
};

/// Bit-identical for the same room, rays and seed, whatever the number of threads.
FormFactors castFormFactors(const Room& room, const RayTracer& tracer, const CastOptions& options);

/// Share of lost rays of each surface, by area: what left the room or met a back face.
std::vector<double> lostShares(const Room& room, const FormFactors& factors);

}  // namespace fiatlux
