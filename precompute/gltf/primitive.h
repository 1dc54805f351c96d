// Primitives of a glTF mesh -> triangles in their own space.
#pragma once

#include <string>
#include <vector>

#include "precompute/gltf/model.h"
#include "precompute/gltf/node_transform.h"
#include "precompute/gltf/source_scene.h"

namespace fiatlux {

/// A primitive in its own space, and what its skin will do to it.
struct LocalPrimitive {
  SourceMesh mesh;
  Influences influences;
};

/// How many triangles its mode and counts make; none of points and lines.
std::size_t triangleCount(const Model& model, const tinygltf::Primitive& primitive);

/// A primitive in its own space, its morph targets applied, triangulated, only with the vertices it uses.
/// `texCoord`: the set of texture coordinates its material reads; `place` is for messages. Throws GltfError.
LocalPrimitive readPrimitive(const Model& model, const tinygltf::Primitive& primitive, int texCoord,
                             const std::vector<double>& morphWeights, const std::string& place);

}  // namespace fiatlux
