// Growing charts over planar regions, and laying the grid along the outline's longest edge.
#include "precompute/geometry/charts.h"

#include <algorithm>
#include <cmath>

#include "core/base/short_number.h"
#include "precompute/base/error.h"

namespace fiatlux {
namespace {

constexpr double kCone = 0.819;    // cos 35 degrees: how far a face may turn from its chart
constexpr double kCrease = 0.707;  // cos 45 degrees: a sharper edge ends a chart

// A plane stands alone from this area on (in patches), where it is this wide (its mean width in patches).
constexpr double kAloneArea = 0.5, kAloneWidth = 0.7;

constexpr double kRounding = 1e-6;     // of a patch: extents that are whole but for it
constexpr double kMostCells = 1e9;     // along a side: beyond, checkGrids refuses it anyway
constexpr double kNearlyAlong = 0.9;   // a component of a unit vector that leaves too little across
constexpr double kCellBytes = 24;      // while a grid is being cut
constexpr double kLeastInCluster = 4;  // patches, so few as crumbs leave them

/// Frame and grid of a set of faces: u along the longest straight side, cells a side = max(1, round(length /
/// patch)).
void layGrid(const WeldedMesh& mesh, const FaceSet& set, const std::vector<std::uint32_t>& faces,
             const Outline& outline, double patch, ChartDraft& draft) {
  Chart& chart = draft.chart;
  Vec3 u = outline.longestDirection;
  u = u - dot(u, chart.normal) * chart.normal;
  if (length(u) < kRounding) {
    const Vec3 axis = std::abs(chart.normal.x) < kNearlyAlong ? Vec3{1, 0, 0} : Vec3{0, 0, 1};
    u = axis - dot(axis, chart.normal) * chart.normal;
  }
  chart.uAxis = normalized(u);
  chart.vAxis = cross(chart.normal, chart.uAxis);
  double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300}, w = 0;
  for (const std::uint32_t f : faces)
    for (const std::uint32_t v : set.faces[f].vertex) {
      const Vec3& p = mesh.positions[v];
      const double at[2] = {dot(p, chart.uAxis), dot(p, chart.vAxis)};
      for (int i = 0; i < 2; ++i) low[i] = std::min(low[i], at[i]), high[i] = std::max(high[i], at[i]);
      w += dot(p, chart.normal) / (3.0 * static_cast<double>(faces.size()));
    }
  chart.origin = low[0] * chart.uAxis + low[1] * chart.vAxis + w * chart.normal;
  const auto cells = [&](double extent) {
    return static_cast<std::uint32_t>(
        std::clamp(std::floor(extent / patch + 0.5 - kRounding), 1.0, kMostCells));
  };
  chart.columns = cells(high[0] - low[0]), chart.rows = cells(high[1] - low[1]);
  chart.cellU = std::max(high[0] - low[0], mesh.tolerance) / chart.columns;
  chart.cellV = std::max(high[1] - low[1], mesh.tolerance) / chart.rows;
}

ChartDraft chartOf(const WeldedMesh& mesh, const SurfaceGroup& group,
                   const std::vector<std::uint32_t>& regions, const Vec3& normal, double patch,
                   std::uint32_t surface) {
  ChartDraft draft;
  draft.chart.surface = surface;
  draft.chart.normal = normal;
  draft.flat = regions.size() == 1;
  std::vector<std::uint32_t> faces;
  for (const std::uint32_t r : regions) {
    draft.area += group.regions[r].area;
    faces.insert(faces.end(), group.regions[r].faces.begin(), group.regions[r].faces.end());
  }
  const Outline outline = draft.flat ? group.regions[regions[0]].outline : outlineOf(mesh, group.set, faces);
  layGrid(mesh, group.set, faces, outline, patch, draft);
  for (const std::uint32_t f : faces) draft.faces.push_back(group.set.faces[f]);
  return draft;
}

void chartsOfGroup(const WeldedMesh& mesh, const SurfaceGroup& group, double patch,
                   std::uint32_t firstSurface, std::vector<ChartDraft>& charts) {
  const std::size_t n = group.regions.size();
  std::vector<std::uint32_t> regionOfFace(group.set.faces.size(), kNone);  // none: left out
  for (std::uint32_t r = 0; r < n; ++r)
    for (const std::uint32_t f : group.regions[r].faces) regionOfFace[f] = r;

  // Large ones first.
  std::vector<bool> taken(n, false);
  std::vector<std::uint32_t> order(n);
  for (std::uint32_t r = 0; r < n; ++r) order[r] = r;
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return group.regions[a].area > group.regions[b].area; });

  // Planes that are about a patch wide or more stand alone.
  for (const std::uint32_t r : order) {
    const Region& region = group.regions[r];
    if (region.area < kAloneArea * patch * patch && n > 1) break;
    // note: a strip of perimeter p and area a is 2 a / p wide, a square twice that
    if (n > 1 && 4 * region.area < kAloneWidth * patch * region.outline.perimeter) continue;
    taken[r] = true;
    charts.push_back(chartOf(mesh, group, {r}, region.normal, patch, firstSurface + group.leafOfRegion[r]));
  }

  // The rest grows along smooth edges, within one leaf.
  for (const std::uint32_t seed : order) {
    if (taken[seed]) continue;
    taken[seed] = true;
    std::vector<std::uint32_t> members{seed};
    Vec3 sum = group.regions[seed].area * group.regions[seed].normal;
    for (std::size_t next = 0; next < members.size(); ++next)
      for (const std::uint32_t f : group.regions[members[next]].faces)
        for (std::uint32_t i = group.set.neighborOffset[f]; i < group.set.neighborOffset[f + 1]; ++i) {
          const std::uint32_t r = regionOfFace[group.set.neighbors[i]];
          if (r == kNone || taken[r] || group.leafOfRegion[r] != group.leafOfRegion[seed]) continue;
          const Region& region = group.regions[r];
          if (dot(region.normal, normalized(sum)) < kCone ||
              dot(region.normal, group.regions[members[next]].normal) < kCrease ||
              dot(region.normal, group.regions[seed].normal) < kCone)
            continue;
          taken[r] = true;
          members.push_back(r);
          sum += region.area * region.normal;
        }
    charts.push_back(
        chartOf(mesh, group, members, normalized(sum), patch, firstSurface + group.leafOfRegion[seed]));
  }
}

}  // namespace

std::vector<ChartDraft> makeCharts(const WeldedMesh& mesh, const SurfaceTree& tree, double patch,
                                   std::uint32_t firstSurface) {
  std::vector<ChartDraft> charts;
  for (const SurfaceGroup& group : tree.groups) chartsOfGroup(mesh, group, patch, firstSurface, charts);
  std::stable_sort(charts.begin(), charts.end(), [](const ChartDraft& a, const ChartDraft& b) {
    return a.chart.surface < b.chart.surface;
  });
  return charts;
}

double foreseenPatches(const std::vector<ChartDraft>& charts) {
  double patches = 0;
  for (const ChartDraft& draft : charts)
    patches += std::max(1.0, draft.area / (draft.chart.cellU * draft.chart.cellV));
  return patches;
}

void checkGrids(const std::vector<ChartDraft>& charts, const RoomOptions& options, double patch,
                std::uint32_t mostClusters) {
  double cells = 0;
  for (const ChartDraft& draft : charts) cells += static_cast<double>(draft.chart.columns) * draft.chart.rows;
  if (cells * kCellBytes > options.memory * 1e9)
    throw CommandError("patches of " + shortNumber(patch) + " m need " + shortNumber(cells) +
                       " grid cells, more than --memory allows; pass a larger --patch");
  RunCounts counts = countsOf(options);
  counts.patches = counts.rows = foreseenPatches(charts);
  counts.clusters = options.paper ? counts.patches / (options.cluster * options.cluster)
                                  : std::min<double>(counts.patches / kLeastInCluster, mostClusters);
  orThrow(checkMemory(counts, options.memory));
}

}  // namespace fiatlux
