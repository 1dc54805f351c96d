// Which half planes C a table holds, and how the others follow from them.
#pragma once

#include "core/photometry/photometry.h"

namespace fiatlux {

/// Any angle C, degrees, brought into the range of planes that `symmetry` keeps.
double foldedPlane(PhotometricSymmetry symmetry, double c);

/// Adds the plane 360, equal to plane 0, where a table without symmetry ends before it.
void closeRound(Photometry& photometry);

}  // namespace fiatlux
