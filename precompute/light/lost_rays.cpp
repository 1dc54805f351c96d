#include "precompute/light/lost_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "precompute/rays/hemisphere.h"
#include "precompute/rays/patch_sampler.h"
#include "precompute/rays/ray_sequence.h"
#include "precompute/room/bounds.h"

namespace fiatlux {

namespace {

constexpr std::uint32_t kPatches = 4096, kRays = 16;  // the sample
constexpr double kMuch = 0.005;                       // share of its rays
constexpr std::size_t kMostNames = 4;
constexpr double kNear = 0.01;   // of the room's diagonal: a back that is met there hides what lies under it
constexpr double kMostly = 0.5;  // of what a back swallows
constexpr double kFacesOut = 0.9;    // of a surface's rays: it has no part in the room
constexpr double kFlat = 0.15;       // of a way along a surface: off it
constexpr double kThickest = 1;      // m, of a wall
constexpr double kMostInBody = 0.5;  // of all rays; else it is faces that are the wrong way round
constexpr double kMainWay = 0.15;    // of the rays that leave: a way worth its name

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f %%", 100 * share);
  return text;
}

/// The sides of the room's bounding box, by which a ray may leave.
constexpr std::array kWays = {"towards -x", "towards +x", "downward", "upward", "towards -z", "towards +z"};
using Ways = std::array<double, kWays.size()>;

struct Sample {
  double rays = 0;
  std::vector<double> cast;  // per surface: rays from it
  std::vector<Ways> left;    // per surface: those that met nothing
  struct Swallowed {
    double rays = 0, near = 0;  // that a surface met with its back; of them, at once
    void add(bool isNear) { rays += 1, near += isNear; }
  };
  std::map<std::string, Swallowed> swallowed;  // per name
};

/// What a triangle's front is called, whether it is a part of the room or left out.
const std::string& frontName(const Room& room, std::uint32_t triangle) {
  const RoomTriangle& t = room.triangles[triangle];
  static const std::string kUnknown = "a triangle";
  if (t.chart != kNone) return room.surfaces[room.charts[t.chart].surface].name;
  return t.leftOut != kNone ? room.leftOut[t.leftOut] : kUnknown;
}

/// By which side a ray from within leaves: index into kWays.
std::size_t wayOut(const Bounds& bounds, const Vec3& origin, const Vec3& direction) {
  std::size_t way = 0;
  double nearest = 1e300;
  const auto look = [&](std::size_t axis, double from, double d, double least, double most) {
    const double distance = d > 0 ? (most - from) / d : d < 0 ? (least - from) / d : 1e300;
    if (distance < nearest) nearest = distance, way = 2 * axis + (d > 0);
  };
  look(0, origin.x, direction.x, bounds.low.x, bounds.high.x);
  look(1, origin.y, direction.y, bounds.low.y, bounds.high.y);
  look(2, origin.z, direction.z, bounds.low.z, bounds.high.z);
  return way;
}

double sumOf(const Ways& ways) { return std::accumulate(ways.begin(), ways.end(), 0.0); }

/// The ways that matter, most first: "upward (97 %)".
std::string namesOf(const Ways& ways) {
  std::vector<std::size_t> order(ways.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return ways[a] > ways[b]; });
  std::string text;
  for (const std::size_t way : order)
    if (ways[way] >= kMainWay * sumOf(ways))
      text += (text.empty() ? "" : ", ") + std::string(kWays[way]) + " (" +
              std::to_string(std::lround(100 * ways[way] / sumOf(ways))) + " %)";
  return text.empty() ? "in all directions" : text;
}

/// Casts one ray.
class Caster {
 public:
  Caster(const Room& room, const RayTracer& tracer) : room_(room), tracer_(tracer) {}

  struct Met {
    bool isNothing = false;
    double distance = 0;                // m
    const std::string* back = nullptr;  // whose it was that was met
  };
  Met operator()(const Vec3& origin, const Vec3& direction) const {
    RayPacket packet;
    tracer_.aim(packet, origin, direction, std::numeric_limits<float>::infinity());
    HitPacket hit;
    tracer_.intersect(packet, hit);
    if (hit.triangle[0] == kNone) return {true};
    if (room_.patchMet(origin, direction, hit.triangle[0], hit.distance[0]) != kNone) return {};
    return {false, hit.distance[0], &frontName(room_, hit.triangle[0])};
  }

  /// Within a wall, say, that stands below a ceiling: the backs of several surfaces are to all sides, or near
  /// by to two opposite ones (where walls meet, what bounds one lies on the other).
  bool isInBody(const Vec3& origin, const Frame& frame) const {
    std::set<std::string> backs;
    bool isAround = true;
    for (const Vec3& side : {frame.x, frame.y}) {
      const Met one = (*this)(origin, normalized(side + kFlat * frame.z));
      const Met two = (*this)(origin, normalized(kFlat * frame.z - side));
      for (const Met& met : {one, two}) {
        isAround = isAround && met.back;
        if (met.back) backs.insert(*met.back);
      }
      if (one.back && two.back && *one.back != *two.back && one.distance + two.distance < kThickest)
        return true;
    }
    return isAround && backs.size() > 1;
  }

 private:
  const Room& room_;
  const RayTracer& tracer_;
};

/// Of patches all over the room. No light comes to what lies within bodies, and its rays do not count.
Sample sampleOf(const Room& room, const RayTracer& tracer) {
  const std::size_t surfaces = room.surfaces.size();
  Sample sample{0, std::vector<double>(surfaces), std::vector<Ways>(surfaces, Ways{}), {}};
  std::map<std::string, Sample::Swallowed> inBodies;
  double hidden = 0;
  const Bounds bounds = boundsOf(room.positions);
  const double near = kNear * bounds.diagonal();
  const Caster cast(room, tracer);
  const RaySequence sequence(kRays);
  const std::uint32_t step = std::max(1u, room.patches.count / kPatches);
  for (std::uint32_t p = 0; p < room.patches.count; p += step) {
    const PatchSampler sampler(room, p);
    const auto scramble = RaySequence::scramble(mixBits(p));
    for (std::uint32_t i = 0; i < kRays; ++i) {
      const auto random = sequence.point(i, scramble);
      const auto [position, normal, weight] = sampler.at(random[2], random[3]);
      const Frame frame(normal);
      const Vec3 origin = position + tracer.offset() * normal;
      const Vec3 direction = cosineDirection(frame, random[0], random[1]);
      const Caster::Met met = cast(origin, direction);
      sample.rays += 1;
      sample.cast[room.patches.surface[p]] += 1;
      if (met.isNothing) sample.left[room.patches.surface[p]][wayOut(bounds, position, direction)] += 1;
      if (!met.back) continue;
      const bool isHidden = cast.isInBody(origin, frame);
      hidden += isHidden;
      (isHidden ? inBodies : sample.swallowed)[*met.back].add(met.distance < near);
    }
  }
  if (hidden < kMostInBody * sample.rays)
    sample.rays -= hidden;
  else
    for (const auto& [name, by] : inBodies)
      sample.swallowed[name].rays += by.rays, sample.swallowed[name].near += by.near;
  return sample;
}

/// Backs that swallow much, most first: "'a' (2.1 %), 'b' (0.8 %)", and of how much in all.
std::pair<std::string, double> namesOfBacks(const Sample& sample, bool areNear) {
  std::vector<std::pair<double, std::string>> order;
  for (const auto& [name, swallowed] : sample.swallowed)
    if (swallowed.rays >= kMuch * sample.rays && (swallowed.near > kMostly * swallowed.rays) == areNear)
      order.emplace_back(-swallowed.rays, name);
  std::sort(order.begin(), order.end());
  std::string text;
  double rays = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    rays -= order[i].first;
    if (i < kMostNames)
      text += (i > 0 ? ", '" : "'") + order[i].second + "' (" + percent(-order[i].first / sample.rays) + ")";
  }
  if (order.size() > kMostNames) text += " and " + std::to_string(order.size() - kMostNames) + " more";
  return {text, sample.rays > 0 ? rays / sample.rays : 0};
}

}  // namespace

std::vector<std::string> warningsOfLostRays(const Room& room, const RayTracer& tracer) {
  const Sample sample = sampleOf(room, tracer);

  std::vector<std::string> warnings;

  // Openings. A surface that faces outward (of a house, of a flipped wall) has no part in the room.
  Ways left{};
  for (std::size_t s = 0; s < sample.left.size(); ++s)
    for (std::size_t way = 0; way < left.size() && sumOf(sample.left[s]) < kFacesOut * sample.cast[s]; ++way)
      left[way] += sample.left[s][way];
  if (sumOf(left) >= kMuch * sample.rays)
    warnings.push_back("the room is open: " + percent(sumOf(left) / sample.rays) +
                       " of its rays meet nothing, and that light is lost; they leave " + namesOf(left));

  // Backs.
  for (const bool areNear : {false, true})
    if (const auto [names, share] = namesOfBacks(sample, areNear); share > 0)
      warnings.push_back(percent(share) + " of its rays are swallowed by backs, those of " + names + ": " +
                         (areNear ? "they lie close over something and hide it; cut away what is hidden, or "
                                    "it counts as dark"
                                  : "turn their faces, or make their material double-sided"));
  return warnings;
}

}  // namespace fiatlux
