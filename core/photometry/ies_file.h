// LM-63, the photometric file of North America, in its five vintages: 1986 (no tag), IESNA91,
// IESNA:LM-63-1995, IESNA:LM-63-2002, IES:LM-63-2019.
//
// What differs between them: the factor after the ballast factor multiplies the candela in 1986 and 1991 only
// (1995 and 2002 leave it unused, 2019 codes there how the file was made); 2019 forbids a TILT file. A TILT
// file of its own is never read, for one file is all that a reader is given.
#pragma once

#include "core/photometry/photometric_text.h"
#include "core/photometry/photometry.h"

namespace fiatlux {

/// Does a line begin with TILT, or the first one (that is not blank) with an LM-63 tag?
bool looksLikeIes(const PhotometricText& text);

/// The line, from 1, that holds the counts of an LM-63 file; 0 where none does. Tells one that lacks both tag
/// and TILT line from any other text.
std::size_t countsLineOf(const PhotometricText& text);

/// Types A and B are turned into C (type_c.h). `flux` is the lamps' lumens, 0 where photometry is absolute.
Result<Photometry> readIes(const PhotometricText& text);

}  // namespace fiatlux
