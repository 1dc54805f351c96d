#include "precompute/cast_form_factors.h"

#include <algorithm>
#include <limits>

#include "precompute/hemisphere.h"
#include "precompute/parallel.h"
#include "precompute/patch_sampler.h"
#include "precompute/ray_sequence.h"

namespace fiatlux {

namespace {

/// Casts the rays of one patch; hits[i] is the patch that ray i met.
void castRow(const Room& room, const RayTracer& tracer, const RaySequence& sequence, std::uint64_t seed,
             std::uint32_t row, std::uint32_t* hits) {
  const PatchSampler sampler(room, row);
  const auto scramble = RaySequence::scramble(seed ^ mixBits(row));
  Vec3 origin[RayPacket::kSize], direction[RayPacket::kSize];
  for (std::uint32_t first = 0; first < sequence.count(); first += RayPacket::kSize) {
    RayPacket packet;
    const std::uint32_t last = std::min(first + RayPacket::kSize, sequence.count());
    for (std::uint32_t i = first; i < last; ++i) {
      const auto sample = sequence.point(i, scramble);
      const PatchPoint point = sampler.at(sample[2], sample[3]);
      origin[i - first] = point.position + tracer.offset() * point.normal;
      direction[i - first] = cosineDirection(Frame(point.normal), sample[0], sample[1]);
      tracer.aim(packet, origin[i - first], direction[i - first], std::numeric_limits<float>::infinity());
    }
    HitPacket found;
    tracer.intersect(packet, found);
    for (std::uint32_t i = 0; i < packet.count; ++i) {
      hits[first + i] = tracer.patchOf(origin[i], direction[i], found.triangle[i], found.distance[i]);
    }
  }
}

}  // namespace

FormFactors castFormFactors(const Room& room, const RayTracer& tracer, const CastOptions& options) {
  const Patches& patches = room.patches;
  FormFactors factors;
  factors.rows = patches.rows();
  factors.count = patches.count;
  factors.clusters = patches.clusterCount;
  factors.rays = options.rays;
  factors.hits.resize(std::size_t{factors.rows} * options.rays);
  factors.u.resize(std::size_t{factors.count} * factors.clusters);

  const RaySequence sequence(options.rays);
  const std::uint64_t seed = mixBits(options.seed);
  constexpr std::uint32_t kRows = 32;  // a thread's portion
  const auto castRows = [&](std::size_t portion) {
    const auto first = static_cast<std::uint32_t>(portion) * kRows;
    for (std::uint32_t p = first; p < std::min(first + kRows, factors.rows); ++p) {
      std::uint32_t* hits = factors.hits.data() + std::size_t{p} * options.rays;
      castRow(room, tracer, sequence, seed, p, hits);
      std::sort(hits, hits + options.rays);
      if (p >= factors.count) continue;
      float* u = factors.u.data() + std::size_t{p} * factors.clusters;
      for (std::uint32_t i = 0; i < options.rays && hits[i] != kNone; ++i) u[patches.cluster[hits[i]]] += 1;
      for (std::uint32_t c = 0; c < factors.clusters; ++c) u[c] /= static_cast<float>(options.rays);
    }
  };
  parallelFor((factors.rows + kRows - 1) / kRows, options.threads, castRows, options.progress);
  return factors;
}

std::vector<double> lostShares(const Room& room, const FormFactors& factors) {
  std::vector<double> lost(room.surfaces.size(), 0.0), area(room.surfaces.size(), 0.0);
  for (std::uint32_t p = 0; p < factors.rows; ++p) {
    const std::uint32_t* hits = factors.hits.data() + std::size_t{p} * factors.rays;
    const auto gone =
        static_cast<double>(hits + factors.rays - std::lower_bound(hits, hits + factors.rays, kNone));
    lost[room.patches.surface[p]] += room.patches.area[p] * gone / factors.rays;
    area[room.patches.surface[p]] += room.patches.area[p];
  }
  for (std::size_t s = 0; s < lost.size(); ++s) lost[s] = area[s] > 0 ? lost[s] / area[s] : 0;
  return lost;
}

}  // namespace fiatlux
