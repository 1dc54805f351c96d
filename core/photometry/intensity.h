// Luminous intensity in a direction: bilinear between the planes and angles of the table, mirrored by its
// symmetry, 0 outside its gammas.
#pragma once

#include "core/base/vec3.h"
#include "core/photometry/photometry.h"

namespace fiatlux {

/// cd at C (any angle) and gamma (0..180), degrees.
double intensityAt(const Photometry& photometry, double c, double gamma);

/// cd along `direction` of any length, given in the luminaire's axes: x along C0, y along C90, z along gamma
/// 0.
double intensity(const Photometry& photometry, const Vec3& direction);

}  // namespace fiatlux
