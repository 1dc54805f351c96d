// What lighter paint would do for what is asked of the light: the derivative of every goal and constraint
// with respect to the reflectance of each surface, in the room as it is painted.
#pragma once

#include <cstdint>
#include <vector>

#include "core/base/result.h"
#include "core/search/intentions.h"
#include "core/transport/photometric_light.h"
#include "core/transport/repaint.h"

namespace fiatlux {

/// Per 0.1 more reflectance of a surface, in the units of the readings (core/search/shown.h).
struct PaintGain {
  std::uint32_t surface = 0;
  std::vector<double> goals, constraints;
};

inline constexpr std::size_t kMostGains = 96;  // surfaces: the largest

/// A layout in the scene whose sites it names: the room's own, or one of candidates in it
/// (core/candidates/candidate_scene.h). Refers to that.
struct LitLayout {
  const Scene& scene;
  Layout layout;
};

/// Of the surfaces that can be painted, by their numbers; the layout hangs in the room under `paint`, and
/// `light` is of that room. What no paint changes (power, direct light) gains 0. An Error where the layout's
/// scene does not tell what is asked.
Result<std::vector<PaintGain>> paintGains(const Scene& room, const PhotometricLight& light,
                                          const Repaint& paint, const LitLayout& lit,
                                          const Intentions& asked);

}  // namespace fiatlux
