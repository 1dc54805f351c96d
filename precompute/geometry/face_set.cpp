// Edges are sorted so that equal ones meet; open ones are cut first at the vertices that lie on them.
#include "precompute/geometry/face_set.h"

#include <algorithm>
#include <utility>

#include "precompute/room/vertex_lattice.h"

namespace fiatlux {
namespace {

// The search for T-junctions: the lattice's cells are no finer than this part of the mean open edge, and it
// is given up after so many steps.
constexpr double kFinestOfMean = 16;
constexpr std::size_t kLeastWork = 20'000'000, kWorkOfEdge = 500;

constexpr std::size_t kManyFaces = 16;  // on one edge: each is then the neighbour of the next alone

/// note: not by std::tie, which stays a dozen calls where the code is made small for the page.
bool edgeLess(const SubEdge& x, const SubEdge& y) {
  return x.a != y.a ? x.a < y.a : x.b != y.b ? x.b < y.b : x.face < y.face;
}

SubEdge makeEdge(std::uint32_t from, std::uint32_t to, std::uint32_t face) {
  return {std::min(from, to), std::max(from, to), face, from < to};
}

/// One past the last edge that runs between the same vertices as edges[i].
std::size_t endOfEqual(const std::vector<SubEdge>& edges, std::size_t i) {
  std::size_t j = i + 1;
  while (j < edges.size() && edges[j].a == edges[i].a && edges[j].b == edges[i].b) ++j;
  return j;
}

/// The open vertices, in a lattice about as fine as open edges are long.
VertexLattice latticeOf(const WeldedMesh& mesh, const std::vector<SubEdge>& open) {
  std::vector<std::uint32_t> vertices;
  std::vector<double> lengths;
  double total = 0;
  for (const SubEdge& edge : open) {
    vertices.push_back(edge.a), vertices.push_back(edge.b);
    lengths.push_back(length(mesh.positions[edge.b] - mesh.positions[edge.a]));
    total += lengths.back();
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::nth_element(lengths.begin(), lengths.begin() + lengths.size() / 2, lengths.end());
  const double mean = total / static_cast<double>(open.size());
  return {mesh.positions, vertices,
          std::max({lengths[lengths.size() / 2], mean / kFinestOfMean, 4 * mesh.tolerance})};
}

/// Replaces open edges by their pieces between the open vertices that lie on them.
void splitAtJunctions(const WeldedMesh& mesh, std::vector<SubEdge>& edges) {
  std::vector<SubEdge> closed, open;
  for (std::size_t i = 0, j; i < edges.size(); i = j) {
    j = endOfEqual(edges, i);
    auto& target = j - i == 1 ? open : closed;
    target.insert(target.end(), edges.begin() + i, edges.begin() + j);
  }
  if (open.size() < 4) return;
  const VertexLattice lattice = latticeOf(mesh, open);

  // Find what lies on each open edge, until it becomes too much work: what is left stays whole.
  const std::size_t budget = kLeastWork + kWorkOfEdge * open.size();
  std::size_t work = 0;
  std::vector<std::pair<double, std::uint32_t>> cuts;
  const double margin = 2 * mesh.tolerance;
  for (const SubEdge& edge : open) {
    const Vec3 a = mesh.positions[edge.a], d = mesh.positions[edge.b] - a;
    const double l = length(d);
    cuts.clear();
    if (work < budget)
      work += lattice.alongSegment(a, a + d, margin, [&](std::uint32_t v) {
        if (v == edge.a || v == edge.b) return;
        const Vec3 p = mesh.positions[v] - a;
        const double t = dot(p, d) / l;
        if (t > 0 && t < l && length(p - (t / l) * d) < margin) cuts.emplace_back(t, v);
      });
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());

    // Put its pieces in its place, each in its direction.
    cuts.emplace_back(l, edge.b);
    std::uint32_t from = edge.a;
    for (const auto& [at, to] : cuts) {
      SubEdge piece = makeEdge(from, to, edge.face);
      piece.forward = piece.forward == edge.forward;
      closed.push_back(piece);
      from = to;
    }
  }
  edges = std::move(closed);
  std::sort(edges.begin(), edges.end(), edgeLess);
}

}  // namespace

FaceSet makeFaceSet(const WeldedMesh& mesh, std::vector<Face> faces) {
  FaceSet set;
  set.faces = std::move(faces);

  // Edges, and which belong to a face.
  set.edges.reserve(3 * set.faces.size());
  for (std::uint32_t f = 0; f < set.faces.size(); ++f)
    for (int i = 0; i < 3; ++i)
      set.edges.push_back(makeEdge(set.faces[f].vertex[i], set.faces[f].vertex[(i + 1) % 3], f));
  std::sort(set.edges.begin(), set.edges.end(), edgeLess);
  splitAtJunctions(mesh, set.edges);
  set.faceEdgeOffset.assign(set.faces.size() + 1, 0);
  for (const SubEdge& edge : set.edges) ++set.faceEdgeOffset[edge.face + 1];
  for (std::size_t f = 0; f < set.faces.size(); ++f) set.faceEdgeOffset[f + 1] += set.faceEdgeOffset[f];
  set.faceEdges.resize(set.edges.size());
  std::vector<std::uint32_t> fill(set.faceEdgeOffset.begin(), set.faceEdgeOffset.end() - 1);
  for (std::uint32_t e = 0; e < set.edges.size(); ++e) set.faceEdges[fill[set.edges[e].face]++] = e;

  // Neighbours: all pairs on an edge; where very many faces meet, each with the next.
  const auto eachPair = [&](auto visit) {
    for (std::size_t i = 0, j; i < set.edges.size(); i = j) {
      j = endOfEqual(set.edges, i);
      for (std::size_t k = i + 1; k < j; ++k)
        for (std::size_t m = j - i < kManyFaces ? i : k - 1; m < k; ++m)
          visit(set.edges[k].face, set.edges[m].face), visit(set.edges[m].face, set.edges[k].face);
    }
  };
  set.neighborOffset.assign(set.faces.size() + 1, 0);
  eachPair([&](std::uint32_t from, std::uint32_t) { ++set.neighborOffset[from + 1]; });
  for (std::size_t f = 0; f < set.faces.size(); ++f) set.neighborOffset[f + 1] += set.neighborOffset[f];
  set.neighbors.resize(set.neighborOffset.back());
  fill.assign(set.neighborOffset.begin(), set.neighborOffset.end() - 1);
  eachPair([&](std::uint32_t from, std::uint32_t to) { set.neighbors[fill[from]++] = to; });
  return set;
}

}  // namespace fiatlux
