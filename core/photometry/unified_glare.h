// Unified glare rating (CIE 117): UGR = 8 log10(0.25 / L_b x sum of L^2 w / p^2), and a luminaire's own value
// by the tabular method (CIE 190) in one room. For a luminaire of projected area A at the distance d, L^2 w =
// I^2 / (A d^2).
#pragma once

#include <optional>

#include "core/photometry/photometry.h"

namespace fiatlux {

/// Guth's position index in closed form. `alpha`: angle from the vertical of the plane that holds the line of
/// sight and the source; `beta`: angle between line of sight and source; degrees. Within 1 % of CIE's table
/// straight ahead, -7 to +11 % far to the side.
double positionIndex(double alpha, double beta);

/// 1 / p^2 of a source `above` (or below) the line of sight, `beside` it and `ahead` along it, in any unit;
/// both are at least 0. 0 outside CIE's table: more than 1.9 R above or 3 R beside, R the distance along it.
double positionWeight(double above, double beside, double ahead);

/// The room 4H x 8H at reflectances 70 / 50 / 20 of ceiling, walls and floor, at the table's own flux; the
/// larger of the luminaire crosswise and endwise. None for a luminaire without luminous area, or that sends
/// no light towards the eye.
///
/// The conditions: luminaires on the ceiling, H = 2 m above the eye, in a square grid of 0.25 H whose
/// outermost rows are half a step from the walls. The eye is at the middle of a short wall and looks level at
/// the opposite one. The room that light is exchanged in reaches from the ceiling down to the level of the
/// eye, which is its "floor"; the luminaires neither block nor absorb. L_b is the indirect illuminance of the
/// walls, mean over all four, over pi: the direct light of all luminaires on floor, walls and (what goes up)
/// ceiling, then a radiosity of these three. Luminaires outside CIE's table of the position index (more
/// than 1.9 R above or 3 R beside the line of sight, R the distance along it) do not count. A luminaire
/// without symmetry is tried in all four turns.
std::optional<double> ugr4h8h(const Photometry& photometry);

}  // namespace fiatlux
