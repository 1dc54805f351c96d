#include "precompute/lost_rays.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <numeric>

#include "precompute/hemisphere.h"
#include "precompute/ray_sequence.h"

namespace fiatlux {

namespace {

constexpr std::uint32_t kPatches = 4096, kRays = 16;  // the sample
constexpr double kMuch = 0.005;                       // share of its rays
constexpr std::size_t kMostNames = 8;

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f %%", 100 * share);
  return text;
}

struct Sample {
  double rays = 0;
  std::vector<double> cast, left, swallowed;  // per surface: rays from it, those that met nothing, those it
                                              // met with its back
};

Sample sampleOf(const Room& room, const RayTracer& tracer) {
  const std::size_t surfaces = room.surfaces.size();
  Sample sample{0, std::vector<double>(surfaces), std::vector<double>(surfaces),
                std::vector<double>(surfaces)};
  const RaySequence sequence(kRays);
  const std::uint32_t step = std::max(1u, room.patches.count / kPatches);
  for (std::uint32_t p = 0; p < room.patches.count; p += step) {
    const auto scramble = RaySequence::scramble(mixBits(p));
    for (std::uint32_t i = 0; i < kRays; ++i) {
      const auto random = sequence.point(i, scramble);
      const auto [position, normal] = room.pointOnPatch(p, random[2], random[3]);
      const Vec3 origin = position + tracer.offset() * normal;
      const Vec3 direction = cosineDirection(Frame(normal), random[0], random[1]);
      RayPacket packet;
      tracer.aim(packet, origin, direction, std::numeric_limits<float>::infinity());
      HitPacket hit;
      tracer.intersect(packet, hit);
      sample.rays += 1;
      sample.cast[room.patches.surface[p]] += 1;
      if (hit.triangle[0] == kNone)
        sample.left[room.patches.surface[p]] += 1;
      else if (tracer.patchOf(origin, direction, hit.triangle[0], hit.distance[0]) == kNone)
        sample.swallowed[room.charts[room.triangles[hit.triangle[0]].chart].surface] += 1;
    }
  }
  return sample;
}

}  // namespace

std::vector<std::string> warningsOfLostRays(const Room& room, const RayTracer& tracer) {
  const Sample sample = sampleOf(room, tracer);
  const std::vector<double>& lost = sample.swallowed;
  std::vector<std::size_t> order(room.surfaces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return lost[a] > lost[b]; });
  order.resize(std::min(order.size(), kMostNames));

  std::vector<std::string> warnings;
  for (const std::size_t s : order) {
    if (lost[s] < kMuch * sample.rays) break;
    warnings.push_back("'" + room.surfaces[s].name + "' swallows " + percent(lost[s] / sample.rays) +
                       " of the light by its back: turn its faces, or make its material double-sided");
  }
  // A surface that faces outward (of a house, of a flipped wall) has no part in the room.
  double left = 0;
  for (std::size_t s = 0; s < lost.size(); ++s)
    if (sample.left[s] < 0.9 * sample.cast[s]) left += sample.left[s];
  if (left >= kMuch * sample.rays)
    warnings.push_back("the room is open: " + percent(left / sample.rays) +
                       " of its rays meet nothing, and that light is lost");
  return warnings;
}

}  // namespace fiatlux
