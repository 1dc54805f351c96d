#include "precompute/gltf/primitive.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "precompute/gltf/codes.h"
#include "precompute/gltf/refusal.h"

namespace fiatlux {
namespace {

template <std::size_t N>
std::vector<std::array<float, N>> readVectors(const Model& model, const tinygltf::Primitive& primitive,
                                              const std::string& name, float fill) {
  const auto found = primitive.attributes.find(name);
  if (found == primitive.attributes.end()) return {};
  const auto width =
      static_cast<std::size_t>(tinygltf::GetNumComponentsInType(model.accessors[found->second].type));
  const std::vector<float> values = readAccessor<float>(model, found->second);
  std::vector<std::array<float, N>> vectors(values.size() / width);
  for (std::size_t i = 0; i < vectors.size(); ++i)
    for (std::size_t c = 0; c < N; ++c) {
      const float value = c < width ? values[i * width + c] : fill;
      vectors[i][c] = std::isfinite(value) ? value : 0;
    }
  return vectors;
}

using Vectors = std::vector<std::array<float, 3>>;

/// Adds the morph targets of an attribute by their weights (glTF 2.0, section 3.7.2.2).
void addMorphTargets(const Model& model, const tinygltf::Primitive& primitive,
                     const std::vector<double>& weights, const std::string& name, Vectors& vectors) {
  for (std::size_t t = 0; t < std::min(weights.size(), primitive.targets.size()); ++t) {
    const auto found = primitive.targets[t].find(name);
    if (weights[t] == 0 || found == primitive.targets[t].end()) continue;
    const std::vector<float> change = readAccessor<float>(model, found->second);
    for (std::size_t i = 0; i < std::min(vectors.size(), change.size() / 3); ++i)
      for (std::size_t c = 0; c < 3; ++c) vectors[i][c] += static_cast<float>(weights[t] * change[3 * i + c]);
  }
}

/// Joints and weights, all sets of four, of the vertices that were kept: target[vertex] is its new number.
Influences readInfluences(const Model& model, const tinygltf::Primitive& primitive,
                          const std::vector<std::uint32_t>& target, std::size_t kept) {
  Influences influences;
  std::vector<std::vector<std::array<float, 4>>> joints, weights;
  for (std::size_t set = 0; primitive.attributes.count("JOINTS_" + std::to_string(set)) != 0; ++set) {
    joints.push_back(readVectors<4>(model, primitive, "JOINTS_" + std::to_string(set), 0));
    weights.push_back(readVectors<4>(model, primitive, "WEIGHTS_" + std::to_string(set), 0));
    weights.back().resize(joints.back().size());
  }
  influences.perVertex = 4 * joints.size();
  influences.joints.resize(kept * influences.perVertex);
  influences.weights.resize(kept * influences.perVertex);
  for (std::size_t v = 0; v < target.size(); ++v) {
    if (target[v] == UINT32_MAX) continue;
    for (std::size_t i = 0; i < influences.perVertex; ++i) {
      const std::size_t at = target[v] * influences.perVertex + i;
      influences.joints[at] = static_cast<std::uint32_t>(joints[i / 4][v][i % 4]);
      influences.weights[at] = std::max(0.0f, weights[i / 4][v][i % 4]);
    }
  }
  return influences;
}

/// Morph targets applied; every number finite.
Vectors readPositions(const Model& model, const tinygltf::Primitive& primitive,
                      const std::vector<double>& morphWeights, const std::string& place) {
  Vectors positions(model.accessors[primitive.attributes.at("POSITION")].count);
  const std::vector<float> raw = readAccessor<float>(model, primitive.attributes.at("POSITION"));
  for (std::size_t i = 0; i < raw.size(); ++i) positions[i / 3][i % 3] = raw[i];
  addMorphTargets(model, primitive, morphWeights, "POSITION", positions);
  for (std::size_t i = 0; i < positions.size(); ++i)
    for (const float x : positions[i])
      if (!std::isfinite(x))
        throw GltfError(place + ": vertex " + std::to_string(i) +
                        " is not a number; repair the mesh in the modelling program");
  return positions;
}

/// Corners of the triangles that a list, strip or fan means, each below `vertices`.
std::vector<std::array<std::uint32_t, 3>> readTriangles(const Model& model,
                                                        const tinygltf::Primitive& primitive,
                                                        std::size_t vertices, const std::string& place) {
  std::vector<std::uint32_t> indices;
  if (primitive.indices >= 0) {
    indices = readAccessor<std::uint32_t>(model, primitive.indices);
  } else {
    indices.resize(vertices);
    for (std::uint32_t i = 0; i < indices.size(); ++i) indices[i] = i;
  }
  for (std::size_t i = 0; i < indices.size(); ++i)
    if (indices[i] >= vertices)
      throw GltfError(place + ": index " + std::to_string(indices[i]) + " is out of range (" +
                      std::to_string(vertices) + " vertices); export the file again");

  const std::size_t triangles = triangleCount(model, primitive);
  std::vector<std::array<std::uint32_t, 3>> corners;
  corners.reserve(triangles);
  for (std::size_t t = 0; t < triangles; ++t) {
    if (primitive.mode == gltf::kTriangleStrip) {  // strip: every other triangle is turned over
      corners.push_back({indices[t], indices[t + 1 + t % 2], indices[t + 2 - t % 2]});
    } else if (primitive.mode == gltf::kTriangleFan) {
      corners.push_back({indices[t + 1], indices[t + 2], indices[0]});
    } else {
      corners.push_back({indices[3 * t], indices[3 * t + 1], indices[3 * t + 2]});
    }
  }
  return corners;
}

}  // namespace

std::size_t triangleCount(const Model& model, const tinygltf::Primitive& primitive) {
  const auto position = primitive.attributes.find("POSITION");
  if (position == primitive.attributes.end()) return 0;
  const std::size_t n = model.accessors[primitive.indices >= 0 ? primitive.indices : position->second].count;
  if (primitive.mode == gltf::kTriangles || primitive.mode == -1) return n / 3;
  return primitive.mode >= gltf::kTriangleStrip && n >= 3 ? n - 2 : 0;
}

LocalPrimitive readPrimitive(const Model& model, const tinygltf::Primitive& primitive, int texCoord,
                             const std::vector<double>& morphWeights, const std::string& place) {
  const Vectors positions = readPositions(model, primitive, morphWeights, place);
  SourceMesh mesh;
  mesh.triangles = readTriangles(model, primitive, positions.size(), place);
  // Keep the vertices that are used, in order of first use.
  Vectors normals = readVectors<3>(model, primitive, "NORMAL", 0);
  addMorphTargets(model, primitive, morphWeights, "NORMAL", normals);
  const auto uv = readVectors<2>(model, primitive, "TEXCOORD_" + std::to_string(texCoord), 0);
  const auto colors = readVectors<4>(model, primitive, "COLOR_0", 1);
  std::vector<std::uint32_t> target(positions.size(), UINT32_MAX);
  for (auto& triangle : mesh.triangles)
    for (std::uint32_t& v : triangle) {
      if (target[v] == UINT32_MAX) {
        target[v] = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back({positions[v][0], positions[v][1], positions[v][2]});
        if (v < normals.size()) mesh.normals.push_back(normals[v]);
        if (v < uv.size()) mesh.uv.push_back(uv[v]);
        if (v < colors.size()) mesh.colors.push_back(colors[v]);
      }
      v = target[v];
    }
  mesh.material = primitive.material;
  Influences influences = readInfluences(model, primitive, target, mesh.positions.size());
  return {std::move(mesh), std::move(influences)};
}

}  // namespace fiatlux
