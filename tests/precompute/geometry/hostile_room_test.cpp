// Files made to hurt that read well: the room is refused in one readable line, or made with a warning.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "precompute/picture/display_mesh.h"
#include "tests/precompute/gltf/gltf_builder.h"

namespace fiatlux {
namespace {

using testing::allWarnings;
using testing::boxRoom;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::ordered_json;
using testing::TestGltf;
using testing::TestMesh;

TestGltf plainRoom() { return boxRoom({4, 3, 5}, 1); }

TEST(HostileRoom, TheRoomOfTheseTestsIsSound) {
  TestGltf gltf = plainRoom();
  const auto room = gltf.build();
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_EQ(room->sites.size(), 20u);
}

TEST(HostileRoom, NodeChainOfAHundredThousand) {  // a flat walk opens it
  TestGltf gltf;
  TestMesh mesh;
  mesh.box({}, {4, 3, 5}, true);
  const int m = gltf.mesh(mesh);
  constexpr int kDepth = 100000;
  ordered_json nodes = ordered_json::array();
  for (int i = 0; i < kDepth; ++i) nodes.push_back({{"children", {i + 1}}});
  nodes.push_back({{"name", "room"}, {"mesh", m}});
  gltf.glb.json["nodes"] = nodes;
  gltf.glb.json["scenes"][0]["nodes"] = {0};
  const auto room = gltf.build();
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_EQ(room->triangles.size(), 12u);
}

/// A room with so many instances of a triangle of this edge (m), 2 by 1 cm apart in layers of ten thousand.
TestGltf instances(int count, double edge) {
  TestGltf gltf = plainRoom();
  TestMesh small;
  small.triangle({1, 1, 1}, {1 + edge, 1, 1}, {1, 1 + edge, 1});
  const int m = gltf.mesh(small);
  for (int i = 0; i < count; ++i) {
    gltf.glb.json["scenes"][0]["nodes"].push_back(gltf.glb.json["nodes"].size());
    gltf.glb.json["nodes"].push_back(
        {{"mesh", m}, {"translation", {i % 100 * 0.02, i / 100 % 100 * 0.01, i / 10000 * 0.1}}});
  }
  return gltf;
}

TEST(HostileRoom, TwoHundredThousandInstances) {
  TestGltf gltf = instances(200000, 0.008);
  const auto room = gltf.build();
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_EQ(room->triangles.size(), 200012u);
  EXPECT_THAT(allWarnings(room->warnings), HasSubstr("200006 nodes"));

  TestMesh large;
  large.box({1, 1, 1}, {0.1, 0.1, 0.1}, false, 2);
  gltf.glb.json["meshes"].back() = {{"primitives", {gltf.primitive(large)}}};
  const auto scene = gltf.read();
  ASSERT_FALSE(scene);
  EXPECT_THAT(scene.error().message, HasSubstr("(48, 200000 times), and 5 million are accepted"));
}

TEST(HostileRoom, InstancesThatCutOneAnotherFiftyTimes) {
  const auto room = instances(20000, 0.1).build();
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_EQ(room->triangles.size(), 20012u);
}

TEST(HostileRoom, ColoursOutsideTheirRange) {
  for (const double grey : {1.0, 7.0, -3.0, 1e9}) {
    TestGltf gltf;
    TestMesh mesh;
    mesh.box({}, {4, 3, 5}, true);
    gltf.node("room", gltf.mesh(mesh, gltf.material("shiny", grey)));
    const auto room = gltf.build();
    ASSERT_TRUE(room) << room.error().message;
    EXPECT_THAT(allWarnings(room->warnings), HasSubstr("'shiny'"));
    for (const float rho : room->patches.reflectance) {
      EXPECT_GE(rho, 0);
      EXPECT_LE(rho, 0.95f);
    }
  }
}

TEST(HostileRoom, NamesAreTextAndShort) {
  for (const std::string& name :
       {std::string("<img src=x onerror=alert(1)>"), std::string("</script>"), std::string("a\u202Egnp.exe"),
        std::string(5 << 20, 'n'), std::string("all"), std::string("\n\x1b[31m"), std::string("a/b/c")}) {
    TestGltf gltf = plainRoom();
    for (auto& node : gltf.glb.json["nodes"]) node["name"] = name;
    gltf.glb.json["materials"][0]["name"] = name;
    const auto scene = gltf.read();
    ASSERT_TRUE(scene) << scene.error().message;
    const auto room = buildRoom(*scene, {});
    ASSERT_TRUE(room) << room.error().message;
    for (const Surface& surface : room->surfaces) {
      EXPECT_NE(surface.name, "all");
      EXPECT_LE(surface.name.size(), 150u);
      EXPECT_THAT(surface.name, Not(HasSubstr("\u202E")));
      EXPECT_THAT(surface.name, Not(HasSubstr("/")));
      for (const char c : surface.name) EXPECT_GE(static_cast<unsigned char>(c), 0x20);
    }
    EXPECT_FALSE(displayMesh(*scene, *room).empty());
  }
}

TEST(HostileRoom, TrianglesWithoutArea) {
  TestGltf flat;
  TestMesh mesh;
  for (int i = 0; i < 50; ++i) mesh.triangle({0, 0, 0}, {1, 0, 0}, {i * 1.0, 0, 0});
  flat.node("line", flat.mesh(mesh));
  const auto room = flat.build();
  ASSERT_FALSE(room);
  EXPECT_THAT(room.error().message, HasSubstr("zero area"));
}

TEST(HostileRoom, AScaleOfZero) {
  TestGltf gltf;
  TestMesh mesh;
  mesh.box({}, {4, 3, 5}, true);
  gltf.node("room", gltf.mesh(mesh), {{"scale", {0.0, 0.0, 0.0}}});
  const auto room = gltf.build();
  ASSERT_FALSE(room);
  EXPECT_THAT(room.error().message, HasSubstr("zero area"));
}

TEST(HostileRoom, JsonOfTheWrongShape) {
  std::size_t made = 0;
  testing::forEachWrongShape(plainRoom, [&](TestGltf& gltf) { made += bool{gltf.build()}; });
  EXPECT_GT(made, 0u);
}

}  // namespace
}  // namespace fiatlux
