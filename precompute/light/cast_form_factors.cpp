#include "precompute/light/cast_form_factors.h"

#include <algorithm>
#include <array>
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

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The least share of what its rays met that a row's estimate must see to be believed.
constexpr double kPlausible = 0.5;

/// The form factor that a shadow ray tells of.
constexpr double kOfRay = 5e-4, kOfDraftRay = 2e-3;

/// Of a row's rays, the share that goes as far as it takes. Where none of them is lost, and the kernels are
/// believed, the others need tell no more than which close patch they meet.
constexpr std::uint32_t kFarRays = 4;

/// What a ray met that was not to go further, if not a patch on its way.
constexpr std::uint32_t kBeyond = kNone - 1;

/// The `share`-th part of some rays, in whole packets.
std::uint32_t perPacket(std::uint32_t rays, std::uint32_t share) {
  const std::uint32_t portion = share * RayPacket::kSize;
  return (rays + portion - 1) / portion * RayPacket::kSize;
}

/// The rays of one patch, from the first on.
class RowRays {
 public:
  RowRays(const Room& room, const RayTracer& tracer, const PatchSampler& sampler, const RaySequence& sequence,
          std::uint64_t seed)
      : room_(room),
        tracer_(tracer),
        sampler_(sampler),
        sequence_(sequence),
        scramble_(RaySequence::scramble(seed)) {}

  /// Casts more of them until there are `count`, at most `reach` m far. hits()[i] is the patch that ray i
  /// met, kNone where it is lost.
  void castUpTo(std::uint32_t count, double reach) {
    for (auto first = static_cast<std::uint32_t>(hits_.size()); first < count; first += RayPacket::kSize)
      cast(first, std::min(count - first, RayPacket::kSize), reach);
  }

  std::vector<std::uint32_t>& hits() { return hits_; }
  bool isAnyLost() const { return std::find(hits_.begin(), hits_.end(), kNone) != hits_.end(); }

 private:
  void cast(std::uint32_t first, std::uint32_t count, double reach) {
    Vec3 origin[RayPacket::kSize], direction[RayPacket::kSize];
    RayPacket packet;
    const auto sample = sequence_.eightPoints(first, scramble_);
    const EightDirections way = cosineDirections(sample[0], sample[1]);
    for (std::uint32_t i = 0; i < count; ++i) {
      const PatchPoint point = sampler_.at(sample[2][i], sample[3][i]);
      const Frame frame(point.normal);
      origin[i] = point.position + tracer_.offset() * point.normal;
      direction[i] = double{way.x[i]} * frame.x + double{way.y[i]} * frame.y + double{way.z[i]} * frame.z;
      tracer_.aim(packet, origin[i], direction[i], reach);
    }
    HitPacket found;
    tracer_.intersect(packet, found);
    const bool isFar = reach == kInfinity;
    for (std::uint32_t i = 0; i < packet.count; ++i) {
      const bool isBeyond = !isFar && found.triangle[i] == kNone;
      hits_.push_back(
          isBeyond ? kBeyond : room_.patchMet(origin[i], direction[i], found.triangle[i], found.distance[i]));
    }
  }

  const Room& room_;
  const RayTracer& tracer_;
  const PatchSampler& sampler_;
  const RaySequence& sequence_;
  std::array<std::uint32_t, 4> scramble_;
  std::vector<std::uint32_t> hits_;
};

/// Leaves of the patches that rays met what the kernels do not tell.
void keepClose(std::uint32_t p, const KernelFactors& kernels, std::vector<std::uint32_t>& hits) {
  std::erase_if(hits, [&](std::uint32_t q) { return q == kBeyond || !kernels.tooClose(p, q); });
}

/// All that a row gets, if so many of its rays met a patch that the kernels do not tell.
double sumOf(const KernelFactors::Row& row, std::size_t hits, std::size_t rays) {
  double sum = static_cast<double>(hits) / static_cast<double>(rays);
  sum = std::accumulate(row.u.begin(), row.u.end(), sum);
  for (const NearPatch& near : row.near) sum += near.factor;
  return sum;
}

/// Where shadow rays saw far less than the rays met (a patch wedged into a corner, a sliver), the rays alone
/// are to be trusted. `hits`: of the first rays, however far.
bool isPlausible(std::uint32_t p, const KernelFactors& kernels, const KernelFactors::Row& row,
                 std::vector<std::uint32_t> hits) {
  const std::size_t rays = hits.size();
  const std::size_t met = rays - std::erase(hits, kNone);
  keepClose(p, kernels, hits);
  return sumOf(row, hits.size(), rays) > kPlausible * static_cast<double>(met) / static_cast<double>(rays);
}

/// Turns the rays of row p and what is known of its surroundings into its U, near patches and slopes.
/// `hits`: of all its rays; `cluster`: of each patch; kernels: nullptr where only rays count.
FormFactorRow finishedRow(std::uint32_t p, const std::vector<std::uint32_t>& cluster,
                          const KernelFactors* kernels, std::vector<std::uint32_t>& hits,
                          KernelFactors::Row row) {
  const std::size_t rays = hits.size();
  const std::size_t met = rays - std::erase(hits, kNone);
  const double found = static_cast<double>(met) / static_cast<double>(rays);
  if (kernels) keepClose(p, *kernels, hits);

  // One factor for all makes the row sum to what was not lost.
  const double sum = sumOf(row, hits.size(), rays);
  const auto scale = static_cast<float>(sum > 0 ? found / sum : 0);
  std::sort(hits.begin(), hits.end());
  const float oneRay = 1 / static_cast<float>(rays);
  for (std::size_t i = 0, j = 0; i < hits.size(); i = j) {
    while (j < hits.size() && hits[j] == hits[i]) ++j;
    row.near.push_back({hits[i], static_cast<float>(j - i) * oneRay});
  }
  std::sort(row.near.begin(), row.near.end(),
            [](const NearPatch& a, const NearPatch& b) { return a.patch < b.patch; });
  for (NearPatch& near : row.near) near.factor *= scale;
  for (float& u : row.u) u *= scale;
  for (const NearPatch& near : row.near) row.u[cluster[near.patch]] += near.factor;
  return {std::move(row.u), std::move(row.near), std::move(row.slopes), static_cast<float>(1 - found),
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
  const PatchSampler sampler(room, p);
  const std::uint32_t count = effort[p] * options.rays;
  RowRays rays(room, tracer, sampler, sequence, seed ^ mixBits(p));
  KernelFactors::Row row{std::vector<float>(room.patches.clusterCount, 0.0f), {}, {}, 1};
  bool isTold = false;  // by kernels
  double reach = kInfinity;
  if (kernels) {
    const std::uint32_t finer = std::clamp(options.rays / kUsualRays, 1u, kMostEffort);
    kernels->row(p, std::min(finer * effort[p], kMostEffort), sampler, row);
    rays.castUpTo(std::min(count, perPacket(count, kFarRays)), kInfinity);
    isTold = isPlausible(p, *kernels, row, rays.hits());
    if (isTold && !rays.isAnyLost()) reach = kernels->closeReach(p);
    if (!isTold) row = {std::vector<float>(row.u.size(), 0.0f), {}, {}, row.open};
  }
  rays.castUpTo(count, reach);
  return finishedRow(p, room.patches.cluster, isTold ? &*kernels : nullptr, rays.hits(), std::move(row));
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
