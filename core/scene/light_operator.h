// The operator behind a scene's responses: which share of a site each row sees, and how light is exchanged
// between groups of patches. From it follow the columns of any photometry, aim or paint
// (core/transport/exchange.h, photometric_light.h), where the responses know one Lambertian square.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/base/vec3.h"

namespace fiatlux {

/// Share of each site's light that shadows let through to each row, in steps of its square root: what is
/// nearly hidden is often near, and bright if it were not.
struct SiteVisibility {
  static constexpr std::uint32_t kSteps = 63;  // finer than shadow rays tell, and than a file keeps
  std::uint32_t rows = 0, sites = 0;
  std::vector<std::uint8_t> steps;  // column-major rows x sites, 0..kSteps; 0 also where a row faces away
  const std::uint8_t* column(std::uint32_t site) const { return steps.data() + std::size_t{site} * rows; }
  static double shareOf(std::uint8_t step) { return static_cast<double>(step) * step / (kSteps * kSteps); }
  static std::uint8_t stepOf(double share) {
    return static_cast<std::uint8_t>(std::lround(kSteps * std::sqrt(std::clamp(share, 0.0, 1.0))));
  }
};

/// The grids that cut surfaces into patches: the shape of a patch.
struct Charts {
  struct Frame {
    Vec3 uAxis, vAxis;            // unit, perpendicular
    double cellU = 0, cellV = 0;  // m, edges of a cell
  };
  /// A row is `aspectOf` times longer along u than along v, if its cell were a square: 0 of a whole cell.
  static constexpr double kAspectStep = 1.0 / 32;  // of the logarithm
  static double aspectOf(std::int8_t step) { return std::exp(kAspectStep * step); }
  static std::int8_t aspectStepOf(double aspect) {
    return static_cast<std::int8_t>(std::lround(std::clamp(std::log(aspect) / kAspectStep, -127.0, 127.0)));
  }
  std::vector<Frame> frames;
  std::vector<std::uint32_t> ofRow;      // rows: index into the frames
  std::vector<std::int8_t> aspect = {};  // rows, or none: older files take parts of cells for small cells
};

/// Rows in groups of about 4 x 4 of one facing: 0..count - 1 hold patches, count..total - 1 receivers.
struct ExchangeGroups {
  std::uint32_t count = 0, total = 0;
  std::vector<std::uint32_t> ofRow;    // rows
  std::vector<std::uint8_t> barriers;  // rows: something stands between the row and its neighbour
  static constexpr std::uint8_t kLeftBarrier = 1, kUpBarrier = 2;
};

/// S = F (I - R F)^-1 A^-1, lx at a row per reflected lumen that leaves a patch, as its means between groups
/// and what smooth interpolation of these leaves over.
struct Exchange {
  std::vector<float> means;           // H, total x count, row-major, 1/m2; symmetric in its first count rows
  std::vector<std::uint32_t> offset;  // rows + 1: entries of row p are [offset[p], offset[p + 1])
  std::vector<std::uint32_t> group;   // of an entry, ascending within a row
  std::vector<float> rest;            // of an entry, 1/m2: S between row and group less the interpolated H
};

/// The mean over each surface of what is reflected, whole: lx per lumen that leaves a patch first. What the
/// exchange between groups blurs and leaves out does not count here.
struct SurfaceExchange {
  std::uint32_t surfaces = 0;  // 0 where the file does not tell
  std::vector<float> means;    // patches x surfaces, row-major, 1/m2
};

struct LightOperator {
  SiteVisibility visibility;
  Charts charts;
  ExchangeGroups groups;
  Exchange exchange;
  SurfaceExchange surfaces = {};
};

}  // namespace fiatlux
