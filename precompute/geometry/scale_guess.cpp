// How high ceilings are is read off rays up from floors and down from ceilings.
#include "precompute/geometry/scale_guess.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/short_number.h"
#include "precompute/geometry/faces.h"
#include "precompute/geometry/source_bounds.h"
#include "precompute/rays/area_sampler.h"
#include "precompute/rays/ray_sequence.h"
#include "precompute/rays/ray_tracer.h"

namespace fiatlux {
namespace {

constexpr double kRoomHeight = 2.7;                 // m, of the usual ceiling
constexpr double kLowest = 0.8, kHighest = 30;      // m: ceilings beyond are absurd
constexpr double kNarrowest = 0.8, kWidest = 2000;  // m: and so are models
constexpr double kSurelyBroad = 5;  // m: what is wider than a small room is not made larger: a plate, no room
constexpr double kSurelyLow = 1.8, kSurelyHigh = 12, kSurelyWide = 150;  // m: within, nothing is measured
constexpr std::uint32_t kHeightRays = 1024;
constexpr double kFlat = 0.9;       // cos 26 degrees
constexpr double kQuantile = 0.75;  // of the heights: what stands in a room makes many of them small

struct Unit {
  double metres;
  const char* name;
};
constexpr std::array kUnits = {Unit{0.01, "centimetres"},   Unit{0.001, "millimetres"},
                               Unit{0.0254, "inches"},      Unit{10, "units of 10 m"},
                               Unit{100, "units of 100 m"}, Unit{1000, "kilometres"}};

}  // namespace

std::string sizesOf(const Vec3& size, double scale) {
  return shortNumber(scale * size.x) + " x " + shortNumber(scale * size.z) + " m and " +
         shortNumber(scale * size.y) + " m high";
}

double heightOfRooms(const SourceScene& source) {
  std::vector<Vec3> positions;
  std::vector<RayTracer::Triangle> triangles;
  std::vector<Fragment> level;
  for (const SourceMesh& mesh : source.meshes) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), mesh.positions.begin(), mesh.positions.end());
    for (const auto& t : mesh.triangles) {
      triangles.push_back({first + t[0], first + t[1], first + t[2]});
      const Vec3 vector = areaVector(positions, triangles.back());
      if (std::abs(vector.y) > kFlat * length(vector))
        level.push_back({{positions[first + t[0]], positions[first + t[1]], positions[first + t[2]]}});
    }
  }
  const AreaSampler sampler(level);
  const Result<RayTracer> tracer = RayTracer::build(positions, triangles);
  if (sampler.empty() || !tracer) return 0;

  const RaySequence sequence(kHeightRays);
  const auto scramble = RaySequence::scramble(0);
  std::vector<double> heights;
  for (std::uint32_t i = 0; i < kHeightRays; ++i) {
    const auto random = sequence.point(i, scramble);
    const auto [position, normal] = sampler.at(random[0], random[1]);
    RayPacket packet;
    for (const double side : {1.0, -1.0})
      tracer->aim(packet, position + side * tracer->offset() * normal,
                  Vec3{0, side * std::copysign(1.0, normal.y), 0}, std::numeric_limits<float>::infinity());
    HitPacket hits;
    tracer->intersect(packet, hits);
    for (std::uint32_t k = 0; k < packet.count; ++k)
      if (hits.triangle[k] != kNone) heights.push_back(hits.distance[k]);
  }
  if (heights.empty()) return 0;
  std::sort(heights.begin(), heights.end());
  return heights[static_cast<std::size_t>(kQuantile * static_cast<double>(heights.size() - 1))];
}

double guessedScale(const SourceScene& source) {
  for (const SourceMesh& mesh : source.meshes)
    if (mesh.extras.siteSpacing || mesh.extras.drop) return 1;
  const Bounds bounds = boundsOf(source);
  const double width = bounds.longestEdge(), tall = bounds.size().y;
  if (bounds.empty() || (tall >= kSurelyLow && tall <= kSurelyHigh && width <= kSurelyWide)) return 1;

  const double measured = heightOfRooms(source), height = measured > 0 ? measured : tall;
  const auto isPossible = [&](double scale) {
    if (scale > 1 && width > kSurelyBroad) return false;
    return scale * height >= kLowest && scale * height <= kHighest && scale * width >= kNarrowest &&
           scale * width <= kWidest;
  };
  if (!(height > 0) || isPossible(1)) return 1;
  const auto distance = [&](double scale) { return std::abs(std::log(scale * height / kRoomHeight)); };
  double best = 1;
  for (const Unit& unit : kUnits)
    if (isPossible(unit.metres) && (best == 1 || distance(unit.metres) < distance(best))) best = unit.metres;
  return best;
}

void scaleBy(double scale, SourceScene& source) {
  for (SourceMesh& mesh : source.meshes)
    for (Vec3& p : mesh.positions) p = scale * p;
}

std::string noteOfScale(double scale, const SourceScene& scaled) {
  const Vec3 size = boundsOf(scaled).size();
  const auto unit =
      std::find_if(kUnits.begin(), kUnits.end(), [&](const Unit& u) { return u.metres == scale; });
  return "as metres the model would be " + sizesOf(size, 1 / scale) + ": it is taken to be in " +
         (unit == kUnits.end() ? shortNumber(scale) : unit->name) + ", " + sizesOf(size, 1) +
         "; --scale 1 refuses that";
}

}  // namespace fiatlux
