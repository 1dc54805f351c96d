// Compressed meshes become plain ones, before a glTF library sees them: KHR_draco_mesh_compression and
// EXT_meshopt_compression, by the libraries of those names.
#pragma once

#include "precompute/gltf/document.h"

namespace fiatlux {

/// Whether a buffer holds nothing of its own: it is where EXT_meshopt_compression unpacks to.
bool isUnpackedTo(const nlohmann::json& buffer);

/// Decodes all compressed views and primitives into buffers of the document, whose JSON then says nothing of
/// compression. Throws GltfError where they are damaged or unpack to too much; as Wasm, where there are any:
/// the page unpacks what it hands over.
void unpackMeshes(GltfDocument& document);

}  // namespace fiatlux
