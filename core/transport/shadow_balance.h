// Shadows that lose no light. Stored shares are of a site's whole square, which a smaller luminaire on it
// does not shine from: where a beam meets the edge of something, what the shares let through and what they
// hold back are not the luminaire's, and the lumens that arrive in the room are not those that leave. In a
// closed room they are. So the shares s of what is seen in part become s + b s (1 - s), with that b for which
// the sum is right within 0.3 %; what is seen wholly or not at all stays. |b| is below 1 by the luminaire's
// share of the site's edge: one as large as the site has the site's shadows.
#pragma once

#include <cstdint>

#include "core/scene/luminaire.h"
#include "core/scene/scene.h"

namespace fiatlux {

/// Whether light that leaves a luminaire arrives in the room, so that its sum is known.
bool isClosed(const Scene& scene);

/// The largest |b|: none of a luminaire as large as its site.
double mostBalance(const Site& site, const Luminaire& luminaire);

/// Balances `column`, the direct light (lx, rows) of a luminaire on a site, so that the patches
/// before the site's mount get `flux` lm. `visible`: steps of SiteVisibility that the column was made with.
void balanceShadows(const Scene& scene, const Site& site, const Luminaire& luminaire, double flux,
                    const std::uint8_t* visible, float* column);

}  // namespace fiatlux
