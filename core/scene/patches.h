// What a room is made of once geometry has become numbers: patches, surfaces and sites.
// Paper section 2.2: diffuse patches of constant reflectance; luminaires hang on a finite set of places.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/vec3.h"

namespace fiatlux {

inline constexpr std::uint32_t kNone = 0xffffffffu;

/// The n patches of a room, then the patches of its measuring planes ("receivers", which get light but
/// neither block nor reflect it). Index p < count is a patch of the radiosity system; count <= p < rows() is
/// a receiver. All vectors have rows() entries, except `cluster` (count entries).
struct Patches {
  std::uint32_t count = 0;             // n
  std::uint32_t clusterCount = 0;      // k
  std::vector<Vec3> center;            // m, the area's centroid
  std::vector<Vec3> normal;            // unit, area-weighted mean over the patch
  std::vector<double> area;            // m2, > 0
  std::vector<float> reflectance;      // 0..0.95; 0 for receivers
  std::vector<std::uint32_t> surface;  // index into the surfaces
  std::vector<std::uint32_t> cluster;  // of each patch, 0..k-1: V has its non-zero of row q there
  // The neighbour one cell before in its chart's grid (smaller index), or kNone.
  std::vector<std::uint32_t> left, up;
  // 1 of a row that nobody sees lit and no meter reaches (the floor under a cabinet, a plane inside one): it
  // takes part in the exchange of light and is left out of all statistics. Empty = no row is covered.
  std::vector<std::uint8_t> covered;

  /// Whether row p counts in the statistics of its surface.
  bool counts(std::uint32_t p) const { return covered.empty() || covered[p] == 0; }
  std::uint32_t rows() const { return static_cast<std::uint32_t>(area.size()); }
};

/// A leaf of the surface tree. A name is a path: "node", "node/material", "node/material/region". Unique in a
/// scene; never "all". An inner node of the tree means the union of the leaves below it.
struct Surface {
  std::string name;
  double area = 0;            // m2, of the patches that are not covered
  double reflectance = 0;     // area-weighted mean of its patches
  std::uint32_t patches = 0;  // how many
  bool measuring = false;     // a measuring plane: outside "all", no exitance
  double border = 0;          // m, of a measuring plane: what it leaves out along what it measures' edges
  double lost = 0;            // share 0..1 of the rays cast from it that met a back face or left the room
};

/// A place where a luminaire may hang: a Lambertian square, flush with its mount.
struct Site {
  Vec3 position;    // m, centre
  Vec3 normal;      // unit, the direction it shines in
  Vec3 axis;        // unit, along one side of the square, perpendicular to normal
  double size = 0;  // m, side of the square
};

}  // namespace fiatlux
