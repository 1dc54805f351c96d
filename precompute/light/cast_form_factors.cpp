#include "precompute/light/cast_form_factors.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

#include "precompute/base/parallel.h"
#include "precompute/light/kernel_factors.h"
#include "precompute/light/open_shares.h"
#include "precompute/rays/hemisphere.h"
#include "precompute/rays/patch_sampler.h"
#include "precompute/rays/ray_sequence.h"

namespace fiatlux {

namespace {

/// The least share of what its rays met that a row's estimate must see to be believed.
constexpr double kPlausible = 0.5;

/// The form factor that a shadow ray tells of.
constexpr double kOfRay = 5e-4, kOfDraftRay = 2e-3;

/// Casts `rays` rays of one patch; hits[i] is the patch that ray i met.
void castRays(const Room& room, const RayTracer& tracer, const PatchSampler& sampler,
              const RaySequence& sequence, std::uint64_t seed, std::uint32_t rays,
              std::vector<std::uint32_t>& hits) {
  hits.resize(rays);
  const auto scramble = RaySequence::scramble(seed);
  Vec3 origin[RayPacket::kSize], direction[RayPacket::kSize];
  for (std::uint32_t first = 0; first < rays; first += RayPacket::kSize) {
    RayPacket packet;
    const std::uint32_t count = std::min(rays - first, RayPacket::kSize);
    const auto sample = sequence.eightPoints(first, scramble);
    const EightDirections way = cosineDirections(sample[0], sample[1]);
    for (std::uint32_t i = 0; i < count; ++i) {
      const PatchPoint point = sampler.at(sample[2][i], sample[3][i]);
      const Frame frame(point.normal);
      origin[i] = point.position + tracer.offset() * point.normal;
      direction[i] = double{way.x[i]} * frame.x + double{way.y[i]} * frame.y + double{way.z[i]} * frame.z;
      tracer.aim(packet, origin[i], direction[i], std::numeric_limits<float>::infinity());
    }
    HitPacket found;
    tracer.intersect(packet, found);
    for (std::uint32_t i = 0; i < packet.count; ++i) {
      hits[first + i] = room.patchMet(origin[i], direction[i], found.triangle[i], found.distance[i]);
    }
  }
}

/// Turns the rays of row p and what is known of its surroundings into its U, near patches and slopes.
/// `hits`: of all its rays, kNone where lost; `cluster`: of each patch; kernels: nullptr where only rays
/// count.
FormFactorRow finishedRow(std::uint32_t p, const std::vector<std::uint32_t>& cluster,
                          const KernelFactors* kernels, std::vector<std::uint32_t>& hits,
                          KernelFactors::Row row) {
  const auto rays = static_cast<double>(hits.size());
  std::erase(hits, kNone);
  const auto met = static_cast<double>(hits.size());
  const auto sumOf = [&](double rayHits) {
    double sum = std::accumulate(row.u.begin(), row.u.end(), rayHits / rays);
    for (const NearPatch& near : row.near) sum += near.factor;
    return sum;
  };

  // Where shadow rays saw far less than the rays met (a patch wedged into a corner, a sliver), trust the rays
  // alone.
  const auto isClose = [&](std::uint32_t q) { return !kernels || kernels->tooClose(p, q); };
  const auto away = std::partition(hits.begin(), hits.end(), isClose);
  if (sumOf(static_cast<double>(away - hits.begin())) > kPlausible * met / rays) {
    hits.erase(away, hits.end());
  } else {
    row = {std::vector<float>(row.u.size(), 0.0f), {}, {}, row.open};
  }

  // One factor for all makes the row sum to what was not lost.
  const double sum = sumOf(static_cast<double>(hits.size()));
  const auto scale = static_cast<float>(sum > 0 ? met / rays / sum : 0);
  std::sort(hits.begin(), hits.end());
  const auto oneRay = static_cast<float>(1 / rays);
  for (std::size_t i = 0, j = 0; i < hits.size(); i = j) {
    while (j < hits.size() && hits[j] == hits[i]) ++j;
    row.near.push_back({hits[i], static_cast<float>(j - i) * oneRay});
  }
  std::sort(row.near.begin(), row.near.end(),
            [](const NearPatch& a, const NearPatch& b) { return a.patch < b.patch; });
  for (NearPatch& near : row.near) {
    near.factor *= scale;
  }
  for (float& u : row.u) u *= scale;
  for (const NearPatch& near : row.near) row.u[cluster[near.patch]] += near.factor;
  return {std::move(row.u), std::move(row.near), std::move(row.slopes), static_cast<float>(1 - met / rays),
          row.open};
}

/// Sizes everything but near patches and slopes, and fills in V.
FormFactors emptyFactors(const Patches& patches) {
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
  factors.near.resize(factors.rows);
  factors.slopes.resize(factors.rows);
  factors.lost.resize(factors.rows);
  factors.open.resize(factors.rows, 1.0f);
  return factors;
}

}  // namespace

struct FormFactorCaster::Parts {
  const Room& room;
  const RayTracer& tracer;
  CastOptions options;
  std::vector<std::uint32_t> effort;  // rows
  std::uint64_t seed = 0;
  RaySequence sequence;
  std::optional<KernelFactors> kernels;
};

FormFactorCaster::FormFactorCaster(const Room& room, const RayTracer& tracer, const CastOptions& options) {
  std::vector<std::uint32_t> effort = effortOfRows(room.patches, options.plain || options.draft);
  const std::uint32_t most = effort.empty() ? 0 : *std::max_element(effort.begin(), effort.end());
  const std::uint64_t seed = mixBits(options.seed);
  parts_.reset(
      new Parts{room, tracer, options, std::move(effort), seed, RaySequence(most * options.rays), {}});
  if (!options.plain) parts_->kernels.emplace(room, tracer, seed, options.draft ? kOfDraftRay : kOfRay);
}
FormFactorCaster::FormFactorCaster(FormFactorCaster&&) noexcept = default;
FormFactorCaster::~FormFactorCaster() = default;

FormFactorRow FormFactorCaster::row(std::uint32_t p) const {
  const auto& [room, tracer, options, effort, seed, sequence, kernels] = *parts_;
  const std::uint32_t finer = std::clamp(options.rays / kUsualRays, 1u, kMostEffort);
  const PatchSampler sampler(room, p);
  std::vector<std::uint32_t> hits;
  castRays(room, tracer, sampler, sequence, seed ^ mixBits(p), effort[p] * options.rays, hits);
  KernelFactors::Row row{std::vector<float>(room.patches.clusterCount, 0.0f), {}, {}, 1};
  if (kernels) {
    kernels->row(p, std::min(finer * effort[p], kMostEffort), sampler, row);
  }
  return finishedRow(p, room.patches.cluster, kernels ? &*kernels : nullptr, hits, std::move(row));
}

FormFactors FormFactorCaster::withoutRows() const {
  FormFactors factors = emptyFactors(parts_->room.patches);
  if (parts_->kernels) factors.slopeShare = parts_->kernels->slopeShare();
  return factors;
}

void FormFactorCaster::complete(FormFactors& factors) const {
  if (parts_->kernels) weighByOpenness(parts_->room, parts_->kernels->clusters(), factors);
}

void setRow(FormFactors& factors, std::uint32_t p, const FormFactorRow& row) {
  std::copy(row.u.begin(), row.u.end(), factors.u.begin() + std::size_t{p} * factors.clusters);
  factors.near[p] = row.near;
  factors.slopes[p] = row.slopes;
  factors.lost[p] = row.lost;
  factors.open[p] = row.open;
}

FormFactors castFormFactors(const Room& room, const RayTracer& tracer, const CastOptions& options) {
  const FormFactorCaster caster(room, tracer, options);
  FormFactors factors = caster.withoutRows();
  constexpr std::uint32_t kRows = 32;  // a thread's portion
  const auto castRows = [&](std::uint32_t first, std::uint32_t end) {
    for (std::uint32_t p = first; p < end; ++p) setRow(factors, p, caster.row(p));
  };
  parallelPortions(factors.rows, kRows, options.threads, castRows, options.progress);
  caster.complete(factors);
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
