#include "precompute/light/kernel_factors.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "precompute/rays/effort.h"
#include "precompute/rays/ray_sequence.h"

namespace fiatlux {

namespace {

// Distances between patch and cluster, in edges of both: from the first on one point of a part is a fair
// quadrature, from the second on the light's spread within the cluster no longer matters.
constexpr double kNearEdges = 2, kFarEdges = 8;
// Distance between two patches, in edges of both, from which on Gauss's 2 x 2 points of each are a fair
// quadrature.
constexpr double kCloseEdges = 1.5;
constexpr float kDeep = 0.4f;  // share of distant light that arrives in what counts as a deep place
constexpr std::uint32_t kLastSlope = std::numeric_limits<std::uint16_t>::max();

std::int8_t inSlopeUnits(double slope) {
  return static_cast<std::int8_t>(std::lround(kSlopeUnit * std::clamp(slope, -1.0, 1.0)));
}

/// Power that a small piece of surface at one end of d, from `leaving` to `arriving`, sends to a unit of area
/// at the other: cos cos / (pi r^2), 0 where they face away.
double kernel(const Vec3& d, const Vec3& leaving, const Vec3& arriving) {
  const double out = dot(d, leaving), in = -dot(d, arriving);
  if (out <= 0 || in <= 0) return 0;
  const double squared = dot(d, d);
  return out * in / (std::numbers::pi * squared * squared);
}

}  // namespace

KernelFactors::KernelFactors(const Room& room, const RayTracer& tracer, std::uint64_t seed)
    : room_(room),
      tracer_(tracer),
      seed_(seed),
      sequence_(kMostRays),
      clusters_(room),
      between_(tracer, placesOfClusters(room, tracer), placesOfClusters(room, tracer)),
      firstPatch_(static_cast<std::uint32_t>(clusters_.parts().size())) {
  const Patches& patches = room.patches;
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    double radius = 0;
    for (const Fragment& fragment : room.fragmentsOf(p)) {
      for (const Vec3& corner : fragment.corner)
        radius = std::max(radius, length(corner - patches.center[p]));
    }
    patchReach_.push_back(squareReach(patches.area[p], radius));
    if (p >= patches.count) continue;
    samplers_.emplace_back(room, p);
    const std::vector<PatchPoint> points = samplers_[p].quadrature(2);
    std::copy_n(points.begin(), kGauss, gauss_.emplace_back().begin());
  }
}

double KernelFactors::edgesTo(std::uint32_t p, std::uint32_t cluster) const {
  const Patches& patches = room_.patches;
  return length(clusters_.centerOf(cluster) - patches.center[p]) /
         (clusters_.reachOf(cluster) + std::sqrt(patches.area[p]));
}

bool KernelFactors::tooClose(std::uint32_t p, std::uint32_t q) const {
  const Patches& patches = room_.patches;
  if (edgesTo(p, patches.cluster[q]) >= kNearEdges) return false;
  return length(patches.center[q] - patches.center[p]) < kCloseEdges * (patchReach_[p] + patchReach_[q]);
}

/// A point of a part or patch, uniform by area: the first number chooses the patch of a part, what is left of
/// it the place there.
PatchPoint KernelFactors::pointOn(std::uint32_t item, double u, double v) const {
  if (item >= firstPatch_) return samplers_[item - firstPatch_].at(u, v);
  const ClusterPart& part = clusters_.parts()[item];
  const std::vector<double>& area = room_.patches.area;
  double along = u * part.area;
  std::size_t chosen = 0;
  while (chosen + 1 < part.members.size() && along >= area[part.members[chosen]])
    along -= area[part.members[chosen++]];
  const std::uint32_t q = part.members[chosen];
  return samplers_[q].at(std::min(along / area[q], 1 - 1e-9), v);
}

/// What is known of all rays from a row's cluster to another. note: a shaft of the row's own costs more than
/// the few rays that it would save.
Between KernelFactors::between(std::uint32_t p, std::uint32_t cluster) const {
  if (p >= room_.patches.count) return Between::kUnknown;
  const std::uint32_t own = room_.patches.cluster[p];
  return between_.at(std::min(own, cluster), std::max(own, cluster));
}

/// Adds the parts of a distant cluster, or the patches of another one that are not too close, that the row
/// can see at all.
void KernelFactors::addCandidates(std::uint32_t p, const std::vector<PatchPoint>& points, std::uint32_t c,
                                  std::vector<Candidate>& candidates) const {
  const Patches& patches = room_.patches;
  if (edgesTo(p, c) >= kNearEdges) {
    for (std::uint32_t i = clusters_.firstOf(c); i < clusters_.firstOf(c + 1); ++i) {
      const ClusterPart& part = clusters_.parts()[i];
      const double factor =
          part.area * kernel(part.center - patches.center[p], patches.normal[p], part.normal);
      if (factor > 0) candidates.push_back({i, c, factor});
    }
    return;
  }
  for (const std::uint32_t q : clusters_.membersOf(c)) {
    if (tooClose(p, q)) continue;
    double factor = 0;
    for (const PatchPoint& from : points) {
      for (const PatchPoint& to : gauss_[q])
        factor += from.weight * to.weight * kernel(to.position - from.position, from.normal, to.normal);
    }
    factor *= patches.area[q];
    if (factor > 0) candidates.push_back({firstPatch_ + q, c, factor});
  }
}

/// All that the row may see, by cluster.
std::vector<KernelFactors::Candidate> KernelFactors::candidatesOf(std::uint32_t p,
                                                                  const PatchSampler& sampler) const {
  const std::vector<PatchPoint> points = sampler.quadrature(2);
  std::vector<Candidate> candidates;
  for (std::uint32_t c = 0; c < room_.patches.clusterCount; ++c) {
    const std::size_t first = candidates.size();
    addCandidates(p, points, c, candidates);
    if (candidates.size() == first) continue;
    const Between known = between(p, c);
    if (known == Between::kWall)
      candidates.erase(candidates.begin() + static_cast<std::ptrdiff_t>(first), candidates.end());
    for (std::size_t i = first; i < candidates.size(); ++i)
      candidates[i].isClear = known == Between::kNothing;
  }
  return candidates;
}

/// Rays from all over the patch to all over each candidate: both ends share a four-dimensional sequence, so
/// few rays already cover both, and what hides a cluster from one side of the patch only (a picture's frame)
/// is not mistaken.
void KernelFactors::castShadows(std::uint64_t seed, std::uint32_t rays, const PatchSampler& sampler,
                                std::size_t first, std::size_t last,
                                std::vector<Candidate>& candidates) const {
  RayPacket packet;
  std::size_t lane[RayPacket::kSize];
  double carried[RayPacket::kSize];
  const auto flush = [&] {
    bool blocked[RayPacket::kSize];
    tracer_.occluded(packet, blocked);
    for (std::uint32_t i = 0; i < packet.count; ++i) {
      if (blocked[i]) continue;
      ++candidates[lane[i]].visible;
      candidates[lane[i]].arrived += carried[i];
    }
    packet.count = 0;
  };

  // Eight rays go together, of whichever candidates they are.
  for (std::size_t i = first; i < last; ++i) {
    Candidate& candidate = candidates[i];
    if (candidate.isClear) continue;
    const auto scramble = RaySequence::scramble(mixBits(seed ^ candidate.item));
    const double area = areaOf(candidate.item);
    candidate.visible = 0;
    candidate.arrived = 0;
    candidate.asked = raysTo(candidate.item, rays);
    for (std::uint32_t ray = 0; ray < candidate.asked; ++ray) {
      const auto sample = sequence_.point(ray, scramble);
      const PatchPoint from = sampler.at(sample[2], sample[3]),
                       to = pointOn(candidate.item, sample[0], sample[1]);
      const Vec3 origin = from.position + tracer_.offset() * from.normal;
      lane[packet.count] = i;
      carried[packet.count] = area * kernel(to.position - from.position, from.normal, to.normal);
      tracer_.aim(packet, origin, to.position + tracer_.offset() * to.normal - origin, 1);
      if (packet.count == RayPacket::kSize) flush();
    }
  }
  if (packet.count > 0) flush();
}

double KernelFactors::factorOf(const Candidate& candidate) {
  // note: not kernel x visible share, for what is hidden may be the part that would give most.
  return candidate.visible == candidate.asked ? candidate.kernel : candidate.arrived / candidate.asked;
}

/// Of all distant clusters together.
float KernelFactors::openOf(const std::vector<Candidate>& candidates) const {
  double arrives = 0, all = 0;
  for (const Candidate& candidate : candidates) {
    if (candidate.item >= firstPatch_) continue;
    arrives += factorOf(candidate);
    all += candidate.kernel;
  }
  return all > 0 ? static_cast<float>(arrives / all) : 1.0f;
}

/// Writes down what row p gets from one cluster.
void KernelFactors::write(const Candidate* first, const Candidate* last, std::uint32_t p, Row& row) const {
  double sum = 0, leanU = 0, leanV = 0;
  for (const Candidate* candidate = first; candidate < last; ++candidate) {
    const double factor = factorOf(*candidate);
    if (factor > 0 && candidate->item >= firstPatch_) {
      row.near.push_back({candidate->item - firstPatch_, static_cast<float>(factor)});
    } else if (factor > 0) {
      const ClusterPart& part = clusters_.parts()[candidate->item];
      sum += factor;
      leanU += factor * part.u;
      leanV += factor * part.v;
    }
  }
  if (!(sum > 0)) return;
  const std::uint32_t cluster = first->cluster;
  row.u[cluster] = static_cast<float>(sum);
  if (cluster <= kLastSlope && edgesTo(p, cluster) < kFarEdges)
    row.slopes.push_back(
        {static_cast<std::uint16_t>(cluster), inSlopeUnits(leanU / sum), inSlopeUnits(leanV / sum)});
}

void KernelFactors::row(std::uint32_t p, std::uint32_t effort, const PatchSampler& sampler,
                        const std::vector<bool>& isMet, Row& row) const {
  assert(effort >= 1 && effort <= kMostEffort);
  row.u.assign(room_.patches.clusterCount, 0.0f);
  row.slopes.clear();
  row.near.clear();
  std::vector<Candidate> candidates = candidatesOf(p, sampler);

  const std::uint64_t seed = mixBits(seed_ ^ (std::uint64_t{p} << 32));
  const std::uint32_t few = effort, many = effort * std::max(4u, effort);  // kMostRays at most
  castShadows(seed, few, sampler, 0, candidates.size(), candidates);

  // A cluster that is seen in part is asked again, more often. So is, where little is open, one that no
  // shadow ray has seen but another ray has met: what comes through narrow gaps is most of the light there,
  // and was missed, so that deep shelves were 4 % too dark.
  const bool isDeep = openOf(candidates) < kDeep;
  for (std::size_t first = 0, last = 0; first < candidates.size(); first = last) {
    std::uint32_t seen = 0, asked = 0;
    for (last = first; last < candidates.size() && candidates[last].cluster == candidates[first].cluster;
         ++last) {
      seen += candidates[last].visible;
      asked += candidates[last].asked;
    }
    const bool isSeen = seen > 0 || (isDeep && isMet[candidates[first].cluster]);
    if (isSeen && seen < asked) castShadows(mixBits(seed), many, sampler, first, last, candidates);
    write(candidates.data() + first, candidates.data() + last, p, row);
  }
  row.open = openOf(candidates);
}

}  // namespace fiatlux
