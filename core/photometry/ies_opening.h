// LM-63's luminous opening: three lengths whose signs tell one of 14 bodies (or a point).
#pragma once

#include "core/photometry/photometry.h"

namespace fiatlux {

/// Width lies in the 90-270 plane, length in the 0-180 plane; negative where the body is round that way.
struct IesOpening {
  double width = 0, length = 0, height = 0;  // m
  bool before2002 = false;                   // when a circle gave its diameter once, as the width
};

/// Signs that no vintage knows are taken as a box.
LuminousArea areaOf(const IesOpening& opening);

/// The same for types A and B, which are stated with the beam horizontal ("length" along it), once the beam
/// points down: the depth becomes the height. An opening without height is taken as already facing the beam.
LuminousArea areaOfBeam(const IesOpening& opening);

}  // namespace fiatlux
