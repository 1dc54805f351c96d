// The forward truth: what given luminaires, anywhere, do to a room. The same parts as the transport of the
// sites, but one right-hand side, refined until it has converged.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/result.h"
#include "core/scene/luminaire.h"
#include "precompute/base/progress.h"
#include "precompute/rays/effort.h"
#include "precompute/rays/ray_tracer.h"
#include "precompute/room/room.h"

namespace fiatlux {

struct ForwardOptions {
  std::uint32_t rays = kUsualRays;  // from every patch and receiver
  std::uint64_t seed = 1;
  unsigned threads = 0;          // 0: all cores
  bool directOnly = false;       // no reflections (emergency lighting, EN 1838)
  double tolerance = 1e-6;       // |e - (I - R F) b| / |e| at which the solution has converged
  std::uint32_t steps = 50;      // most refinement steps
  Progress* progress = nullptr;  // of its stages; nullptr: nobody listens
};

/// Where the flux goes, lm. emitted = absorbed + lostDirect + lostReflected + imbalance; absorbed is what
/// patches receive and do not reflect, lost what leaves the room or meets a back face, the imbalance sampling
/// error.
struct EnergyBalance {
  double emitted = 0, absorbed = 0, lostDirect = 0, lostReflected = 0, imbalance = 0;
};

struct ForwardLight {
  std::vector<float> direct, illuminance;  // rows(), lx
  std::vector<float> radiosity;            // n, lm/m2: reflected light, and what patches emit
  std::vector<double> lost;                // per surface, share of its rays
  double residual = 0;                     // at the end
  std::uint32_t steps = 0;                 // refinement steps taken
  EnergyBalance energy;
};

/// Light before it is reflected: column-major rows() x luminaires, lx, each at its flux. Few of them are
/// looked at more finely than a room's sites.
std::vector<float> forwardDirectLight(const Room& room, const RayTracer& tracer,
                                      const std::vector<Luminaire>& luminaires, const ForwardOptions& options,
                                      const std::function<void(double)>& progress = {});

/// `emission` (n, lm/m2, or empty): patches that shine by themselves, for white furnaces and luminous
/// surfaces.
Result<ForwardLight> computeForwardLight(const Room& room, const RayTracer& tracer,
                                         const std::vector<Luminaire>& luminaires,
                                         const ForwardOptions& options,
                                         const std::vector<float>& emission = {});

}  // namespace fiatlux
