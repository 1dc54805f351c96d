#include "precompute/light/kernel_factors.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

#include "precompute/light/brightest.h"
#include "precompute/light/kernel.h"
#include "precompute/rays/effort.h"
#include "precompute/rays/ray_sequence.h"

namespace fiatlux {

namespace {

// Distances between patch and cluster, in edges of both: from the first on one point of a part is a fair
// quadrature, from the second on the light's spread within the cluster no longer matters.
constexpr double kNearEdges = 2, kFarEdges = 8;
// Distances between two patches, in edges of both, from which on Gauss's 2 x 2 points of each are a fair
// quadrature, and their centres.
constexpr double kCloseEdges = 1.5, kCenterEdges = 3;
// Rays to one cluster for each of the row's.
constexpr std::uint32_t kMostOfCluster = 256;
// So many rays to a cluster tell as much each as a single one.
constexpr double kFewRays = 8;
// The form factor that gets a ray at least: of smaller clusters in a row one stands for the others.
constexpr double kLeastAsked = 1.25e-4;
constexpr std::uint32_t kLastSlope = std::numeric_limits<std::uint16_t>::max();

std::int8_t inSlopeUnits(double slope) {
  return static_cast<std::int8_t>(std::lround(kSlopeUnit * std::clamp(slope, -1.0, 1.0)));
}

/// How many times as many rays a row of some effort gets: surfaces of few patches average over little.
constexpr std::uint32_t timesOf(std::uint32_t effort) { return effort + effort * effort / 8; }

}  // namespace

KernelFactors::KernelFactors(const Room& room, const RayTracer& tracer, std::uint64_t seed, double ofRay)
    : room_(room),
      tracer_(tracer),
      seed_(seed),
      ofRay_(ofRay),
      sequence_(timesOf(kMostEffort) * kMostOfCluster),
      clusters_(room),
      brightness_(brightestByMean(room, clusters_)),
      between_(tracer, placesOfClusters(room, tracer), placesOfClusters(room, tracer)),
      partKernels_(clusters_),
      points_(room, tracer.center()),
      firstPatch_(static_cast<std::uint32_t>(clusters_.parts().size())) {
  for (const ClusterPart& part : clusters_.parts()) points_.add(part.members);
  const Patches& patches = room.patches;
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    double radius = 0;
    for (const Fragment& fragment : room.fragmentsOf(p)) {
      for (const Vec3& corner : fragment.corner)
        radius = std::max(radius, length(corner - patches.center[p]));
    }
    edge_.push_back(std::sqrt(patches.area[p]));
    patchReach_.push_back(squareReach(patches.area[p], radius));
    points_.add({&p, 1});
    if (p >= patches.count) continue;
    mostReach_ = std::max(mostReach_, patchReach_.back());
    const std::vector<PatchPoint> points = PatchSampler(room, p).quadrature(2);
    std::copy_n(points.begin(), kGauss, gauss_.emplace_back().begin());
  }
}

bool KernelFactors::isWithin(double edges, std::uint32_t p, std::uint32_t cluster) const {
  const Vec3 d = clusters_.centerOf(cluster) - room_.patches.center[p];
  const double reach = edges * (clusters_.reachOf(cluster) + edge_[p]);
  return dot(d, d) < reach * reach;
}

bool KernelFactors::areWithin(double edges, std::uint32_t p, std::uint32_t q) const {
  const Vec3 d = room_.patches.center[q] - room_.patches.center[p];
  const double reach = edges * (patchReach_[p] + patchReach_[q]);
  return dot(d, d) < reach * reach;
}

bool KernelFactors::tooClose(std::uint32_t p, std::uint32_t q) const {
  return isWithin(kNearEdges, p, room_.patches.cluster[q]) && areWithin(kCloseEdges, p, q);
}

double KernelFactors::closeReach(std::uint32_t p) const {
  // From centre to centre, and from each to the corners.
  return (kCloseEdges + 1 / std::numbers::sqrt2) * (patchReach_[p] + mostReach_);
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
void KernelFactors::addCandidates(std::uint32_t p, const std::vector<PatchPoint>& points,
                                  const std::vector<float>& ofParts, std::uint32_t c,
                                  std::vector<Candidate>& candidates) const {
  const Patches& patches = room_.patches;
  if (!isWithin(kNearEdges, p, c)) {
    for (std::uint32_t i = clusters_.firstOf(c); i < clusters_.firstOf(c + 1); ++i)
      if (ofParts[i] > 0) candidates.push_back({i, ofParts[i]});
    return;
  }
  for (const std::uint32_t q : clusters_.membersOf(c)) {
    if (areWithin(kCloseEdges, p, q)) continue;
    double factor = 0;
    if (areWithin(kCenterEdges, p, q)) {
      for (const PatchPoint& from : points) {
        for (const PatchPoint& to : gauss_[q])
          factor += from.weight * to.weight * kernel(to.position - from.position, from.normal, to.normal);
      }
    } else {
      factor = kernel(patches.center[q] - patches.center[p], patches.normal[p], patches.normal[q]);
    }
    factor *= patches.area[q];
    if (factor > 0) candidates.push_back({firstPatch_ + q, static_cast<float>(factor)});
  }
}

/// In proportion to the light that the cluster may send; of many fewer, for they fill cluster and patch so
/// evenly that each tells more.
double KernelFactors::raysTo(const Group& group, std::uint32_t effort) const {
  const double wanted = brightness_[group.cluster] * group.kernel / ofRay_;
  const double rays = timesOf(effort) * std::min(wanted, double{kMostOfCluster});
  if (rays <= kFewRays) return rays;
  const double times = rays / kFewRays;
  return kFewRays * std::sqrt(times * std::sqrt(times));
}

/// Gives the cluster its rays, or none where `due`, how much of a ray the clusters so far have left over,
/// does not come to one.
void KernelFactors::ask(Group& group, std::uint32_t effort, double& due) const {
  const double wanted = raysTo(group, effort);
  due += std::min(1.0, wanted * ofRay_ / kLeastAsked);
  group.isAlike = due < 1;
  if (group.isAlike) return;
  due -= 1;
  group.rays = std::max(1u, static_cast<std::uint32_t>(std::lround(wanted)));
}

/// All that the row may see.
KernelFactors::Faced KernelFactors::facedBy(std::uint32_t p, std::uint32_t effort,
                                            const PatchSampler& sampler) const {
  const std::vector<PatchPoint> points = sampler.quadrature(2);
  std::vector<float> ofParts;
  partKernels_.at(room_.patches.center[p], room_.patches.normal[p], ofParts);
  Faced faced;
  faced.candidates.reserve(firstPatch_);
  faced.groups.reserve(room_.patches.clusterCount);
  // Equal steps from a random first one here, too.
  double due = 0x1p-64 * static_cast<double>(mixBits(seed_ ^ ~(std::uint64_t{p} << 32)));
  for (std::uint32_t c = 0; c < room_.patches.clusterCount; ++c) {
    Group group{c, faced.candidates.size(), 0};
    addCandidates(p, points, ofParts, c, faced.candidates);
    group.last = faced.candidates.size();
    if (group.last == group.first) continue;
    const Between known = between(p, c);
    if (known == Between::kWall) {
      faced.candidates.resize(group.first);
      continue;
    }
    for (std::size_t i = group.first; i < group.last; ++i) group.kernel += faced.candidates[i].kernel;
    if (known == Between::kUnknown) ask(group, effort, due);
    faced.groups.push_back(group);
  }
  return faced;
}

/// Eight shadow rays at a time, of whichever clusters they are, and what of their light arrives.
class KernelFactors::ShadowRays {
 public:
  explicit ShadowRays(const KernelFactors& of)
      : of_(of), offset_(static_cast<float>(of.tracer_.offset())), center_(of.tracer_.center()) {}

  void add(Candidate& candidate, std::uint32_t cluster, const PatchSets::Point& from,
           const PatchSets::Point& to) {
    const std::uint32_t i = rays_.count++;
    float* const origin[3]{rays_.originX, rays_.originY, rays_.originZ};
    float* const direction[3]{rays_.directionX, rays_.directionY, rays_.directionZ};
    for (int axis = 0; axis < 3; ++axis) {
      from_[axis][i] = from.normal[axis];
      to_[axis][i] = to.normal[axis];
      origin[axis][i] = from.position[axis] + offset_ * from.normal[axis];
      direction[axis][i] = to.position[axis] + offset_ * to.normal[axis] - origin[axis][i];
    }
    rays_.reach[i] = 1;
    candidate_[i] = &candidate;
    cluster_[i] = cluster;
    if (rays_.count == RayPacket::kSize) flush();
  }

  void flush() {
    if (rays_.count == 0) return;
    bool blocked[RayPacket::kSize];
    of_.tracer_.occluded(rays_, blocked);
    alignas(32) float kernel[RayPacket::kSize];
    const Float8 each = kernels();
    std::memcpy(kernel, &each, sizeof kernel);
    for (std::uint32_t i = 0; i < rays_.count; ++i)
      if (!blocked[i]) arrive(i, kernel[i]);
    rays_.count = 0;
  }

 private:
  /// Of a unit of area.
  Float8 kernels() const {
    const EightVectors leaving{load8(from_[0]), load8(from_[1]), load8(from_[2])},
        arriving{load8(to_[0]), load8(to_[1]), load8(to_[2])};
    const EightVectors d{load8(rays_.directionX) + offset_ * (leaving.x - arriving.x),
                         load8(rays_.directionY) + offset_ * (leaving.y - arriving.y),
                         load8(rays_.directionZ) + offset_ * (leaving.z - arriving.z)};
    return eightKernels(d, leaving, arriving);
  }

  void arrive(std::uint32_t i, float kernel) {
    Candidate& candidate = *candidate_[i];
    const float factor = static_cast<float>(of_.areaOf(candidate.item)) * kernel;  // that the ray stands for
    ++candidate.visible;
    candidate.arrived += factor;
    if (candidate.item >= of_.firstPatch_) return;
    const Vec3 met{rays_.originX[i] + rays_.directionX[i], rays_.originY[i] + rays_.directionY[i],
                   rays_.originZ[i] + rays_.directionZ[i]};
    const ClusterParts::Place place = of_.clusters_.placeAt(cluster_[i], center_ + met);
    candidate.leanU += factor * static_cast<float>(place.u);
    candidate.leanV += factor * static_cast<float>(place.v);
  }

  const KernelFactors& of_;
  float offset_;  // m
  Vec3 center_;   // m
  RayPacket rays_;
  alignas(32) float from_[3][RayPacket::kSize], to_[3][RayPacket::kSize];  // normals
  Candidate* candidate_[RayPacket::kSize];
  std::uint32_t cluster_[RayPacket::kSize];
};

/// Rays from all over the patch to all over each cluster, to each part of it as many as it would give light:
/// both ends share a four-dimensional sequence, so few rays already cover both, and what hides a cluster from
/// one side of the patch only (a picture's frame) is not mistaken.
/// note: no second look where a first one finds that some is hidden. What is seen a little would often be
/// missed by the first, and counted for nothing: deep shelves were 4 % too dark.
void KernelFactors::castShadows(std::uint32_t p, Faced& faced) const {
  const std::uint64_t seed = mixBits(seed_ ^ (std::uint64_t{p} << 32));
  ShadowRays rays(*this);
  for (Group& group : faced.groups) {
    const auto scramble = RaySequence::scramble(mixBits(seed ^ group.cluster));
    // Equal steps from a random first one: no candidate gets a ray more or less than it should.
    const double step = group.rays > 0 ? group.kernel / group.rays : 0;
    double along = step * (scramble[0] ^ scramble[3]) * 0x1p-32;
    std::size_t chosen = group.first;
    for (std::uint32_t first = 0; first < group.rays; first += 8) {
      const auto sample = sequence_.eightPoints(first, scramble);
      for (std::uint32_t i = 0; i < std::min(group.rays - first, 8u); ++i, along += step) {
        while (chosen + 1 < group.last && along >= faced.candidates[chosen].kernel)
          along -= faced.candidates[chosen++].kernel;
        Candidate& candidate = faced.candidates[chosen];
        ++candidate.asked;
        rays.add(candidate, group.cluster, points_.at(firstPatch_ + p, sample[2][i], sample[3][i]),
                 points_.at(candidate.item, sample[0][i], sample[1][i]));
      }
    }
  }
  rays.flush();

  for (Group& group : faced.groups) {
    group.isHidden =
        std::any_of(faced.candidates.begin() + static_cast<std::ptrdiff_t>(group.first),
                    faced.candidates.begin() + static_cast<std::ptrdiff_t>(group.last),
                    [](const Candidate& candidate) { return candidate.visible < candidate.asked; });
  }
}

/// What arrives of a group.
double KernelFactors::arrivingOf(const Faced& faced, const Group& group) {
  double sum = 0;
  for (std::size_t i = group.first; i < group.last; ++i) sum += factorOf(faced.candidates[i], group);
  return sum;
}

/// Lets of clusters that got no ray as much arrive as of the next one that did, or of the last.
void KernelFactors::lendOpenness(Faced& faced) {
  const auto isAsked = [](const Group& group) { return group.rays > 0; };
  auto& groups = faced.groups;
  const auto last = std::find_if(groups.rbegin(), groups.rend(), isAsked);
  if (last == groups.rend()) return;
  const auto openOf = [&](const Group& group) { return arrivingOf(faced, group) / group.kernel; };
  double open = openOf(*last);
  for (auto group = groups.rbegin(); group != groups.rend(); ++group) {
    if (isAsked(*group)) open = openOf(*group);
    if (group->isAlike) group->open = open;
  }
}

double KernelFactors::factorOf(const Candidate& candidate, const Group& group) {
  if (!group.isHidden) return candidate.kernel * group.open;
  if (candidate.visible == 0) return 0;
  // note: not kernel x visible share, for what is hidden may be the part that would give most.
  const double factor = candidate.arrived / candidate.asked;
  // What gets less than a ray, stands for others like it where it gets one.
  return factor / std::min(1.0, group.rays * candidate.kernel / group.kernel);
}

/// Of all distant clusters together.
float KernelFactors::openOf(const Faced& faced) const {
  double arrives = 0, all = 0;
  for (const Group& group : faced.groups) {
    if (faced.candidates[group.first].item >= firstPatch_) continue;
    arrives += arrivingOf(faced, group);
    all += group.kernel;
  }
  return all > 0 ? static_cast<float>(arrives / all) : 1.0f;
}

/// Writes down what row p gets from one cluster.
void KernelFactors::write(const Faced& faced, const Group& group, std::uint32_t p, Row& row) const {
  double sum = 0, leanU = 0, leanV = 0;
  for (std::size_t i = group.first; i < group.last; ++i) {
    const std::uint32_t item = faced.candidates[i].item;
    const double factor = factorOf(faced.candidates[i], group);
    if (factor > 0 && item >= firstPatch_) {
      row.near.push_back({item - firstPatch_, static_cast<float>(factor)});
    } else if (factor > 0) {
      const ClusterPart& part = clusters_.parts()[item];
      const Candidate& seen = faced.candidates[i];
      sum += factor;
      leanU += factor * (group.isHidden ? seen.leanU / seen.arrived : part.u);
      leanV += factor * (group.isHidden ? seen.leanV / seen.arrived : part.v);
    }
  }
  if (!(sum > 0)) return;
  row.u[group.cluster] = static_cast<float>(sum);
  if (group.cluster <= kLastSlope && isWithin(kFarEdges, p, group.cluster))
    row.slopes.push_back(
        {static_cast<std::uint16_t>(group.cluster), inSlopeUnits(leanU / sum), inSlopeUnits(leanV / sum)});
}

void KernelFactors::row(std::uint32_t p, std::uint32_t effort, const PatchSampler& sampler, Row& row) const {
  assert(effort >= 1 && effort <= kMostEffort);
  row.u.assign(room_.patches.clusterCount, 0.0f);
  row.slopes.clear();
  row.near.clear();
  Faced faced = facedBy(p, effort, sampler);
  castShadows(p, faced);
  lendOpenness(faced);
  for (const Group& group : faced.groups) write(faced, group, p, row);
  row.open = openOf(faced);
}

}  // namespace fiatlux
