#include "precompute/light/direct_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/random.h"
#include "core/transport/polygon_form_factor.h"
#include "precompute/base/parallel.h"
#include "precompute/light/emission.h"
#include "precompute/light/photometric_shadow.h"
#include "precompute/rays/effort.h"
#include "precompute/rays/places.h"
#include "precompute/rays/ray_sequence.h"

namespace fiatlux {

namespace {

// Nearer to a part of the source than this many of its edges, its own form factor is needed; beyond, its
// centre will do.
constexpr double kExactEdges = 3;

// From so many edges of a whole patch on, Gauss's 2 x 2 points of it stand for 4 x 4 where no shadow falls:
// off by 5e-5 of the light at worst, by 5e-6 RMS, and the fourth power of the distance less further away.
constexpr double kFewPointsEdges = 8;

// From so many edges of a source on, Gauss's 2 x 2 points of it stand for its own form factor: off by 1e-4 at
// most.
constexpr double kGaussEdges = 4;

// How far before its site a tilted luminaire hangs, about; and what light must rise above a patch's plane, m.
constexpr double kTilted = 0.05, kInPlane = 1e-3;

/// Whether a point gets any light of the source if nothing is between.
bool faces(const Emission& source, const Vec3& position, const Vec3& normal) {
  if (source.isBehind(position)) return false;
  if (source.isPoint()) return dot(source.position() - position, normal) > 0;
  return std::any_of(source.corners().begin(), source.corners().end(),
                     [&](const Vec3& corner) { return dot(corner - position, normal) > 0; });
}

/// Whether any of the points is one; which are.
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

/// lx without any shadow.
double unshadowed(const Emission& source, const Vec3& position, const Vec3& normal) {
  if (source.isBehind(position)) return 0;
  if (!source.isPoint()) {
    // Lambertian exitance times the share of the receiver's hemisphere that the source fills.
    return source.exitance() * polygonFormFactor(position, normal, source.corners().data(), 4);
  }
  const Vec3 d = position - source.position();
  const double squared = dot(d, d), incidence = -dot(d, normal);
  if (incidence <= 0 || squared <= 0) return 0;
  return source.intensity(d) * (incidence / (squared * std::sqrt(squared)));
}

/// The same; of an area that is far away and all of it before the receiver, by Gauss's 2 x 2 points of it.
double unshadowedFar(const Emission& source, const Vec3& position, const Vec3& normal) {
  const double largest = std::max(source.width(), source.height());
  const Vec3 away = source.position() - position;
  if (source.isPoint() || source.isBehind(position) ||
      dot(away, away) < kGaussEdges * kGaussEdges * largest * largest || dot(away, normal) < largest)
    return unshadowed(source, position, normal);
  double sum = 0;
  for (const double u : {kGaussNode, 1 - kGaussNode})
    for (const double v : {kGaussNode, 1 - kGaussNode}) {
      const Vec3 d = position - source.at(u, v);
      const double squared = dot(d, d);
      sum -= dot(d, normal) * dot(d, source.normal()) / (squared * squared);
    }
  return source.exitance() * source.width() * source.height() / (4 * std::numbers::pi) * sum;
}

/// Relative light of one part of the source, u and v in parts of 1: exact nearby, by its centre further away.
double partWeight(const Emission& source, const Vec3& position, const Vec3& normal, double u, double v,
                  double edge) {
  const Vec3 d = position - source.at(u + 0.5 * edge, v + 0.5 * edge);
  const double squared = dot(d, d);
  const double largest = edge * std::max(source.width(), source.height());
  const double incidence = -dot(d, normal);
  if (squared < kExactEdges * kExactEdges * largest * largest || incidence < largest) {
    return polygonFormFactor(position, normal, source.part(u, u + edge, v, v + edge).data(), 4);
  }
  const double area = edge * edge * source.width() * source.height();
  return area * incidence * dot(d, source.normal()) / (std::numbers::pi * squared * squared);
}

/// Shadow rays from some points of one patch to split x split parts of the source.
class Shadow {
 public:
  /// Rays end on the source, or `lower` m before it. `blockers`: all that may stand there, where that is
  /// known.
  Shadow(const RayTracer& tracer, const Emission& source, const Blockers* blockers, double lower = 0)
      : tracer_(tracer), source_(source), blockers_(blockers), lower_(lower * source.normal()) {}

  /// visible[i * split^2 + part] for each point i that faces the source; true elsewhere. `untilMixed`: no
  /// further than it takes to see that the verdict is 0.
  void cast(const std::vector<PatchPoint>& points, const std::vector<char>& facing, std::uint32_t split,
            bool untilMixed, Random random) {
    split_ = source_.isPoint() ? 1 : split;
    const std::uint32_t parts = split_ * split_;
    visible_.assign(points.size() * parts, 1);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!facing[i]) continue;
      if (untilMixed && cast_ > 0 && verdict() == 0) return;
      const Vec3 origin = points[i].position + tracer_.offset() * points[i].normal;
      for (std::uint32_t part = 0; part < parts; ++part) {
        const double u = (part % split_ + random.unit()) / split_,
                     v = (part / split_ + random.unit()) / split_;
        tracer_.aim(packet_, origin, source_.startAt(u, v) + lower_ - origin, 1);
        lane_[packet_.count - 1] = i * parts + part;
        if (packet_.count == RayPacket::kSize) flush();
      }
    }
    if (packet_.count > 0) flush();
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
    const std::uint32_t parts = split_ * split_;
    if (parts == 1) return visible_[i];
    double all = 0, seen = 0;
    for (std::uint32_t part = 0; part < parts; ++part) {
      const double edge = 1.0 / split_;
      const double weight =
          partWeight(source_, point.position, point.normal, part % split_ * edge, part / split_ * edge, edge);
      all += weight;
      if (visible_[i * parts + part]) seen += weight;
    }
    return all > 0 ? seen / all : 0;
  }

 private:
  void flush() {
    bool blocked[RayPacket::kSize];
    if (blockers_) {
      blockers_->occluded(packet_, blocked);
    } else {
      tracer_.occluded(packet_, blocked, true);  // from one patch to one source
    }
    for (std::uint32_t i = 0; i < packet_.count; ++i) {
      visible_[lane_[i]] = !blocked[i];
      blocked_ += blocked[i];
    }
    cast_ += packet_.count;
    packet_.count = 0;
  }

  const RayTracer& tracer_;
  const Emission& source_;
  const Blockers* blockers_;
  Vec3 lower_;  // m
  std::uint32_t split_ = 1;
  std::size_t cast_ = 0, blocked_ = 0;
  std::vector<char> visible_;
  RayPacket packet_;
  std::size_t lane_[RayPacket::kSize];
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
  const Blockers* blockers = nullptr;
};

/// Mean illuminance over one patch by its points, of which the many that are `facing` see the source: where
/// it is not known what stands between, shadow rays go to split x split parts of the source from each, and
/// to penumbra x penumbra, if these are more, where a shadow's edge crosses the patch. `edge`: of the patch,
/// m.
PatchLight patchLight(const RayTracer& tracer, const Emission& source, const PatchPoints& points,
                      const std::vector<char>& facing, const Shade& shade, double edge, std::uint32_t split,
                      std::uint32_t penumbra, std::uint64_t seed) {
  if (shade.between == Between::kWall) return {};
  bool isClear = shade.between == Between::kNothing;
  Shadow shadow(tracer, source, shade.blockers);
  if (!isClear) {
    shadow.cast(points.many, facing, split, penumbra > split, Random(seed));
    if (shadow.verdict() < 0) return {};
    isClear = shadow.verdict() > 0;
    if (!isClear && penumbra > split) shadow.cast(points.many, facing, penumbra, false, Random(seed, 1));
  }
  const bool isFew = isClear && isEven(source, points, facing, edge);
  const std::vector<PatchPoint>& used = isFew ? points.few : points.many;
  double sum = 0, all = 0;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!isFew && !facing[i]) continue;
    const double lit = used[i].weight * unshadowedFar(source, used[i].position, used[i].normal);
    sum += isClear ? lit : lit * shadow.visibleShare(used[i], i);
    all += lit;
  }
  return {sum, all > 0 ? sum / all : 0};
}

/// Share 0..1 of the source, a little lowered, that is seen where a Lambertian square sends nothing, but a
/// luminaire may that is tilted or shines upwards: beside it on its mount, and above.
double shareFromBehind(const RayTracer& tracer, const Emission& source, const std::vector<PatchPoint>& points,
                       std::uint64_t seed, std::vector<char>& facing) {
  const Vec3 place = source.position() + kTilted * source.normal();
  facing.clear();
  bool any = false;
  for (const PatchPoint& point : points) {
    facing.push_back(!faces(source, point.position, point.normal) &&
                     dot(place - point.position, point.normal) > kInPlane);
    any |= facing.back() != 0;
  }
  if (!any) return 0;
  Shadow shadow(tracer, source, nullptr, kTilted);
  shadow.cast(points, facing, 1, false, Random(seed, 2));
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
        finer_(options.draft ? 1 : 2),
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
    const std::uint32_t split = (isSmall ? 2 : 1) * split_, penumbra = finer_ * split;
    const std::optional<Place> place = placeOf(room_, tracer_, {&p, 1});
    std::vector<char> facing;
    Blockers blockers;
    for (std::size_t j = 0; j < sources_.size(); ++j) {
      const std::uint64_t own = mixBits(seed_ ^ (std::uint64_t{p} << 32 | j));
      if (sources_[j].isPhotometric()) {
        light[j * stride] = static_cast<float>(photometricPatchLight(
            tracer_, sampler, room_.patches.center[p], 0.5 * edge, luminaires_[j], split, own));
        continue;
      }
      PatchLight lit;
      if (findFacing(sources_[j], points.many, facing))
        lit = patchLight(tracer_, sources_[j], points, facing, shadeOf(p, place, j, blockers), edge, split,
                         penumbra, own);
      light[j * stride] = static_cast<float>(lit.illuminance);
      if (visible && lit.visible == 0)
        lit.visible = shareFromBehind(tracer_, sources_[j], points.many, own, facing);
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
  std::uint32_t split_, finer_;  // times as many parts at a shadow's edge
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
  Shadow shadow(tracer, source, nullptr);
  shadow.cast({receiver}, {1}, split, false, Random(mixBits(seed)));
  const double lit = unshadowed(source, receiver.position, receiver.normal);
  return shadow.verdict() > 0 ? lit : lit * shadow.visibleShare(receiver, 0);
}

}  // namespace fiatlux
