// A few rays from points spread over a plane; see free_space.h.
#include "precompute/geometry/free_space.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "precompute/rays/area_sampler.h"
#include "precompute/rays/hemisphere.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kLooks = 64;  // on a plane
constexpr double kFarAway = 10;       // m: as far counts what a ray meets nothing in
constexpr double kFloorLevel = 0.7;   // cos 45 degrees
constexpr Vec3 kDownward{0, -1, 0}, kUpward{0, 1, 0};

}  // namespace

double FreeSpace::View::floorsWithin(double low, double high) const {
  const auto within = std::count_if(floors.begin(), floors.end(),
                                    [&](double floor) { return floor >= low && floor <= high; });
  return static_cast<double>(within) / kLooks;
}

FreeSpace::FreeSpace(const WeldedMesh& mesh, const RayTracer& tracer, const std::vector<Face>& faces)
    : mesh_(mesh), tracer_(tracer), sequence_(kLooks), isSurface_(mesh.triangles.size(), {false, false}) {
  for (const Face& face : faces) isSurface_[face.triangle][face.back] = true;
}

FreeSpace::Met FreeSpace::meet(const Vec3& origin, const Vec3& direction) const {
  const auto [t, distance] = tracer_.firstHit(origin, direction);
  if (t == kNone) return {};
  const bool back = dot(direction, areaVector(mesh_.positions, mesh_.triangles[t].vertex)) > 0;
  return {t, distance, back, isSurface_[t][back]};
}

std::optional<double> FreeSpace::floorAt(const Met& met) const {
  if (!met.isSurface) return std::nullopt;
  const Vec3 normal = normalized(areaVector(mesh_.positions, mesh_.triangles[met.triangle].vertex));
  if (std::abs(normal.y) < kFloorLevel) return std::nullopt;
  return met.distance;
}

FreeSpace::View FreeSpace::from(const std::vector<Face>& faces, std::uint64_t seed) const {
  const AreaSampler sampler(trianglesOf(mesh_, faces));
  View view;
  if (sampler.empty()) return view;
  const auto scramble = RaySequence::scramble(mixBits(seed));
  double lost = 0, skies = 0;
  for (std::uint32_t i = 0; i < kLooks; ++i) {
    const auto random = sequence_.point(i, scramble);
    const auto [position, normal] = sampler.at(random[0], random[1]);
    const Vec3 origin = position + tracer_.offset() * normal;
    const Met met = meet(origin, cosineDirection(Frame(normal), random[2], random[3]));
    view.path += (met.triangle == kNone ? kFarAway : met.distance) / kLooks;
    lost += !met.isSurface;

    // The floor, and what is above it.
    const Met below = meet(origin, kDownward);
    const std::optional<double> floor = floorAt(below);
    if (!floor) continue;
    view.floors.push_back(*floor);
    view.floorSides.emplace_back(below.triangle, below.back);
    const Vec3 onFloor = origin + (*floor - tracer_.offset()) * kDownward;
    skies += meet(onFloor, cosineDirection(Frame(kUpward), random[2], random[3])).triangle == kNone;
  }
  view.lost = lost / kLooks;
  if (!view.floors.empty()) view.sky = skies / static_cast<double>(view.floors.size());
  std::sort(view.floors.begin(), view.floors.end());
  return view;
}

std::optional<double> FreeSpace::floorBelow(const Vec3& point) const {
  return floorAt(meet(point, kDownward));
}

bool FreeSpace::isWithinBody(const Vec3& point) const {
  for (const Vec3& side : {Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, 0, -1}}) {
    const Met met = meet(point, side);
    if (met.triangle == kNone || met.isSurface) return false;
  }
  return true;
}

std::vector<double> FreeSpace::heightsAbove(const std::vector<Face>& faces) const {
  const AreaSampler sampler(trianglesOf(mesh_, faces));
  std::vector<double> heights;
  if (sampler.empty()) return heights;
  const auto scramble = RaySequence::scramble(0);
  for (std::uint32_t i = 0; i < kLooks; ++i) {
    const auto random = sequence_.point(i, scramble);
    const Met above = meet(sampler.at(random[0], random[1]).position + tracer_.offset() * kUpward, kUpward);
    heights.push_back(above.triangle == kNone ? std::numeric_limits<double>::infinity() : above.distance);
  }
  std::sort(heights.begin(), heights.end());
  return heights;
}

double FreeSpace::skyAbove(const Vec3& point) const {
  const auto scramble = RaySequence::scramble(0);
  double skies = 0;
  for (std::uint32_t i = 0; i < kLooks; ++i) {
    const auto random = sequence_.point(i, scramble);
    skies += meet(point, cosineDirection(Frame(kUpward), random[0], random[1])).triangle == kNone;
  }
  return skies / kLooks;
}

}  // namespace fiatlux
