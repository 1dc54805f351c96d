// Where vertices come to stand: skins, animated nodes and morph targets, in the light and in the picture.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "precompute/gltf/source_scene.h"
#include "precompute/picture/display_mesh.h"
#include "tests/precompute/gltf/gltf_builder.h"

namespace fiatlux {
namespace {

using testing::allWarnings;
using ::testing::HasSubstr;
using testing::ordered_json;
using testing::surfaceIndex;
using testing::TestGltf;
using testing::TestMesh;

/// Lowest and highest corner of a node's meshes.
std::pair<Vec3, Vec3> boxOf(const SourceScene& scene, const std::string& node) {
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

void expectBox(const SourceScene& scene, const std::string& node, const Vec3& low, const Vec3& high) {
  const auto [a, b] = boxOf(scene, node);
  EXPECT_LT(length(a - low), 1e-5) << node << " begins at " << a.x << " " << a.y << " " << a.z;
  EXPECT_LT(length(b - high), 1e-5) << node << " ends at " << b.x << " " << b.y << " " << b.z;
}

/// A room of 4 x 3 x 5 m with a sail 1 m wide and 2 m high, skinned: its lower half hangs on joint 0, the
/// upper on joint 1, and half way up on both. The node of the sail is far away, which must not matter.
struct Skinned {
  TestGltf gltf = testing::boxRoom({4, 3, 5}, 1);
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

TEST(GltfPose, ASkinStandsWhereItsJointsTakeIt) {
  for (const bool bytes : {false, true}) {
    Skinned skinned(bytes);
    const auto scene = skinned.gltf.read();
    ASSERT_TRUE(scene) << scene.error().message;
    // The lower edge goes with joint 0 to y = 0, the upper (y = 2) with joint 1 to 0.5, the middle between
    // both: half of 1 and half of 1 - 2 + 0.5.
    expectBox(*scene, "sail", {1, 0, 2}, {2, 0.5, 2});
    const SourceMesh& mesh = scene->meshes.back();
    EXPECT_NEAR(mesh.positions[3].y, 0.25, bytes ? 0.01 : 1e-6);
    EXPECT_THAT(allWarnings(scene->warnings), HasSubstr("rest pose of their joints"));
  }
}

TEST(GltfPose, TheLightAndThePictureHaveTheSamePose) {
  Skinned skinned;
  const auto scene = skinned.gltf.read();
  ASSERT_TRUE(scene);
  RoomOptions options;
  options.patch = 0.25;
  const auto room = buildRoom(*scene, options);
  ASSERT_TRUE(room) << room.error().message;
  const int sail = surfaceIndex(*room, "sail");
  ASSERT_GE(sail, 0);
  EXPECT_NEAR(room->surfaces[sail].area, 0.5, 1e-4);
  for (std::uint32_t p = 0; p < room->patches.count; ++p)
    if (room->patches.surface[p] == static_cast<std::uint32_t>(sail)) {
      EXPECT_NEAR(room->patches.center[p].z, 2, 1e-5);
      EXPECT_LT(room->patches.center[p].y, 0.5);
    }
  const auto picture = readSourceScene(displayMesh(*scene, *room), "picture.glb", 1);
  ASSERT_TRUE(picture);
  expectBox(*picture, "sail", {1, 0, 2}, {2, 0.5, 2});
}

TEST(GltfPose, BadSkinsAreRefused) {
  const auto refusal = [](Skinned& skinned) {
    const auto scene = skinned.gltf.read();
    EXPECT_FALSE(scene);
    return scene ? "" : scene.error().message;
  };
  Skinned skinned;
  skinned.gltf.glb.json["skins"][0]["joints"] = {skinned.joint};
  EXPECT_THAT(refusal(skinned), HasSubstr("joint 1 is out of range (its skin has 1)"));
  skinned = Skinned();
  skinned.gltf.glb.json["skins"][0]["joints"] = {skinned.joint, 99};
  EXPECT_THAT(refusal(skinned), HasSubstr("skin 0: 'joints' names a node that is not there"));
  skinned = Skinned();
  skinned.gltf.glb.json["skins"][0]["inverseBindMatrices"] = 0;
  EXPECT_THAT(refusal(skinned), HasSubstr("skin 0: it has not a matrix for every joint"));
  skinned = Skinned();
  skinned.gltf.glb.json["nodes"][skinned.sail]["skin"] = 1;
  EXPECT_THAT(refusal(skinned), HasSubstr("node"));
  skinned = Skinned();
  skinned.gltf.glb.json["skins"][0]["joints"] = ordered_json::array();
  EXPECT_THAT(refusal(skinned), HasSubstr("no joints"));
}

TEST(GltfPose, AnAnimatedNodeStandsAtItsOwnTransform) {
  TestGltf gltf = testing::boxRoom({4, 3, 5}, 1);
  TestMesh box;
  box.box({}, {0.5, 0.5, 0.5}, false);
  const int door = gltf.node("door", gltf.mesh(box), {{"translation", {1, 0.25, 2}}});
  const float times[] = {0, 1}, places[] = {9, 9, 9, 8, 8, 8};
  const int input = gltf.glb.addAccessor(gltf.glb.addView(times, 8, 0, 0), 5126, false, 2, "SCALAR"),
            output = gltf.glb.addAccessor(gltf.glb.addView(places, 24, 0, 0), 5126, false, 2, "VEC3");
  gltf.glb.json["animations"] = {
      {{"channels", {{{"sampler", 0}, {"target", {{"node", door}, {"path", "translation"}}}}}},
       {"samplers", {{{"input", input}, {"output", output}}}}}};
  const auto scene = gltf.read();
  ASSERT_TRUE(scene) << scene.error().message;
  expectBox(*scene, "door", {1, 0.25, 2}, {1.5, 0.75, 2.5});
  EXPECT_THAT(allWarnings(scene->warnings), HasSubstr("its rest pose is used"));
}

TEST(GltfPose, MorphTargetsHaveTheirDefaultWeights) {
  TestGltf gltf = testing::boxRoom({4, 3, 5}, 1);
  TestMesh square;
  for (const Vec3& p : {Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{1, 1, 0}}) square.add(p);
  square.indices = {0, 1, 2, 2, 1, 3};
  TestMesh wider, deeper;
  for (const auto& p : square.positions) wider.add({p[0], 0, 0}), deeper.add({0, 0, 4});
  ordered_json primitive = gltf.primitive(square);
  primitive["targets"] = {{{"POSITION", gltf.positions(wider)}}, {{"POSITION", gltf.positions(deeper)}}};
  const int mesh =
      gltf.glb.append("meshes", {{"primitives", ordered_json::array({primitive})}, {"weights", {1, 0.25}}});
  gltf.node("default", mesh), gltf.node("own", mesh, {{"weights", {0, 0.5}}});
  const auto scene = gltf.read();
  ASSERT_TRUE(scene) << scene.error().message;
  expectBox(*scene, "default", {0, 0, 1}, {2, 1, 1});
  expectBox(*scene, "own", {0, 0, 2}, {1, 1, 2});

  gltf.glb.json["meshes"][mesh]["primitives"][0]["targets"][0]["POSITION"] = 0;  // of another count
  const auto refused = gltf.read();
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("different counts"));
}

}  // namespace
}  // namespace fiatlux
