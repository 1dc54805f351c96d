// Open edges of every chart, the vertices that lie on them, and the triangles cut there.
#include "precompute/picture/display_junctions.h"

#include "precompute/room/vertex_lattice.h"

namespace fiatlux {
namespace {

constexpr double kOnEdge = 2.5 / kPositionSteps;  // m, a vertex this near to an edge lies on it

struct PositionHash {
  std::size_t operator()(const std::array<float, 3>& p) const {
    std::uint64_t h = 0;
    for (const float c : p) {
      h = (h ^ static_cast<std::uint64_t>(std::llround(c * kPositionSteps))) * 0x9e3779b97f4a7c15ull;
      h ^= h >> 29;
    }
    return h;
  }
};

/// One side of a triangle of the picture, between places.
struct Side {
  std::uint32_t chart, a, b;  // a < b
  std::uint32_t part, triangle;
  bool forward;  // the triangle runs from a to b
};

/// The picture's places: positions that several vertices may share.
struct Places {
  std::vector<Vec3> positions;
  std::vector<std::vector<std::uint32_t>> ofVertex;  // per part

  explicit Places(const std::vector<Part*>& parts) {
    std::unordered_map<std::array<float, 3>, std::uint32_t, PositionHash> known;
    std::size_t expected = 0;
    for (const Part* part : parts) expected += part->vertices.size();
    known.reserve(expected);
    for (const Part* part : parts) {
      ofVertex.emplace_back();
      for (const Vertex& v : part->vertices) {
        const auto found = known.emplace(v.position, static_cast<std::uint32_t>(positions.size()));
        if (found.second) positions.push_back({v.position[0], v.position[1], v.position[2]});
        ofVertex.back().push_back(found.first->second);
      }
    }
  }
};

/// Sides that no triangle of the same chart runs along the other way.
std::vector<Side> openSides(const std::vector<Part*>& parts, const Places& places) {
  std::vector<Side> sides, open;
  for (std::uint32_t p = 0; p < parts.size(); ++p)
    for (std::uint32_t t = 0; t < parts[p]->charts.size(); ++t)
      for (int i = 0; i < 3; ++i) {
        const std::uint32_t a = places.ofVertex[p][parts[p]->indices[3 * t + i]],
                            b = places.ofVertex[p][parts[p]->indices[3 * t + (i + 1) % 3]];
        if (a != b) sides.push_back({parts[p]->charts[t], std::min(a, b), std::max(a, b), p, t, a < b});
      }
  const auto key = [](const Side& s) { return std::tie(s.chart, s.a, s.b); };
  std::sort(sides.begin(), sides.end(), [&](const Side& x, const Side& y) {
    return std::tie(x.chart, x.a, x.b, x.part, x.triangle) < std::tie(y.chart, y.a, y.b, y.part, y.triangle);
  });
  for (std::size_t i = 0, j; i < sides.size(); i = j) {
    int balance = 0;
    for (j = i; j < sides.size() && key(sides[j]) == key(sides[i]); ++j) balance += sides[j].forward ? 1 : -1;
    if (balance != 0) open.insert(open.end(), sides.begin() + i, sides.begin() + j);
  }
  return open;
}

/// A place on a side of a triangle: which side, and how far along it.
struct Cut {
  std::uint32_t part, triangle;
  int side;
  double along;  // 0..1
  std::uint32_t place;
};

std::vector<Cut> cutsOn(const std::vector<Side>& open, const std::vector<Part*>& parts,
                        const Places& places) {
  std::vector<std::uint32_t> candidates;
  double total = 0;
  for (const Side& side : open) {
    candidates.push_back(side.a), candidates.push_back(side.b);
    total += length(places.positions[side.b] - places.positions[side.a]);
  }
  std::sort(candidates.begin(), candidates.end());
  candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  const double cell = std::max(total / static_cast<double>(open.size()), 16 * kOnEdge);
  const VertexLattice lattice(places.positions, candidates, cell);

  const std::size_t budget = 20'000'000 + 200 * open.size();  // soups that exceed it keep some cracks
  std::size_t work = 0;
  std::vector<Cut> cuts;
  std::vector<std::pair<double, std::uint32_t>> found;
  for (const Side& side : open) {
    if (work > budget) break;
    const auto corner = [&](int i) {
      return places.ofVertex[side.part][parts[side.part]->indices[3 * side.triangle + i % 3]];
    };
    const std::uint32_t first = side.forward ? side.a : side.b, second = side.forward ? side.b : side.a;
    int which = 0;
    while (which < 2 && (corner(which) != first || corner(which + 1) != second)) ++which;
    const Vec3 from = places.positions[first], d = places.positions[second] - from;
    const double l = length(d);
    found.clear();
    work += lattice.alongSegment(from, from + d, kOnEdge, [&](std::uint32_t place) {
      const Vec3 p = places.positions[place] - from;
      const double along = dot(p, d) / l;
      if (along > kOnEdge && along < l - kOnEdge && length(p - (along / l) * d) < kOnEdge)
        found.emplace_back(along / l, place);
    });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    for (const auto& [along, place] : found) cuts.push_back({side.part, side.triangle, which, along, place});
  }
  std::sort(cuts.begin(), cuts.end(), [](const Cut& x, const Cut& y) {
    return std::tie(x.part, x.triangle, x.side, x.along, x.place) <
           std::tie(y.part, y.triangle, y.side, y.along, y.place);
  });
  return cuts;
}

/// A triangle under the knife: its corners, and the vertices on each side in the order they are met.
struct Cutting {
  std::array<std::uint32_t, 3> corner;
  std::array<std::vector<std::uint32_t>, 3> on;
};

/// Cuts from the middle vertex of a side to the corner opposite, until no side has any left.
void divide(const Cutting& whole, std::vector<std::uint32_t>& indices) {
  for (int i = 0; i < 3; ++i) {
    const std::vector<std::uint32_t>& on = whole.on[i];
    if (on.empty()) continue;
    const std::size_t middle = on.size() / 2;
    const std::uint32_t a = whole.corner[i], b = whole.corner[(i + 1) % 3], c = whole.corner[(i + 2) % 3];
    divide({{a, on[middle], c}, {{{on.begin(), on.begin() + middle}, {}, whole.on[(i + 2) % 3]}}}, indices);
    divide({{on[middle], b, c}, {{{on.begin() + middle + 1, on.end()}, whole.on[(i + 1) % 3], {}}}}, indices);
    return;
  }
  indices.insert(indices.end(), whole.corner.begin(), whole.corner.end());
}

/// A vertex at a place on the side from a to b.
Vertex between(const Vertex& a, const Vertex& b, double along, const Vec3& place, std::uint32_t chart,
               const PatchBlender& blender) {
  Vertex v;
  v.position = tidyPosition(place);
  v.blend = blender.inChart(chart, place);
  const auto mixed = [&](double x, double y) { return x + along * (y - x); };
  Vec3 normal;
  normal = {mixed(a.normal[0], b.normal[0]), mixed(a.normal[1], b.normal[1]),
            mixed(a.normal[2], b.normal[2])};
  v.normal = packedNormal(normalized(normal));
  for (int i = 0; i < 2; ++i) v.uv[i] = tidy(mixed(a.uv[i], b.uv[i]), kUvSteps);
  for (int i = 0; i < 4; ++i)
    v.color[i] = static_cast<std::uint8_t>(std::lround(mixed(a.color[i], b.color[i])));
  return v;
}

}  // namespace

void closeJunctions(const PatchBlender& blender, Parts& parts) {
  std::vector<Part*> list;
  for (auto& entry : parts) list.push_back(&entry.second);
  const Places places(list);
  const std::vector<Side> open = openSides(list, places);
  if (open.empty()) return;
  const std::vector<Cut> cuts = cutsOn(open, list, places);

  std::size_t next = 0;
  for (std::uint32_t p = 0; p < list.size(); ++p) {
    Part& part = *list[p];
    std::vector<std::uint32_t> indices, charts;
    for (std::uint32_t t = 0; t < part.charts.size(); ++t) {
      Cutting cutting{{part.indices[3 * t], part.indices[3 * t + 1], part.indices[3 * t + 2]}, {}};
      for (; next < cuts.size() && cuts[next].part == p && cuts[next].triangle == t; ++next) {
        const Cut& cut = cuts[next];
        const std::uint32_t a = cutting.corner[cut.side], b = cutting.corner[(cut.side + 1) % 3];
        cutting.on[cut.side].push_back(
            part.vertex(between(part.vertices[a], part.vertices[b], cut.along, places.positions[cut.place],
                                part.charts[t], blender)));
      }
      divide(cutting, indices);
      charts.resize(indices.size() / 3, part.charts[t]);
    }
    part.indices = std::move(indices);
    part.charts = std::move(charts);
  }
}

}  // namespace fiatlux
