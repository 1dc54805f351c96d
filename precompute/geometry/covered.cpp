// A few rays from points spread over each patch; see covered.h.
#include "precompute/geometry/covered.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "precompute/base/parallel.h"
#include "precompute/rays/hemisphere.h"
#include "precompute/rays/patch_sampler.h"
#include "precompute/rays/ray_sequence.h"

namespace fiatlux {
namespace {

constexpr double kTouching = 0.02;     // m: what stands closer touches
constexpr double kLiesOn = 0.1;        // m above a measuring plane: something lies on it
constexpr double kConfined = 0.25;     // m: looks that end nearer on both sides are of a hollow
constexpr double kSlit = 0.15;         // m: what is not higher is a slit
constexpr double kSlitEnds = 0.5;      // m: in a slit of 0.15 m nine tenths of the looks end nearer
constexpr double kMostly = 0.5;        // share of the points
constexpr std::uint32_t kPoints = 32;  // on a patch, a whole number of packets
constexpr double kEyeAbove = 0.05;     // m above a place: from there it is looked round
constexpr double kFirstWay = 0.2;      // rad: what is built lies along the axes, and no look should
constexpr std::uint32_t kInsides = 5;  // of eight looks round: a straight sheet is met from behind by four

/// What the rays from one patch have told: of how many points.
struct Seen {
  std::uint32_t hidden = 0;  // something is right in front of them, or they are inside a body
  std::uint32_t closed = 0;  // hidden, or in a hollow or a slit
};

class Looker {
 public:
  Looker(const Room& room, const RayTracer& tracer) : room_(room), tracer_(tracer), sequence_(kPoints) {}

  bool isCovered(std::uint32_t p) const {
    const bool measuring = p >= room_.patches.count;
    const Seen seen = lookFrom(p, measuring ? kLiesOn : kTouching);
    return (measuring ? seen.hidden : seen.closed) >= kMostly * kPoints;
  }

 private:
  /// From every point one ray along the normal, one by the cosine, and its mirror image on the other side of
  /// the normal: in a corner of a room one of the two finds a way out, between a sofa and the wall neither
  /// does. A point is inside a body where the first two end at insides: a single sheet is seen from behind by
  /// few such pairs. The first may end at a ceiling that lies in one plane with the top of a wall; then looks
  /// round tell.
  Seen lookFrom(std::uint32_t p, double reach) const {
    const PatchSampler sampler(room_, p);
    const auto scramble = RaySequence::scramble(mixBits(p));
    Seen seen;
    for (std::uint32_t first = 0; first < kPoints; first += RayPacket::kSize) {
      RayPacket straight, spread, mirrored;
      Vec3 origin[RayPacket::kSize], normal[RayPacket::kSize], direction[RayPacket::kSize];
      for (std::uint32_t i = 0; i < RayPacket::kSize; ++i) {
        const auto random = sequence_.point(first + i, scramble);
        const PatchPoint point = sampler.at(random[0], random[1]);
        normal[i] = point.normal;
        origin[i] = point.position + tracer_.offset() * point.normal;
        direction[i] = cosineDirection(Frame(point.normal), random[2], random[3]);
        tracer_.aim(straight, origin[i], normal[i], kFar);
        tracer_.aim(spread, origin[i], direction[i], kFar);
        tracer_.aim(mirrored, origin[i], 2 * dot(normal[i], direction[i]) * normal[i] - direction[i], kFar);
      }
      HitPacket before, met, across;
      tracer_.intersect(straight, before);
      tracer_.intersect(spread, met);
      tracer_.intersect(mirrored, across);
      for (std::uint32_t i = 0; i < RayPacket::kSize; ++i) {
        const bool inside = isInside(origin[i], direction[i], met, i) &&
                            (isInside(origin[i], normal[i], before, i) || isSurrounded(origin[i], normal[i]));
        const bool hidden = inside || ends(before, i, reach);
        const double width = ends(before, i, kSlit) ? kSlitEnds : kConfined;
        seen.hidden += hidden;
        seen.closed += hidden || (ends(met, i, width) && ends(across, i, width));
      }
    }
    return seen;
  }

  static bool ends(const HitPacket& hits, std::uint32_t i, double within) {
    return hits.triangle[i] != kNone && hits.distance[i] < within;
  }

  bool isInside(const Vec3& origin, const Vec3& direction, const HitPacket& hits, std::uint32_t i) const {
    return hits.triangle[i] != kNone &&
           room_.patchMet(origin, direction, hits.triangle[i], hits.distance[i]) == kNone;
  }

  /// Whether looks round, level with the patch, mostly end at insides.
  bool isSurrounded(const Vec3& origin, const Vec3& normal) const {
    const Frame frame(normal);
    const Vec3 from = origin + kEyeAbove * normal;
    RayPacket round;
    Vec3 ways[RayPacket::kSize];
    for (std::uint32_t i = 0; i < RayPacket::kSize; ++i) {
      const double angle = kFirstWay + 2 * std::numbers::pi * i / RayPacket::kSize;
      ways[i] = std::cos(angle) * frame.x + std::sin(angle) * frame.y;
      tracer_.aim(round, from, ways[i], kFar);
    }
    HitPacket met;
    tracer_.intersect(round, met);
    std::uint32_t insides = 0;
    for (std::uint32_t i = 0; i < RayPacket::kSize; ++i) insides += isInside(from, ways[i], met, i);
    return insides >= kInsides;
  }

  static constexpr double kFar = 1e6;  // m
  const Room& room_;
  const RayTracer& tracer_;
  RaySequence sequence_;
};

}  // namespace

std::vector<std::uint8_t> coveredRows(const Room& room, const RayTracer& tracer, unsigned threads) {
  const Patches& patches = room.patches;
  const Looker looker(room, tracer);
  std::vector<std::uint8_t> covered(patches.rows());
  constexpr std::uint32_t kRows = 256;  // a thread's portion
  parallelPortions(patches.rows(), kRows, threads, [&](std::uint32_t first, std::uint32_t end) {
    for (std::uint32_t p = first; p < end; ++p) covered[p] = looker.isCovered(p);
  });
  std::vector<char> counts(room.surfaces.size());  // whether some patch of a surface does
  for (std::uint32_t p = 0; p < patches.rows(); ++p)
    if (!covered[p]) counts[patches.surface[p]] = 1;
  for (std::uint32_t p = 0; p < patches.rows(); ++p)
    if (!counts[patches.surface[p]]) covered[p] = 0;
  if (std::find(covered.begin(), covered.end(), 1) == covered.end()) covered.clear();
  return covered;
}

}  // namespace fiatlux
