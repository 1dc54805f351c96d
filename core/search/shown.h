// Everything that is shown of one layout: its light, the statistics of every surface, and how each goal and
// constraint stands. Means and spreads come from the statistics (paper (8), (10)), minima and maxima from the
// patches.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/result.h"
#include "core/scene/plane_points.h"
#include "core/search/intentions.h"
#include "core/search/prepared_scene.h"

namespace fiatlux {

/// In the quantity asked for: lx, or lm/m2. Measuring planes have no exitance: all 0 there.
struct SurfaceReading {
  double mean = 0, sigma = 0, minimum = 0, maximum = 0;
};

/// One constraint as it stands, judged at the less favourable end of what is not known exactly. `value` lies
/// between the ends; of two sides that read differently (chebyshev) it is the tighter one's. It is infinite
/// for a contrast against darkness and NaN for one of darkness against darkness, which meets no bound. A
/// bound on a ugr is one on its glareRatio, -infinity where nothing glares.
struct ConstraintReading {
  double value = 0;
  double violation = 0;         // sum of excessOver
  double margin = 0;            // least marginTo; negative where not met
  double below = 0, above = 0;  // of the violation: misses of the lower and of the upper bound
};

struct Shown {
  Layout layout;
  std::vector<float> illuminance;        // lx, rows() entries; where direct light is asked for, of that alone
  std::vector<float> direct;             // likewise, where some goal or constraint asks for direct light
  std::vector<SurfaceReading> surfaces;  // one a leaf, then "all"
  std::vector<double> goals;             // value of each, in its unit; of an aim the distance
  std::vector<ConstraintReading> constraints;
  std::vector<ObserverReading> observers;  // of the scene's
  std::vector<PlaneReading> planes;        // of the scene's
};

/// Precondition: checkLayout and checkIntentions passed.
Shown shownOf(PreparedScene& prepared, const Intentions& intentions, const Layout& layout);

/// How each constraint stands, without what else is shown. Precondition as for shownOf.
std::vector<ConstraintReading> constraintReadings(PreparedScene& prepared, const Intentions& intentions,
                                                  const Layout& layout);

/// Sites that exist, each once; one flux a luminaire, finite and not negative; the dimming likewise.
Result<Done> checkLayout(const Scene& scene, const Layout& layout);

/// Statistics against patches: the largest difference of a mean or sigma, relative to the surface's mean.
struct StatisticsCheck {
  double largestDifference = 0;
  std::uint32_t surface = 0;  // leaf, or the number of leaves for "all"
};
StatisticsCheck checkStatistics(const Scene& scene, Quantity quantity, const Shown& shown);

}  // namespace fiatlux
