#include "precompute/light/lost_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "precompute/light/emission.h"
#include "precompute/rays/hemisphere.h"
#include "precompute/rays/patch_sampler.h"
#include "precompute/rays/ray_sequence.h"
#include "precompute/room/bounds.h"

namespace fiatlux {

namespace {

constexpr std::uint32_t kPaths = 4096, kMostSteps = 64;  // the sample
constexpr double kLeastWeight = 0.01;                    // of a path: less is as good as taken up
constexpr double kMuch = 0.005;                          // share of the flux
constexpr std::size_t kMostNames = 4;
constexpr double kNear = 0.01;   // of the room's diagonal: a back that is met there hides what lies under it
constexpr double kMostly = 0.5;  // of what a back swallows
constexpr double kThickest = 1;  // m, of a wall
constexpr double kMainWay = 0.15;  // of the light that leaves: a way worth its name

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f %%", 100 * share);
  return text;
}

/// The sides of the room's bounding box, by which a ray may leave.
constexpr std::array kWays = {"to the west", "to the east",  "downward",
                              "upward",      "to the north", "to the south"};
using Ways = std::array<double, kWays.size()>;

struct Lost {
  Ways left{};  // shares of the flux
  struct Swallowed {
    double share = 0, near = 0;  // of the flux; of that, at once
  };
  std::map<std::string, Swallowed> swallowed;  // per name
  double inBodies = 0;                         // of patches that go on under a wall
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

/// Light on its way through the room.
class LightPath {
 public:
  LightPath(const Room& room, const RayTracer& tracer, Lost& lost)
      : room_(room), tracer_(tracer), bounds_(boundsOf(room.positions)), lost_(lost) {}

  /// Goes on until the rest is not worth a look; `sequence`: point `i` of it for every step.
  void follow(Vec3 origin, Vec3 direction, const RaySequence& sequence, std::uint32_t i) const {
    double share = 1.0 / kPaths;
    bool isPlaced = true;  // by a luminaire, not by a patch
    for (std::uint32_t step = 1; step < kMostSteps && share > kLeastWeight / kPaths; ++step) {
      const std::uint32_t p = meet(origin, direction, share, isPlaced);
      if (p == kNone) return;
      share *= room_.patches.reflectance[p];
      const auto random = sequence.point(i, RaySequence::scramble(mixBits(step)));
      const PatchPoint from = PatchSampler(room_, p).at(random[2], random[3]);
      direction = cosineDirection(Frame(from.normal), random[0], random[1]);
      origin = from.position + tracer_.offset() * from.normal;
      isPlaced = false;
    }
  }

 private:
  struct Met {
    std::uint32_t triangle = kNone, patch = kNone;
    double distance = 0;  // m
    const std::string* backIn(const Room& room) const {
      return triangle != kNone && patch == kNone ? &frontName(room, triangle) : nullptr;
    }
  };
  Met cast(const Vec3& origin, const Vec3& direction) const {
    const auto [t, distance] = tracer_.firstHit(origin, direction);
    if (t == kNone) return {};
    return {t, room_.patchMet(origin, direction, t, distance), distance};
  }

  /// The patch that is met; kNone where the light is lost, which is noted.
  std::uint32_t meet(const Vec3& origin, const Vec3& direction, double share, bool isPlaced) const {
    const Met met = cast(origin, direction);
    if (met.patch != kNone) return met.patch;
    if (met.triangle == kNone) {
      lost_.left[wayOut(bounds_, origin, direction)] += share;
    } else if (!isPlaced && isInBody(origin)) {
      lost_.inBodies += share;
    } else {
      Lost::Swallowed& back = lost_.swallowed[frontName(room_, met.triangle)];
      back.share += share;
      if (met.distance < kNear * bounds_.diagonal()) back.near += share;
    }
    return kNone;
  }

  /// Within a wall, say, that a patch of the floor goes on under: the backs of several surfaces are to all
  /// sides, or near by to two opposite ones (where walls meet, what bounds one lies on the other).
  bool isInBody(const Vec3& origin) const {
    std::set<std::string> backs;
    bool isAround = true;
    for (const Vec3& side : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
      const Met one = cast(origin, side), two = cast(origin, -side);
      const std::string *first = one.backIn(room_), *second = two.backIn(room_);
      for (const std::string* back : {first, second})
        if (back) backs.insert(*back);
      if (first && second && one.distance + two.distance < kThickest) return true;
      isAround = isAround && (side.y != 0 || (first && second));
    }
    return isAround && backs.size() > 1;
  }

  const Room& room_;
  const RayTracer& tracer_;
  const Bounds bounds_;
  Lost& lost_;
};

/// A direction in which a luminaire shines; where it has a photometry of its own, about so.
Vec3 wayOf(const Luminaire& luminaire, double u, double v) {
  if (luminaire.distribution == Luminaire::Distribution::kIsotropic) {
    const bool isUp = u < 0.5;  // note: half a sphere by the cosine is not even, and near enough here
    return cosineDirection(Frame(isUp ? -luminaire.normal : luminaire.normal), isUp ? 2 * u : 2 * u - 1, v);
  }
  return cosineDirection(Frame(luminaire.normal), u, v);
}

Lost lostOf(const Room& room, const std::vector<Luminaire>& luminaires, const RayTracer& tracer) {
  Lost lost;
  const LightPath path(room, tracer, lost);
  const std::size_t count = room.sites.empty() ? luminaires.size() : room.sites.size();
  const RaySequence sequence(kPaths);
  const auto scramble = RaySequence::scramble(0);
  for (std::uint32_t i = 0; count > 0 && i < kPaths; ++i) {
    const std::size_t which = std::size_t{i} * count / kPaths;
    const Luminaire luminaire = room.sites.empty() ? luminaires[which] : luminaireOf(room.sites[which]);
    const auto random = sequence.point(i, scramble);
    path.follow(Emission(luminaire).startAt(random[2], random[3]), wayOf(luminaire, random[0], random[1]),
                sequence, i);
  }
  return lost;
}

/// Backs that swallow much, most first: "'a' (2.1 %), 'b' (0.8 %)", and of how much in all.
std::pair<std::string, double> namesOfBacks(const Lost& lost, bool areNear) {
  std::vector<std::pair<double, std::string>> order;
  for (const auto& [name, back] : lost.swallowed)
    if (back.share >= kMuch && (back.near > kMostly * back.share) == areNear)
      order.emplace_back(-back.share, name);
  std::sort(order.begin(), order.end());
  std::string text;
  double share = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    share -= order[i].first;
    if (i < kMostNames)
      text += (i > 0 ? ", '" : "'") + order[i].second + "' (" + percent(-order[i].first) + ")";
  }
  if (order.size() > kMostNames) text += " and " + std::to_string(order.size() - kMostNames) + " more";
  return {text, share};
}

}  // namespace

LostLight lostLight(const Room& room, const std::vector<Luminaire>& luminaires, const RayTracer& tracer) {
  const Lost lost = lostOf(room, luminaires, tracer);
  const double left = sumOf(lost.left);
  LostLight result{left + lost.inBodies, {}};
  for (const auto& [name, back] : lost.swallowed) result.share += back.share;

  if (left >= kMuch)
    result.warnings.push_back("the room is open: " + percent(left) +
                              " of the light of its luminaires meets nothing and is lost; it leaves " +
                              namesOf(lost.left));
  for (const bool areNear : {false, true})
    if (const auto [names, share] = namesOfBacks(lost, areNear); share > 0)
      result.warnings.push_back(
          percent(share) + " of the light is swallowed by backs, those of " + names + ": " +
          (areNear
               ? "they lie close over something and hide it; cut away what is hidden, or it counts as dark"
               : "turn their faces, or make their material double-sided"));
  return result;
}

}  // namespace fiatlux
