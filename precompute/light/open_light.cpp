#include "precompute/light/open_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/transport/polygon_form_factor.h"

namespace fiatlux {
namespace {

// Nearer to a part of the source than this many of its edges, its own form factor is needed; beyond, its
// middle will do.
constexpr double kExactEdges = 3;

// From so many edges of a source on, Gauss's 2 x 2 points of it stand for its own form factor: off by 1e-4 at
// most.
constexpr double kGaussEdges = 4;

/// From eight places on an area, (u, v) of it, to a receiver. note: eightKernels() would do for the kernels,
/// but both normals in all lanes and its clamps make the light of a corridor take 3 % longer.
struct EightWays {
  EightWays(const Emission& source, const Vec3& position, const Vec3& normal, Float8 u, Float8 v) {
    const auto to = inFloats(position - source.at(0, 0)), along = inFloats(source.at(1, 0) - source.at(0, 0)),
               across = inFloats(source.at(0, 1) - source.at(0, 0)), leaving = inFloats(source.normal()),
               arriving = inFloats(normal);
    for (int axis = 0; axis < 3; ++axis) {
      const Float8 way = to[axis] - u * along[axis] - v * across[axis];
      squared += way * way;
      out += way * leaving[axis];
      in -= way * arriving[axis];
    }
  }

  /// cos cos / r^2: pi times the kernel. note: of what is before both only.
  Float8 kernels() const { return out * in / (squared * squared); }

  Float8 squared{}, out{}, in{};  // m^2; m over the source's plane and the receiver's
};

}  // namespace

bool faces(const Emission& source, const Vec3& position, const Vec3& normal) {
  if (source.isBehind(position)) return false;
  if (source.isPoint()) return dot(source.position() - position, normal) > 0;
  return std::any_of(source.corners().begin(), source.corners().end(),
                     [&](const Vec3& corner) { return dot(corner - position, normal) > 0; });
}

double openLight(const Emission& source, const Vec3& position, const Vec3& normal) {
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

double openLightFar(const Emission& source, const Vec3& position, const Vec3& normal) {
  const double largest = std::max(source.width(), source.height());
  const Vec3 away = source.position() - position;
  if (source.isPoint() || source.isBehind(position) ||
      dot(away, away) < kGaussEdges * kGaussEdges * largest * largest || dot(away, normal) < largest)
    return openLight(source, position, normal);
  constexpr auto low = static_cast<float>(kGaussNode), high = static_cast<float>(1 - kGaussNode);
  const EightWays ways(source, position, normal, Float8{low, low, high, high}, Float8{low, high, low, high});
  const Float8 kernels = ways.kernels();
  const float sum = (kernels[0] + kernels[1]) + (kernels[2] + kernels[3]);
  return source.exitance() * source.width() * source.height() / (4 * std::numbers::pi) * sum;
}

Float8 lightOfParts(const Emission& source, const PatchPoint& receiver, Float8 u, Float8 v, double edge,
                    std::size_t count) {
  const EightWays ways(source, receiver.position, receiver.normal, u, v);
  const double largest = edge * std::max(source.width(), source.height());
  const auto area = static_cast<float>(edge * edge * source.width() * source.height() / std::numbers::pi);
  Float8 light = area * ways.kernels();
  for (std::size_t i = count; i < 8; ++i) light[i] = 0;
  const auto exact = static_cast<float>(kExactEdges * kExactEdges * largest * largest);
  const unsigned near = bitsOf((ways.squared < all8(exact)) | (ways.in < all8(static_cast<float>(largest))));
  for (unsigned lanes = near & ((1u << count) - 1); lanes; lanes &= lanes - 1) {
    const int i = __builtin_ctz(lanes);
    const double u0 = u[i] - 0.5 * edge, v0 = v[i] - 0.5 * edge;
    light[i] = static_cast<float>(polygonFormFactor(receiver.position, receiver.normal,
                                                    source.part(u0, u0 + edge, v0, v0 + edge).data(), 4));
  }
  return light;
}

}  // namespace fiatlux
