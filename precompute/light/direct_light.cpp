#include "precompute/light/direct_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/base/random.h"
#include "core/transport/polygon_form_factor.h"
#include "precompute/base/parallel.h"
#include "precompute/rays/effort.h"
#include "precompute/rays/ray_sequence.h"

namespace fiatlux {

namespace {

/// Receivers less than this in front of a source's plane get nothing from it, m: the mount itself, rounded.
constexpr double kFront = 1e-5;

/// A luminaire prepared for many receivers.
struct Source {
  Luminaire luminaire;
  Vec3 halfU, halfV;  // m, from the centre to the middle of a side
  bool isPoint, oneSided;
  std::array<Vec3, 4> corners;

  explicit Source(const Luminaire& l) : luminaire(l) {
    isPoint = !(l.width > 0 && l.height > 0);
    oneSided = !isPoint || l.distribution == Luminaire::Distribution::kLambertian;
    halfU = 0.5 * l.width * l.axis;
    halfV = 0.5 * l.height * cross(l.normal, l.axis);
    corners = part(0, 1, 0, 1);
  }
  Vec3 at(double u, double v) const { return luminaire.position + (2 * u - 1) * halfU + (2 * v - 1) * halfV; }
  std::array<Vec3, 4> part(double u0, double u1, double v0, double v1) const {
    return {at(u0, v0), at(u1, v0), at(u1, v1), at(u0, v1)};
  }
};

/// Whether a point gets any light of the source if nothing is between.
bool faces(const Source& source, const Vec3& position, const Vec3& normal) {
  const Luminaire& l = source.luminaire;
  if (source.oneSided && dot(position - l.position, l.normal) <= kFront) return false;
  if (source.isPoint) return dot(l.position - position, normal) > 0;
  return std::any_of(source.corners.begin(), source.corners.end(),
                     [&](const Vec3& corner) { return dot(corner - position, normal) > 0; });
}

/// lx without any shadow.
double unshadowed(const Source& source, const Vec3& position, const Vec3& normal) {
  const Luminaire& l = source.luminaire;
  const Vec3 d = position - l.position;
  const double front = dot(d, l.normal);
  if (source.oneSided && front <= kFront) return 0;
  if (!source.isPoint) {
    // Lambertian exitance flux / area times the share of the receiver's hemisphere.
    return l.flux / (l.width * l.height) * polygonFormFactor(position, normal, source.corners.data(), 4);
  }
  const double squared = dot(d, d), incidence = -dot(d, normal);
  if (incidence <= 0 || squared <= 0) return 0;
  const double perLength = incidence / (squared * std::sqrt(squared));
  if (!source.oneSided) return l.flux / (4 * std::numbers::pi) * perLength;
  return l.flux / std::numbers::pi * front / std::sqrt(squared) * perLength;
}

/// Relative light of one part of the source, u and v in parts of 1: exact nearby, by its centre further away.
double partWeight(const Source& source, const Vec3& position, const Vec3& normal, double u, double v,
                  double edge) {
  const Vec3 center = source.at(u + 0.5 * edge, v + 0.5 * edge);
  const Vec3 d = position - center;
  const double squared = dot(d, d);
  const double largest = edge * std::max(source.luminaire.width, source.luminaire.height);
  const double incidence = -dot(d, normal);
  if (squared < 9 * largest * largest || incidence < largest) {
    return polygonFormFactor(position, normal, source.part(u, u + edge, v, v + edge).data(), 4);
  }
  const double area = edge * edge * source.luminaire.width * source.luminaire.height;
  return area * incidence * dot(d, source.luminaire.normal) / (std::numbers::pi * squared * squared);
}

/// Shadow rays from some points of one patch to split x split parts of the source.
class Shadow {
 public:
  Shadow(const RayTracer& tracer, const Source& source) : tracer_(tracer), source_(source) {}

  /// visible[i * split^2 + part] for each point i that faces the source; true elsewhere. `untilMixed`: no
  /// further than it takes to see that the verdict is 0.
  void cast(const std::vector<PatchPoint>& points, const std::vector<char>& facing, std::uint32_t split,
            bool untilMixed, Random random) {
    split_ = source_.isPoint ? 1 : split;
    const std::uint32_t parts = split_ * split_;
    visible_.assign(points.size() * parts, 1);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!facing[i]) continue;
      if (untilMixed && cast_ > 0 && verdict() == 0) return;
      const Vec3 origin = points[i].position + tracer_.offset() * points[i].normal;
      for (std::uint32_t part = 0; part < parts; ++part) {
        const double u = (part % split_ + random.unit()) / split_,
                     v = (part / split_ + random.unit()) / split_;
        const Vec3 target = source_.at(u, v) + kLuminaireClearance * source_.luminaire.normal;
        tracer_.aim(packet_, origin, target - origin, 1);
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
    tracer_.occluded(packet_, blocked, true);  // from one patch to one source
    for (std::uint32_t i = 0; i < packet_.count; ++i) {
      visible_[lane_[i]] = !blocked[i];
      blocked_ += blocked[i];
    }
    cast_ += packet_.count;
    packet_.count = 0;
  }

  const RayTracer& tracer_;
  const Source& source_;
  std::uint32_t split_ = 1;
  std::size_t cast_ = 0, blocked_ = 0;
  std::vector<char> visible_;
  RayPacket packet_;
  std::size_t lane_[RayPacket::kSize];
};

/// Mean illuminance over one patch by its `points`: shadow rays to split x split parts of the source from
/// each, and to penumbra x penumbra where a shadow's edge crosses the patch. `facing` is scratch.
double patchLight(const RayTracer& tracer, const Source& source, const std::vector<PatchPoint>& points,
                  std::uint32_t split, std::uint32_t penumbra, std::uint64_t seed,
                  std::vector<char>& facing) {
  facing.clear();
  for (const PatchPoint& point : points) facing.push_back(faces(source, point.position, point.normal));
  Shadow probe(tracer, source);
  probe.cast(points, facing, split, true, Random(seed));
  if (probe.verdict() < 0) return 0;

  Shadow shadow(tracer, source);
  if (probe.verdict() == 0) shadow.cast(points, facing, penumbra, false, Random(seed, 1));
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!facing[i]) continue;
    const double lit = points[i].weight * unshadowed(source, points[i].position, points[i].normal);
    sum += probe.verdict() > 0 ? lit : lit * shadow.visibleShare(points[i], i);
  }
  return sum;
}

}  // namespace

std::vector<float> directLight(const Room& room, const RayTracer& tracer,
                               const std::vector<Luminaire>& luminaires, const DirectLightOptions& options) {
  const std::uint32_t rows = room.patches.rows();
  const std::vector<Source> sources(luminaires.begin(), luminaires.end());
  std::vector<float> light(std::size_t{rows} * sources.size());
  const std::uint64_t seed = mixBits(options.seed ^ 0xd1ec7u);
  const std::vector<std::uint32_t> effort = effortOfRows(room.patches);
  constexpr std::uint32_t kRows = 32;   // a thread's portion
  constexpr std::uint32_t kPoints = 4;  // on a patch's edge: fewer miss the shadows of table legs and frames
  const auto lightRows = [&](std::size_t portion) {
    std::vector<char> facing;
    const auto first = static_cast<std::uint32_t>(portion) * kRows;
    for (std::uint32_t p = first; p < std::min(first + kRows, rows); ++p) {
      const std::vector<PatchPoint> points = PatchSampler(room, p).quadrature(kPoints);
      const bool isSmall = effort[p] >= 2;
      const std::uint32_t split = (isSmall ? 2 : 1) * options.split, penumbra = (isSmall ? 4 : 2) * split;
      for (std::size_t j = 0; j < sources.size(); ++j) {
        light[j * rows + p] =
            static_cast<float>(patchLight(tracer, sources[j], points, split, penumbra,
                                          mixBits(seed ^ (std::uint64_t{p} << 32 | j)), facing));
      }
    }
  };
  parallelFor((rows + kRows - 1) / kRows, options.threads, lightRows, options.progress);
  return light;
}

double directLightAt(const RayTracer& tracer, const PatchPoint& receiver, const Luminaire& luminaire,
                     std::uint32_t split, std::uint64_t seed) {
  const Source source(luminaire);
  if (!faces(source, receiver.position, receiver.normal)) return 0;
  Shadow shadow(tracer, source);
  shadow.cast({receiver}, {1}, split, false, Random(mixBits(seed)));
  const double lit = unshadowed(source, receiver.position, receiver.normal);
  return shadow.verdict() > 0 ? lit : lit * shadow.visibleShare(receiver, 0);
}

}  // namespace fiatlux
