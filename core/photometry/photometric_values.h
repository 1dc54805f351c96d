// What a luminaire's card tells: values that follow from its table.
#pragma once

#include <optional>

#include "core/photometry/photometry.h"

namespace fiatlux {

/// lm of the whole table: the exact integral of what `intensityAt` returns. In a plane, between gammas a < b,
/// int I sin = I_a cos a - I_b cos b + s (sin b - sin a) with s = (I_b - I_a) / (b - a); over C the trapezoid
/// rule.
double integratedFlux(const Photometry& photometry);

/// Whether what an LM-63 file says of its lamps cannot be the light of its table, `flux` lm: lamps give no
/// less than that and hardly ten times more. EULUMDAT's tables are per kilolumen of the lamps and cannot
/// disagree so.
bool isFluxDisputed(const Photometry& photometry, double flux);

/// Share of the flux at gamma > 90, 0..1; exact in the same sense. 0 for a dark table.
double upwardShare(const Photometry& photometry);

double maxCandela(const Photometry& photometry);

/// Full angle, degrees, between the outermost directions with at least `share` of maxCandela, mean over those
/// of the planes C0-C180 and C90-C270 that have any; where neither has, in the plane of the brightest
/// direction. Sought in the half of space where that lies, and beyond the horizontal as long as the light
/// stays above. 50 %: beam angle; 10 %: field angle.
double openingAngle(const Photometry& photometry, double share);

/// lm emitted per watt; none where the file states no watts.
std::optional<double> efficacy(const Photometry& photometry);

}  // namespace fiatlux
