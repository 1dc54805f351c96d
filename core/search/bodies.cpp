// Rectangles that overlap, by separating axes (Gottschalk et al. 1996); see bodies.h.
#include "core/search/bodies.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fiatlux {
namespace {

constexpr double kTouch = 0.005;    // m by which bodies may run into each other: sites lie to the millimetre
constexpr double kOneMount = 0.05;  // m off a mount's plane that still counts as on it
constexpr double kParallel = 0.99;  // cosine between mounts of one plane

/// Half of a body each way.
std::array<Vec3, 2> halvesOf(const Scene& scene, std::uint32_t site) {
  const Body& body = scene.hangings[site].body;
  return {body.halfLength * body.along, body.halfBreadth * cross(scene.sites[site].normal, body.along)};
}

double reachOf(const Body& body) { return std::hypot(body.halfLength, body.halfBreadth); }

}  // namespace

bool haveBodies(const Scene& scene) {
  return std::any_of(scene.hangings.begin(), scene.hangings.end(),
                     [](const Hanging& hanging) { return reachOf(hanging.body) > 0; });
}

bool collide(const Scene& scene, std::uint32_t a, std::uint32_t b) {
  if (scene.hangings.empty()) return false;
  const Vec3 off = scene.sites[b].position - scene.sites[a].position;
  const Body& bodyA = scene.hangings[a].body;
  const Body& bodyB = scene.hangings[b].body;
  const double apart = length(off);
  // Most pairs are far apart, and that is seen without the diagonals.
  if (apart >= bodyA.halfLength + bodyA.halfBreadth + bodyB.halfLength + bodyB.halfBreadth) return false;
  if (apart >= reachOf(bodyA) + reachOf(bodyB)) return false;
  const Vec3& normal = scene.sites[a].normal;
  if (dot(normal, scene.sites[b].normal) < kParallel || std::fabs(dot(off, normal)) > kOneMount) return false;
  const std::array<Vec3, 2> ofA = halvesOf(scene, a), ofB = halvesOf(scene, b);
  for (const std::uint32_t site : {a, b}) {
    const Vec3& along = scene.hangings[site].body.along;
    for (const Vec3& axis : {along, cross(scene.sites[site].normal, along)}) {
      double halves = 0;
      for (const Vec3& half : {ofA[0], ofA[1], ofB[0], ofB[1]}) halves += std::fabs(dot(half, axis));
      if (std::fabs(dot(off, axis)) >= halves - kTouch) return false;
    }
  }
  return true;
}

bool fieldCollides(const Scene& scene, const std::vector<std::uint32_t>& sites, std::size_t columns) {
  if (!haveBodies(scene)) return false;
  // Two corners of it see every difference between two places.
  for (const std::size_t corner : {std::size_t{0}, columns - 1})
    for (std::size_t other = 0; other < sites.size(); ++other)
      if (other != corner && collide(scene, sites[corner], sites[other])) return true;
  return false;
}

}  // namespace fiatlux
