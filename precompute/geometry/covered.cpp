// A few rays from points spread over each patch; see covered.h.
#include "precompute/geometry/covered.h"

#include <algorithm>

#include "precompute/rays/hemisphere.h"
#include "precompute/rays/patch_sampler.h"
#include "precompute/rays/ray_sequence.h"

namespace fiatlux {
namespace {

constexpr double kTouching = 0.02;     // m: what stands closer touches
constexpr double kLiesOn = 0.1;        // m above a measuring plane: something lies on it
constexpr double kConfined = 0.25;     // m: a hollow that is nowhere wider is closed
constexpr double kMostly = 0.5;        // share of the points
constexpr std::uint32_t kPoints = 32;  // on a patch, a whole number of packets

/// What the rays from one patch have told.
struct Seen {
  std::uint32_t touched = 0;  // points with something right in front of them
  std::uint32_t inside = 0;   // points that look at the inside of a body
  std::uint32_t near = 0;     // looks that end within kConfined
};

class Looker {
 public:
  Looker(const Room& room, const RayTracer& tracer) : room_(room), tracer_(tracer), sequence_(kPoints) {}

  bool isCovered(std::uint32_t p) const {
    const bool measuring = p >= room_.patches.count;
    const Seen seen = lookFrom(p, measuring ? kLiesOn : kTouching);
    const auto share = [](std::uint32_t count) { return static_cast<double>(count) / kPoints; };
    if (share(seen.touched) >= kMostly) return true;
    return measuring ? share(seen.inside) >= kMostly : seen.near == kPoints || seen.inside == kPoints;
  }

 private:
  /// One ray along the normal and one by the cosine from every point.
  Seen lookFrom(std::uint32_t p, double reach) const {
    const PatchSampler sampler(room_, p);
    const auto scramble = RaySequence::scramble(mixBits(p));
    Seen seen;
    for (std::uint32_t first = 0; first < kPoints; first += RayPacket::kSize) {
      RayPacket straight, spread;
      Vec3 origin[RayPacket::kSize], direction[RayPacket::kSize];
      for (std::uint32_t i = 0; i < RayPacket::kSize; ++i) {
        const auto random = sequence_.point(first + i, scramble);
        const PatchPoint point = sampler.at(random[0], random[1]);
        origin[i] = point.position + tracer_.offset() * point.normal;
        direction[i] = cosineDirection(Frame(point.normal), random[2], random[3]);
        tracer_.aim(straight, origin[i], point.normal, reach);
        tracer_.aim(spread, origin[i], direction[i], kFar);
      }
      HitPacket touched, met;
      tracer_.intersect(straight, touched);
      tracer_.intersect(spread, met);
      for (std::uint32_t i = 0; i < RayPacket::kSize; ++i) {
        seen.touched += touched.triangle[i] != kNone;
        if (met.triangle[i] == kNone) continue;
        seen.near += met.distance[i] < kConfined;
        seen.inside += room_.patchMet(origin[i], direction[i], met.triangle[i], met.distance[i]) == kNone;
      }
    }
    return seen;
  }

  static constexpr double kFar = 1e6;  // m
  const Room& room_;
  const RayTracer& tracer_;
  RaySequence sequence_;
};

}  // namespace

std::vector<std::uint8_t> coveredRows(const Room& room, const RayTracer& tracer) {
  const Patches& patches = room.patches;
  const Looker looker(room, tracer);
  std::vector<std::uint8_t> covered(patches.rows());
  std::vector<char> counts(room.surfaces.size());  // whether some patch of a surface does
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    covered[p] = looker.isCovered(p);
    if (!covered[p]) counts[patches.surface[p]] = 1;
  }
  for (std::uint32_t p = 0; p < patches.rows(); ++p)
    if (!counts[patches.surface[p]]) covered[p] = 0;
  if (std::find(covered.begin(), covered.end(), 1) == covered.end()) covered.clear();
  return covered;
}

}  // namespace fiatlux
