#include "precompute/geometry/lid.h"

#include <algorithm>
#include <map>

namespace fiatlux {
namespace {

constexpr double kWhiteLid = 0.8;  // reflectance

}  // namespace

/// One side of the cubes of one slice of the grid, in rows along `u`.
struct Lid::Slice {
  std::size_t axis;  // that it lies across
  bool isUpper;      // side of its cubes
  int at;
  std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;

  std::array<int, 3> steps(int i, int j) const {
    std::array<int, 3> steps{};
    steps[axis] = at, steps[u] = i, steps[v] = j;
    return steps;
  }
};

Lid::Lid(const Spaces& spaces, const std::vector<std::uint8_t>& air) : spaces_(spaces), air_(air) {
  mesh_.node = mesh_.extras.surface = "lid";
  std::vector<std::uint8_t> other(air.size());
  for (std::size_t cube = 0; cube < other.size(); ++cube) other[cube] = !air[cube] && !spaces.isSolid(cube);
  nearOther_ = widened(spaces.grid(), std::move(other), 1);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (int at = 0; at < spaces.grid().count[axis]; ++at)
      for (const bool isUpper : {false, true}) close({axis, isUpper, at});
}

/// Whether air that is kept goes on there in air that is not, or leaves the model.
bool Lid::isOpen(const Slice& slice, int u, int v) const {
  const CubeGrid& grid = spaces_.grid();
  auto next = slice.steps(u, v);
  if (!air_[grid.indexOf(next)]) return false;
  next[slice.axis] += slice.isUpper ? 1 : -1;
  if (next[slice.axis] < 0 || next[slice.axis] >= grid.count[slice.axis]) return true;
  const std::size_t cube = grid.indexOf(next);
  return !air_[cube] && !spaces_.isSolid(cube);
}

/// Closes what is open in a slice, and the cubes around it that something solid passes through: runs of
/// cubes, and of equal ones in neighbouring rows, are one rectangle.
void Lid::close(const Slice& slice) {
  const CubeGrid& grid = spaces_.grid();
  const int width = grid.count[slice.u], height = grid.count[slice.v];
  const CubeGrid flat{{}, grid.edge, {width, height, 1}};
  std::vector<std::uint8_t> open(flat.size());
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) open[flat.indexOf({i, j, 0})] = isOpen(slice, i, j);
  if (std::find(open.begin(), open.end(), 1) == open.end()) return;
  const std::vector<std::uint8_t> around = widened(flat, open, 1);
  const auto isClosed = [&](int i, int j) {
    if (i >= width || j >= height) return false;
    const std::size_t cell = flat.indexOf({i, j, 0});
    return open[cell] || (around[cell] && spaces_.isSolid(grid.indexOf(slice.steps(i, j))));
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
      if (here.count(run) == 0) addRectangle(slice, run.first, run.second, since, j);
    begun = std::move(here);
  }
}

void Lid::addRectangle(const Slice& slice, int left, int right, int low, int high) {
  Slice side = slice;
  if (slice.isUpper) ++side.at;
  const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
  for (const auto& [i, j] : {std::pair(left, low), {right, low}, {right, high}, {left, high}})
    mesh_.positions.push_back(spaces_.grid().cornerAt(side.steps(i, j)));
  // Counter-clockwise about the axis: it looks along it, or the other way, into the place.
  const std::uint32_t two = slice.isUpper ? 3 : 1, four = slice.isUpper ? 1 : 3;
  mesh_.triangles.push_back({first, first + two, first + 2});
  mesh_.triangles.push_back({first, first + 2, first + four});
}

bool Lid::takePane(Vec3 a, Vec3 b, Vec3 c) {
  const CubeGrid& grid = spaces_.grid();
  if (!anyCube(grid, a, b, c, [&](std::size_t cube) { return nearOther_[cube] != 0; })) return false;
  const Vec3 before = kClearOfPlane * grid.edge * normalized(cross(b - a, c - a));
  const Vec3 middle = (1.0 / 3) * (a + b + c);
  if (!air_[grid.indexOf(grid.stepsTo(middle + before))]) std::swap(b, c);
  const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
  mesh_.positions.insert(mesh_.positions.end(), {a, b, c});
  mesh_.triangles.push_back({first, first + 1, first + 2});
  return true;
}

void Lid::addTo(SourceScene& source, bool isWhite) {
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

}  // namespace fiatlux
