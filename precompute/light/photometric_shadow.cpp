#include "precompute/light/photometric_shadow.h"

#include <algorithm>
#include <cmath>

#include "core/base/random.h"
#include "precompute/light/emission.h"

namespace fiatlux {
namespace {

constexpr double kNearField = 3, kBeamParts = 8, kNearest = 0.15, kWidestStep = 0.25;  // the last in rad
constexpr std::uint32_t kLeastPoints = 5, kMostPoints = 16, kMostParts = 16;

std::uint32_t partsOf(double size, double distance, std::uint32_t least) {
  if (size <= 0) return 1;
  const double parts = std::ceil(kNearField * size / std::max(distance, 1e-6));
  return std::clamp(static_cast<std::uint32_t>(std::min<double>(parts, kMostParts)), least,
                    std::max(least, kMostParts));
}

/// Shadow rays with the light that each carries if nothing blocks it.
class LitRays {
 public:
  explicit LitRays(const RayTracer& tracer) : tracer_(tracer) {}
  void add(const Vec3& origin, const Vec3& target, double light) {
    tracer_.aim(packet_, origin, target - origin, 1);
    light_[packet_.count - 1] = light;
    if (packet_.count == RayPacket::kSize) flush();
  }
  double sum() {
    if (packet_.count > 0) flush();
    return sum_;
  }

 private:
  void flush() {
    bool blocked[RayPacket::kSize];
    tracer_.occluded(packet_, blocked, true);
    for (std::uint32_t i = 0; i < packet_.count; ++i)
      if (!blocked[i]) sum_ += light_[i];
    packet_.count = 0;
  }
  const RayTracer& tracer_;
  RayPacket packet_;
  double light_[RayPacket::kSize] = {};
  double sum_ = 0;
};

/// Where light is looked up, and where its shadow ray starts.
struct Receiver {
  PatchPoint lit, start;
};

/// Mean light on `count` places of equal weight, by one ray to each part of the luminaire from each: the i-th
/// is what receiver(i, random) says, anew for each ray.
template <class ReceiverOf>
double lightOn(const RayTracer& tracer, std::uint32_t count, const ReceiverOf& receiver, double distance,
               const Luminaire& luminaire, std::uint32_t split, std::uint64_t seed) {
  const std::uint32_t nu = partsOf(luminaire.width, distance, split),
                      nv = partsOf(luminaire.height, distance, split);
  const Emission source(luminaire);
  Random random(seed);
  LitRays rays(tracer);
  for (std::uint32_t i = 0; i < count; ++i)
    for (std::uint32_t part = 0; part < nu * nv; ++part) {
      const double u = (part % nu + random.unit()) / nu, v = (part / nu + random.unit()) / nv;
      const auto [lit, start] = receiver(i, random);
      const Vec3 d = lit.position - source.at(u, v);
      const double squared = dot(d, d), incidence = -dot(d, lit.normal);
      if (incidence <= 0 || squared <= 0) continue;
      const double light = source.intensity(d) * incidence / (squared * std::sqrt(squared));
      if (light > 0)
        rays.add(start.position + tracer.offset() * start.normal, source.startAt(u, v),
                 light / (nu * nv) / count);
    }
  return rays.sum();
}

}  // namespace

double photometricPatchLight(const RayTracer& tracer, const PatchSampler& patch, const Vec3& center,
                             double radius, const Luminaire& luminaire, std::uint32_t split,
                             std::uint64_t seed) {
  const double distance = length(center - luminaire.position);
  const double reach = radius + 0.5 * std::max(luminaire.width, luminaire.height);
  const double nearest = std::max(distance - reach, kNearest * distance);
  const double step = nearest * std::min(luminaire.beam / kBeamParts, kWidestStep);
  const auto edge = static_cast<std::uint32_t>(
      std::clamp<double>(std::ceil(2 * radius / std::max(step, 1e-6)), kLeastPoints, kMostPoints));
  // Rays start anywhere around their point. From the points alone they missed or doubled a shadow's edge that
  // runs along the patches by as much in each of them: 3 % of a narrow beam's lumens.
  const auto receiver = [&](std::uint32_t i, Random& random) -> Receiver {
    const std::uint32_t row = i / edge, column = i % edge;
    const double s = random.unit(), t = random.unit();
    const PatchPoint start = patch.at((row + s) / edge, (column + t) / edge);
    return {patch.isFullCell() ? patch.at((row + 0.5) / edge, (column + 0.5) / edge) : start, start};
  };
  return lightOn(tracer, edge * edge, receiver, nearest, luminaire, split, seed);
}

double photometricPointLight(const RayTracer& tracer, const PatchPoint& receiver, const Luminaire& luminaire,
                             std::uint32_t split, std::uint64_t seed) {
  const auto same = [&](std::uint32_t, Random&) { return Receiver{receiver, receiver}; };
  return lightOn(tracer, 1, same, length(receiver.position - luminaire.position), luminaire, split, seed);
}

}  // namespace fiatlux
