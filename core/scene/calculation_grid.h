// The calculation grid of EN 12464-1 on floors and level measuring planes: a rim is left out (0.5 m, or 15 %
// of the shorter side where that is less), and points are at most p = 0.2 x 5^log10(d) m apart, at most 10 m,
// d the longer side of what is left, or the shorter one where they differ by a factor of two or more. A plane
// that stays away from the walls by itself (Surface::border) has left out as much of the rim. Read off the
// patches of a scene; `fiatlux light` takes the same points to its rays. A task area (a zone) has a grid of
// its own, without a rim.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/scene/scene.h"

namespace fiatlux {

/// What the rule makes of a rectangle.
struct GridRule {
  double rim = 0, spacing = 0;  // m; the rim is left out of the rectangle, the spacing is the largest allowed
  std::uint32_t columns = 0, rows = 0;
};

/// Of `length` x `width` metres, both above 0, within a border (m) that is left out already.
GridRule gridRule(double length, double width, double border = 0, bool hasRim = true);

/// A plane piece of a surface, cut into cells of which each holds one patch or none.
struct PatchLattice {
  std::uint32_t surface = 0;
  Vec3 origin, uAxis, vAxis;    // m, the corner of the first cell; unit, along columns and rows
  double cellU = 0, cellV = 0;  // m
  std::uint32_t columns = 0, rows = 0;
  std::vector<std::uint32_t> patchOfCell;  // rows x columns, row-major; kNone where there is none

  /// The patch at (u, v) metres from the origin, or kNone.
  std::uint32_t patchAt(double u, double v) const;
};

struct CalculationGrid {
  GridRule rule;
  std::vector<std::array<double, 2>> points;  // m from the lattice's origin, along u and v
};

/// The points of a lattice whose rim lies on it too and that nothing covers; none where `surface` is a floor
/// and its piece narrower than half a metre (a threshold, the feet of chairs).
CalculationGrid calculationGridOn(const PatchLattice& lattice, const Patches& patches, const Surface& surface,
                                  bool hasRim = true);

/// Is that a floor or a measuring plane: level, facing up, and measuring or hardly above the `lowest` height?
bool wantsGrid(const Surface& surface, const Vec3& normal, double height, double lowest);

/// The lattices of a scene's floors and level measuring planes, in the order of their patches.
std::vector<PatchLattice> measuredLattices(const Scene& scene);
/// Those of its zones that are level, likewise.
std::vector<PatchLattice> zoneLattices(const Scene& scene);

/// A row around a point, and its share of a bilinear reading there.
struct PatchShare {
  std::uint32_t row = 0;
  double share = 0;
};

/// Of the four cells around a point of the lattice's grid, those that hold a patch that counts; in sum 1.
std::vector<PatchShare> sharesAt(const PatchLattice& lattice, const Patches& patches,
                                 const std::array<double, 2>& point);

/// Of every point of a surface's or a zone's grids; none where it has no grid.
std::vector<std::vector<PatchShare>> gridPointsOf(const Scene& scene, std::uint32_t surface);

/// What a layout does to a grid.
struct GridReading {
  std::uint32_t surface = 0, points = 0;
  double spacing = 0, rim = 0;           // m; all of the rim: the surface's own border, too
  double mean = 0, least = 0, most = 0;  // lx: E_m, E_min and E_max
  double uniformity() const { return mean > 0 ? least / mean : 0; }  // U_o
};

/// Of values (lx) at the points of a grid, of which there is one at least, within a border (m).
GridReading gridReading(std::uint32_t surface, const CalculationGrid& grid, double border,
                        const std::vector<double>& values);

/// Every grid of a scene, made once to be read of any light.
class CalculationGrids {
 public:
  /// Those of its surfaces.
  explicit CalculationGrids(const Scene& scene);
  /// Those of its zones.
  static CalculationGrids ofZones(const Scene& scene);

  /// Bilinear between the patches. `light`: lx, one a row of the scene.
  std::vector<GridReading> read(const std::vector<float>& light) const;

 private:
  struct Grid {
    std::uint32_t surface = 0;
    double border = 0;  // m, of the surface
    CalculationGrid of;
    std::vector<std::vector<PatchShare>> points;
  };
  CalculationGrids() = default;
  void add(const Scene& scene, const std::vector<PatchLattice>& lattices, bool hasRim);

  std::vector<Grid> grids_;
};

/// What the grids of a scene, and then those of its zones, read of one light.
std::vector<GridReading> readGrids(const Scene& scene, const std::vector<float>& light);

}  // namespace fiatlux
