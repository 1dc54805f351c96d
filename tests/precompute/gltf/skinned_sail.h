// A skinned thing in a room, and where the meshes of a node come to stand.
#pragma once

#include <gtest/gtest.h>

#include "tests/precompute/gltf/gltf_builder.h"

namespace fiatlux::testing {

/// Lowest and highest corner of a node's meshes.
inline std::pair<Vec3, Vec3> boxOf(const SourceScene& scene, const std::string& node) {
  Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  for (const SourceMesh& mesh : scene.meshes) {
    if (mesh.node != node) continue;
    for (const Vec3& p : mesh.positions) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  return {low, high};
}

inline void expectBox(const SourceScene& scene, const std::string& node, const Vec3& low, const Vec3& high) {
  const auto [a, b] = boxOf(scene, node);
  EXPECT_LT(length(a - low), 1e-5) << node << " begins at " << a.x << " " << a.y << " " << a.z;
  EXPECT_LT(length(b - high), 1e-5) << node << " ends at " << b.x << " " << b.y << " " << b.z;
}

/// A room of 4 x 3 x 5 m with a sail 1 m wide and 2 m high, skinned: its lower half hangs on joint 0, the
/// upper on joint 1, and half way up on both. The node of the sail is far away, which must not matter.
struct Skinned {
  TestGltf gltf = boxRoom({4, 3, 5}, 1);
  int sail = 0, joint = 0;

  explicit Skinned(bool bytes = false) {
    TestMesh mesh;
    for (const double y : {0.0, 1.0, 2.0})
      for (const double x : {0.0, 1.0}) mesh.add({x, y, 0});
    mesh.indices = {0, 1, 3, 0, 3, 2, 2, 3, 5, 2, 5, 4};
    ordered_json primitive = gltf.primitive(mesh, gltf.material("cloth", 0.5, {{"doubleSided", true}}));
    std::vector<std::array<std::uint8_t, 4>> joints(6, {0, 1, 0, 0});
    const float share[] = {1, 1, 0.5f, 0.5f, 0, 0};
    std::vector<std::array<float, 4>> weights;
    std::vector<std::array<std::uint8_t, 4>> byteWeights;
    for (const float s : share) {
      weights.push_back({s, 1 - s, 0, 0});
      const auto b = static_cast<std::uint8_t>(255 * s);
      byteWeights.push_back({b, static_cast<std::uint8_t>(255 - b), 0, 0});
    }
    primitive["attributes"]["JOINTS_0"] =
        gltf.glb.addAccessor(gltf.glb.addView(joints.data(), 24, 0, 0), 5121, false, 6, "VEC4");
    primitive["attributes"]["WEIGHTS_0"] =
        bytes ? gltf.glb.addAccessor(gltf.glb.addView(byteWeights.data(), 24, 0, 0), 5121, true, 6, "VEC4")
              : gltf.glb.addAccessor(gltf.glb.addView(weights.data(), 96, 0, 0), 5126, false, 6, "VEC4");
    sail = gltf.node("sail", gltf.mesh(ordered_json::array({primitive})),
                     {{"skin", 0}, {"translation", {100, 200, 300}}, {"scale", {7, 7, 7}}});
    // Bound with joint 1 at (0, 2, 0); now it stands at (1, 0.5, 2) of the sail, joint 0 at (1, 0, 2).
    std::array<float, 32> inverse{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                                  1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -2, 0, 1};
    const int matrices =
        gltf.glb.addAccessor(gltf.glb.addView(inverse.data(), 128, 0, 0), 5126, false, 2, "MAT4");
    joint = static_cast<int>(gltf.glb.json["nodes"].size());
    gltf.glb.append("nodes", {{"name", "root"}, {"translation", {1, 0, 2}}, {"children", {joint + 1}}});
    gltf.glb.append("nodes", {{"name", "tip"}, {"translation", {0, 0.5, 0}}});
    gltf.glb.json["scenes"][0]["nodes"].push_back(joint);
    gltf.glb.json["skins"] = {{{"joints", {joint, joint + 1}}, {"inverseBindMatrices", matrices}}};
  }
};

}  // namespace fiatlux::testing
