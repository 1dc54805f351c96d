// Region growing over faces that share an edge or a part of one.
#include "precompute/flat_regions.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "precompute/vertex_lattice.h"

namespace fiatlux {
namespace {

constexpr double kSameNormal = 0.9986;  // cos 3 degrees

bool edgeLess(const SubEdge& x, const SubEdge& y) {
  return std::tie(x.a, x.b, x.face) < std::tie(y.a, y.b, y.face);
}

SubEdge makeEdge(std::uint32_t from, std::uint32_t to, std::uint32_t face) {
  return {std::min(from, to), std::max(from, to), face, from < to};
}

/// Replaces open edges by their pieces between the open vertices that lie on them.
void splitAtJunctions(const WeldedMesh& mesh, std::vector<SubEdge>& edges) {
  std::vector<SubEdge> closed, open;
  for (std::size_t i = 0, j; i < edges.size(); i = j) {
    for (j = i + 1; j < edges.size() && edges[j].a == edges[i].a && edges[j].b == edges[i].b; ++j) {
    }
    auto& target = j - i == 1 ? open : closed;
    target.insert(target.end(), edges.begin() + i, edges.begin() + j);
  }
  if (open.size() < 4) return;
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
  const double cell =
      std::max({lengths[lengths.size() / 2], total / (16.0 * open.size()), 4 * mesh.tolerance});
  const VertexLattice lattice(mesh.positions, vertices, cell);

  const std::size_t budget = 20'000'000 + 500 * open.size();
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
    std::uint32_t from = edge.a;
    for (const auto& cut : cuts) {
      SubEdge piece = makeEdge(from, cut.second, edge.face);
      piece.forward = piece.forward == edge.forward;
      closed.push_back(piece);
      from = cut.second;
    }
    SubEdge piece = makeEdge(from, edge.b, edge.face);
    piece.forward = piece.forward == edge.forward;
    closed.push_back(piece);
  }
  edges = std::move(closed);
  std::sort(edges.begin(), edges.end(), edgeLess);
}

/// A chain of boundary points -> its straight sides; calls side(from, to) for each.
template <class Side>
void straightSides(const std::vector<Vec3>& loop, double tolerance, Side side) {
  const std::size_t n = loop.size();
  if (n < 2) return;
  // Start where the chain turns most, so that no side is cut in two by the start.
  std::size_t start = 0;
  double sharpest = 2;
  for (std::size_t i = 0; i < n; ++i) {
    const double turn =
        dot(normalized(loop[i] - loop[(i + n - 1) % n]), normalized(loop[(i + 1) % n] - loop[i]));
    if (turn < sharpest) sharpest = turn, start = i;
  }
  Vec3 from = loop[start], direction = normalized(loop[(start + 1) % n] - from), last = from;
  for (std::size_t i = 1; i <= n; ++i) {
    const Vec3 p = loop[(start + i) % n], d = p - from;
    const bool onLine =
        length(d - dot(d, direction) * direction) < 4 * tolerance && dot(p - last, direction) > 0;
    if (!onLine) {
      side(from, last);
      from = last;
      direction = normalized(p - from);
    } else if (length(d) > 0) {
      direction = normalized(d);
    }
    last = p;
  }
  side(from, last);
}

}  // namespace

FaceSet makeFaceSet(const WeldedMesh& mesh, std::vector<Face> faces) {
  FaceSet set;
  set.faces = std::move(faces);
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
      for (j = i + 1;
           j < set.edges.size() && set.edges[j].a == set.edges[i].a && set.edges[j].b == set.edges[i].b;
           ++j) {
      }
      for (std::size_t k = i + 1; k < j; ++k)
        for (std::size_t m = j - i < 16 ? i : k - 1; m < k; ++m)
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

std::vector<Region> flatRegions(const WeldedMesh& mesh, const FaceSet& set, bool strict) {
  const std::size_t n = set.faces.size();
  const double planeTolerance = 10 * mesh.tolerance;
  std::vector<Vec3> vectors(n);
  std::vector<double> areas(n);
  std::vector<std::uint32_t> order(n);
  for (std::uint32_t f = 0; f < n; ++f) {
    vectors[f] = areaVector(mesh.positions, set.faces[f].vertex);
    areas[f] = length(vectors[f]);
    order[f] = f;
  }
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return areas[a] > areas[b]; });
  const auto centroidOf = [&](std::uint32_t f) {
    const auto& v = set.faces[f].vertex;
    return (1.0 / 3) * (mesh.positions[v[0]] + mesh.positions[v[1]] + mesh.positions[v[2]]);
  };

  std::vector<bool> taken(n, false);
  std::vector<Region> regions;
  for (const std::uint32_t seed : order) {
    if (taken[seed]) continue;
    Region region;
    Vec3 sum{}, moment{};
    const auto take = [&](std::uint32_t f) {
      taken[f] = true;
      region.faces.push_back(f);
      sum += vectors[f];
      moment += areas[f] * centroidOf(f);
      region.area += areas[f];
    };
    take(seed);
    for (std::size_t next = 0; next < region.faces.size(); ++next) {
      const std::uint32_t at = region.faces[next];
      for (std::uint32_t i = set.neighborOffset[at]; i < set.neighborOffset[at + 1]; ++i) {
        const std::uint32_t f = set.neighbors[i];
        if (taken[f]) continue;
        const Vec3 normal = normalized(sum), center = (1 / region.area) * moment;
        const auto& v = set.faces[f].vertex;
        double off = 0, longest = 0;
        for (int c = 0; c < 3; ++c) {
          off = std::max(off, std::abs(dot(mesh.positions[v[c]] - center, normal)));
          longest = std::max(longest, length(mesh.positions[v[(c + 1) % 3]] - mesh.positions[v[c]]));
        }
        // The direction of a narrow face is known only as well as its vertices are.
        const double height = 2 * areas[f] / longest;
        const bool narrow = height <= 40 * mesh.tolerance;
        const double least = narrow ? 0.5 : kSameNormal;
        const double most =
            strict || narrow ? planeTolerance : std::max(planeTolerance, 0.01 * std::sqrt(region.area));
        if (off <= most && dot(vectors[f], normal) >= least * areas[f]) take(f);
      }
    }
    region.normal = normalized(sum);
    region.centroid = (1 / region.area) * moment;
    region.outline = outlineOf(mesh, set, region.faces);
    regions.push_back(std::move(region));
  }
  return regions;
}

Outline outlineOf(const WeldedMesh& mesh, const FaceSet& set, const std::vector<std::uint32_t>& faces) {
  // Boundary = sub-edges that the faces' turns do not cancel. The set's edges are in order already.
  std::vector<std::uint32_t> pieces;
  for (const std::uint32_t f : faces)
    pieces.insert(pieces.end(), set.faceEdges.begin() + set.faceEdgeOffset[f],
                  set.faceEdges.begin() + set.faceEdgeOffset[f + 1]);
  std::sort(pieces.begin(), pieces.end());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> steps;  // directed, from -> to
  for (std::size_t i = 0, j; i < pieces.size(); i = j) {
    const SubEdge& edge = set.edges[pieces[i]];
    int balance = 0;
    for (j = i; j < pieces.size() && set.edges[pieces[j]].a == edge.a && set.edges[pieces[j]].b == edge.b;
         ++j)
      balance += set.edges[pieces[j]].forward ? 1 : -1;
    for (; balance > 0; --balance) steps.emplace_back(edge.a, edge.b);
    for (; balance < 0; ++balance) steps.emplace_back(edge.b, edge.a);
  }
  std::sort(steps.begin(), steps.end());
  std::vector<bool> used(steps.size(), false);
  std::vector<std::size_t> firstFree(steps.size());  // at the first step of a vertex: its first unused one
  for (std::size_t s = 0; s < steps.size(); ++s) firstFree[s] = s;
  Outline outline;
  double longest = 0;
  const auto side = [&](const Vec3& from, const Vec3& to) {
    const Vec3 d = to - from;
    const double l = length(d);
    outline.perimeter += l;
    if (l < longest * (1 - 1e-3) || l <= 0) return;
    Vec3 unit = (1 / l) * d;
    const double largest = std::max({std::abs(unit.x), std::abs(unit.y), std::abs(unit.z)});
    const double lead = std::abs(unit.x) > largest - 1e-9   ? unit.x
                        : std::abs(unit.y) > largest - 1e-9 ? unit.y
                                                            : unit.z;
    if (lead < 0) unit = -unit;
    const auto rank = [](const Vec3& u) {
      const auto rounded = [](double x) { return std::round(std::abs(x) * 1e4); };
      return std::array{rounded(u.x), rounded(u.y), rounded(u.z)};
    };
    if (l > longest * (1 + 1e-3) || rank(unit) > rank(outline.longestDirection))
      outline.longestDirection = unit;
    longest = std::max(longest, l);
  };
  std::vector<Vec3> loop;
  for (std::size_t first = 0; first < steps.size(); ++first) {
    if (used[first]) continue;
    loop.clear();
    const std::uint32_t start = steps[first].first;
    std::uint32_t at = start;
    do {
      // Where boundaries touch, go on as straight as possible (among the first few, where very many touch).
      std::size_t best = steps.size();
      double straightest = -3;
      int looked = 0;
      const auto begin = static_cast<std::size_t>(
          std::lower_bound(steps.begin(), steps.end(), std::pair{at, 0u}) - steps.begin());
      if (begin == steps.size()) break;
      std::size_t& free = firstFree[begin];
      while (free < steps.size() && used[free] && steps[free].first == at) ++free;
      for (std::size_t s = free; s < steps.size() && steps[s].first == at && looked < 64; ++s) {
        if (used[s]) continue;
        ++looked;
        const double straight = loop.empty()
                                    ? 0
                                    : dot(normalized(mesh.positions[at] - loop.back()),
                                          normalized(mesh.positions[steps[s].second] - mesh.positions[at]));
        if (straight > straightest) straightest = straight, best = s;
      }
      loop.push_back(mesh.positions[at]);
      if (best == steps.size()) break;
      used[best] = true;
      at = steps[best].second;
    } while (at != start);
    straightSides(loop, mesh.tolerance, side);
  }
  return outline;
}

}  // namespace fiatlux
