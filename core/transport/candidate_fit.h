// Whether a luminaire has room where it is to hang: a long one on a site near a wall would pierce the wall,
// and its light would start behind it.
#pragma once

#include <vector>

#include "core/scene/luminaire.h"
#include "core/scene/scene.h"
#include "core/transport/patch_tiles.h"

namespace fiatlux {

/// Refers to the scene, which must have a light operator and outlive it.
class CandidateFit {
 public:
  explicit CandidateFit(const Scene& scene);

  /// Whether no patch crosses the luminous area of `luminaire`, nor a body of `depth` m before it: further
  /// than kFitSlack, so that what touches still fits. Measuring planes are in nobody's way.
  bool fits(const Luminaire& luminaire, double depth) const;

 private:
  const Scene& scene_;
  std::vector<PatchTile> tiles_;  // rows
};

inline constexpr double kFitSlack = 0.01;  // m

}  // namespace fiatlux
