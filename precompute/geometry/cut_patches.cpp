// Clipping of faces against the grid of their chart, and the bookkeeping that makes patches of the pieces.
#include "precompute/geometry/cut_patches.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "core/base/short_number.h"
#include "precompute/geometry/clusters.h"
#include "precompute/room/grid_cut.h"

namespace fiatlux {
namespace {

constexpr double kSliver = 0.05;           // of a cell's area: smaller pieces join a neighbour
constexpr double kSmallChart = 0.25;       // of a patch's area: smaller charts share patches
constexpr int kSamples = 128;              // points per patch at which a texture is read
constexpr std::size_t kMostMaterials = 8;  // of materials, in warnings
constexpr double kFullCell = 1e-6;         // of a cell: how nearly its chart must fill it to be called whole

/// A triangle of a patch, with the source it came from.
struct Piece {
  Fragment fragment;
  std::uint32_t mesh, source, cell;
  double area;
};

/// Cuts the faces of a chart into pieces, one cell each.
std::vector<Piece> cutFaces(const WeldedMesh& mesh, const ChartDraft& draft) {
  std::vector<Piece> pieces;
  GridCut cut;
  for (const Face& face : draft.faces) {
    const auto& v = face.vertex;
    cut.cut(draft.chart, {mesh.positions[v[0]], mesh.positions[v[1]], mesh.positions[v[2]]},
            [&](std::uint32_t cell, const std::vector<GridCorner>& polygon) {
              for (std::size_t i = 2; i < polygon.size(); ++i) {
                const Fragment fragment{{polygon[0].position, polygon[i - 1].position, polygon[i].position}};
                const auto& c = fragment.corner;
                const double area = 0.5 * length(cross(c[1] - c[0], c[2] - c[0]));
                if (area > 0) pieces.push_back({fragment, face.mesh, face.source, cell, area});
              }
            });
  }
  return pieces;
}

/// The cell whose patch each cell joins: itself, or for a sliver the largest cell beside it.
std::vector<std::uint32_t> joinSlivers(const Chart& chart, const std::vector<double>& area) {
  const double least = kSliver * chart.cellU * chart.cellV;
  const auto columns = static_cast<std::int64_t>(chart.columns), rows = static_cast<std::int64_t>(chart.rows);
  std::vector<std::uint32_t> target(area.size());
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(area.size()); ++i) {
    target[i] = static_cast<std::uint32_t>(i);
    if (area[i] <= 0 || area[i] >= least) continue;
    const std::int64_t r = i / columns, c = i % columns;
    for (const bool diagonal : {false, true}) {
      double best = area[i];
      for (std::int64_t dr = -1; dr <= 1; ++dr)
        for (std::int64_t dc = -1; dc <= 1; ++dc) {
          if ((dr != 0 && dc != 0) != diagonal || r + dr < 0 || r + dr >= rows || c + dc < 0 ||
              c + dc >= columns)
            continue;
          const std::int64_t j = (r + dr) * columns + c + dc;
          if (area[j] > best) best = area[j], target[i] = static_cast<std::uint32_t>(j);
        }
      if (target[i] != i) break;
    }
  }
  for (std::uint32_t& t : target)
    while (target[t] != t) t = target[t];  // areas grow along the way, so it ends
  return target;
}

/// The two triangles of a cell that its chart fills wholly and exactly; false when the pieces say otherwise.
bool wholeCell(const ChartDraft& draft, std::uint32_t cell, double area, const std::vector<Piece>& pieces,
               const std::vector<std::uint32_t>& members, std::array<Fragment, 2>& fragments) {
  const Chart& chart = draft.chart;
  const double full = chart.cellU * chart.cellV;
  if (!draft.flat || std::abs(area - full) > kFullCell * full) return false;
  const std::uint32_t r = cell / chart.columns, c = cell % chart.columns;
  for (const std::uint32_t m : members)
    for (const Vec3& p : pieces[m].fragment.corner)
      if (std::abs(dot(p - chart.origin, chart.normal)) > kFullCell * std::min(chart.cellU, chart.cellV))
        return false;
  const auto at = [&](int i, int j) {
    return chart.origin + (c + i) * chart.cellU * chart.uAxis + (r + j) * chart.cellV * chart.vAxis;
  };
  fragments = {Fragment{{at(0, 0), at(1, 0), at(1, 1)}}, Fragment{{at(0, 0), at(1, 1), at(0, 1)}}};
  return true;
}

/// Area-weighted mean reflectance of some pieces; textures are read at stratified points.
double meanReflectance(const ReflectanceMap& map, const std::vector<Piece>& pieces,
                       const std::vector<std::uint32_t>& members, double area, double& unclamped) {
  const SourceScene& source = map.source();
  double sum = 0;
  for (const std::uint32_t m : members) {
    const Piece& piece = pieces[m];
    if (map.isConstant(piece.mesh)) {
      sum += piece.area * map.at(piece.mesh, piece.source, {1, 0, 0});
      continue;
    }
    const auto& v = source.meshes[piece.mesh].triangles[piece.source];
    const auto& p = source.meshes[piece.mesh].positions;
    const Vec3 e1 = p[v[1]] - p[v[0]], e2 = p[v[2]] - p[v[0]], n = cross(e1, e2);
    const int count = std::clamp(static_cast<int>(std::ceil(kSamples * piece.area / area)), 1, kSamples);
    double local = 0;
    for (int i = 0; i < count; ++i) {
      // A low-discrepancy sequence (R2), folded into the triangle.
      double s = std::fmod(0.5 + (i + 1) * 0.7548776662466927, 1.0),
             t = std::fmod(0.5 + (i + 1) * 0.5698402909980532, 1.0);
      if (s + t > 1) s = 1 - s, t = 1 - t;
      const auto& corner = piece.fragment.corner;
      const Vec3 d = corner[0] + s * (corner[1] - corner[0]) + t * (corner[2] - corner[0]) - p[v[0]];
      const double w1 = dot(cross(d, e2), n) / dot(n, n), w2 = dot(cross(e1, d), n) / dot(n, n);
      local += map.at(piece.mesh, piece.source, {1 - w1 - w2, w1, w2});
    }
    sum += piece.area * local / count;
  }
  unclamped = sum / area;
  return std::clamp(unclamped, 0.0, kMostReflectance);
}

/// Grid neighbours with smaller index of each patch of a chart.
void linkNeighbors(const Chart& chart, const std::vector<std::uint32_t>& homeCell, std::uint32_t first,
                   Patches& patches) {
  for (std::uint32_t p = first; p < patches.rows(); ++p) {
    const std::uint32_t cell = homeCell[p - first];
    const auto neighbor = [&](bool exists, std::uint32_t back) {
      const std::uint32_t q = exists ? chart.patchOfCell[cell - back] : kNone;
      return q < p ? q : kNone;
    };
    patches.left[p] = neighbor(cell % chart.columns > 0, 1);
    patches.up[p] = neighbor(cell >= chart.columns, chart.columns);
  }
}

/// Where a patch came from: its chart and main cell.
struct Home {
  std::uint32_t draft = 0, cell = 0;
  bool shared = false;  // by several small charts
};

/// Which patch small charts of one surface, place and direction share.
using SharedKey = std::tuple<std::uint32_t, std::int64_t, std::int64_t, std::int64_t, int>;

SharedKey sharedKey(const ChartDraft& draft, const std::vector<Piece>& pieces, double patch) {
  const Vec3 p = pieces[0].fragment.corner[0];
  const auto at = [&](double c) { return static_cast<std::int64_t>(std::floor(c / patch)); };
  return {draft.chart.surface, at(p.x), at(p.y), at(p.z), dominantDirection(draft.chart.normal)};
}

/// Numbers the patches of one chart; sets each piece's cell to its patch.
void numberPatches(ChartDraft& draft, std::uint32_t index, double patch, std::vector<Piece>& pieces,
                   std::vector<Home>& homes, std::map<SharedKey, std::uint32_t>& shared,
                   std::uint32_t firstRow, Patches& patches) {
  Chart& chart = draft.chart;
  const std::size_t cells = std::size_t{chart.columns} * chart.rows;

  // Cells with area become patches, slivers of a neighbour's; a chart far smaller than a patch shares one.
  std::vector<double> area(cells, 0);
  for (const Piece& piece : pieces) area[piece.cell] += piece.area;
  const std::vector<std::uint32_t> target = joinSlivers(chart, area);
  chart.patchOfCell.assign(cells, kNone);
  const std::uint32_t first = patches.rows();
  const bool small = cells == 1 && draft.area < kSmallChart * patch * patch && !pieces.empty();
  const auto append = [&](std::uint32_t cell) {
    homes.push_back({index, cell, false});
    patches.area.push_back(0);
    patches.surface.push_back(chart.surface);
    return patches.rows() - 1;
  };
  if (small) {
    const auto [found, fresh] = shared.emplace(sharedKey(draft, pieces, patch), first);
    if (fresh)
      append(0);
    else
      homes[found->second - firstRow].shared = true;
    chart.patchOfCell[0] = found->second;
  } else {
    for (std::uint32_t c = 0; c < cells; ++c)
      if (area[c] > 0 && target[c] == c) chart.patchOfCell[c] = append(c);
    for (std::uint32_t c = 0; c < cells; ++c)
      if (area[c] > 0) chart.patchOfCell[c] = chart.patchOfCell[target[c]];
  }

  // From here on a piece belongs to its patch.
  for (Piece& piece : pieces) piece.cell = chart.patchOfCell[piece.cell];
  patches.left.resize(patches.rows(), kNone), patches.up.resize(patches.rows(), kNone);
  if (small) return;
  std::vector<std::uint32_t> homeCell;
  for (std::uint32_t p = first; p < patches.rows(); ++p) homeCell.push_back(homes[p - firstRow].cell);
  linkNeighbors(chart, homeCell, first, patches);
}

/// By patch from row `first` to row `end`: its pieces, in their order.
std::vector<std::vector<std::uint32_t>> piecesOfPatches(const std::vector<Piece>& pieces, std::uint32_t first,
                                                        std::uint32_t end) {
  std::vector<std::vector<std::uint32_t>> members(end - first);
  for (std::uint32_t i = 0; i < pieces.size(); ++i) members[pieces[i].cell - first].push_back(i);
  return members;
}

/// Appends centre and normal of a patch; returns its area, m2. `fallback`: the normal where pieces cancel.
double addShape(const std::vector<Piece>& pieces, const std::vector<std::uint32_t>& members,
                const Vec3& fallback, Room& room) {
  double area = 0;
  Vec3 moment{}, normal{};
  for (const std::uint32_t m : members) {
    const auto& c = pieces[m].fragment.corner;
    area += pieces[m].area;
    moment += pieces[m].area / 3 * (c[0] + c[1] + c[2]);
    normal += cross(c[1] - c[0], c[2] - c[0]);
  }
  room.patches.center.push_back((1 / area) * moment);
  room.patches.normal.push_back(length(normal) > 1e-3 * area ? normalized(normal) : fallback);
  return area;
}

/// Appends what a patch is made of: its pieces, or two triangles where it is a whole cell.
void addFragments(const ChartDraft& draft, const Home& home, double area, const std::vector<Piece>& pieces,
                  const std::vector<std::uint32_t>& members, Room& room) {
  std::array<Fragment, 2> whole;
  if (!home.shared && wholeCell(draft, home.cell, area, pieces, members, whole)) {
    room.fragments.insert(room.fragments.end(), whole.begin(), whole.end());
  } else {
    for (const std::uint32_t m : members) room.fragments.push_back(pieces[m].fragment);
  }
  room.fragmentOffset.push_back(static_cast<std::uint32_t>(room.fragments.size()));
}

void warnOfClamped(const std::map<std::string, double>& clamped, Room& room) {
  const std::string most = shortNumber(kMostReflectance);
  std::size_t listed = 0;
  for (const auto& [name, value] : clamped) {
    if (++listed > kMostMaterials) {
      room.warnings.push_back(std::to_string(clamped.size() - kMostMaterials) +
                              " more materials reflect more than " + most + " and are taken as " + most);
      break;
    }
    room.warnings.push_back(name + " reflects " + std::to_string(value).substr(0, 4) +
                            " of the light: taken as " + most);
  }
}

}  // namespace

void appendPatches(const WeldedMesh& mesh, std::vector<ChartDraft>& drafts, double patch,
                   const ReflectanceMap* reflectance, Room& room) {
  Patches& patches = room.patches;
  const std::uint32_t firstRow = patches.rows(), firstChart = static_cast<std::uint32_t>(room.charts.size());
  std::vector<Home> homes;
  std::vector<Piece> pieces;
  std::map<SharedKey, std::uint32_t> shared;
  for (std::uint32_t d = 0; d < drafts.size(); ++d) {
    std::vector<Piece> own = cutFaces(mesh, drafts[d]);
    numberPatches(drafts[d], d, patch, own, homes, shared, firstRow, patches);
    pieces.insert(pieces.end(), own.begin(), own.end());
    room.charts.push_back(drafts[d].chart);
  }

  if (room.fragmentOffset.empty()) room.fragmentOffset.push_back(0);
  std::map<std::string, double> clamped;
  const std::vector<std::vector<std::uint32_t>> piecesOf = piecesOfPatches(pieces, firstRow, patches.rows());
  for (std::size_t i = 0; i < homes.size(); ++i) {
    const ChartDraft& draft = drafts[homes[i].draft];
    const double area = addShape(pieces, piecesOf[i], draft.chart.normal, room);
    patches.area[firstRow + i] = area;
    addFragments(draft, homes[i], area, pieces, piecesOf[i], room);
    room.chartOfPatch.push_back(firstChart + homes[i].draft);
    double unclamped = 0;
    patches.reflectance.push_back(static_cast<float>(
        reflectance ? meanReflectance(*reflectance, pieces, piecesOf[i], area, unclamped) : 0));
    if (unclamped <= kMostReflectance + 1e-6) continue;
    double& most = clamped[reflectance->materialName(pieces[piecesOf[i][0]].mesh)];
    most = std::max(most, unclamped);
  }
  warnOfClamped(clamped, room);
}

}  // namespace fiatlux
