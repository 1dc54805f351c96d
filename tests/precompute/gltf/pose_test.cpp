// Where vertices come to stand: skins, animated nodes and morph targets (node_transform, nodes, primitive).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "precompute/gltf/source_scene.h"
#include "tests/precompute/gltf/skinned_sail.h"

namespace fiatlux {
namespace {

using testing::allWarnings;
using testing::expectBox;
using ::testing::HasSubstr;
using testing::ordered_json;
using testing::Skinned;
using testing::TestGltf;
using testing::TestMesh;

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
