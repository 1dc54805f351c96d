#include "precompute/light/cluster_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace fiatlux {

double squareReach(double area, double radius) {
  return std::max(std::sqrt(area), std::numbers::sqrt2 * radius);
}

ClusterParts::ClusterParts(const Room& room) {
  const Patches& patches = room.patches;
  members_.resize(patches.clusterCount);
  for (std::uint32_t q = 0; q < patches.count; ++q) members_[patches.cluster[q]].push_back(q);
  slopeShare_.resize(std::size_t{patches.count} * 2);
  for (std::uint32_t c = 0; c < patches.clusterCount; ++c) {
    firstPart_.push_back(static_cast<std::uint32_t>(parts_.size()));
    measure(room, c);
    addParts(room, c);
    addSlopeShares(room, c);
  }
  firstPart_.push_back(static_cast<std::uint32_t>(parts_.size()));
}

void ClusterParts::measure(const Room& room, std::uint32_t cluster) {
  const Patches& patches = room.patches;
  Vec3 center;
  double area = 0, radius = 0;
  for (const std::uint32_t q : members_[cluster]) {
    center += patches.area[q] * patches.center[q];
    area += patches.area[q];
  }
  center = (1 / area) * center;
  for (const std::uint32_t q : members_[cluster])
    radius = std::max(radius, length(patches.center[q] - center));
  center_.push_back(center);
  reach_.push_back(squareReach(area, radius));
  const Chart& chart = room.charts[room.chartOfPatch[members_[cluster][0]]];
  axes_.push_back({(1 / reach_.back()) * chart.uAxis, (1 / reach_.back()) * chart.vAxis});
}

void ClusterParts::addParts(const Room& room, std::uint32_t cluster) {
  const Patches& patches = room.patches;
  const std::vector<std::uint32_t>& members = members_[cluster];
  const Vec3 center = center_[cluster];

  // The second moment of the cluster about its centre, its patches taken as squares.
  double moment = 0, partMoment = 0;
  for (const std::uint32_t q : members) {
    const Vec3 d = patches.center[q] - center;
    moment += patches.area[q] * (dot(d, d) + patches.area[q] / 6);
  }

  // Quarter the cluster along its chart's axes.
  const Chart& chart = room.charts[room.chartOfPatch[members[0]]];
  std::array<std::vector<std::uint32_t>, 4> quarters;
  for (const std::uint32_t q : members) {
    const Vec3 local = patches.center[q] - center;
    quarters[(dot(local, chart.uAxis) > 0 ? 1 : 0) + (dot(local, chart.vAxis) > 0 ? 2 : 0)].push_back(q);
  }
  for (const auto& quarter : quarters) {
    if (quarter.empty()) continue;
    ClusterPart part;
    for (const std::uint32_t q : quarter) {
      part.center += patches.area[q] * patches.center[q];
      part.normal += patches.area[q] * patches.normal[q];
      part.area += patches.area[q];
    }
    part.members = quarter;
    part.center = (1 / part.area) * part.center;
    part.normal = normalized(part.normal);
    const Vec3 d = part.center - center;
    partMoment += part.area * dot(d, d);
    parts_.push_back(part);
  }

  // Spread the points so that they have the cluster's second moment: on a square, Gauss's 2 x 2 nodes.
  const double spread = partMoment > 1e-9 * moment ? std::sqrt(moment / partMoment) : 1;
  for (std::size_t i = firstPart_.back(); i < parts_.size(); ++i) {
    const Vec3 d = spread * (parts_[i].center - center);
    parts_[i].center = center + d;
    parts_[i].u = dot(d, chart.uAxis) / reach_[cluster];
    parts_[i].v = dot(d, chart.vAxis) / reach_[cluster];
  }
}

/// So that a light of first moment s over the cluster, sum f_i (u, v)_i of its parts' form factors over their
/// sum, becomes the linear density that has this moment: patch q gets share_q + s . slopeShare_q. The second
/// moments are those of the patches, taken as squares: parts in a row along a diagonal have none across it.
void ClusterParts::addSlopeShares(const Room& room, std::uint32_t cluster) {
  const double reach = reach_[cluster];
  double uu = 0, uv = 0, vv = 0;
  for (const std::uint32_t q : members_[cluster]) {
    const auto [u, v] = placeOf(room, q);
    const double area = room.patches.area[q], own = area / (12 * reach * reach);
    uu += area * (u * u + own);
    uv += area * u * v;
    vv += area * (v * v + own);
  }
  const double determinant = uu * vv - uv * uv;
  for (const std::uint32_t q : members_[cluster]) {
    const auto [u, v] = placeOf(room, q);
    const double weight = room.patches.area[q] / determinant;
    slopeShare_[std::size_t{q} * 2] = static_cast<float>(weight * (vv * u - uv * v));
    slopeShare_[std::size_t{q} * 2 + 1] = static_cast<float>(weight * (uu * v - uv * u));
  }
}

}  // namespace fiatlux
