#include "precompute/rays/places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fiatlux {
namespace {

/// How far out of their plane, in parts of the offset, the corners of what is flat may be; and how far the
/// cosine between two normals from 1.
constexpr double kFlat = 0.1, kParallel = 1e-8;

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

}  // namespace

std::optional<Place> placeOf(const Room& room, const RayTracer& tracer,
                             std::span<const std::uint32_t> patches) {
  if (patches.empty()) return {};
  const Chart& chart = room.charts[room.chartOfPatch[patches[0]]];
  const Vec3 center = room.patches.center[patches[0]];
  Extent u, v, height;
  for (const std::uint32_t p : patches) {
    if (room.fragmentsOf(p).empty()) return {};
    for (const Fragment& fragment : room.fragmentsOf(p)) {
      const auto& [a, b, c] = fragment.corner;
      const Vec3 normal = cross(b - a, c - a);
      if (dot(normal, chart.normal) < (1 - kParallel) * length(normal)) return {};
      for (const Vec3& corner : fragment.corner) {
        u.include(dot(corner - center, chart.uAxis));
        v.include(dot(corner - center, chart.vAxis));
        height.include(dot(corner - center, chart.normal));
      }
    }
  }
  if (height.high - height.low > kFlat * tracer.offset()) return {};
  const Vec3 base = center + (0.5 * (height.low + height.high) + tracer.offset()) * chart.normal;
  const auto at = [&](double along, double across) {
    return base + along * chart.uAxis + across * chart.vAxis;
  };
  return tracer.place({at(u.low, v.low), at(u.high, v.low), at(u.high, v.high), at(u.low, v.high)});
}

std::vector<std::optional<Place>> placesOfClusters(const Room& room, const RayTracer& tracer) {
  std::vector<std::vector<std::uint32_t>> members(room.patches.clusterCount);
  for (std::uint32_t p = 0; p < room.patches.count; ++p) members[room.patches.cluster[p]].push_back(p);
  std::vector<std::optional<Place>> places;
  for (const std::vector<std::uint32_t>& patches : members) places.push_back(placeOf(room, tracer, patches));
  return places;
}

BetweenPlaces::BetweenPlaces(const RayTracer& tracer, Places from, Places to)
    : tracer_(tracer), from_(std::move(from)), to_(std::move(to)), known_(from_.size() * to_.size()) {}

Between BetweenPlaces::at(std::size_t from, std::size_t to) const {
  if (!from_[from] || !to_[to]) return Between::kUnknown;
  std::atomic<std::uint8_t>& known = known_[from * to_.size() + to];
  std::uint8_t answer = known.load(std::memory_order_relaxed);
  if (answer == 0) {
    answer = static_cast<std::uint8_t>(1 + static_cast<int>(tracer_.between(*from_[from], *to_[to])));
    known.store(answer, std::memory_order_relaxed);
  }
  return static_cast<Between>(answer - 1);
}

}  // namespace fiatlux
