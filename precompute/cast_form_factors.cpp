#include "precompute/cast_form_factors.h"

#include <algorithm>
#include <limits>

#include "precompute/effort.h"
#include "precompute/far_field.h"
#include "precompute/hemisphere.h"
#include "precompute/parallel.h"
#include "precompute/patch_sampler.h"
#include "precompute/ray_sequence.h"

namespace fiatlux {

namespace {

/// The least share of what its rays met that a row's estimate must see to be believed.
constexpr double kPlausible = 0.5;

/// Casts the rays of one patch; hits[i] is the patch that ray i met.
void castRays(const RayTracer& tracer, const PatchSampler& sampler, const RaySequence& sequence,
              std::uint64_t seed, std::uint32_t rays, std::uint32_t* hits) {
  const auto scramble = RaySequence::scramble(seed);
  Vec3 origin[RayPacket::kSize], direction[RayPacket::kSize];
  for (std::uint32_t first = 0; first < rays; first += RayPacket::kSize) {
    RayPacket packet;
    const std::uint32_t last = std::min(first + RayPacket::kSize, rays);
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

/// Turns the rays of row p into its U, its hits and their weight; `ranges` and `u` come from FarField::row.
void finishRow(FormFactors& factors, std::uint32_t p, std::vector<FarField::Range>& ranges, float* u) {
  std::uint32_t* hits = factors.hits.data() + factors.hitOffset[p];
  std::uint32_t* end = factors.hits.data() + factors.hitOffset[p + 1];
  const auto rays = static_cast<double>(end - hits);
  const auto rangeOf = [&](std::uint32_t q) { return ranges[factors.cluster[q]]; };
  std::uint32_t* met = std::remove(hits, end, kNone);
  const auto lost = static_cast<double>(end - met) / rays;

  // Where shadow rays saw far less than the rays met (a patch wedged into a corner, a sliver), trust the rays
  // alone.
  double seen = 0;
  for (std::uint32_t c = 0; c < factors.clusters; ++c) seen += u[c];
  seen += static_cast<double>(std::count_if(
              hits, met, [&](std::uint32_t q) { return rangeOf(q) == FarField::Range::kNear; })) /
          rays;
  if (!(seen > kPlausible * (1 - lost))) {
    std::fill(u, u + factors.clusters, 0.0f);
    std::fill(ranges.begin(), ranges.end(), FarField::Range::kNear);
  }
  std::uint32_t* kept =
      std::remove_if(hits, met, [&](std::uint32_t q) { return rangeOf(q) == FarField::Range::kFar; });
  std::sort(hits, kept);
  std::fill(kept, end, kNone);

  // One factor for near and far alike makes the row sum to what was not lost.
  const auto near =
      std::count_if(hits, kept, [&](std::uint32_t q) { return rangeOf(q) == FarField::Range::kNear; });
  double sum = static_cast<double>(near) / rays;
  for (std::uint32_t c = 0; c < factors.clusters; ++c) sum += u[c];
  const double scale = sum > 0 ? (1 - lost) / sum : 0;
  for (std::uint32_t c = 0; c < factors.clusters; ++c) u[c] = static_cast<float>(scale * u[c]);
  factors.lost[p] = static_cast<float>(lost);
  factors.hitWeight[p] = static_cast<float>(scale / rays);
  for (const std::uint32_t* hit = hits; hit < kept; ++hit) {
    if (rangeOf(*hit) == FarField::Range::kNear) u[factors.cluster[*hit]] += factors.hitWeight[p];
  }
}

/// Sizes everything and fills in V.
FormFactors emptyFactors(const Patches& patches, const std::vector<std::uint32_t>& rays) {
  FormFactors factors;
  factors.rows = patches.rows();
  factors.count = patches.count;
  factors.clusters = patches.clusterCount;
  factors.cluster.assign(patches.cluster.begin(), patches.cluster.begin() + patches.count);
  std::vector<double> clusterArea(patches.clusterCount, 0.0);
  for (std::uint32_t q = 0; q < patches.count; ++q) clusterArea[patches.cluster[q]] += patches.area[q];
  for (std::uint32_t q = 0; q < patches.count; ++q) {
    factors.share.push_back(patches.area[q] / clusterArea[patches.cluster[q]]);
  }
  factors.u.resize(std::size_t{factors.rows} * factors.clusters);
  factors.hitOffset.push_back(0);
  for (const std::uint32_t count : rays) factors.hitOffset.push_back(factors.hitOffset.back() + count);
  factors.hits.resize(factors.hitOffset.back());
  factors.hitWeight.resize(factors.rows);
  factors.lost.resize(factors.rows);
  return factors;
}

}  // namespace

FormFactors castFormFactors(const Room& room, const RayTracer& tracer, const CastOptions& options) {
  const std::vector<std::uint32_t> effort =
      options.plain ? std::vector<std::uint32_t>(room.patches.rows(), 1) : effortOfRows(room.patches);
  std::vector<std::uint32_t> rays;
  for (const std::uint32_t factor : effort) rays.push_back(factor * options.rays);
  FormFactors factors = emptyFactors(room.patches, rays);
  const RaySequence sequence(rays.empty() ? 0 : *std::max_element(rays.begin(), rays.end()));
  const std::uint64_t seed = mixBits(options.seed);
  const FarField farField(room, tracer, seed);
  constexpr std::uint32_t kRows = 32;  // a thread's portion
  const auto castRows = [&](std::size_t portion) {
    std::vector<FarField::Range> ranges(factors.clusters, FarField::Range::kNear);
    const auto first = static_cast<std::uint32_t>(portion) * kRows;
    for (std::uint32_t p = first; p < std::min(first + kRows, factors.rows); ++p) {
      const PatchSampler sampler(room, p);
      float* u = factors.u.data() + std::size_t{p} * factors.clusters;
      castRays(tracer, sampler, sequence, seed ^ mixBits(p), rays[p],
               factors.hits.data() + factors.hitOffset[p]);
      if (!options.plain) farField.row(p, effort[p], sampler, ranges, u);
      finishRow(factors, p, ranges, u);
    }
  };
  parallelFor((factors.rows + kRows - 1) / kRows, options.threads, castRows, options.progress);
  return factors;
}

std::vector<double> lostShares(const Patches& patches, std::size_t surfaces, const FormFactors& factors) {
  std::vector<double> lost(surfaces, 0.0), area(surfaces, 0.0);
  for (std::uint32_t p = 0; p < factors.rows; ++p) {
    lost[patches.surface[p]] += patches.area[p] * factors.lost[p];
    area[patches.surface[p]] += patches.area[p];
  }
  for (std::size_t s = 0; s < surfaces; ++s) lost[s] = area[s] > 0 ? lost[s] / area[s] : 0;
  return lost;
}

}  // namespace fiatlux
