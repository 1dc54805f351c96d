// The only door to tinygltf, which gets checked JSON (document.h) and virtual buffers, so that it opens
// nothing and trusts nothing new. Only this folder includes it: beyond them there is SourceScene.
#pragma once

#include <vector>

#include "precompute/gltf/document.h"

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#include <tiny_gltf.h>
#pragma GCC diagnostic pop

namespace fiatlux {

using tinygltf::Model;

/// Gives the document's JSON to tinygltf; takes its buffers out of it. Images stay outside. Throws GltfError.
Model parseModel(GltfDocument& document);

/// All components of an accessor, element by element, sparse changes applied; T is float, double or
/// std::uint32_t. Throws GltfError where a sparse index is out of range.
template <class T>
std::vector<T> readAccessor(const Model& model, int index);

}  // namespace fiatlux
