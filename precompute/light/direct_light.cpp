#include "precompute/light/direct_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "precompute/base/parallel.h"
#include "precompute/light/emission.h"
#include "precompute/light/open_light.h"
#include "precompute/light/photometric_shadow.h"
#include "precompute/rays/effort.h"
#include "precompute/rays/float8.h"
#include "precompute/rays/places.h"
#include "precompute/rays/ray_sequence.h"

namespace fiatlux {

namespace {

// From so many edges of a whole patch on, Gauss's 2 x 2 points of it stand for 4 x 4 where no shadow falls:
// off by 5e-5 of the light at worst, by 5e-6 RMS, and the fourth power of the distance less further away.
constexpr double kFewPointsEdges = 8;

// How far before its site a tilted luminaire hangs, about; and what light must rise above a patch's plane, m.
constexpr double kTilted = 0.05, kInPlane = 1e-3;

/// Whether any of the points gets light of the source if nothing is between; which do.
bool findFacing(const Emission& source, const std::vector<PatchPoint>& points, std::vector<char>& facing) {
  facing.clear();
  bool any = false;
  for (const PatchPoint& point : points) {
    facing.push_back(faces(source, point.position, point.normal));
    any |= facing.back() != 0;
  }
  return any;
}

/// Where rays to the sources end.
BetweenPlaces::Places placesOf(const RayTracer& tracer, const std::vector<Emission>& sources) {
  BetweenPlaces::Places places;
  for (const Emission& source : sources)
    places.push_back(tracer.place(
        {source.startAt(0, 0), source.startAt(1, 0), source.startAt(1, 1), source.startAt(0, 1)}));
  return places;
}

/// Well-spread places on sources: for each shadow ray of a patch one, over and over from so many on.
constexpr std::uint32_t kPlaces = 4096;
const RaySequence& placesOnSources() {
  static const RaySequence sequence(kPlaces);
  return sequence;
}

/// How shadow rays go to a source from each point of a patch; one alone to a point source.
struct Probe {
  std::uint32_t rays;   // multiples of 4 are spread evenly, those of a point and those of neighbours together
  std::uint32_t split;  // light is told by split x split parts of the source
};

/// What shadow rays tell, points x rays; one for all shadows of a patch.
struct ShadowMemory {
  std::vector<float> visible;  // 0, or 1, also where none was cast
  std::vector<float> u, v;     // middle of the part of the source that the ray goes to

  void begin(std::size_t rays) {
    visible.assign(rays + 8, 1);  // eight can be read from any
    if (u.size() < rays + 8) u.resize(rays + 8), v.resize(rays + 8);
  }
};

/// Shadow rays from some points of one patch to all over the source.
class Shadow {
 public:
  /// Rays end on the source, or `lower` m before it. `blockers`: all that may stand there, where that is
  /// known.
  Shadow(const RayTracer& tracer, const Emission& source, Blockers* blockers, Probe probe,
         ShadowMemory& memory, double lower = 0)
      : tracer_(tracer),
        source_(source),
        blockers_(blockers),
        probe_(source.isPoint() ? Probe{1, 1} : probe),
        memory_(memory),
        corner_(inFloats(source.startAt(0, 0) + lower * source.normal() - tracer.center())),
        along_(inFloats(source.startAt(1, 0) - source.startAt(0, 0))),
        across_(inFloats(source.startAt(0, 1) - source.startAt(0, 0))) {}

  /// The first `rays` from each point that faces the source; no further than it takes to see that the verdict
  /// is 0.
  void begin(const std::vector<PatchPoint>& points, const std::vector<char>& facing, std::uint32_t rays,
             std::uint64_t seed) {
    seed_ = seed;
    memory_.begin(points.size() * probe_.rays);
    begunRays_ = std::min(rays, probe_.rays);
    for (begunPoints_ = 0; begunPoints_ < points.size(); ++begunPoints_) {
      if (cast_ > 0 && verdict() == 0) break;
      if (facing[begunPoints_]) castFrom(points[begunPoints_], begunPoints_, 0, begunRays_);
    }
    flush();
  }

  /// All others.
  void complete(const std::vector<PatchPoint>& points, const std::vector<char>& facing) {
    for (std::uint32_t i = 0; i < points.size(); ++i)
      if (facing[i]) castFrom(points[i], i, i < begunPoints_ ? begunRays_ : 0, probe_.rays);
    flush();
  }

  /// Whether what was cast is all visible (+1), all blocked (-1) or mixed (0).
  int verdict() const {
    if (cast_ == blocked_) return -1;
    return blocked_ == 0 ? 1 : 0;
  }

  /// Share of the rays that nothing blocked.
  double openShare() const { return cast_ > 0 ? static_cast<double>(cast_ - blocked_) / cast_ : 0; }

  /// Share of the light of the whole source that reaches point i.
  double visibleShare(const PatchPoint& point, std::size_t i) const {
    const std::size_t first = i * probe_.rays, end = first + probe_.rays;
    const auto own = memory_.visible.begin() + static_cast<std::ptrdiff_t>(first);
    if (std::all_of(own, own + probe_.rays, [&](float is) { return is == *own; })) return *own;
    Float8 all{}, seen{};
    for (std::size_t ray = first; ray < end; ray += 8) {
      const std::size_t count = std::min(end - ray, std::size_t{8});
      const Float8 light = lightOfParts(source_, point, unaligned8(&memory_.u[ray]),
                                        unaligned8(&memory_.v[ray]), 1.0 / probe_.split, count);
      all += light;
      seen += light * unaligned8(&memory_.visible[ray]);
    }
    return laneSum(all) > 0 ? laneSum(seen) / laneSum(all) : 0;
  }

 private:
  /// Rays `first` to before `last` of point i.
  void castFrom(const PatchPoint& point, std::uint32_t i, std::uint32_t first, std::uint32_t last) {
    const auto [x, y, z] = inFloats(point.position + tracer_.offset() * point.normal - tracer_.center());
    for (std::uint32_t ray = first; ray < last; ++ray) {
      const std::uint32_t lane = rays_.count++;
      rays_.originX[lane] = x, rays_.originY[lane] = y, rays_.originZ[lane] = z;
      rays_.reach[lane] = 1;
      index_[lane] = i * probe_.rays + ray;
      if (rays_.count == RayPacket::kSize) flush();
    }
  }

  void flush() {
    if (rays_.count == 0) return;
    std::uint32_t place[RayPacket::kSize]{};
    for (std::uint32_t i = 0; i < rays_.count; ++i) place[i] = index_[i] % kPlaces;
    const auto [u, v] =
        placesOnSources().eightPairs(place, RaySequence::scramble(seed_ + index_[0] / kPlaces));
    aim(0, u, v, rays_.originX, rays_.directionX);
    aim(1, u, v, rays_.originY, rays_.directionY);
    aim(2, u, v, rays_.originZ, rays_.directionZ);
    bool blocked[RayPacket::kSize];
    if (blockers_) {
      blockers_->occluded(rays_, blocked);
    } else {
      tracer_.occluded(rays_, blocked, true);  // from one patch to one source
    }
    const Float8 partU = middleOfPart(u), partV = middleOfPart(v);
    for (std::uint32_t i = 0; i < rays_.count; ++i) {
      memory_.visible[index_[i]] = blocked[i] ? 0.0f : 1.0f;
      memory_.u[index_[i]] = partU[i];
      memory_.v[index_[i]] = partV[i];
      blocked_ += blocked[i];
    }
    cast_ += rays_.count;
    rays_.count = 0;
  }

  /// Of the part of the source that a ray goes to; u or v of both.
  Float8 middleOfPart(Float8 along) const {
    const auto split = static_cast<float>(probe_.split);
    return (__builtin_convertvector(__builtin_convertvector(along * split, Mask8), Float8) + 0.5f) / split;
  }

  void aim(int axis, Float8 u, Float8 v, const float* origin, float* direction) const {
    const Float8 way = corner_[axis] + u * along_[axis] + v * across_[axis] - load8(origin);
    std::memcpy(direction, &way, sizeof way);
  }

  const RayTracer& tracer_;
  const Emission& source_;
  Blockers* blockers_;
  Probe probe_;
  ShadowMemory& memory_;
  std::array<float, 3> corner_, along_, across_;  // m, of where rays end, from the tracer's centre
  std::uint64_t seed_ = 0;
  std::uint32_t begunPoints_ = 0, begunRays_ = 0;
  std::size_t cast_ = 0, blocked_ = 0;
  RayPacket rays_;
  std::uint32_t index_[RayPacket::kSize];  // points x rays
};

/// What a source does to a patch: lx, and the share 0..1 that arrives of what would without any shadow.
struct PatchLight {
  double illuminance = 0, visible = 0;
};

/// Points all over a patch: many, and those of them that are enough where light changes little; empty where
/// there are none.
struct PatchPoints {
  std::vector<PatchPoint> many, few;
};

/// Whether the few points are enough for the whole source's light: far away, and no horizon between them.
bool isEven(const Emission& source, const PatchPoints& points, const std::vector<char>& facing, double edge) {
  if (points.few.empty()) return false;
  const PatchPoint& point = points.few[0];
  const double away =
      length(source.position() - point.position) - 0.5 * std::hypot(source.width(), source.height());
  if (away < kFewPointsEdges * edge) return false;
  return std::all_of(facing.begin(), facing.end(), [](char is) { return is != 0; }) &&
         std::all_of(source.corners().begin(), source.corners().end(),
                     [&](const Vec3& corner) { return dot(corner - point.position, point.normal) > 0; });
}

/// What stands between a patch and a source: where that is unknown, something of `blockers`, if they are
/// there, or of the room.
struct Shade {
  Between between = Between::kUnknown;
  Blockers* blockers = nullptr;
};

/// Mean illuminance over one patch by its points, of which the many that are `facing` see the source: where
/// it is not known what stands between, `few` shadow rays go to the source from each, and all of the probe's
/// where a shadow's edge crosses the patch. `edge`: of the patch, m.
PatchLight patchLight(const RayTracer& tracer, const Emission& source, const PatchPoints& points,
                      const std::vector<char>& facing, const Shade& shade, double edge, std::uint32_t few,
                      Probe probe, std::uint64_t seed, ShadowMemory& memory) {
  if (shade.between == Between::kWall) return {};
  bool isClear = shade.between == Between::kNothing;
  Shadow shadow(tracer, source, shade.blockers, probe, memory);
  if (!isClear) {
    shadow.begin(points.many, facing, few, seed);
    if (shadow.verdict() < 0) return {};
    isClear = shadow.verdict() > 0;
    if (!isClear) shadow.complete(points.many, facing);
  }
  const bool isFew = isClear && isEven(source, points, facing, edge);
  const std::vector<PatchPoint>& used = isFew ? points.few : points.many;
  double sum = 0, all = 0;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!isFew && !facing[i]) continue;
    const double lit = used[i].weight * openLightFar(source, used[i].position, used[i].normal);
    sum += isClear ? lit : lit * shadow.visibleShare(used[i], i);
    all += lit;
  }
  return {sum, all > 0 ? sum / all : 0};
}

/// Share 0..1 of the source, a little lowered, that is seen where a Lambertian square sends nothing, but a
/// luminaire may that is tilted or shines upwards: beside it on its mount, and above.
double shareFromBehind(const RayTracer& tracer, const Emission& source, const std::vector<PatchPoint>& points,
                       std::uint64_t seed, std::vector<char>& facing, ShadowMemory& memory) {
  const Vec3 place = source.position() + kTilted * source.normal();
  facing.clear();
  bool any = false;
  for (const PatchPoint& point : points) {
    facing.push_back(!faces(source, point.position, point.normal) &&
                     dot(place - point.position, point.normal) > kInPlane);
    any |= facing.back() != 0;
  }
  if (!any) return 0;
  Shadow shadow(tracer, source, nullptr, {1, 1}, memory, kTilted);
  shadow.begin(points, facing, 0, seed + 2);
  shadow.complete(points, facing);
  return shadow.openShare();
}

/// What rows of a room get from some luminaires, row by row, on any thread.
class RowLight {
 public:
  RowLight(const Room& room, const RayTracer& tracer, const std::vector<Luminaire>& luminaires,
           const DirectLightOptions& options)
      : room_(room),
        tracer_(tracer),
        luminaires_(luminaires),
        sources_(luminaires.begin(), luminaires.end()),
        split_(options.draft ? 1 : options.split),
        isDraft_(options.draft),
        seed_(mixBits(options.seed ^ 0xd1ec7u)),
        effort_(effortOfRows(room.patches, options.draft)),
        between_(tracer, placesOfClusters(room, tracer), placesOf(tracer, sources_)) {}

  /// light[j * stride] is what source j gives row p; visible[j * stride] the step of the share that shadows
  /// let through, where not nullptr.
  void row(std::uint32_t p, std::size_t stride, float* light, std::uint8_t* visible) const {
    constexpr std::uint32_t kPoints =
        4;  // on a patch's edge: fewer miss the shadows of table legs and frames
    const PatchSampler sampler(room_, p);
    PatchPoints points{sampler.quadrature(kPoints), {}};
    if (sampler.isFullCell()) points.few = sampler.quadrature(2);
    const double edge = std::sqrt(room_.patches.area[p]);
    const bool isSmall = effort_[p] >= 2;
    const std::uint32_t split = (isSmall ? 2 : 1) * split_, finer = isDraft_ ? split : 2 * split;
    // Spread so well, three rays tell a shadow's edge as four parts would; on surfaces of few patches, which
    // average over little, there is one to each part.
    const Probe probe{isSmall || isDraft_ ? finer * finer : finer * finer * 3 / 4, finer};
    const std::optional<Place> place = placeOf(room_, tracer_, {&p, 1});
    std::vector<char> facing;
    Blockers blockers;
    ShadowMemory memory;
    for (std::size_t j = 0; j < sources_.size(); ++j) {
      const std::uint64_t own = mixBits(seed_ ^ (std::uint64_t{p} << 32 | j));
      if (sources_[j].isPhotometric()) {
        light[j * stride] = static_cast<float>(photometricPatchLight(
            tracer_, sampler, room_.patches.center[p], 0.5 * edge, luminaires_[j], split, own));
        continue;
      }
      PatchLight lit;
      if (findFacing(sources_[j], points.many, facing))
        lit = patchLight(tracer_, sources_[j], points, facing, shadeOf(p, place, j, blockers), edge,
                         split * split, probe, own, memory);
      light[j * stride] = static_cast<float>(lit.illuminance);
      if (visible && lit.visible == 0)
        lit.visible = shareFromBehind(tracer_, sources_[j], points.many, own, facing, memory);
      if (visible) visible[j * stride] = SiteVisibility::stepOf(lit.visible);
    }
  }

 private:
  Shade shadeOf(std::uint32_t p, const std::optional<Place>& place, std::size_t source,
                Blockers& blockers) const {
    if (p < room_.patches.count) {
      const Between known = between_.at(room_.patches.cluster[p], source);
      if (known != Between::kUnknown) return {known};
    }
    if (!place) return {};
    const Between known = tracer_.between(*place, *between_.to(source), blockers);
    return {known, blockers.isFull() ? nullptr : &blockers};
  }

  const Room& room_;
  const RayTracer& tracer_;
  const std::vector<Luminaire>& luminaires_;
  std::vector<Emission> sources_;
  std::uint32_t split_;
  bool isDraft_;
  std::uint64_t seed_;
  std::vector<std::uint32_t> effort_;  // rows
  BetweenPlaces between_;              // clusters x sources
};

/// Room for the steps of so many rows; nullptr where nobody wants them.
std::uint8_t* stepsOf(SiteVisibility* visibility, std::uint32_t rows, std::size_t sites) {
  if (!visibility) return nullptr;
  *visibility = {rows, static_cast<std::uint32_t>(sites), std::vector<std::uint8_t>(rows * sites)};
  return visibility->steps.data();
}

}  // namespace

std::vector<float> directLight(const Room& room, const RayTracer& tracer,
                               const std::vector<Luminaire>& luminaires, const DirectLightOptions& options,
                               SiteVisibility* visibility) {
  const std::uint32_t rows = room.patches.rows();
  std::vector<float> light(std::size_t{rows} * luminaires.size());
  std::uint8_t* const visible = stepsOf(visibility, rows, luminaires.size());
  const RowLight rowLight(room, tracer, luminaires, options);
  constexpr std::uint32_t kRows = 32;  // a thread's portion
  const auto lightRows = [&](std::uint32_t first, std::uint32_t end) {
    for (std::uint32_t p = first; p < end; ++p)
      rowLight.row(p, rows, light.data() + p, visible ? visible + p : nullptr);
  };
  parallelPortions(rows, kRows, options.threads, lightRows, options.progress);
  return light;
}

std::vector<float> directLightOfRows(const Room& room, const RayTracer& tracer,
                                     const std::vector<Luminaire>& luminaires,
                                     const DirectLightOptions& options, std::uint32_t first,
                                     std::uint32_t count, SiteVisibility* visibility) {
  const RowLight rowLight(room, tracer, luminaires, options);
  std::vector<float> light(count * luminaires.size());
  std::uint8_t* const visible = stepsOf(visibility, count, luminaires.size());
  for (std::uint32_t i = 0; i < count; ++i)
    rowLight.row(first + i, count, light.data() + i, visible ? visible + i : nullptr);
  return light;
}

double directLightAt(const RayTracer& tracer, const PatchPoint& receiver, const Luminaire& luminaire,
                     std::uint32_t split, std::uint64_t seed) {
  const Emission source(luminaire);
  if (source.isPhotometric()) return photometricPointLight(tracer, receiver, luminaire, split, mixBits(seed));
  if (!faces(source, receiver.position, receiver.normal)) return 0;
  ShadowMemory memory;
  Shadow shadow(tracer, source, nullptr, {split * split, split}, memory);
  shadow.begin({receiver}, {1}, split * split, mixBits(seed));
  const double lit = openLight(source, receiver.position, receiver.normal);
  return shadow.verdict() > 0 ? lit : lit * shadow.visibleShare(receiver, 0);
}

}  // namespace fiatlux
