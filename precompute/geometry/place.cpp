// Spaces of air -> the triangles that they touch, cut at a box around them -> a lid where air goes on.
#include "precompute/geometry/place.h"

#include <algorithm>
#include <map>
#include <optional>

#include "core/base/short_number.h"
#include "precompute/base/error.h"
#include "precompute/geometry/spaces.h"
#include "precompute/room/bounds.h"

namespace fiatlux {
namespace {

constexpr double kWhiteLid = 0.8;  // reflectance

double along(const Vec3& p, std::size_t axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

Vec3 withAlong(Vec3 p, std::size_t axis, double value) {
  (axis == 0 ? p.x : axis == 1 ? p.y : p.z) = value;
  return p;
}

std::string textOf(const Vec3& p) {
  return shortNumber(p.x) + "," + shortNumber(p.y) + "," + shortNumber(p.z);
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
    Vec3 low = grid.low, high;
    for (int axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<std::size_t>(axis);
      const auto steps = cube / grid.stride(axis) % static_cast<std::size_t>(grid.count[k]);
      low = withAlong(low, k, along(grid.low, k) + grid.edge * static_cast<double>(steps));
      high = withAlong(high, k, along(low, k) + grid.edge);
    }
    kept.box.include(low), kept.box.include(high);
  }
  return kept;
}

/// A corner of a triangle, with all that its mesh says of it.
struct Corner {
  Vec3 position;
  std::array<float, 3> normal{};
  std::array<float, 2> uv{};
  std::array<float, 4> color{};
};

template <std::size_t N>
std::array<float, N> mixed(const std::array<float, N>& a, const std::array<float, N>& b, double share) {
  std::array<float, N> result{};
  for (std::size_t i = 0; i < N; ++i) result[i] = static_cast<float>((1 - share) * a[i] + share * b[i]);
  return result;
}

/// What of a convex polygon lies on the side of a plane where sign * (value - limit) <= 0 (Sutherland and
/// Hodgman 1974).
std::vector<Corner> cutAt(const std::vector<Corner>& polygon, std::size_t axis, double sign, double limit) {
  std::vector<Corner> left;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner& a = polygon[(i + polygon.size() - 1) % polygon.size()];
    const Corner& b = polygon[i];
    const double from = sign * (along(a.position, axis) - limit),
                 to = sign * (along(b.position, axis) - limit);
    if ((from > 0) != (to > 0)) {
      const double share = from / (from - to);
      left.push_back({(1 - share) * a.position + share * b.position, mixed(a.normal, b.normal, share),
                      mixed(a.uv, b.uv, share), mixed(a.color, b.color, share)});
    }
    if (to <= 0) left.push_back(b);
  }
  return left;
}

/// A mesh as it is rebuilt, corner by corner.
class Rest {
 public:
  Rest(const SourceMesh& from, const Bounds& box) : from_(from), box_(box) {
    mesh_.node = from.node, mesh_.nodeIndex = from.nodeIndex;
    mesh_.material = from.material, mesh_.extras = from.extras;
  }

  void add(const std::array<std::uint32_t, 3>& triangle) {
    std::vector<Corner> polygon;
    bool isIn = true;
    for (const std::uint32_t v : triangle) {
      polygon.push_back(cornerOf(v));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double value = along(polygon.back().position, axis);
        isIn = isIn && value >= along(box_.low, axis) && value <= along(box_.high, axis);
      }
    }
    if (isIn) {
      mesh_.triangles.push_back({kept(triangle[0]), kept(triangle[1]), kept(triangle[2])});
      return;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      polygon = cutAt(polygon, axis, -1, along(box_.low, axis));
      polygon = cutAt(polygon, axis, 1, along(box_.high, axis));
    }
    if (polygon.size() < 3) return;
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    for (const Corner& corner : polygon) append(corner);
    for (std::uint32_t i = 2; i < polygon.size(); ++i)
      mesh_.triangles.push_back({first, first + i - 1, first + i});
  }

  SourceMesh take() { return std::move(mesh_); }

 private:
  Corner cornerOf(std::uint32_t v) const {
    Corner corner{from_.positions[v]};
    if (!from_.normals.empty()) corner.normal = from_.normals[v];
    if (!from_.uv.empty()) corner.uv = from_.uv[v];
    if (!from_.colors.empty()) corner.color = from_.colors[v];
    return corner;
  }
  std::uint32_t kept(std::uint32_t v) {
    const auto [found, isFresh] = taken_.emplace(v, static_cast<std::uint32_t>(mesh_.positions.size()));
    if (isFresh) append(cornerOf(v));
    return found->second;
  }
  void append(const Corner& corner) {
    mesh_.positions.push_back(corner.position);
    if (!from_.normals.empty()) mesh_.normals.push_back(corner.normal);
    if (!from_.uv.empty()) mesh_.uv.push_back(corner.uv);
    if (!from_.colors.empty()) mesh_.colors.push_back(corner.color);
  }

  const SourceMesh& from_;
  Bounds box_;
  SourceMesh mesh_;
  std::map<std::uint32_t, std::uint32_t> taken_;  // vertices that stay as they are
};

/// One side of the cubes of one slice of the grid.
struct Slice {
  const Spaces& spaces;
  const std::vector<std::uint8_t>& air;  // that is kept
  std::size_t axis;                      // that it lies across
  bool isUpper;                          // side of its cubes
  int at;

  std::array<std::size_t, 2> across() const { return {(axis + 1) % 3, (axis + 2) % 3}; }
  std::array<int, 3> steps(int u, int v) const {
    std::array<int, 3> steps{};
    steps[axis] = at, steps[across()[0]] = u, steps[across()[1]] = v;
    return steps;
  }
  /// Whether air that is kept goes on there in air that is not, or leaves the model.
  bool isOpen(int u, int v) const {
    const CubeGrid& grid = spaces.grid();
    auto next = steps(u, v);
    if (!air[grid.indexOf(next)]) return false;
    next[axis] += isUpper ? 1 : -1;
    if (next[axis] < 0 || next[axis] >= grid.count[axis]) return true;
    const std::size_t cube = grid.indexOf(next);
    return !air[cube] && !spaces.isSolid(cube);
  }
};

/// Closes what is open in a slice, and the cubes around it that something solid passes through: runs of
/// cubes, and of equal ones in neighbouring rows, are one rectangle.
void closeSlice(const Slice& slice, SourceMesh& lid) {
  const CubeGrid& grid = slice.spaces.grid();
  const std::size_t u = slice.across()[0], v = slice.across()[1];
  const int width = grid.count[u], height = grid.count[v];
  CubeGrid flat{{}, grid.edge, {width, height, 1}};
  std::vector<std::uint8_t> open(flat.size());
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) open[flat.indexOf({i, j, 0})] = slice.isOpen(i, j);
  if (std::find(open.begin(), open.end(), 1) == open.end()) return;
  const std::vector<std::uint8_t> around = widened(flat, open, 1);
  const auto isClosed = [&](int i, int j) {
    if (i >= width || j >= height) return false;
    const std::size_t cell = flat.indexOf({i, j, 0});
    return open[cell] || (around[cell] && slice.spaces.isSolid(grid.indexOf(slice.steps(i, j))));
  };
  const double depth = along(grid.low, slice.axis) + grid.edge * (slice.at + (slice.isUpper ? 1 : 0));
  const auto corner = [&](int i, int j) {
    Vec3 p = withAlong({}, slice.axis, depth);
    p = withAlong(p, u, along(grid.low, u) + grid.edge * i);
    return withAlong(p, v, along(grid.low, v) + grid.edge * j);
  };
  const auto close = [&](int left, int right, int low, int high) {
    const auto first = static_cast<std::uint32_t>(lid.positions.size());
    for (const auto& [i, j] : {std::pair(left, low), {right, low}, {right, high}, {left, high}})
      lid.positions.push_back(corner(i, j));
    // Counter-clockwise about the axis: it looks along it, or the other way, into the place.
    const std::uint32_t two = slice.isUpper ? 2 : 1, three = slice.isUpper ? 1 : 2;
    lid.triangles.push_back({first, first + two, first + three});
    lid.triangles.push_back({first, first + (slice.isUpper ? 3 : 2), first + (slice.isUpper ? 2 : 3)});
  };
  std::map<std::pair<int, int>, int> begun;  // runs of the row before, and the row that they began in
  for (int j = 0; j <= height; ++j) {
    std::map<std::pair<int, int>, int> here;
    for (int i = 0; i < width; ++i) {
      const int from = i;
      while (isClosed(i, j)) ++i;
      if (i == from) continue;
      const auto before = begun.find({from, i});
      here[{from, i}] = before == begun.end() ? j : before->second;
    }
    for (const auto& [run, since] : begun)
      if (here.count(run) == 0) close(run.first, run.second, since, j);
    begun = std::move(here);
  }
}

/// What closes a place: rectangles where its air goes on, and the panes of its windows, through which light
/// would leave it.
class Lid {
 public:
  Lid(const Spaces& spaces, const Kept& kept) : spaces_(spaces), kept_(kept) {
    mesh_.node = mesh_.extras.surface = "lid";
    std::vector<std::uint8_t> other(spaces.grid().size());
    for (std::size_t cube = 0; cube < other.size(); ++cube)
      other[cube] = !kept.air[cube] && !spaces.isSolid(cube);
    nearOther_ = widened(spaces.grid(), std::move(other), 1);
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (int at = 0; at < spaces.grid().count[axis]; ++at)
        for (const bool isUpper : {false, true}) closeSlice({spaces, kept.air, axis, isUpper, at}, mesh_);
  }

  /// Takes a triangle of something transparent, turned into the place; false where it does not part it from
  /// what is left out.
  bool takePane(Vec3 a, Vec3 b, Vec3 c) {
    const CubeGrid& grid = spaces_.grid();
    if (!anyCube(grid, a, b, c, [&](std::size_t cube) { return nearOther_[cube] != 0; })) return false;
    const Vec3 before = 1.5 * grid.edge * normalized(cross(b - a, c - a));
    const Vec3 middle = (1.0 / 3) * (a + b + c);
    if (!kept_.air[grid.indexOf(grid.stepsTo(middle + before))]) std::swap(b, c);
    const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
    mesh_.positions.insert(mesh_.positions.end(), {a, b, c});
    mesh_.triangles.push_back({first, first + 1, first + 2});
    return true;
  }

  void addTo(SourceScene& source, bool isWhite) {
    if (mesh_.triangles.empty()) return;
    for (const SourceMesh& mesh : source.meshes)
      mesh_.nodeIndex = std::max(mesh_.nodeIndex, mesh.nodeIndex + 1);
    SourceMaterial paint;
    paint.name = "lid";
    for (std::size_t c = 0; c < 3; ++c) paint.baseColor[c] = isWhite ? kWhiteLid : 0;
    mesh_.material = static_cast<int>(source.materials.size());
    source.materials.push_back(std::move(paint));
    source.meshes.push_back(std::move(mesh_));
  }

 private:
  const Spaces& spaces_;
  const Kept& kept_;
  SourceMesh mesh_;
  std::vector<std::uint8_t> nearOther_;  // cubes beside air that is left out
};

/// The meshes of a scene as far as they touch the place; panes go to the lid, where there is one.
std::vector<SourceMesh> touched(const SourceScene& source, const Spaces& spaces, const Kept& kept, Lid* lid) {
  const CubeGrid& grid = spaces.grid();
  const std::vector<std::uint8_t> near = widened(grid, kept.air, 1);
  const auto isNear = [&](std::size_t cube) { return near[cube] != 0; };
  const Vec3 more{grid.edge, grid.edge, grid.edge};
  Bounds box = kept.box;
  box.low = box.low - more, box.high += more;
  std::vector<SourceMesh> meshes;
  for (const SourceMesh& mesh : source.meshes) {
    const bool isGlass =
        mesh.material >= 0 &&
        source.materials[static_cast<std::size_t>(mesh.material)].alpha == SourceMaterial::Alpha::kBlend;
    Rest rest(mesh, box);
    for (const auto& t : mesh.triangles) {
      const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
      if (!anyCube(grid, a, b, c, isNear)) continue;
      if (!isGlass || !lid || !lid->takePane(a, b, c)) rest.add(t);
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
  if (place.lid != PlaceOptions::Lid::kNone) lid.emplace(spaces, kept);
  source.meshes = touched(source, spaces, kept, lid ? &*lid : nullptr);
  if (lid) lid->addTo(source, place.lid == PlaceOptions::Lid::kWhite);
  const Vec3 size = kept.box.size();
  return "only the place around " + textOf(*place.inside) + " stays, " + shortNumber(size.x) + " x " +
         shortNumber(size.z) + " m and " + shortNumber(size.y) + " m high: " + std::to_string(kept.parts) +
         " of " + std::to_string(spaces.count()) +
         " rooms, and the rest is left out; --doors N takes in what lies behind so many open doors";
}

}  // namespace fiatlux
