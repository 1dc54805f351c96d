#include "precompute/light/forward_light.h"

#include <algorithm>

#include "core/transport/low_rank_radiosity.h"
#include "core/transport/site_responses.h"
#include "precompute/base/error.h"
#include "precompute/light/cast_form_factors.h"
#include "precompute/light/direct_light.h"
#include "precompute/light/emission.h"
#include "precompute/rays/ray_sequence.h"

namespace fiatlux {

namespace {

/// Few luminaires deserve a finer look than hundreds of sites: within the same time.
constexpr std::size_t kFewLuminaires = 16;
constexpr std::uint32_t kFinerSplit = 4;

constexpr std::uint32_t kLostRays = 4096;  // from each luminaire, to see what leaves the room at once

/// Direct light of all luminaires together.
std::vector<float> sumOfDirectLight(const Room& room, const RayTracer& tracer,
                                    const std::vector<Luminaire>& luminaires, const ForwardOptions& options,
                                    const std::function<void(double)>& progress) {
  const std::uint32_t rows = room.patches.rows();
  const std::vector<float> columns = forwardDirectLight(room, tracer, luminaires, options, progress);
  std::vector<float> sum(rows, 0.0f);
  for (std::uint32_t p = 0; p < rows; ++p) {
    double light = 0;
    for (std::size_t j = 0; j < luminaires.size(); ++j) light += columns[j * rows + p];
    sum[p] = static_cast<float>(light);
  }
  return sum;
}

/// Share of a luminaire's own rays that meet no front of a patch.
double lostShare(const Room& room, const RayTracer& tracer, const Luminaire& luminaire,
                 const RaySequence& sequence, std::uint64_t seed) {
  const auto scramble = RaySequence::scramble(seed);
  const Emission source(luminaire);
  double lost = 0, all = 0;
  for (std::uint32_t i = 0; i < sequence.count(); ++i) {
    const auto sample = sequence.point(i, scramble);
    const Vec3 origin = source.startAt(sample[2], sample[3]),
               direction = source.direction(sample[0], sample[1]);
    const double weight = source.weight(direction);
    const auto [triangle, distance] = tracer.firstHit(origin, direction);
    all += weight;
    if (room.patchMet(origin, direction, triangle, distance) == kNone) lost += weight;
  }
  return all > 0 ? lost / all : 0;
}

double emittedFlux(const Patches& patches, const std::vector<Luminaire>& luminaires,
                   const std::vector<float>& emission) {
  double flux = 0;
  for (const Luminaire& luminaire : luminaires) flux += luminaire.flux;
  for (std::size_t p = 0; p < emission.size(); ++p) flux += patches.area[p] * emission[p];
  return flux;
}

/// Reflections: solves the radiosity system for one right-hand side and fills in what depends on it.
void reflect(const Room& room, const RayTracer& tracer, const ForwardOptions& options,
             const std::vector<float>& emission, ForwardLight& light) {
  const Patches& patches = room.patches;
  const FormFactors factors = castFormFactors(
      room, tracer,
      {options.rays, false, options.seed, options.threads, beginStage(options.progress, "form factors")});
  beginStage(options.progress, "interreflection");
  const LowRankRadiosity lowRank = orThrow(LowRankRadiosity::factorize(factors, patches));
  ResponseBlock block;
  block.width = 1;
  block.direct = light.direct;
  block.emission = emission;
  solveResponses(factors, patches, lowRank, options.steps, options.tolerance, block);
  light.illuminance = std::move(block.irradiance);
  light.radiosity = std::move(block.radiosity);
  light.residual = block.residuals.back();
  light.steps = static_cast<std::uint32_t>(block.residuals.size()) - 1;
  light.lost = lostShares(patches, room.surfaces.size(), factors);
  for (std::uint32_t p = 0; p < patches.count; ++p) {
    light.energy.absorbed += patches.area[p] * (1 - patches.reflectance[p]) * light.illuminance[p];
    light.energy.lostReflected += patches.area[p] * factors.lost[p] * light.radiosity[p];
  }
}

/// No reflections: what patches receive is lost to the room.
void absorbAll(const Room& room, ForwardLight& light) {
  const Patches& patches = room.patches;
  light.illuminance = light.direct;
  light.lost.assign(room.surfaces.size(), 0.0);
  for (std::uint32_t p = 0; p < patches.count; ++p) {
    light.radiosity.push_back(patches.reflectance[p] * light.direct[p]);
    light.energy.absorbed += patches.area[p] * light.direct[p];
  }
}

ForwardLight forwardLight(const Room& room, const RayTracer& tracer, const std::vector<Luminaire>& luminaires,
                          const ForwardOptions& options, const std::vector<float>& emission) {
  ForwardLight light;
  light.direct =
      sumOfDirectLight(room, tracer, luminaires, options, beginStage(options.progress, "direct light"));
  EnergyBalance& energy = light.energy;
  energy.emitted = emittedFlux(room.patches, luminaires, emission);
  const RaySequence sequence(kLostRays);
  for (std::size_t j = 0; j < luminaires.size(); ++j) {
    energy.lostDirect +=
        luminaires[j].flux * lostShare(room, tracer, luminaires[j], sequence, mixBits(options.seed) + j);
  }
  if (options.directOnly) {
    absorbAll(room, light);
  } else {
    reflect(room, tracer, options, emission, light);
  }
  energy.imbalance = energy.emitted - energy.absorbed - energy.lostDirect - energy.lostReflected;
  return light;
}

}  // namespace

std::vector<float> forwardDirectLight(const Room& room, const RayTracer& tracer,
                                      const std::vector<Luminaire>& luminaires, const ForwardOptions& options,
                                      const std::function<void(double)>& progress) {
  DirectLightOptions direct;
  direct.seed = options.seed;
  direct.threads = options.threads;
  direct.progress = progress;
  if (luminaires.size() <= kFewLuminaires) direct.split = kFinerSplit;
  return directLight(room, tracer, luminaires, direct);
}

Result<ForwardLight> computeForwardLight(const Room& room, const RayTracer& tracer,
                                         const std::vector<Luminaire>& luminaires,
                                         const ForwardOptions& options, const std::vector<float>& emission) {
  return atDoor([&] { return forwardLight(room, tracer, luminaires, options, emission); },
                "not enough memory for the light; pass a larger --patch");
}

}  // namespace fiatlux
