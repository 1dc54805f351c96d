// Everything that is told of a luminaire before it is used: the values that follow from its table, and the
// table sampled evenly, to be drawn.
#pragma once

#include <optional>
#include <vector>

#include "core/photometry/photometry.h"

namespace fiatlux {

struct PhotometricDescription {
  double integratedFlux = 0;       // lm that the table holds
  bool disputed = false;           // the file's own flux cannot be that of its table: somebody has to choose
  std::optional<double> efficacy;  // lm/W; none where no watts are stated
  double maxCandela = 0;           // cd
  double beamAngle = 0, fieldAngle = 0;  // degrees, at 50 and 10 % of maxCandela
  double upwardShare = 0;                // 0..1
  std::optional<double> ugr4h8h;         // none without a luminous area
};

PhotometricDescription describe(const Photometry& photometry);

/// Planes and directions of the even sampling: C = 0, 15, ..., 345; gamma = 0, 1, ..., 180 degrees.
inline constexpr int kSampledPlanes = 24, kSampledGammas = 181;

/// cd, kSampledPlanes x kSampledGammas, plane by plane.
std::vector<float> sampledIntensities(const Photometry& photometry);

}  // namespace fiatlux
