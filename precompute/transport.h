// How light travels in a room: the whole precomputation, from rays to mean rows and covariances.
// Stages: form factors by rays, direct light from the sources, low-rank radiosity, refinement, statistics.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/form_factors.h"
#include "core/result.h"
#include "core/scene.h"
#include "precompute/effort.h"
#include "precompute/room.h"

namespace fiatlux {

struct TransportOptions {
  std::uint32_t rays = kUsualRays;  // from every patch and receiver
  std::uint32_t refine = 2;         // refinement steps after the low-rank answer
  bool paper = false;  // the paper to the letter: emission spread by V, response -Y V^T E, nothing refined
  std::uint64_t seed = 1;
  unsigned threads = 0;  // 0: all cores; the result does not depend on it
  std::function<void(const char* stage, double fraction)> progress;  // called often, on the calling thread
};

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

inline constexpr std::uint32_t kBlockWidth = 16;  // sites solved together: each ray is read once for them all

struct Transport {
  FormFactors factors;
  std::vector<float> direct;  // lx per lm, column-major rows x sites; empty in paper mode
  Responses responses;        // lx per lm
  std::vector<SurfaceStatistics> illuminance, exitance;  // per leaf surface, over the sites
  std::vector<double> lost;                              // per surface, share of its rays
  std::vector<double>
      residuals;  // refine + 1: |e - (I - R F) b| / |e| over all sites before each step, after the last
  std::vector<std::pair<std::string, double>> seconds;  // stage, wall clock
  double bytes = 0;                                     // held at the peak, estimated from the arrays' sizes
  std::optional<PaperTransport> paper;
};

/// Errors: no patches, a singular system. The same room, rays, refine and seed give the same bits.
Result<Transport> computeTransport(const Room& room, const TransportOptions& options);

}  // namespace fiatlux
