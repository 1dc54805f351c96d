// Grids of sites, and the test that a square lies wholly on its mount.
#include "precompute/geometry/sites.h"

#include <algorithm>
#include <cmath>

#include "precompute/geometry/flat_regions.h"

namespace fiatlux {
namespace {

constexpr std::size_t kMostSquares = 4'000'000;  // of a grid: no plane has so many sites
constexpr double kDown = 0.5;                    // cos 60 degrees
constexpr double kSlack = 1e-3;                  // m, and of a spacing above 1 m
constexpr double kMostInRow = 1e6;
constexpr double kCovered = 0.996;      // of a square's area: a millimetre of quantisation is not missing
constexpr double kNearlyCovered = 0.8;  // so much of it where a mount is drawn in pieces
constexpr double kSamePlane = 0.01;     // m: so near they lie in one plane
constexpr double kParallel = 0.9986;    // cos 3 degrees

struct MountPlanes {
  FaceSet set;
  std::vector<Region> regions;
  bool areInPieces = false;
};

MountPlanes planesOf(const WeldedMesh& mesh, const std::vector<Face>& faces,
                     Flatness flatness = Flatness::kExact) {
  MountPlanes planes;
  planes.set = makeFaceSet(mesh, faces);
  planes.regions = flatRegions(mesh, planes.set, flatness);
  const auto down = [](const Region& r) { return r.normal.y < -kDown; };
  if (std::any_of(planes.regions.begin(), planes.regions.end(), down))
    planes.regions.erase(std::remove_if(planes.regions.begin(), planes.regions.end(),
                                        [&](const Region& r) { return !down(r); }),
                         planes.regions.end());
  return planes;
}

using Polygon = std::vector<std::array<double, 2>>;

/// Keeps the part with sign * (coordinate[axis] - at) >= 0.
void clip(Polygon& polygon, int axis, double at, double sign) {
  Polygon out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double da = sign * (a[axis] - at), db = sign * (b[axis] - at);
    if (da >= 0) out.push_back(a);
    if ((da > 0 && db < 0) || (da < 0 && db > 0)) {
      const double t = da / (da - db);
      out.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])});
    }
  }
  polygon = std::move(out);
}

double areaOf(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i)
    twice += (polygon[i - 1][0] - polygon[0][0]) * (polygon[i][1] - polygon[0][1]) -
             (polygon[i - 1][1] - polygon[0][1]) * (polygon[i][0] - polygon[0][0]);
  return 0.5 * std::abs(twice);
}

/// One direction of the grid: squares i of [first + i * pitch, + size].
struct Axis {
  double first = 0, pitch = 0, size = 0;
  int count = 0;

  Axis(double low, double high, double spacing, double side) : pitch(spacing), size(side) {
    // A millimetre is what quantised vertices may lack; it must not cost a row of squares.
    const double length = high - low, slack = kSlack * std::max(spacing, 1.0);
    count = static_cast<int>(std::min(kMostInRow, std::floor((length + slack) / spacing)));
    if (side > spacing)
      count = static_cast<int>(std::min(kMostInRow, std::floor((length - side + slack) / spacing))) +
              (length + slack >= side);
    if (count <= 0 && length + slack >= side) count = 1;
    count = std::max(count, 0);
    first = 0.5 * (low + high) - 0.5 * (count - 1) * spacing - 0.5 * side;
  }
  std::pair<int, int> touching(double low, double high) const {
    return {std::clamp(static_cast<int>(std::floor((low - first - size) / pitch)), 0, count),
            std::clamp(static_cast<int>(std::ceil((high - first) / pitch)), 0, count)};
  }
};

void sitesOnPlane(const WeldedMesh& mesh, const MountPlanes& planes, const Region& region, double spacing,
                  double size, std::vector<Site>& sites) {
  Vec3 u = region.outline.longestDirection;
  u = normalized(u - dot(u, region.normal) * region.normal);
  if (length(u) == 0) return;
  const Vec3 v = cross(region.normal, u);

  // The plane's triangles in its own coordinates, and the grid over them.
  double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300};
  std::vector<std::array<std::array<double, 2>, 3>> flat;
  for (const std::uint32_t f : region.faces) {
    flat.emplace_back();
    for (int c = 0; c < 3; ++c) {
      const Vec3& p = mesh.positions[planes.set.faces[f].vertex[c]];
      flat.back()[c] = {dot(p, u), dot(p, v)};
      for (int i = 0; i < 2; ++i)
        low[i] = std::min(low[i], flat.back()[c][i]), high[i] = std::max(high[i], flat.back()[c][i]);
    }
  }
  const Axis columns(low[0], high[0], spacing, size), rows(low[1], high[1], spacing, size);
  if (std::size_t{1} * columns.count * rows.count > kMostSquares) return;

  // How much of each square the triangles cover.
  std::vector<double> covered(std::size_t{1} * columns.count * rows.count, 0);
  for (const auto& triangle : flat) {
    const auto [u0, u1] = std::minmax({triangle[0][0], triangle[1][0], triangle[2][0]});
    const auto [v0, v1] = std::minmax({triangle[0][1], triangle[1][1], triangle[2][1]});
    const auto cols = columns.touching(u0, u1), lines = rows.touching(v0, v1);
    for (int r = lines.first; r < lines.second; ++r)
      for (int c = cols.first; c < cols.second; ++c) {
        Polygon polygon(triangle.begin(), triangle.end());
        clip(polygon, 0, columns.first + c * spacing, 1),
            clip(polygon, 0, columns.first + c * spacing + size, -1);
        clip(polygon, 1, rows.first + r * spacing, 1), clip(polygon, 1, rows.first + r * spacing + size, -1);
        covered[std::size_t{1} * r * columns.count + c] += areaOf(polygon);
      }
  }

  // Squares that are covered wholly are sites; of what is rough they hang below the lowest point.
  const double least = planes.areInPieces ? kNearlyCovered : kCovered;
  double height = dot(region.centroid, region.normal);
  if (planes.areInPieces)
    for (const std::uint32_t f : region.faces)
      for (const std::uint32_t v : planes.set.faces[f].vertex)
        height = std::max(height, dot(mesh.positions[v], region.normal));
  for (int r = 0; r < rows.count; ++r)
    for (int c = 0; c < columns.count; ++c) {
      if (covered[std::size_t{1} * r * columns.count + c] < least * size * size) continue;
      const double x = columns.first + c * spacing + 0.5 * size, y = rows.first + r * spacing + 0.5 * size;
      sites.push_back({x * u + y * v + height * region.normal, region.normal, u, size});
    }
}

/// Puts what lies in one plane together, the largest first.
MountPlanes together(const WeldedMesh& mesh, MountPlanes pieces) {
  std::stable_sort(pieces.regions.begin(), pieces.regions.end(),
                   [](const Region& a, const Region& b) { return a.area > b.area; });
  MountPlanes planes{std::move(pieces.set), {}, true};
  for (Region& piece : pieces.regions) {
    const auto home = std::find_if(planes.regions.begin(), planes.regions.end(), [&](const Region& plane) {
      return dot(plane.normal, piece.normal) > kParallel &&
             std::abs(dot(piece.centroid - plane.centroid, plane.normal)) < kSamePlane;
    });
    if (home == planes.regions.end())
      planes.regions.push_back(std::move(piece));
    else
      home->faces.insert(home->faces.end(), piece.faces.begin(), piece.faces.end());
  }
  for (Region& plane : planes.regions) plane.outline = outlineOf(mesh, planes.set, plane.faces);
  return planes;
}

}  // namespace

std::vector<Site> sitesOn(const WeldedMesh& mesh, const std::vector<Face>& faces, double spacing,
                          double size) {
  std::vector<Site> sites;
  const auto hangOn = [&](const MountPlanes& planes) {
    for (const Region& region : planes.regions) sitesOnPlane(mesh, planes, region, spacing, size, sites);
  };
  hangOn(planesOf(mesh, faces));
  if (sites.empty()) hangOn(together(mesh, planesOf(mesh, faces, Flatness::kScanned)));
  return sites;
}

std::vector<Face> facesForSites(const WeldedMesh& mesh, const std::vector<Face>& faces) {
  const MountPlanes planes = planesOf(mesh, faces);
  std::vector<Face> used;
  for (const Region& region : planes.regions)
    for (const std::uint32_t f : region.faces) used.push_back(planes.set.faces[f]);
  return used;
}

double mountArea(const WeldedMesh& mesh, const std::vector<Face>& faces) {
  double area = 0;
  for (const Region& region : planesOf(mesh, faces).regions) area += region.area;
  return area;
}

}  // namespace fiatlux
