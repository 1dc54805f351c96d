// Types A and B of LM-63 as type C. Both measure about a beam: H to the side, V upwards, (0, 0) along the
// beam. In type A the half planes turn about the upright axis (H) and V is the height within one; in type B
// they turn about the crosswise axis (V) and H is the angle within one. Here the beam becomes gamma 0, H > 0
// lies towards C 0 and V > 0 towards C 90 (the conversions of CIE 121: tan A = cos C tan gamma, sin alpha =
// sin C sin gamma; tan B = sin C tan gamma, sin beta = cos C sin gamma).
#pragma once

#include "core/photometry/photometry.h"

namespace fiatlux {

/// A table about a beam. Angles in degrees, ascending, two or more; a list that begins at 0 is mirrored to
/// below 0.
struct BeamTable {
  bool typeA = false;              // else type B
  std::vector<double> vertical;    // within [-90, 90] (type B: [-180, 180])
  std::vector<double> horizontal;  // within [-90, 90] (type A: [-180, 180])
  std::vector<double> candela;     // horizontal x vertical
};

/// Fills gamma, c, candela and symmetry by looking the table up (bilinear) on a grid as fine as its finest
/// step, within 0.5 and 2.5 degrees. No light outside the table.
void resampleAsTypeC(const BeamTable& table, Photometry& photometry);

}  // namespace fiatlux
