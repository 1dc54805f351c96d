// The light of one layout at the front of a scene file: what is to be seen while the rest is on its way.
#pragma once

#include <vector>

#include "core/scene/checked_sections.h"
#include "core/scene/layout.h"
#include "core/scene/scene.h"
#include "core/scene/scene_file.h"

namespace fiatlux {

struct OpeningLight {
  Layout layout;
  std::vector<float> illuminance;  // lx, a value a row
  bool ofTypes = false;  // luminaires of photometric files give it; not in the file, but the order of its
                         // sections follows from it
};

/// Its sections; the light is rounded as responses are (response_codec.h). Needs finite values >= 0.
std::vector<PlainSection> encodeOpening(const Patches& patches, std::uint32_t surfaces,
                                        const OpeningLight& opening);

/// The inverse, for a room of `sites` sites whose patches are checked; `in` remembers what is wrong.
OpeningLight readOpening(CheckedSections& in, const Patches& patches, std::uint32_t surfaces,
                         std::uint32_t sites);

}  // namespace fiatlux
