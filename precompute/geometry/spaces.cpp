#include "precompute/geometry/spaces.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/short_number.h"
#include "precompute/base/error.h"
#include "precompute/geometry/source_bounds.h"

namespace fiatlux {
namespace {

constexpr double kFinestEdge = 0.1;     // m
constexpr double kCoarsestEdge = 0.3;   // m: beyond, a door is no longer seen
constexpr double kMostCubes = 8e6;      //
constexpr double kPassage = 1.1;        // m: what is narrower is an opening between spaces
constexpr double kDoorHeight = 2.25;    // m, at most, of the air in an opening below a lintel
constexpr double kLintel = 0.2;         // m, at least, that it hangs lower than the ceilings beside it
constexpr double kDeepest = 0.7;        // m, of the wall that it is in
constexpr double kJambs = 0.15;         // m, at least, that an opening is narrower than what it leads to
constexpr double kAround = 0.5;         // m, from a point to the air nearest to it
constexpr double kLeastOpening = 0.3;   // m2: a gap that nobody walks through is none
constexpr std::size_t kLeastCore = 50;  // cubes: fewer are a corner of something

/// Half a cube more on all sides, so that walls along them lie in the middle of cubes.
CubeGrid gridOf(const Bounds& bounds) {
  const Vec3 size = bounds.size();
  const auto cubes = [&](double edge) {
    return (size.x / edge + 2) * (size.y / edge + 2) * (size.z / edge + 2);
  };
  double edge = kFinestEdge;
  while (cubes(edge) > kMostCubes) edge *= 1.1;
  const Vec3 half{0.5 * edge, 0.5 * edge, 0.5 * edge};
  const auto count = [&](double length) { return static_cast<int>(std::floor(length / edge + 0.5)) + 1; };
  return {bounds.low - half, edge, {count(size.x), count(size.y), count(size.z)}};
}

}  // namespace

std::array<int, 3> CubeGrid::stepsTo(const Vec3& point) const {
  const Vec3 from = point - low;
  const auto step = [&](double along, int most) {
    return std::clamp(static_cast<int>(std::floor(along / edge)), 0, most - 1);
  };
  return {step(from.x, count[0]), step(from.y, count[1]), step(from.z, count[2])};
}

std::size_t CubeGrid::indexOf(const std::array<int, 3>& steps) const {
  return static_cast<std::size_t>(steps[0]) + stride(1) * static_cast<std::size_t>(steps[1]) +
         stride(2) * static_cast<std::size_t>(steps[2]);
}

std::vector<std::uint8_t> widened(const CubeGrid& grid, std::vector<std::uint8_t> cubes, int reach) {
  std::vector<int> since;
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t stride = grid.stride(axis);
    const int count = grid.count[static_cast<std::size_t>(axis)];
    since.resize(static_cast<std::size_t>(count));
    for (std::size_t first = 0; first < cubes.size(); ++first) {
      if (first / stride % static_cast<std::size_t>(count) != 0) continue;
      // How far the last one is, from below and then from above.
      int last = -reach - 1;
      for (int i = 0; i < count; ++i) {
        if (cubes[first + static_cast<std::size_t>(i) * stride]) last = i;
        since[static_cast<std::size_t>(i)] = i - last;
      }
      last = count + reach;
      for (int i = count - 1; i >= 0; --i) {
        std::uint8_t& cube = cubes[first + static_cast<std::size_t>(i) * stride];
        if (cube) last = i;
        cube = std::min(since[static_cast<std::size_t>(i)], last - i) <= reach;
      }
    }
  }
  return cubes;
}

std::array<int, 3> CubeGrid::stepsOf(std::size_t cube) const {
  std::array<int, 3> steps{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    steps[k] = static_cast<int>(cube / stride(axis) % static_cast<std::size_t>(count[k]));
  }
  return steps;
}

bool Spaces::canTell(const SourceScene& source) { return gridOf(boundsOf(source)).edge <= kCoarsestEdge; }

Spaces::Spaces(const SourceScene& source) : grid_(gridOf(boundsOf(source))) {
  fill(source);
  part(true);
  if (count() == 0) part(false);
}

Spaces::Spaces(const SourceScene& source, const Vec3& inside) : grid_(gridOf(boundsOf(source))) {
  if (const Vec3 size = boundsOf(source).size(); grid_.edge > kCoarsestEdge)
    throw CommandError("--inside: " + shortNumber(size.x) + " x " + shortNumber(size.z) + " x " +
                       shortNumber(size.y) +
                       " m are too much for rooms to be told apart; export a part of it");
  fill(source);
  part(true);
  if (at(inside) == kNowhere) part(false);
}

void Spaces::fill(const SourceScene& source) {
  solid_.assign(grid_.size(), 0);
  const auto fill = [&](std::size_t cube) {
    solid_[cube] = 1;
    return false;
  };
  for (const SourceMesh& mesh : source.meshes)
    if (!mesh.extras.measure)
      for (const auto& t : mesh.triangles)
        anyCube(grid_, mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]], fill);
}

void Spaces::part(bool hasOutdoors) {
  spaces_.assign(grid_.size(), kNowhere);
  next_ = kOutdoors + 1;
  findCores(hasOutdoors);
  grow();
}

/// How many steps up the air of each cube ends; low is what has no more than `most` cubes of it.
std::vector<std::uint16_t> Spaces::topsOfAir(int most, std::vector<std::uint8_t>& isLow) const {
  std::vector<std::uint16_t> top(grid_.size(), 0);
  const std::size_t up = grid_.stride(1);
  const int tall = grid_.count[1];
  for (std::size_t first = 0; first < grid_.size(); ++first) {
    if (first / up % static_cast<std::size_t>(tall) != 0) continue;
    for (int from = 0, to; from < tall; from = to + 1) {
      for (to = from; to < tall && !solid_[first + static_cast<std::size_t>(to) * up]; ++to) {
      }
      for (int y = from; y < to; ++y) {
        top[first + static_cast<std::size_t>(y) * up] = static_cast<std::uint16_t>(to);
        isLow[first + static_cast<std::size_t>(y) * up] = to - from <= most;
      }
    }
  }
  return top;
}

/// Air that ends lower than on both sides of it, within the depth of a wall, is as narrow as a door: an
/// opening may be as wide as it likes, but not as wide as what it leads to on both sides, like what is below
/// a beam. Around lamps one may go.
void Spaces::narrowBelowLintels(std::vector<std::uint8_t>& narrow) const {
  const auto cubesIn = [&](double metres) { return static_cast<int>(std::lround(metres / grid_.edge)); };
  const int lintel = std::max(1, cubesIn(kLintel)), reach = cubesIn(kDeepest);
  std::vector<std::uint8_t> isLow(grid_.size(), 0);
  const std::vector<std::uint16_t> top = topsOfAir(cubesIn(kDoorHeight), isLow);
  for (const int axis : {0, 2}) {
    const std::size_t stride = grid_.stride(axis);
    // Where air ends higher in front of a cube and behind it; false: solid comes first, or it is too far.
    const auto isBelowLintel = [&](std::size_t cube, std::size_t& back, std::size_t& forth) {
      const int at = grid_.stepsOf(cube)[static_cast<std::size_t>(axis)];
      const auto stepsToHigher = [&](int way, int count) {
        for (int i = 1; i <= std::min(count, reach); ++i) {
          const std::size_t steps = static_cast<std::size_t>(i) * stride;
          const std::size_t other = way > 0 ? cube + steps : cube - steps;
          if (solid_[other]) return 0;
          if (top[other] >= top[cube] + lintel) return i;
        }
        return 0;
      };
      const int before = isLow[cube] ? stepsToHigher(-1, at) : 0;
      if (before == 0) return false;
      const int after = stepsToHigher(1, grid_.count[static_cast<std::size_t>(axis)] - 1 - at);
      back = cube - static_cast<std::size_t>(before) * stride;
      forth = cube + static_cast<std::size_t>(after) * stride;
      return after > 0 && before + after - 1 <= reach;
    };
    for (std::size_t cube = 0, back = 0, forth = 0; cube < grid_.size(); ++cube) {
      if (narrow[cube] || !isBelowLintel(cube, back, forth)) continue;
      const int wide = airAlong(2 - axis, cube);
      const int beside = std::max(airAlong(2 - axis, back), airAlong(2 - axis, forth));
      if ((beside - wide) * grid_.edge >= kJambs) narrow[cube] = 1;
    }
  }
}

/// In how many cubes along an axis there is air, from what is solid to what is solid.
int Spaces::airAlong(int axis, std::size_t cube) const {
  const std::size_t stride = grid_.stride(axis);
  const int at = grid_.stepsOf(cube)[static_cast<std::size_t>(axis)];
  int before = 0, after = 0;
  while (before < at && !solid_[cube - static_cast<std::size_t>(before + 1) * stride]) ++before;
  while (at + after + 1 < grid_.count[static_cast<std::size_t>(axis)] &&
         !solid_[cube + static_cast<std::size_t>(after + 1) * stride])
    ++after;
  return before + 1 + after;
}

/// What is far enough from all that is solid, in connected pieces; the open sky is one.
void Spaces::findCores(bool hasOutdoors) {
  const int reach = std::max(1, static_cast<int>((kPassage / grid_.edge - 1) / 2));
  std::vector<std::uint8_t> narrow = widened(grid_, solid_, reach);
  narrowBelowLintels(narrow);
  if (hasOutdoors)
    for (std::size_t cube = 0; cube < grid_.size(); ++cube) {
      const auto top = static_cast<std::size_t>(grid_.count[1] - 1);
      if (cube / grid_.stride(1) % static_cast<std::size_t>(grid_.count[1]) != top) continue;
      for (std::size_t y = 0; y <= top && !solid_[cube - y * grid_.stride(1)]; ++y)
        if (std::size_t below = cube - y * grid_.stride(1); !narrow[below]) spaces_[below] = kOutdoors;
    }
  std::vector<std::size_t> piece;
  for (std::size_t seed = 0; seed < grid_.size(); ++seed) {
    if (narrow[seed] || spaces_[seed] != kNowhere) continue;
    piece.assign(1, seed), spaces_[seed] = next_;
    for (std::size_t i = 0; i < piece.size(); ++i)
      eachNeighbour(piece[i], [&](std::size_t next) {
        if (!narrow[next] && spaces_[next] == kNowhere) spaces_[next] = next_, piece.push_back(next);
      });
    if (piece.size() >= kLeastCore)
      ++next_;
    else
      for (const std::size_t cube : piece) spaces_[cube] = kNowhere, narrow[cube] = 1;
  }
}

/// All at one pace.
void Spaces::grow() {
  std::vector<std::size_t> front, next;
  for (std::size_t cube = 0; cube < grid_.size(); ++cube)
    if (spaces_[cube] != kNowhere) front.push_back(cube);
  for (; !front.empty(); front.swap(next), next.clear())
    for (const std::size_t cube : front)
      eachNeighbour(cube, [&](std::size_t other) {
        if (!solid_[other] && spaces_[other] == kNowhere)
          spaces_[other] = spaces_[cube], next.push_back(other);
      });
}

std::uint32_t Spaces::at(const Vec3& point) const {
  const auto center = grid_.stepsTo(point);
  const int most = static_cast<int>(kAround / grid_.edge);
  std::uint32_t found = kNowhere;
  int nearest = 3 * most * most + 1;
  std::array<int, 3> by{};
  for (by[2] = -most; by[2] <= most; ++by[2])
    for (by[1] = -most; by[1] <= most; ++by[1])
      for (by[0] = -most; by[0] <= most; ++by[0]) {
        auto steps = center;
        bool isIn = true;
        int distance = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) {
          steps[axis] += by[axis], distance += by[axis] * by[axis];
          isIn = isIn && steps[axis] >= 0 && steps[axis] < grid_.count[axis];
        }
        if (!isIn || distance >= nearest) continue;
        const std::uint32_t space = spaces_[grid_.indexOf(steps)];
        if (space > kOutdoors) found = space, nearest = distance;
      }
  return found;
}

std::vector<bool> Spaces::reached(std::uint32_t from, std::uint32_t openings) const {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> faces;  // between two spaces
  for (std::size_t cube = 0; cube < grid_.size(); ++cube)
    eachNeighbour(cube, [&](std::size_t other) {
      const std::uint32_t one = spaces_[cube], two = spaces_[other];
      if (one > kOutdoors && two > one) ++faces[{one, two}];
    });
  std::vector<bool> isReached(next_, false);
  isReached[from] = true;
  for (std::uint32_t step = 0; step < openings; ++step) {
    const std::vector<bool> before = isReached;
    for (const auto& [pair, count] : faces)
      if (static_cast<double>(count) * grid_.edge * grid_.edge >= kLeastOpening) {
        if (before[pair.first]) isReached[pair.second] = true;
        if (before[pair.second]) isReached[pair.first] = true;
      }
  }
  return isReached;
}

}  // namespace fiatlux
