// Welding by a hash of space.
#include "precompute/geometry/faces.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "precompute/room/bounds.h"

namespace fiatlux {
namespace {

/// Vertices by cell of a coarse lattice; a vertex looks into neighbouring cells only near a cell's border.
class Welder {
 public:
  Welder(std::vector<Vec3>& positions, double tolerance, std::size_t expected)
      : positions_(positions), tolerance_(tolerance), cell_(8 * tolerance) {
    while (heads_.size() < expected * 2) heads_.resize(std::max<std::size_t>(1024, heads_.size() * 2), kNone);
    std::fill(heads_.begin(), heads_.end(), kNone);
  }

  std::uint32_t add(const Vec3& p) {
    const double limit = tolerance_ * tolerance_;
    std::array<std::int64_t, 3> low{}, high{};
    const double c[3] = {p.x, p.y, p.z};
    for (int i = 0; i < 3; ++i) {
      low[i] = static_cast<std::int64_t>(std::floor((c[i] - tolerance_) / cell_));
      high[i] = static_cast<std::int64_t>(std::floor((c[i] + tolerance_) / cell_));
    }
    for (auto x = low[0]; x <= high[0]; ++x)
      for (auto y = low[1]; y <= high[1]; ++y)
        for (auto z = low[2]; z <= high[2]; ++z)
          for (std::uint32_t v = heads_[slot(x, y, z)]; v != kNone; v = next_[v]) {
            const Vec3 d = positions_[v] - p;
            if (dot(d, d) <= limit) return v;
          }
    const auto at = [&](double x) { return static_cast<std::int64_t>(std::floor(x / cell_)); };
    std::uint32_t& head = heads_[slot(at(p.x), at(p.y), at(p.z))];
    positions_.push_back(p);
    next_.push_back(head);
    return head = static_cast<std::uint32_t>(positions_.size() - 1);
  }

 private:
  std::size_t slot(std::int64_t x, std::int64_t y, std::int64_t z) const {
    std::uint64_t h = static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15ull;
    h = (h ^ (h >> 29) ^ static_cast<std::uint64_t>(y)) * 0xbf58476d1ce4e5b9ull;
    h = (h ^ (h >> 32) ^ static_cast<std::uint64_t>(z)) * 0x94d049bb133111ebull;
    return (h ^ (h >> 31)) & (heads_.size() - 1);
  }

  std::vector<Vec3>& positions_;
  double tolerance_, cell_;
  std::vector<std::uint32_t> heads_, next_;
};

bool hasArea(const std::vector<Vec3>& p, const std::array<std::uint32_t, 3>& v, double tolerance) {
  if (v[0] == v[1] || v[1] == v[2] || v[0] == v[2]) return false;
  const double longest =
      std::max({length(p[v[1]] - p[v[0]]), length(p[v[2]] - p[v[1]]), length(p[v[0]] - p[v[2]])});
  return 2 * length(areaVector(p, v)) > tolerance * longest;
}

/// Drops repeated triangles; a repetition that faces the other way becomes the first one's back.
void mergeDuplicates(WeldedMesh& mesh) {
  struct Key {
    std::array<std::uint32_t, 3> sorted;
    std::uint32_t index;
  };
  std::vector<Key> keys(mesh.triangles.size());
  for (std::uint32_t i = 0; i < keys.size(); ++i) {
    keys[i] = {mesh.triangles[i].vertex, i};
    std::sort(keys[i].sorted.begin(), keys[i].sorted.end());
  }
  std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
    return std::tie(a.sorted, a.index) < std::tie(b.sorted, b.index);
  });
  const auto isEven = [](const std::array<std::uint32_t, 3>& v) {
    return (v[0] < v[1]) + (v[1] < v[2]) + (v[2] < v[0]) == 2;  // an even rotation of the sorted order
  };
  std::vector<bool> dropped(keys.size(), false);
  for (std::size_t i = 0, j; i < keys.size(); i = j) {
    WeldedTriangle& first = mesh.triangles[keys[i].index];
    for (j = i + 1; j < keys.size() && keys[j].sorted == keys[i].sorted; ++j) {
      const WeldedTriangle& other = mesh.triangles[keys[j].index];
      dropped[keys[j].index] = true;
      if (isEven(other.vertex) != isEven(first.vertex) && first.backMesh == kNone) {
        first.backMesh = other.mesh;
        first.backSource = other.source;
      } else {
        ++mesh.duplicates;
      }
    }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (!dropped[i]) mesh.triangles[kept++] = mesh.triangles[i];
  mesh.triangles.resize(kept);
}

}  // namespace

WeldedMesh weld(const SourceScene& source, const std::vector<std::uint32_t>& meshes) {
  WeldedMesh result;
  Bounds bounds;
  std::size_t vertices = 0, triangles = 0;
  for (const std::uint32_t m : meshes) {
    for (const Vec3& p : source.meshes[m].positions) bounds.include(p);
    vertices += source.meshes[m].positions.size();
    triangles += source.meshes[m].triangles.size();
  }
  if (vertices == 0) return result;

  // Vertices closer than rounding are one; triangles that this leaves without area go.
  result.diagonal = bounds.diagonal();
  result.tolerance = std::max(1e-5 * result.diagonal, 1e-12);
  result.triangles.reserve(triangles);

  Welder welder(result.positions, result.tolerance, vertices);
  std::vector<std::uint32_t> target;
  for (const std::uint32_t m : meshes) {
    const SourceMesh& mesh = source.meshes[m];
    target.clear();
    for (const Vec3& p : mesh.positions) target.push_back(welder.add(p));
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& v = mesh.triangles[t];
      const std::array<std::uint32_t, 3> welded{target[v[0]], target[v[1]], target[v[2]]};
      if (hasArea(result.positions, welded, result.tolerance))
        result.triangles.push_back({welded, m, t, kNone, 0});
      else
        ++result.withoutArea;
    }
  }
  mergeDuplicates(result);
  return result;
}

std::vector<Fragment> trianglesOf(const WeldedMesh& mesh, const std::vector<Face>& faces) {
  std::vector<Fragment> triangles;
  for (const Face& face : faces)
    triangles.push_back(
        {{mesh.positions[face.vertex[0]], mesh.positions[face.vertex[1]], mesh.positions[face.vertex[2]]}});
  return triangles;
}

}  // namespace fiatlux
