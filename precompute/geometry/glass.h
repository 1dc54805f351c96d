// Glass that a file paints like a wall: programs often export it opaque.
#pragma once

#include <string>

#include "precompute/gltf/source_scene.h"

namespace fiatlux {

/// Whether one of a name's words is glass in a common language: "Fensterglas", "Verre clair", "MI_Glass01";
/// not "glasses", "fiberglass", "glass frame".
bool saysGlass(const std::string& name);

/// Whether light stops at a mesh that is called glass. What reflects no more than a pane does before the
/// night is meant so, and so is what a node says that it reflects.
bool isOpaqueGlass(const SourceScene& source, const SourceMesh& mesh);

}  // namespace fiatlux
