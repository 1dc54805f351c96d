// Region growing over faces that share an edge or a part of one.
#include "precompute/geometry/flat_regions.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace fiatlux {
namespace {

constexpr double kSameNormal = 0.9986;   // cos 3 degrees
constexpr double kNarrowNormal = 0.5;    // cos 60 degrees
constexpr double kNarrow = 40;           // in tolerances of the mesh: a face less high has no sure direction
constexpr double kPlaneTolerances = 10;  // of the mesh: as far from a plane as rounding takes a vertex
constexpr double kBent = 0.01;           // of a region's size: how far a hand-made wall may leave its plane
constexpr double kScanned = 0.05;        // m: how far a scan does
constexpr double kScannedNormal = 0.7;   // cos 45 degrees

/// Grows planar regions over the faces of a set.
class RegionGrower {
 public:
  RegionGrower(const WeldedMesh& mesh, const FaceSet& set, Flatness flatness)
      : mesh_(mesh), set_(set), flatness_(flatness), taken_(set.faces.size(), false) {
    for (const Face& face : set.faces) {
      vectors_.push_back(areaVector(mesh.positions, face.vertex));
      areas_.push_back(length(vectors_.back()));
    }
  }

  /// Faces from the largest to the smallest.
  std::vector<std::uint32_t> seeds() const {
    std::vector<std::uint32_t> order(areas_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return areas_[a] > areas_[b]; });
    return order;
  }
  bool taken(std::uint32_t face) const { return taken_[face]; }

  Region grow(std::uint32_t seed) {
    region_ = {};
    sum_ = moment_ = {};
    take(seed);
    for (std::size_t next = 0; next < region_.faces.size(); ++next) {
      const std::uint32_t at = region_.faces[next];
      for (std::uint32_t i = set_.neighborOffset[at]; i < set_.neighborOffset[at + 1]; ++i) {
        const std::uint32_t f = set_.neighbors[i];
        if (!taken_[f] && fits(f)) take(f);
      }
    }
    region_.normal = normalized(sum_);
    region_.centroid = (1 / region_.area) * moment_;
    region_.outline = outlineOf(mesh_, set_, region_.faces);
    return std::move(region_);
  }

 private:
  void take(std::uint32_t f) {
    const auto& v = set_.faces[f].vertex;
    taken_[f] = true;
    region_.faces.push_back(f);
    sum_ += vectors_[f];
    moment_ +=
        areas_[f] * ((1.0 / 3) * (mesh_.positions[v[0]] + mesh_.positions[v[1]] + mesh_.positions[v[2]]));
    region_.area += areas_[f];
  }

  /// Whether a face lies in the plane of the region so far and looks the same way.
  bool fits(std::uint32_t f) const {
    const Vec3 normal = normalized(sum_), center = (1 / region_.area) * moment_;
    const auto& v = set_.faces[f].vertex;
    double off = 0, longest = 0;
    for (int c = 0; c < 3; ++c) {
      off = std::max(off, std::abs(dot(mesh_.positions[v[c]] - center, normal)));
      longest = std::max(longest, length(mesh_.positions[v[(c + 1) % 3]] - mesh_.positions[v[c]]));
    }
    // The direction of a narrow face is known only as well as its vertices are.
    const double height = 2 * areas_[f] / longest;
    const bool narrow = height <= kNarrow * mesh_.tolerance;
    const double planar = kPlaneTolerances * mesh_.tolerance;
    const bool isScanned = flatness_ == Flatness::kScanned;
    const double bent = isScanned ? kScanned : narrow ? 0 : kBent * std::sqrt(region_.area);
    const double most = flatness_ == Flatness::kExact ? planar : std::max(planar, bent);
    const double alike = narrow ? kNarrowNormal : isScanned ? kScannedNormal : kSameNormal;
    return off <= most && dot(vectors_[f], normal) >= alike * areas_[f];
  }

  const WeldedMesh& mesh_;
  const FaceSet& set_;
  const Flatness flatness_;
  std::vector<Vec3> vectors_;  // of faces: normal x area, m2
  std::vector<double> areas_;  // m2
  std::vector<bool> taken_;
  Region region_;      // so far
  Vec3 sum_, moment_;  // of its vectors; of its centroids, by area
};

}  // namespace

std::vector<Region> flatRegions(const WeldedMesh& mesh, const FaceSet& set, Flatness flatness) {
  RegionGrower grower(mesh, set, flatness);
  std::vector<Region> regions;
  for (const std::uint32_t seed : grower.seeds())
    if (!grower.taken(seed)) regions.push_back(grower.grow(seed));
  return regions;
}

}  // namespace fiatlux
