// The nodes of a glTF: which are shown, where they stand, and what they say to this program.
#pragma once

#include <string>
#include <vector>

#include "precompute/gltf/model.h"
#include "precompute/gltf/node_transform.h"
#include "precompute/gltf/source_scene.h"

namespace fiatlux {

/// `extras.fiatlux` of a node called `name`; what is wrong in it is ignored, with a warning.
NodeExtras readExtras(const tinygltf::Node& node, const std::string& name,
                      std::vector<std::string>& warnings);

/// The nodes of the default scene, parents first, each once.
std::vector<int> nodesOfScene(const Model& model);

/// Of all nodes: a skin's joints need not be in the scene. The file's own pose: animations do not run.
std::vector<Matrix> worldFromNodes(const Model& model);

/// joint x inverse bind matrix of every joint of a skin.
std::vector<Matrix> worldFromBind(const Model& model, int skin, const std::vector<Matrix>& worldFromNode);

}  // namespace fiatlux
