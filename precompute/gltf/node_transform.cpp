#include "precompute/gltf/node_transform.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/short_number.h"
#include "precompute/base/error.h"
#include "precompute/gltf/refusal.h"

namespace fiatlux {
namespace {

constexpr double kFarthest = 1e5;  // m from the origin; beyond, single precision no longer resolves a room

/// Moves every vertex by its own matrix, matrixOf(vertex).
template <class MatrixOf>
void moveVertices(SourceMesh& mesh, double scale, MatrixOf matrixOf) {
  std::vector<bool> mirrored(mesh.positions.size());
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    const Matrix& m = matrixOf(v);
    const Vec3 a{m[0], m[1], m[2]}, b{m[4], m[5], m[6]}, c{m[8], m[9], m[10]}, origin{m[12], m[13], m[14]};
    Vec3& p = mesh.positions[v];
    p = scale * (p.x * a + p.y * b + p.z * c + origin);
    const double farthest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    if (!(farthest < kFarthest))
      throw GltfError("node '" + mesh.node + "' reaches " + shortNumber(farthest) +
                      " m from the origin; check its scale, or pass --scale");
    mirrored[v] = dot(cross(a, b), c) < 0;
    if (v >= mesh.normals.size()) continue;
    auto& normal = mesh.normals[v];
    // The rows of the inverse transpose, up to a factor.
    const Vec3 n = normalized((mirrored[v] ? -1.0 : 1.0) *
                              (normal[0] * cross(b, c) + normal[1] * cross(c, a) + normal[2] * cross(a, b)));
    normal = {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
  }
  for (auto& t : mesh.triangles)
    if (mirrored[t[0]] + mirrored[t[1]] + mirrored[t[2]] >= 2) std::swap(t[1], t[2]);
}

}  // namespace

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      for (int k = 0; k < 4; ++k) c[column * 4 + row] += a[k * 4 + row] * b[column * 4 + k];
  return c;
}

Matrix parentFromNode(const std::vector<double>& matrix, const std::vector<double>& translation,
                      const std::vector<double>& rotation, const std::vector<double>& scale) {
  Matrix m = kIdentity;
  if (matrix.size() == 16) {
    std::copy(matrix.begin(), matrix.end(), m.begin());
    return m;
  }
  if (rotation.size() == 4) {
    double x = rotation[0], y = rotation[1], z = rotation[2], w = rotation[3];
    const double norm = std::sqrt(x * x + y * y + z * z + w * w);
    if (norm > 0) {
      x /= norm, y /= norm, z /= norm, w /= norm;
      const Vec3 columns[3] = {{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
                               {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
                               {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)}};
      for (int c = 0; c < 3; ++c)
        m[4 * c] = columns[c].x, m[4 * c + 1] = columns[c].y, m[4 * c + 2] = columns[c].z;
    }
  }
  for (int c = 0; c < 3; ++c) {
    if (scale.size() == 3)
      for (int r = 0; r < 3; ++r) m[c * 4 + r] *= scale[c];
    if (translation.size() == 3) m[12 + c] = translation[c];
  }
  return m;
}

void moveToWorld(SourceMesh& mesh, const Matrix& worldFromNode, double scale) {
  moveVertices(mesh, scale, [&](std::uint32_t) -> const Matrix& { return worldFromNode; });
}

void moveToJoints(SourceMesh& mesh, const Influences& influences, const std::vector<Matrix>& worldFromBind,
                  double scale) {
  Matrix blend;
  moveVertices(mesh, scale, [&](std::uint32_t v) -> const Matrix& {
    const std::size_t n = influences.perVertex;
    const std::uint32_t* joints = &influences.joints[v * n];
    const float* weights = &influences.weights[v * n];
    blend = {};
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      if (weights[i] == 0) continue;
      if (joints[i] >= worldFromBind.size())
        throw GltfError("node '" + mesh.node + "': joint " + std::to_string(joints[i]) +
                        " is out of range (its skin has " + std::to_string(worldFromBind.size()) +
                        "); export the file again");
      for (int k = 0; k < 16; ++k) blend[k] += weights[i] * worldFromBind[joints[i]][k];
      sum += weights[i];
    }
    if (!(sum > 0)) return blend = worldFromBind[std::min<std::size_t>(joints[0], worldFromBind.size() - 1)];
    for (double& x : blend) x /= sum;
    return blend;
  });
}

}  // namespace fiatlux
