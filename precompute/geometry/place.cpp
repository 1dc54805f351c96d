// Spaces of air -> the triangles that they touch, cut at a box around them -> a lid where air goes on.
#include "precompute/geometry/place.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/short_number.h"
#include "precompute/base/error.h"
#include "precompute/geometry/box_cut.h"
#include "precompute/geometry/inside.h"
#include "precompute/geometry/lid.h"
#include "precompute/geometry/spaces.h"

namespace fiatlux {
namespace {

constexpr double kLevelMount = 0.9;  // cos 26 degrees

std::string textOf(const Vec3& p) {
  return shortNumber(p.x) + "," + shortNumber(p.y) + "," + shortNumber(p.z);
}

void include(const CubeGrid& grid, std::size_t cube, Bounds& box) {
  const Vec3 corner = grid.cornerAt(grid.stepsOf(cube));
  box.include(corner), box.include(corner + Vec3{grid.edge, grid.edge, grid.edge});
}

/// The cubes that stay.
struct Kept {
  std::vector<std::uint8_t> air;
  Bounds box;             // m, of the air
  std::size_t parts = 0;  // spaces
};

Kept keptOf(const Spaces& spaces, std::uint32_t from, std::uint32_t openings) {
  const CubeGrid& grid = spaces.grid();
  const std::vector<bool> reached = spaces.reached(from, openings);
  Kept kept;
  kept.parts = static_cast<std::size_t>(std::count(reached.begin(), reached.end(), true));
  kept.air.resize(grid.size());
  for (std::size_t cube = 0; cube < grid.size(); ++cube) {
    kept.air[cube] = reached[spaces.of(cube)];
    if (!kept.air[cube]) continue;
    include(grid, cube, kept.box);
  }
  return kept;
}

/// Which triangles belong to the place: those at its air. A large one that touches it beside an opening
/// alone, or through a thin wall, is the far side of a wall or a floor, and sees nothing of it.
class AtAir {
 public:
  AtAir(const CubeGrid& grid, const std::vector<std::uint8_t>& air, const RayTracer& tracer)
      : grid_(grid), air_(air), tracer_(tracer), near_(widened(grid, air, 1)) {}

  bool operator()(const Vec3& a, const Vec3& b, const Vec3& c) const {
    if (!anyCube(grid_, a, b, c, [&](std::size_t cube) { return near_[cube] != 0; })) return false;
    Bounds bounds;
    for (const Vec3& p : {a, b, c}) bounds.include(p);
    return bounds.longestEdge() < kSmall || looksIntoIt(a, b, c);
  }

 private:
  static constexpr double kSmall = 1;          // m
  static constexpr double kInOnePlane = 1e-3;  // m

  /// Whether the air that is kept lies before it or behind it anywhere.
  bool looksIntoIt(const Vec3& a, const Vec3& b, const Vec3& c) const {
    const Vec3 normal = normalized(cross(b - a, c - a)), clear = kClearOfPlane * grid_.edge * normal;
    const Vec3 toMiddle = 0.5 * Vec3{grid_.edge, grid_.edge, grid_.edge};
    return anyCube(grid_, a, b, c, [&](std::size_t cube) {
      if (!near_[cube]) return false;
      const Vec3 middle = grid_.cornerAt(grid_.stepsOf(cube)) + toMiddle;
      const Vec3 on = middle - dot(middle - a, normal) * normal;
      const auto sees = [&](double side) {
        const Vec3 to = on + side * clear;
        return air_[grid_.indexOf(grid_.stepsTo(to))] &&
               !tracer_.isBlocked(on + side * kInOnePlane * normal, to);
      };
      return sees(1) || sees(-1);
    });
  }

  const CubeGrid& grid_;
  const std::vector<std::uint8_t>& air_;
  const RayTracer& tracer_;
  std::vector<std::uint8_t> near_;
};

/// The box of the air that is kept beside a mesh, up to the middle of what bounds it.
Bounds airBeside(const SourceMesh& mesh, const CubeGrid& grid, const std::vector<std::uint8_t>& air) {
  std::vector<std::uint8_t> met(grid.size());
  const auto meet = [&](std::size_t cube) {
    met[cube] = 1;
    return false;
  };
  for (const auto& t : mesh.triangles)
    anyCube(grid, mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]], meet);
  met = widened(grid, std::move(met), 1);
  Bounds box;
  for (std::size_t cube = 0; cube < grid.size(); ++cube)
    if (met[cube] && air[cube]) include(grid, cube, box);
  const Vec3 half = 0.5 * Vec3{grid.edge, grid.edge, grid.edge};
  if (!box.empty()) box.low = box.low - half, box.high += half;
  return box;
}

/// The meshes of a scene as far as they belong to the place; panes go to the lid, where there is one.
std::vector<SourceMesh> touched(const SourceScene& source, const CubeGrid& grid, const Kept& kept, Lid* lid) {
  std::vector<std::string> unsaid;
  const RayTracer tracer = tracerOf(weld(source, assignRoles(source, {}, unsaid).reflectors));
  const AtAir isAtAir(grid, kept.air, tracer);
  const Vec3 more{grid.edge, grid.edge, grid.edge};
  const Bounds box{kept.box.low - more, kept.box.high + more};
  std::vector<SourceMesh> meshes;
  for (const SourceMesh& mesh : source.meshes) {
    const bool isGlass =
        mesh.material >= 0 &&
        source.materials[static_cast<std::size_t>(mesh.material)].alpha == SourceMaterial::Alpha::kBlend;
    // A ceiling goes on over walls, where no luminaire is to hang.
    Bounds below = box;
    if (mesh.extras.mount)
      if (const Bounds beside = airBeside(mesh, grid, kept.air); !beside.empty())
        below = {{beside.low.x, box.low.y, beside.low.z}, {beside.high.x, box.high.y, beside.high.z}};
    BoxCut rest(mesh);
    for (const auto& t : mesh.triangles) {
      const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
      if (isAtAir(a, b, c) && !(isGlass && lid && lid->takePane(a, b, c)))
        rest.add(t, std::abs(normalized(cross(b - a, c - a)).y) > kLevelMount ? below : box);
    }
    meshes.push_back(rest.take());
    if (meshes.back().triangles.empty()) meshes.pop_back();
  }
  return meshes;
}

}  // namespace

std::string keepPlace(const PlaceOptions& place, SourceScene& source) {
  const Spaces spaces(source, *place.inside);
  const std::uint32_t from = spaces.at(*place.inside);
  if (from == Spaces::kNowhere)
    throw CommandError("--inside " + textOf(*place.inside) +
                       ": there is no air that belongs to a room; name a point about a metre over its floor");
  const Kept kept = keptOf(spaces, from, place.doors);
  std::optional<Lid> lid;
  if (place.lid != PlaceOptions::Lid::kNone) lid.emplace(spaces, kept.air);
  source.meshes = touched(source, spaces.grid(), kept, lid ? &*lid : nullptr);
  if (lid) lid->addTo(source, place.lid == PlaceOptions::Lid::kWhite);
  const Vec3 size = kept.box.size();
  return "only the place around " + textOf(*place.inside) + " stays, " + shortNumber(size.x) + " x " +
         shortNumber(size.z) + " m and " + shortNumber(size.y) + " m high: " + std::to_string(kept.parts) +
         " of " + std::to_string(spaces.count()) +
         " rooms, and the rest is left out; --doors N takes in what lies behind so many open doors";
}

}  // namespace fiatlux
