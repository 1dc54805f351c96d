#include "precompute/far_field.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "precompute/ray_sequence.h"

namespace fiatlux {

namespace {

// Distances between patch and cluster, in edges of both: from the first on a point a part is a fair
// quadrature, from the second on the light's spread within the cluster no longer matters.
constexpr double kMiddleEdges = 2, kFarEdges = 8;

}  // namespace

FarField::FarField(const Room& room, const RayTracer& tracer, std::uint64_t seed)
    : room_(room), tracer_(tracer), seed_(seed), sequence_(kShadowPoints) {
  const Patches& patches = room.patches;
  std::vector<std::vector<std::uint32_t>> members(patches.clusterCount);
  std::vector<Vec3> targets;  // kShadowPoints of each part
  for (std::uint32_t q = 0; q < patches.count; ++q) members[patches.cluster[q]].push_back(q);
  for (std::uint32_t c = 0; c < patches.clusterCount; ++c) {
    firstPart_.push_back(static_cast<std::uint32_t>(parts_.size()));
    addParts(c, members[c], mixBits(seed ^ 0xfa5u) ^ c, targets);
  }
  firstPart_.push_back(static_cast<std::uint32_t>(parts_.size()));

  // Most rows use the first few targets of every part: they lie together.
  targets_.resize(targets.size());
  for (std::size_t i = 0; i < targets.size(); ++i) {
    targets_[targetAt(i / kShadowPoints, i % kShadowPoints)] = targets[i];
  }
}

void FarField::addParts(std::uint32_t cluster, const std::vector<std::uint32_t>& members, std::uint64_t seed,
                        std::vector<Vec3>& targets) {
  const Patches& patches = room_.patches;
  Vec3 center;
  double area = 0;
  for (const std::uint32_t q : members) {
    center += patches.area[q] * patches.center[q];
    area += patches.area[q];
  }
  center = (1 / area) * center;
  double radius = 0;
  for (const std::uint32_t q : members) radius = std::max(radius, length(patches.center[q] - center));
  center_.push_back(center);
  reach_.push_back(std::max(std::sqrt(area), std::numbers::sqrt2 * radius));

  // The second moment of the cluster about its centre, its patches taken as squares.
  double moment = 0, partMoment = 0;
  for (const std::uint32_t q : members) {
    const Vec3 d = patches.center[q] - center;
    moment += patches.area[q] * (dot(d, d) + patches.area[q] / 6);
  }

  // Quarter the cluster along its chart's axes.
  const Chart& chart = room_.charts[room_.chartOfPatch[members[0]]];
  std::array<std::vector<std::uint32_t>, 4> quarters;
  for (const std::uint32_t q : members) {
    const Vec3 local = patches.center[q] - center;
    quarters[(dot(local, chart.uAxis) > 0 ? 1 : 0) + (dot(local, chart.vAxis) > 0 ? 2 : 0)].push_back(q);
  }
  for (const auto& quarter : quarters) {
    if (quarter.empty()) continue;
    Part part;
    part.cluster = cluster;
    for (const std::uint32_t q : quarter) {
      part.center += patches.area[q] * patches.center[q];
      part.normal += patches.area[q] * patches.normal[q];
      part.area += patches.area[q];
    }
    part.center = (1 / part.area) * part.center;
    part.normal = normalized(part.normal);
    // Where shadow rays end: the first number chooses the patch by area, what is left of it the place there.
    std::vector<PatchSampler> samplers;
    for (const std::uint32_t q : quarter) samplers.emplace_back(room_, q);
    const auto scramble = RaySequence::scramble(seed = mixBits(seed));
    for (std::uint32_t i = 0; i < kShadowPoints; ++i) {
      const auto sample = sequence_.point(i, scramble);
      double along = sample[0] * part.area;
      std::size_t chosen = 0;
      while (chosen + 1 < quarter.size() && along >= patches.area[quarter[chosen]])
        along -= patches.area[quarter[chosen++]];
      const double left = std::min(along / patches.area[quarter[chosen]], 1 - 1e-9);
      const PatchPoint point = samplers[chosen].at(left, sample[1]);
      targets.push_back(point.position + tracer_.offset() * point.normal);
    }
    const Vec3 d = part.center - center;
    partMoment += part.area * dot(d, d);
    parts_.push_back(part);
  }

  // Spread the points so that they have the cluster's second moment: on a square, Gauss's 2 x 2 nodes.
  const double spread = partMoment > 1e-9 * moment ? std::sqrt(moment / partMoment) : 1;
  for (std::size_t i = firstPart_.back(); i < parts_.size(); ++i) {
    parts_[i].center = center + spread * (parts_[i].center - center);
  }
}

void FarField::castShadows(std::uint64_t seed, std::uint32_t rays, const std::vector<Vec3>& origins,
                           std::size_t first, std::size_t last, std::vector<Candidate>& candidates) const {
  RayPacket packet;
  std::size_t lane[RayPacket::kSize];
  const auto flush = [&] {
    bool blocked[RayPacket::kSize];
    tracer_.occluded(packet, blocked);
    for (std::uint32_t i = 0; i < packet.count; ++i) candidates[lane[i]].visible += !blocked[i];
    packet.count = 0;
  };
  for (std::size_t i = first; i < last; ++i) {
    const std::uint64_t bits = mixBits(seed ^ candidates[i].part);
    candidates[i].visible = 0;
    for (std::uint32_t ray = 0; ray < rays; ++ray) {
      const std::size_t point = (bits + ray) % origins.size();
      const Vec3 &origin = origins[point], &target = targets_[targetAt(candidates[i].part, point)];
      lane[packet.count] = i;
      tracer_.aim(packet, origin, target - origin, 1);
      if (packet.count == RayPacket::kSize) flush();
    }
  }
  if (packet.count > 0) flush();
}

void FarField::row(std::uint32_t p, std::uint32_t effort, const PatchSampler& sampler,
                   std::vector<Range>& ranges, float* u) const {
  const Patches& patches = room_.patches;
  const Vec3 center = patches.center[p], normal = patches.normal[p];
  const double edge = std::sqrt(patches.area[p]);
  std::vector<Candidate> candidates;
  ranges.assign(patches.clusterCount, Range::kNear);
  for (std::uint32_t c = 0; c < patches.clusterCount; ++c) {
    u[c] = 0;
    const Vec3 apart = center_[c] - center;
    const double edges = length(apart) / (reach_[c] + edge);
    if (edges < kMiddleEdges) continue;
    ranges[c] = edges < kFarEdges ? Range::kMiddle : Range::kFar;
    for (std::uint32_t i = firstPart_[c]; i < firstPart_[c + 1]; ++i) {
      const Part& part = parts_[i];
      const Vec3 d = part.center - center;
      const double leaving = dot(d, normal), arriving = -dot(d, part.normal);
      if (leaving <= 0 || arriving <= 0) continue;
      const double squared = dot(d, d);
      candidates.push_back({i, part.area * leaving * arriving / (std::numbers::pi * squared * squared), 0});
    }
  }

  // Point i here and point i of every part share a four-dimensional sequence: few rays already cover both
  // ends, and what hides a cluster from one side of the patch only (a picture's frame) is not mistaken.
  const std::uint64_t seed = mixBits(seed_ ^ (std::uint64_t{p} << 32));
  std::vector<Vec3> origins;
  const auto scramble = RaySequence::scramble(seed);
  for (std::size_t i = 0; i < std::min(kFewPoints * effort, kShadowPoints); ++i) {
    const auto sample = sequence_.point(static_cast<std::uint32_t>(i), scramble);
    const PatchPoint point = sampler.at(sample[2], sample[3]);
    origins.push_back(point.position + tracer_.offset() * point.normal);
  }
  const std::uint32_t few = (effort + 3) / 4, many = 4 * effort * few;  // of 4 and 256 at most
  castShadows(seed, few, origins, 0, candidates.size(), candidates);

  // A cluster that is seen in part is asked again, more often.
  for (std::size_t first = 0, last = 0; first < candidates.size(); first = last) {
    const std::uint32_t cluster = parts_[candidates[first].part].cluster;
    std::uint32_t seen = 0;
    for (last = first; last < candidates.size() && parts_[candidates[last].part].cluster == cluster; ++last) {
      seen += candidates[last].visible;
    }
    std::uint32_t rays = few;
    if (seen > 0 && seen < few * (last - first)) {
      rays = many;
      castShadows(mixBits(seed), rays, origins, first, last, candidates);
    }
    double sum = 0;
    for (std::size_t i = first; i < last; ++i) sum += candidates[i].kernel * candidates[i].visible / rays;
    u[cluster] = static_cast<float>(sum);
  }
}

}  // namespace fiatlux
