// Materials and pictures of a glTF.
#pragma once

#include <string>
#include <vector>

#include "precompute/gltf/model.h"
#include "precompute/gltf/source_scene.h"

namespace fiatlux {

/// All materials, in the file's order; colours outside 0..1 are clamped, with a warning.
std::vector<SourceMaterial> readMaterials(const Model& model, std::vector<std::string>& warnings);

/// Decodes the document's images, taking their bytes out of it; one that cannot be read is empty, with a
/// warning that names the materials it is of. Throws GltfError where they are too large together.
std::vector<SourceImage> readImages(GltfDocument& document, const std::vector<SourceMaterial>& materials,
                                    std::vector<std::string>& warnings);

}  // namespace fiatlux
