#include "precompute/light/photometric_shadow.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "core/base/random.h"
#include "precompute/light/emission.h"

namespace fiatlux {
namespace {

constexpr double kNearField = 3, kBeamParts = 8, kNearest = 0.15, kWidestStep = 0.25;  // the last in rad
constexpr std::uint32_t kLeastPoints = 4, kMostPoints = 16, kMostParts = 16;

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

double lightOn(const RayTracer& tracer, std::span<const PatchPoint> points, double distance,
               const Luminaire& luminaire, std::uint32_t split, std::uint64_t seed) {
  const std::uint32_t nu = partsOf(luminaire.width, distance, split),
                      nv = partsOf(luminaire.height, distance, split);
  const Emission source(luminaire);
  Random random(seed);
  LitRays rays(tracer);
  for (const PatchPoint& point : points) {
    const Vec3 origin = point.position + tracer.offset() * point.normal;
    for (std::uint32_t part = 0; part < nu * nv; ++part) {
      const double u = (part % nu + random.unit()) / nu, v = (part / nu + random.unit()) / nv;
      const Vec3 d = point.position - source.at(u, v);
      const double squared = dot(d, d), incidence = -dot(d, point.normal);
      if (incidence <= 0 || squared <= 0) continue;
      const double light = source.intensity(d) * incidence / (squared * std::sqrt(squared) * nu * nv);
      if (light > 0) rays.add(origin, source.startAt(u, v), point.weight * light);
    }
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
  const double edge =
      std::clamp<double>(std::ceil(2 * radius / std::max(step, 1e-6)), kLeastPoints, kMostPoints);
  const std::vector<PatchPoint> points = patch.quadrature(static_cast<std::uint32_t>(edge));
  return lightOn(tracer, points, nearest, luminaire, split, seed);
}

double photometricPointLight(const RayTracer& tracer, const PatchPoint& receiver, const Luminaire& luminaire,
                             std::uint32_t split, std::uint64_t seed) {
  PatchPoint point = receiver;
  point.weight = 1;
  return lightOn(tracer, {&point, 1}, length(receiver.position - luminaire.position), luminaire, split, seed);
}

}  // namespace fiatlux
