// The picture's mesh, read back: the same area, every vertex blends patches of its own surface, shares sum to
// one (display_part, display_junctions, patch_blend, glb_writer).
#include "precompute/picture/display_mesh.h"

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <string>

#include "tests/precompute/gltf/skinned_sail.h"

namespace fiatlux {
namespace {

using testing::boxRoom;
using testing::expectBox;
using testing::Skinned;
using testing::surfaceIndex;
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

/// A room with a box in it, and its picture.
struct RoomWithBox {
  Result<Room> room = Error{"not built"};
  std::optional<Glb> glb;

  RoomWithBox(const Vec3& low, const Vec3& size, double patch) {
    TestGltf gltf = boxRoom({4, 3, 5}, 1);
    TestMesh box;
    box.box(low, size, false);
    gltf.node("box", gltf.mesh(box));
    const auto scene = gltf.read();
    RoomOptions options;
    options.patch = patch;
    room = buildRoom(*scene, options);
    if (room) glb.emplace(displayMesh(*scene, *room));
  }

  /// The attributes of a node's vertices; null where there is no such node.
  nlohmann::json attributesOf(const std::string& name) const {
    for (const auto& node : glb->json["nodes"])
      if (node["name"] == name)
        return glb->json["meshes"][node["mesh"].get<int>()]["primitives"][0]["attributes"];
    return nullptr;
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

/// Length of the edges that no other triangle of the picture runs along the other way, m.
double openLength(const SourceScene& picture) {
  using Point = std::array<double, 3>;
  std::map<std::pair<Point, Point>, int> balance;
  for (const SourceMesh& mesh : picture.meshes)
    for (const auto& t : mesh.triangles)
      for (int i = 0; i < 3; ++i) {
        const Vec3 &p = mesh.positions[t[i]], &q = mesh.positions[t[(i + 1) % 3]];
        const Point a{p.x, p.y, p.z}, b{q.x, q.y, q.z};
        if (a != b) balance[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
      }
  double open = 0;
  for (const auto& [edge, count] : balance) {
    const auto& [a, b] = edge;
    open += std::abs(count) * length(Vec3{a[0] - b[0], a[1] - b[1], a[2] - b[2]});
  }
  return open;
}

TEST(DisplayMesh, StripsRoundADoorLeaveNoCracks) {
  // A box whose south wall is five strips that meet in T-junctions round a door of another node.
  const double w = 4.13, h = 2.9, d = 5.27, left = 1.07, right = 2.03, top = 2.11;
  TestGltf gltf;
  using nlohmann::ordered_json;
  const auto add = [&](const char* name, const TestMesh& mesh,
                       const ordered_json& more = ordered_json::object()) {
    gltf.node(name, gltf.mesh(mesh), more);
  };
  const Vec3 x{w, 0, 0}, y{0, h, 0}, z{0, 0, d};
  TestMesh floor, ceiling, north, west, east, south, door;
  floor.quad({}, z, x), ceiling.quad(y, x, z), north.quad(z, y, x), west.quad({}, y, z);
  for (int i = 0; i < 3; ++i) east.quad(x + (i / 3.0) * y, z, (1 / 3.0) * y);
  const auto strip = [](TestMesh& mesh, double x0, double x1, double y0, double y1) {
    mesh.quad({x0, y0, 0}, {x1 - x0, 0, 0}, {0, y1 - y0, 0});
  };
  strip(south, 0, left, 0, h), strip(south, left, right, top, h);
  strip(south, right, w, 0, 0.83), strip(south, right, w, 0.83, 1.39), strip(south, right, w, 1.39, h);
  strip(door, left, right, 0, top);
  add("floor", floor), add("ceiling", ceiling, TestGltf::extras({{"mount", true}, {"siteSpacing", 1}}));
  add("north", north), add("west", west), add("east", east), add("south", south), add("door", door);
  const auto scene = gltf.read();
  ASSERT_TRUE(scene);
  for (const double patch : {0.23, 0.31, 1.0}) {
    RoomOptions options;
    options.patch = patch;
    const auto room = buildRoom(*scene, options);
    ASSERT_TRUE(room) << room.error().message;
    const auto picture = readSourceScene(displayMesh(*scene, *room), "display.glb", 1);
    ASSERT_TRUE(picture);
    EXPECT_LT(openLength(*picture), 1e-3) << "patches of " << patch << " m";
    double area = 0;
    for (const SourceMesh& mesh : picture->meshes)
      for (const auto& t : mesh.triangles) {
        const auto& p = mesh.positions;
        area += 0.5 * length(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
      }
    EXPECT_NEAR(area, 2 * (w * h + h * d + d * w), 1e-2);
  }
}

TEST(DisplayMesh, WhatIsCoveredDarkensNothingBesideIt) {
  const RoomWithBox made({1, 0.01, 1}, {1, 0.5, 1}, 0.25);
  ASSERT_TRUE(made.room);
  const nlohmann::json floor = made.attributesOf("floor");
  const auto blended = made.glb->values<std::array<std::uint16_t, 4>>(floor["_PATCHES"]);
  const auto shares = made.glb->values<std::array<std::uint8_t, 4>>(floor["_WEIGHTS"]);
  int besideIt = 0, within = 0;
  for (std::size_t v = 0; v < blended.size(); ++v) {
    int covered = 0;
    for (int i = 0; i < 4; ++i) covered += made.room->patches.counts(blended[v][i]) ? 0 : shares[v][i];
    EXPECT_TRUE(covered == 0 || covered == 255);
    ++(covered ? within : besideIt);
  }
  EXPECT_GT(besideIt, 0);
  EXPECT_GT(within, 0);
}

TEST(DisplayMesh, LightDoesNotLeakRoundAnEdge) {
  const RoomWithBox made({1, 1, 1}, {0.4, 0.4, 0.4}, 0.2);
  ASSERT_TRUE(made.room);
  const nlohmann::json box = made.attributesOf("box");
  const auto patches = made.glb->values<std::array<std::uint16_t, 4>>(box["_PATCHES"]);
  const auto shares = made.glb->values<std::array<std::uint8_t, 4>>(box["_WEIGHTS"]);
  const auto normals = made.glb->values<std::array<std::int8_t, 4>>(box["NORMAL"]);
  ASSERT_FALSE(patches.empty());
  for (std::size_t v = 0; v < patches.size(); ++v)
    for (int i = 0; i < 4; ++i) {
      const Vec3 n{normals[v][0] / 127.0, normals[v][1] / 127.0, normals[v][2] / 127.0};
      ASSERT_TRUE(shares[v][i] == 0 || dot(made.room->patches.normal[patches[v][i]], n) > 0.99);
    }
}

TEST(DisplayMesh, TheLightAndThePictureHaveTheSamePose) {
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

}  // namespace
}  // namespace fiatlux
