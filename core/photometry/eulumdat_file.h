// EULUMDAT (.ldt), the photometric file of Europe: one value a line, lines told by their number. Blank lines
// count.
//
// Intensities are cd per 1000 lm of the lamps: x flux of all sets of lamps / 1000 x the conversion factor. A
// negative number of lamps says that photometry is absolute; the flux is then the luminaire's own.
#pragma once

#include "core/photometry/photometric_text.h"
#include "core/photometry/photometry.h"

namespace fiatlux {

/// Are most of lines 2 to 7 numbers, as the heads of such a file are?
bool looksLikeEulumdat(const PhotometricText& text);

/// `flux` is the lamps' flux times the light output ratio. Warns where that ratio or the downward share is
/// more than 2 % off what the table holds.
Result<Photometry> readEulumdat(const PhotometricText& text);

}  // namespace fiatlux
