// What a layout does to the surfaces, as JSON, as a table and patch by patch: the same for `evaluate`,
// `light` and `solve`.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/scene/calculation_grid.h"
#include "core/scene/patches.h"
#include "core/scene/scene.h"

namespace fiatlux {

struct SurfaceResult {
  std::string name;
  double area = 0;  // m2
  std::uint32_t patches = 0;
  double reflectance = 0;
  bool measuring = false;
  ExplicitStatistics illuminance;  // lx
  ExplicitStatistics exitance;     // lm/m2; all 0 for measuring planes
};

struct LightResults {
  std::vector<SurfaceResult> surfaces;  // leaves, in their order
  SurfaceResult all;                    // all that are not measuring planes
};

/// Everything read off the illuminance (lx), one value a row of the patches.
LightResults lightResults(const Patches& patches, const std::vector<Surface>& surfaces,
                          const std::vector<float>& light);

/// Of a layout on a scene: means and sigmas by the mean rows and covariances (exact), minima and maxima from
/// the quantised patches.
LightResults lightResults(const Scene& scene, const Layout& layout);
/// Of any light (lx, one a row), those of its zones after its surfaces'.
LightResults lightResults(const Scene& scene, const std::vector<float>& light);

/// [{"name", "area", "patches", "mean", "sigma", "min", "max", "uniformity", "reflectance", "exitance":
/// {...}}, ...]; "measuring": true and no exitance for measuring planes.
nlohmann::ordered_json surfacesJson(const LightResults& results);
nlohmann::ordered_json surfaceJson(const SurfaceResult& result);

/// Aligned text for a person, a line a surface and one for all.
std::string surfacesTable(const LightResults& results);

/// [{"surface", "points", "spacing", "rim", "mean", "min", "uniformity"}, ...]: a grid each, lx and m.
nlohmann::ordered_json gridsJson(const std::vector<Surface>& surfaces, const std::vector<GridReading>& grids);

/// A line a grid, for a person.
std::string gridLines(const std::vector<Surface>& surfaces, const std::vector<GridReading>& grids);

/// surface,x,y,z,nx,ny,nz,area,reflectance,illuminance,exitance; a row a patch, receivers too. `light`: lx,
/// likewise.
std::string patchesCsv(const Patches& patches, const std::vector<Surface>& surfaces,
                       const std::vector<float>& light);

}  // namespace fiatlux
