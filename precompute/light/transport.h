// How light travels in a room: from rays to mean rows and covariances. Stages: form factors by rays, low-rank
// radiosity, direct light from the sources, interreflection (low-rank answer and refinement), statistics.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/scene/scene.h"
#include "core/transport/form_factors.h"
#include "precompute/base/progress.h"
#include "precompute/light/paper_transport.h"
#include "precompute/rays/effort.h"
#include "precompute/rays/ray_tracer.h"
#include "precompute/room/room.h"

namespace fiatlux {

/// Residual at which a block of responses has settled: refined no further.
inline constexpr double kSettled = 1e-3;

struct TransportOptions {
  std::uint32_t rays = kUsualRays;  // from every patch and receiver
  std::uint32_t refine = 24;  // most refinement steps after the low-rank answer; fewer where it has settled
  bool paper = false;     // the paper to the letter: emission spread by V, response -Y V^T E, nothing refined
  bool draft = false;     // to be replaced soon: few shadow rays, and small surfaces as noisy as others
  bool exchange = false;  // the light operator too, for other photometries; not in paper mode
  std::uint64_t seed = 1;
  unsigned threads = 0;          // 0: all cores; the result does not depend on it
  Progress* progress = nullptr;  // of its stages; nullptr: nobody listens
};

struct Transport {
  FormFactors factors;
  std::vector<float> direct;  // lx per lm, column-major rows x sites; empty in paper mode
  Responses responses;        // lx per lm
  std::vector<SurfaceStatistics> illuminance, exitance;  // per leaf surface, over the sites
  std::vector<double> lost;                              // per surface, share of its rays
  std::vector<double>
      residuals;  // steps + 1: |e - (I - R F) b| / |e| over all sites before each step, after the last
  std::optional<PaperTransport> paper;
  std::optional<LightOperator> lightOperator;
};

/// `tracer`: of the room's triangles. Errors: no patches, a singular system, too little memory, stopped. The
/// same room, rays, refine and seed give the same bits.
Result<Transport> computeTransport(const Room& room, const RayTracer& tracer,
                                   const TransportOptions& options);

}  // namespace fiatlux
