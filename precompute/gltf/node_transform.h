// Where the nodes of a glTF put a mesh: transforms, and the bending of skins (glTF 2.0, sections 3.5
// and 3.7.3).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "precompute/gltf/source_scene.h"

namespace fiatlux {

using Matrix = std::array<double, 16>;  // column-major, as in glTF

inline constexpr Matrix kIdentity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

Matrix product(const Matrix& a, const Matrix& b);

/// What a node says of itself: `matrix` (16 numbers) or, where that is empty, translation * rotation * scale,
/// each of which may be empty. Rotations are brought to length 1.
Matrix parentFromNode(const std::vector<double>& matrix, const std::vector<double>& translation,
                      const std::vector<double>& rotation, const std::vector<double>& scale);

/// Which joints move a mesh's vertices, and how much.
struct Influences {
  std::size_t perVertex = 0;  // 0: the mesh is not skinned
  std::vector<std::uint32_t> joints;
  std::vector<float> weights;
};

/// Moves a mesh into the world, in metres (`scale` of them in a unit), with counter-clockwise fronts whatever
/// the transform mirrors. Throws GltfError where it lands too far away for single precision.
void moveToWorld(SourceMesh& mesh, const Matrix& worldFromNode, double scale);

/// The same for a skinned mesh: every vertex goes where its joints take it, whatever node the mesh hangs on;
/// `worldFromBind` is joint x inverse bind matrix. Throws GltfError for a joint that is not there, too.
void moveToJoints(SourceMesh& mesh, const Influences& influences, const std::vector<Matrix>& worldFromBind,
                  double scale);

}  // namespace fiatlux
