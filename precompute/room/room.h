// A room as the tracer sees it: triangles, the charts that cut them into patches, and where luminaires may
// hang. Product of glTF import, surface finding and patch cutting; input of form factors, direct light and
// the picture.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/scene/patches.h"

namespace fiatlux {

/// A near-planar connected piece of one surface with a grid of square-ish cells in its own plane. A patch is
/// what of the chart's triangles lies in one cell; cells without area have no patch.
struct Chart {
  std::uint32_t surface = 0;
  Vec3 origin, uAxis, vAxis,
      normal;  // m; unit vectors, right-handed (u x v = normal), u along the outline's longest edge
  double cellU = 0, cellV = 0;  // m, edges of a cell
  std::uint32_t columns = 0, rows = 0;
  std::vector<std::uint32_t> patchOfCell;  // rows x columns, row-major along u; kNone where empty
};

/// Which triangle of which mesh of the source something came from.
struct SourceTriangle {
  std::uint32_t mesh = kNone, triangle = 0;
};

struct RoomTriangle {
  std::array<std::uint32_t, 3> vertex;          // counter-clockwise seen from the front
  std::uint32_t chart = kNone;                  // of the front: kNone = left out, it faces the void
  std::uint32_t backChart = kNone;              // of the back: kNone = a ray that meets the back is lost
  SourceTriangle source = {}, backSource = {};  // for display: where front and back got their material
  std::uint32_t leftOut = kNone;  // of Room::leftOut: whose front it was, where that is left out
};

/// A flat piece of a patch, to sample points on.
struct Fragment {
  std::array<Vec3, 3> corner;  // m, counter-clockwise seen from the front of its patch
};

struct Room {
  std::vector<Vec3> positions;          // m, world space
  std::vector<RoomTriangle> triangles;  // reflectors and blockers; measuring planes are not among them
  std::vector<Chart> charts;            // receivers' charts after those of reflectors
  Patches patches;
  std::vector<std::uint32_t> chartOfPatch;  // rows()
  std::vector<std::uint32_t>
      fragmentOffset;  // rows() + 1: fragments of patch p are [offset[p], offset[p + 1])
  std::vector<Fragment> fragments;
  std::vector<Surface> surfaces;
  std::vector<Site> sites;
  double patchSize = 0;               // m, the nominal edge of a patch
  double scale = 1;                   // metres per unit of the file that it was made from
  bool isZUp = false;                 // z of that file is up, not y
  std::uint32_t floor = kNone;        // the surface that lies below most sites
  std::vector<std::string> leftOut;   // names of surfaces that face the void, wholly or in part
  std::vector<std::string> warnings;  // one readable line each, what matters most first
  std::size_t leading = 0;            // of them: where luminaires hang, in which scale, what is left out
  std::string assumptions;            // that decide about the light and that no option says: for the identity
  std::string sourceHash;             // 16 hex digits of the source's bytes (buffers and images included)

  /// The patch of a point on a triangle's front or back; kNone when the back is no surface.
  std::uint32_t patchAt(std::uint32_t triangle, bool back, const Vec3& point) const;
  /// The patch that a ray met at `distance` (in lengths of its direction) on a triangle: kNone where it met
  /// none (kNone), a back that is no surface, or a hole of a chart.
  std::uint32_t patchMet(const Vec3& origin, const Vec3& direction, std::uint32_t triangle,
                         double distance) const;
  /// What patch p is made of.
  std::span<const Fragment> fragmentsOf(std::uint32_t p) const {
    return std::span(fragments).subspan(fragmentOffset[p], fragmentOffset[p + 1] - fragmentOffset[p]);
  }
};

}  // namespace fiatlux
