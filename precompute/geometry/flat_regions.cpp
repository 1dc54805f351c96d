// Region growing over faces that share an edge or a part of one.
#include "precompute/geometry/flat_regions.h"

#include <algorithm>
#include <cmath>

namespace fiatlux {
namespace {

constexpr double kSameNormal = 0.9986;  // cos 3 degrees

}  // namespace

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

}  // namespace fiatlux
