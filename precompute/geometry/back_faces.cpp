// The search for double-sided sheets that have a visible back.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

#include "precompute/geometry/faces.h"
#include "precompute/room/bounds.h"
#include "precompute/room/disjoint_sets.h"

namespace fiatlux {
namespace {

constexpr double kRoomLike = 0.5;    // of the scene's diagonal: a room rather than a thing in it
constexpr std::size_t kProbes = 64;  // of other things, which may stand within a room

/// A connected piece of double-sided triangles.
struct Sheet {
  bool open = false;
  double volume = 0;  // m3, positive where the fronts look outward
  Bounds bounds;
};

/// Pieces that share edges, those of one node apart from those of another.
struct Sheets {
  DisjointSets sets;           // of triangles
  std::vector<Sheet> ofRoot;   // by the triangle that stands for its piece
  std::vector<bool> isMember;  // of a sheet at all

  const Sheet& of(std::uint32_t t) { return ofRoot[sets.find(t)]; }
};

Sheets findSheets(const SourceScene& source, const WeldedMesh& mesh, bool all) {
  const std::size_t n = mesh.triangles.size();
  Sheets sheets{DisjointSets(n), std::vector<Sheet>(n), std::vector<bool>(n)};

  // Edges of double-sided triangles, equal ones of a node side by side.
  struct Edge {
    std::uint32_t node, a, b, triangle;
    bool forward;
  };
  std::vector<Edge> edges;
  for (std::uint32_t t = 0; t < n; ++t) {
    const int material = source.meshes[mesh.triangles[t].mesh].material;
    sheets.isMember[t] = all || (material >= 0 && source.materials[material].doubleSided);
    if (!sheets.isMember[t]) continue;
    const auto& v = mesh.triangles[t].vertex;
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = v[i], b = v[(i + 1) % 3];
      edges.push_back(
          {source.meshes[mesh.triangles[t].mesh].nodeIndex, std::min(a, b), std::max(a, b), t, a < b});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& x, const Edge& y) {
    return std::tie(x.node, x.a, x.b, x.triangle) < std::tie(y.node, y.a, y.b, y.triangle);
  });

  // What shares an edge is one sheet; it is open where an edge is not run along once in each direction.
  std::vector<bool> open(n, false);
  for (std::size_t i = 0, j; i < edges.size(); i = j) {
    int balance = 0;
    for (j = i; j < edges.size() && edges[j].node == edges[i].node && edges[j].a == edges[i].a &&
                edges[j].b == edges[i].b;
         ++j) {
      sheets.sets.join(edges[i].triangle, edges[j].triangle);
      balance += edges[j].forward ? 1 : -1;
    }
    if (balance != 0 || j - i != 2) open[edges[i].triangle] = true;
  }

  // Volume and extent, by the divergence theorem.
  for (std::uint32_t t = 0; t < n; ++t) {
    if (!sheets.isMember[t]) continue;
    Sheet& sheet = sheets.ofRoot[sheets.sets.find(t)];
    if (open[t]) sheet.open = true;
    const auto& v = mesh.triangles[t].vertex;
    sheet.volume += dot(mesh.positions[v[0]], cross(mesh.positions[v[1]], mesh.positions[v[2]])) / 6;
    for (const std::uint32_t i : v) sheet.bounds.include(mesh.positions[i]);
  }
  return sheets;
}

/// Signed solid angle of a triangle seen from p (van Oosterom and Strackee 1983), positive from behind.
double solidAngle(const WeldedMesh& mesh, const WeldedTriangle& t, const Vec3& p) {
  const Vec3 a = mesh.positions[t.vertex[0]] - p, b = mesh.positions[t.vertex[1]] - p,
             c = mesh.positions[t.vertex[2]] - p;
  const double la = length(a), lb = length(b), lc = length(c);
  return 2 * std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

/// About as large as the scene: a room rather than a thing in it.
bool isLarge(const Sheet& sheet, const WeldedMesh& mesh) {
  return sheet.bounds.diagonal() > kRoomLike * mesh.diagonal;
}

/// Whether a closed sheet that looks outward is a room drawn from outside: as large as the scene, and other
/// things stand within it, or there is nothing else.
bool isRoomFromOutside(const WeldedMesh& mesh, Sheets& sheets, std::uint32_t root) {
  const Sheet& sheet = sheets.ofRoot[root];
  if (sheet.open || sheet.volume <= 0 || !isLarge(sheet, mesh)) return false;
  std::vector<std::uint32_t> own, others;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
    (sheets.isMember[t] && sheets.sets.find(t) == root ? own : others).push_back(t);
  if (others.empty()) return true;
  const std::size_t step = std::max<std::size_t>(1, others.size() / kProbes);
  for (std::size_t i = 0; i < others.size(); i += step) {
    const auto& v = mesh.triangles[others[i]].vertex;
    const Vec3 p = (1.0 / 3) * (mesh.positions[v[0]] + mesh.positions[v[1]] + mesh.positions[v[2]]);
    double angle = 0;
    for (const std::uint32_t t : own) angle += solidAngle(mesh, mesh.triangles[t], p);
    // note: a thing that lies in the sheet's own plane sees half of the sphere
    if (angle > 3 * std::numbers::pi) return true;
  }
  return false;
}

}  // namespace

std::vector<Face> backFaces(const SourceScene& source, const WeldedMesh& mesh, bool all) {
  Sheets sheets = findSheets(source, mesh, all);
  std::vector<Face> faces;
  std::vector<char> roomFromOutside(mesh.triangles.size(), -1);  // by root; -1: not asked yet
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const WeldedTriangle& triangle = mesh.triangles[t];
    const std::array<std::uint32_t, 3> turned{triangle.vertex[0], triangle.vertex[2], triangle.vertex[1]};
    if (triangle.backMesh != kNone) {
      faces.push_back({turned, t, triangle.backMesh, triangle.backSource, true});
    } else if (sheets.isMember[t]) {
      const std::uint32_t root = sheets.sets.find(t);
      const Sheet& sheet = sheets.ofRoot[root];
      if (roomFromOutside[root] < 0) roomFromOutside[root] = isRoomFromOutside(mesh, sheets, root);
      if (sheet.open || roomFromOutside[root] || (sheet.volume < 0 && !isLarge(sheet, mesh)))
        faces.push_back({turned, t, triangle.mesh, triangle.source, true});
    }
  }
  return faces;
}

std::vector<std::uint32_t> closedBodies(const SourceScene& source, const WeldedMesh& mesh) {
  Sheets sheets = findSheets(source, mesh, true);
  std::vector<std::uint32_t> bodies(mesh.triangles.size(), kNone);
  for (std::uint32_t t = 0; t < bodies.size(); ++t)
    if (const Sheet& sheet = sheets.of(t); !sheet.open && sheet.volume > 0) bodies[t] = sheets.sets.find(t);
  return bodies;
}

}  // namespace fiatlux
