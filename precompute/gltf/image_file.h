// PNG and JPEG bytes -> pixels, by stb_image with a limit on the size.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "precompute/gltf/source_scene.h"

namespace fiatlux {

/// Fills width, height and rgba from `image.encoded`. False, with `why` as a short clause, when it is not a
/// PNG or JPEG of at most GltfBudget::kImageEdge squared pixels that decodes.
bool decodeImage(SourceImage& image, std::string& why);

}  // namespace fiatlux
