// The picture's mesh, read back: the same area, every vertex blends patches of its own surface, shares sum to
// one.
#include "precompute/display_mesh.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/precompute/gltf_builder.h"

namespace fiatlux {
namespace {

using testing::boxRoom;
using testing::TestGltf;
using testing::TestMesh;

/// The JSON and the binary chunk of a .glb.
struct Glb {
  nlohmann::json json;
  std::vector<std::uint8_t> bin;
  explicit Glb(const std::vector<std::uint8_t>& bytes) {
    std::uint32_t size = 0;
    std::memcpy(&size, bytes.data() + 12, 4);
    json = nlohmann::json::parse(bytes.begin() + 20, bytes.begin() + 20 + size);
    bin.assign(bytes.begin() + 28 + size, bytes.end());
  }
  template <class T>
  std::vector<T> values(int accessor) const {
    const auto& a = json["accessors"][accessor];
    const auto& view = json["bufferViews"][a["bufferView"].get<int>()];
    std::vector<T> out(a["count"].get<std::size_t>());
    std::memcpy(out.data(), bin.data() + view["byteOffset"].get<std::size_t>(), out.size() * sizeof(T));
    return out;
  }
};

TEST(DisplayMesh, EveryVertexBlendsPatchesOfItsSurface) {
  TestGltf gltf = boxRoom({4, 3, 5}, 1);
  TestMesh plane;
  plane.quad({0.5, 0.75, 0.5}, {0, 0, 4}, {3, 0, 0});
  gltf.node("plane", gltf.mesh(plane), TestGltf::extras({{"measure", true}}));
  const auto scene = gltf.read();
  RoomOptions options;
  options.patch = 0.25;
  const auto room = buildRoom(*scene, options);
  ASSERT_TRUE(room);
  const std::vector<std::uint8_t> bytes = displayMesh(*scene, *room);
  const Glb glb(bytes);
  std::map<std::string, int> nodes;
  for (const auto& node : glb.json["nodes"]) {
    const int surface = node["extras"]["surfaceIndex"];
    ASSERT_EQ(node["extras"]["surface"], room->surfaces[surface].name);
    ASSERT_EQ(node["extras"].contains("measuring"), room->surfaces[surface].measuring);
    ++nodes[node["name"]];
    const auto& attributes = glb.json["meshes"][node["mesh"].get<int>()]["primitives"][0]["attributes"];
    const auto patches = glb.values<std::array<std::uint16_t, 4>>(attributes["_PATCHES"]);
    const auto shares = glb.values<std::array<std::uint8_t, 4>>(attributes["_WEIGHTS"]);
    const auto positions = glb.values<std::array<float, 3>>(attributes["POSITION"]);
    for (std::size_t v = 0; v < patches.size(); ++v) {
      int sum = 0;
      Vec3 mean{};
      for (int i = 0; i < 4; ++i) {
        ASSERT_EQ(room->patches.surface[patches[v][i]], static_cast<std::uint32_t>(surface));
        sum += shares[v][i];
        mean += shares[v][i] / 255.0 * room->patches.center[patches[v][i]];
      }
      ASSERT_EQ(sum, 255);
      // Inside a wall the blend is centred on the vertex; on its rim it is half a patch off.
      ASSERT_LT(length(mean - Vec3{positions[v][0], positions[v][1], positions[v][2]}), 0.18);
    }
  }
  EXPECT_EQ(nodes.size(), 7u);
  EXPECT_EQ(nodes["plane"], 1);
}

TEST(DisplayMesh, WholeCellsAreTwoTrianglesAndNothingIsLost) {
  TestGltf gltf = boxRoom({4, 3, 5}, 1);
  TestMesh ball;
  for (int i = 0; i < 24; ++i)
    for (int j = 0; j < 24; ++j) {
      const auto at = [](int a, int b) {
        return Vec3{2 + 0.5 * std::sin(M_PI * a / 24) * std::cos(2 * M_PI * b / 24),
                    1 + 0.5 * std::cos(M_PI * a / 24),
                    2 - 0.5 * std::sin(M_PI * a / 24) * std::sin(2 * M_PI * b / 24)};
      };
      ball.triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1)),
          ball.triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  gltf.node("ball", gltf.mesh(ball));
  const auto scene = gltf.read();
  RoomOptions options;
  options.patch = 0.25;
  const auto room = buildRoom(*scene, options);
  ASSERT_TRUE(room);
  const auto again = readSourceScene(displayMesh(*scene, *room), "display.glb", 1);
  ASSERT_TRUE(again) << again.error().message;
  for (const SourceMesh& mesh : again->meshes) {
    double area = 0;
    for (const auto& t : mesh.triangles)
      area += 0.5 * length(cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                                 mesh.positions[t[2]] - mesh.positions[t[0]]));
    const Surface& surface = room->surfaces[testing::surfaceIndex(*room, mesh.node)];
    EXPECT_NEAR(area, surface.area, 1e-3 * surface.area) << mesh.node;
    if (mesh.node == "floor") {
      EXPECT_EQ(mesh.triangles.size(), 2u * 16 * 20);
      EXPECT_EQ(mesh.positions.size(), 17u * 21);
    }
  }
}

TEST(DisplayMesh, LightDoesNotLeakRoundAnEdge) {
  TestGltf gltf = boxRoom({4, 3, 5}, 1);
  TestMesh box;
  box.box({1, 1, 1}, {0.4, 0.4, 0.4}, false);
  gltf.node("box", gltf.mesh(box));
  const auto scene = gltf.read();
  RoomOptions options;
  options.patch = 0.2;
  const auto room = buildRoom(*scene, options);
  ASSERT_TRUE(room);
  const Glb glb(displayMesh(*scene, *room));
  for (const auto& node : glb.json["nodes"]) {
    if (node["name"] != "box") continue;
    const auto& attributes = glb.json["meshes"][node["mesh"].get<int>()]["primitives"][0]["attributes"];
    const auto patches = glb.values<std::array<std::uint16_t, 4>>(attributes["_PATCHES"]);
    const auto shares = glb.values<std::array<std::uint8_t, 4>>(attributes["_WEIGHTS"]);
    const auto normals = glb.values<std::array<std::int8_t, 4>>(attributes["NORMAL"]);
    for (std::size_t v = 0; v < patches.size(); ++v)
      for (int i = 0; i < 4; ++i) {
        const Vec3 n{normals[v][0] / 127.0, normals[v][1] / 127.0, normals[v][2] / 127.0};
        ASSERT_TRUE(shares[v][i] == 0 || dot(room->patches.normal[patches[v][i]], n) > 0.99);
      }
  }
}

}  // namespace
}  // namespace fiatlux
