// Floor -> its boundary -> a grid whose lines pass where the plane ends -> cells that are far enough inside
// -> few rectangles.
#include "precompute/geometry/working_plane.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/base/short_number.h"
#include "precompute/base/error.h"
#include "precompute/geometry/open_floor.h"
#include "precompute/geometry/outline.h"

namespace fiatlux {
namespace {

constexpr Vec3 kUp{0, 1, 0};
constexpr double kFloorUp = 0.9;       // cos 26 degrees
constexpr double kAsLow = 0.1;         // m: of one floor
constexpr double kOften = 0.1;         // of the rays that its largest piece gets: a piece of the floor, too
constexpr double kFinestCell = 0.1;    // m, where a boundary is slanted
constexpr double kCellsAcross = 128;   // at most, but for lines where sides end
constexpr std::size_t kMostEnds = 64;  // of sides in one direction: beyond, the grid alone must do
constexpr double kSameLine = 1e-3;     // m
constexpr double kRimSlack = 1e-6;     // m

/// A plane of the surface tree.
struct FloorPiece {
  const SurfaceGroup* group;
  const Region* region;
  double met = 0;  // rays down from a mount
};

std::vector<Face> facesOf(const FloorPiece& piece) {
  std::vector<Face> faces;
  for (const std::uint32_t f : piece.region->faces) faces.push_back(piece.group->set.faces[f]);
  return faces;
}

/// The floor below a mount; empty where there is none.
std::vector<Face> floorBelow(const Inside& inside, const Mount& mount) {
  if (mount.lift > 0) return mount.faces;
  std::map<std::pair<std::uint32_t, bool>, std::size_t> pieceOfSide;
  std::vector<FloorPiece> pieces;
  for (const SurfaceGroup& group : inside.tree.groups)
    for (const Region& region : group.regions) {
      if (region.normal.y < kFloorUp) continue;
      for (const std::uint32_t f : region.faces)
        pieceOfSide[{group.set.faces[f].triangle, group.set.faces[f].back}] = pieces.size();
      pieces.push_back({&group, &region});
    }
  for (const auto& side : inside.space->from(mount.faces, 0).floorSides)
    if (const auto piece = pieceOfSide.find(side); piece != pieceOfSide.end()) ++pieces[piece->second].met;
  const auto most = std::max_element(pieces.begin(), pieces.end(),
                                     [](const FloorPiece& a, const FloorPiece& b) { return a.met < b.met; });
  std::vector<Face> floor;
  if (most == pieces.end() || most->met == 0) return floor;
  for (const FloorPiece& piece : pieces) {
    const double higher = piece.region->centroid.y - most->region->centroid.y;
    if (std::abs(higher) > kAsLow || piece.met < kOften * most->met) continue;
    const std::vector<Face> faces = facesOf(piece);
    floor.insert(floor.end(), faces.begin(), faces.end());
  }
  return floor;
}

struct Point {
  double u = 0, v = 0;  // m
};

/// A side of the floor, seen from above.
struct Side {
  Point from, to;

  bool isAligned() const {
    return std::abs(to.u - from.u) < kSameLine || std::abs(to.v - from.v) < kSameLine;
  }
  /// Whether a line from the point along u crosses it.
  bool isCrossed(const Point& p) const {
    if ((from.v > p.v) == (to.v > p.v)) return false;
    return p.u < from.u + (p.v - from.v) / (to.v - from.v) * (to.u - from.u);
  }
  /// m; of a side along the grid as a square reaches, so that corners stay square.
  double distance(const Point& p) const {
    if (isAligned()) {
      const auto [lowU, highU] = std::minmax(from.u, to.u);
      const auto [lowV, highV] = std::minmax(from.v, to.v);
      return std::max({lowU - p.u, p.u - highU, lowV - p.v, p.v - highV, 0.0});
    }
    const double du = to.u - from.u, dv = to.v - from.v;
    const double t = std::clamp(((p.u - from.u) * du + (p.v - from.v) * dv) / (du * du + dv * dv), 0.0, 1.0);
    return std::hypot(p.u - from.u - t * du, p.v - from.v - t * dv);
  }
};

/// Lines of the grid in one direction: where sides end and where the rim does, and enough between.
std::vector<double> linesThrough(std::vector<double> ends, double rim) {
  std::sort(ends.begin(), ends.end());
  const double low = ends.front(), high = ends.back();
  const auto isSame = [](double a, double b) { return b - a < kSameLine; };
  ends.erase(std::unique(ends.begin(), ends.end(), isSame), ends.end());
  std::vector<double> exact{low, high};
  if (ends.size() <= kMostEnds)
    for (const double end : ends)
      for (const double line : {end, end - rim, end + rim})
        if (line > low && line < high) exact.push_back(line);
  std::sort(exact.begin(), exact.end());
  const double widest = std::max(kFinestCell, (high - low) / kCellsAcross);
  std::vector<double> lines{low};
  for (const double next : exact) {
    const double last = lines.back(), gap = next - last;
    if (gap < kSameLine) continue;
    const double count = std::ceil(gap / widest);
    for (int i = 1; i <= count; ++i) lines.push_back(last + gap * i / count);
  }
  return lines;
}

/// A floor from above: its sides along two directions of the plane.
struct FloorPlan {
  Vec3 u, v;          // u x v is up
  double height = 0;  // m
  std::vector<Side> sides;

  Vec3 at(double a, double b, double y) const { return a * u + b * v + y * kUp; }
  bool holds(const Point& p, double rim) const {
    bool isInside = false;
    for (const Side& side : sides) {
      if (side.isCrossed(p)) isInside = !isInside;
      if (side.distance(p) < rim - kRimSlack) return false;
    }
    return isInside;
  }
};

FloorPlan planOf(const WeldedMesh& mesh, const std::vector<Face>& faces) {
  const FaceSet set = makeFaceSet(mesh, faces);
  std::vector<std::uint32_t> all(set.faces.size());
  std::iota(all.begin(), all.end(), 0u);
  FloorPlan plan;
  const Vec3 along = outlineOf(mesh, set, all).longestDirection;
  plan.u = normalized(along - dot(along, kUp) * kUp);
  if (length(plan.u) == 0) plan.u = {1, 0, 0};
  plan.v = cross(kUp, plan.u);
  const auto seen = [&](std::uint32_t vertex) {
    const Vec3& p = mesh.positions[vertex];
    return Point{dot(p, plan.u), dot(p, plan.v)};
  };
  for (const auto& [from, to] : boundaryOf(set, all)) plan.sides.push_back({seen(from), seen(to)});
  double area = 0;
  for (const Face& face : faces) {
    const double own = length(areaVector(mesh.positions, face.vertex));
    for (const std::uint32_t vertex : face.vertex) plan.height += own / 3 * mesh.positions[vertex].y;
    area += own;
  }
  plan.height /= area;
  return plan;
}

void addRectangle(const FloorPlan& plan, const Point& low, const Point& high, double y, SourceMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const auto& [a, b] : {std::pair(low.u, low.v), {high.u, low.v}, {high.u, high.v}, {low.u, high.v}})
    mesh.positions.push_back(plan.at(a, b, y));
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

/// Runs of cells, and of equal ones in neighbouring rows, are one rectangle.
void addPlane(const FloorPlan& plan, const RoomOptions& options, SourceMesh& mesh) {
  std::vector<double> endsU, endsV;
  for (const Side& side : plan.sides)
    for (const Point& p : {side.from, side.to}) endsU.push_back(p.u), endsV.push_back(p.v);
  if (endsU.empty()) return;
  const std::vector<double> us = linesThrough(endsU, options.planeRim);
  const std::vector<double> vs = linesThrough(endsV, options.planeRim);
  const double y = plan.height + options.plane;

  using Run = std::pair<std::size_t, std::size_t>;  // of lines
  std::map<Run, std::size_t> open;                  // and the row it began in
  for (std::size_t row = 0; row < vs.size(); ++row) {
    std::map<Run, std::size_t> here;
    const auto isKept = [&](std::size_t i) {
      return row + 1 < vs.size() && i + 1 < us.size() &&
             plan.holds({0.5 * (us[i] + us[i + 1]), 0.5 * (vs[row] + vs[row + 1])}, options.planeRim);
    };
    for (std::size_t i = 0; i + 1 < us.size(); ++i) {
      const std::size_t begin = i;
      while (isKept(i)) ++i;
      if (i == begin) continue;
      const auto before = open.find({begin, i});
      here[{begin, i}] = before == open.end() ? row : before->second;
    }
    for (const auto& [run, since] : open)
      if (here.count(run) == 0)
        addRectangle(plan, {us[run.first], vs[since]}, {us[run.second], vs[row]}, y, mesh);
    open = std::move(here);
  }
}

}  // namespace

SourceScene workingPlane(const WeldedMesh& mesh, const Inside& inside, const RoomOptions& options) {
  std::vector<std::vector<Face>> floors;
  for (const Mount& mount : inside.mounts)
    if (std::vector<Face> floor = floorBelow(inside, mount); !floor.empty()) {
      const auto isSame = [&](const std::vector<Face>& other) {
        return other[0].triangle == floor[0].triangle && other[0].back == floor[0].back;
      };
      if (std::none_of(floors.begin(), floors.end(), isSame)) floors.push_back(std::move(floor));
    }
  if (floors.empty())
    if (const auto floor = largestFloor(mesh, inside.tree, *inside.space)) floors.push_back(floor->faces);
  if (floors.empty()) throw CommandError("there is no floor for a working plane (--plane) to lie over");

  SourceScene planes;
  SourceMesh plane;
  plane.node = "working plane";
  plane.extras.measure = true;
  plane.extras.border = options.planeRim;
  for (const std::vector<Face>& floor : floors) addPlane(planOf(mesh, floor), options, plane);
  if (plane.triangles.empty())
    throw CommandError("no working plane: the floor is narrower than two rims of " +
                       shortNumber(options.planeRim) + " m; make the rim smaller (--plane-rim)");
  planes.meshes.push_back(std::move(plane));
  return planes;
}

}  // namespace fiatlux
