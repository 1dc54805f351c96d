// Form factors (core/transport/form_factors.h). Cosine-distributed rays, stratified over the patch and over
// the hemisphere at once (paper section 2.4), say what a row loses and what it gets from the closest patches;
// kernel_factors.h says the rest. Where the first of them lose nothing, the others go no further than that.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "core/transport/form_factors.h"
#include "precompute/rays/effort.h"
#include "precompute/rays/ray_tracer.h"
#include "precompute/room/room.h"

namespace fiatlux {

struct CastOptions {
  // From every patch and receiver, times its effort (effort.h). More than usual mean more shadow rays, too.
  std::uint32_t rays = kUsualRays;
  bool plain = false;  // as in the paper: the same rays from every patch, and nothing but rays
  std::uint64_t seed = 1;
  unsigned threads = 0;  // 0: all cores
  std::function<void(double)> progress;
  bool draft = false;  // the same rays from every patch, small surfaces or not
};

/// What one row gets from all patches, as FormFactors keeps it.
struct FormFactorRow {
  std::vector<float> u;  // k
  std::vector<NearPatch> near;
  std::vector<ClusterSlope> slopes;
  float lost = 0;
  float open = 1;  // of what distant clusters would send it if nothing stood between, the share that arrives
};

/// Casts rows one by one, in any order, on any thread. Room and tracer must outlive it.
class FormFactorCaster {
 public:
  FormFactorCaster(const Room& room, const RayTracer& tracer, const CastOptions& options);
  FormFactorCaster(FormFactorCaster&&) noexcept;
  ~FormFactorCaster();
  FormFactorRow row(std::uint32_t p) const;
  /// Form factors that want nothing but their rows (setRow) and then complete().
  FormFactors withoutRows() const;
  void complete(FormFactors& factors) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

void setRow(FormFactors& factors, std::uint32_t p, const FormFactorRow& row);

/// Every row sums to 1 - its lost share. Bit-identical for the same room and options, whatever the threads.
FormFactors castFormFactors(const Room& room, const RayTracer& tracer, const CastOptions& options);

/// Share of lost rays of each surface, by area: what left the room or met a back face.
std::vector<double> lostShares(const Patches& patches, std::size_t surfaces, const FormFactors& factors);

}  // namespace fiatlux
