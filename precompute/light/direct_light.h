// Direct light of luminaires, never from hemisphere rays: the source's own form factor (Lambert's polygon, or
// inverse square for a point) times its visible part by stratified shadow rays, averaged over the receiving
// patch. A patch and a source that nothing stands between, or a whole wall, need no rays.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/scene/light_operator.h"
#include "core/scene/luminaire.h"
#include "precompute/rays/patch_sampler.h"
#include "precompute/rays/ray_tracer.h"
#include "precompute/room/room.h"

namespace fiatlux {

struct DirectLightOptions {
  // Parts of the source's edge, to each of which a shadow ray goes from each point of a patch; twice as many
  // on small surfaces. Where a shadow's edge is found twice as many again, and on others than small surfaces
  // three rays for four parts.
  std::uint32_t split = 2;
  std::uint64_t seed = 1;
  unsigned threads = 0;  // 0: all cores
  std::function<void(double)> progress;
  // One ray from each point of a patch to anywhere on the source.
  bool draft = false;
};

/// Illuminance (lx) of every row by each luminaire at its own flux: column-major rows() x luminaires.
/// `visibility`, where given, becomes the share of that light which shadows let through; behind a luminaire,
/// of its area that is seen.
std::vector<float> directLight(const Room& room, const RayTracer& tracer,
                               const std::vector<Luminaire>& luminaires, const DirectLightOptions& options,
                               SiteVisibility* visibility = nullptr);

/// The same of rows [first, first + count) alone: column-major count x luminaires.
std::vector<float> directLightOfRows(const Room& room, const RayTracer& tracer,
                                     const std::vector<Luminaire>& luminaires,
                                     const DirectLightOptions& options, std::uint32_t first,
                                     std::uint32_t count, SiteVisibility* visibility = nullptr);

/// Illuminance (lx) at a point by one luminaire, `split` x `split` shadow rays on the source (one for a point
/// source).
double directLightAt(const RayTracer& tracer, const PatchPoint& receiver, const Luminaire& luminaire,
                     std::uint32_t split, std::uint64_t seed);

}  // namespace fiatlux
