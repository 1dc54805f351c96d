// Files made to hurt: each is refused in one readable line, or opened with a warning; never a crash, never a
// request.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>

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

std::vector<std::uint8_t> bytesOf(const std::string& text) { return {text.begin(), text.end()}; }

/// The line with which a file is refused; fails the test when it is not, or when the line is not one line.
std::string refusal(const std::vector<std::uint8_t>& bytes) {
  const auto scene = readSourceScene(bytes, "hostile.glb", 1);
  std::string line;
  if (!scene) {
    line = scene.error().message;
  } else if (const auto room = buildRoom(*scene, {}); !room) {
    line = room.error().message;
  } else {
    ADD_FAILURE() << "the file was opened";
  }
  EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  EXPECT_GT(line.size(), 20u);
  EXPECT_LT(line.size(), 700u);
  return line;
}

std::string refusal(TestGltf& gltf) { return refusal(gltf.glb.bytes()); }

TestGltf plainRoom() { return boxRoom({4, 3, 5}, 1); }

/// A .gltf in a folder of its own, with whatever lies around it.
struct Folder {
  std::filesystem::path path;
  Folder()
      : path(std::filesystem::temp_directory_path() /
             ("fiatlux-" + std::to_string(::getpid()) + "-" + std::to_string(counter()++))) {
    std::filesystem::create_directories(path / "inner");
  }
  ~Folder() { std::filesystem::remove_all(path); }
  static int& counter() {
    static int value = 0;
    return value;
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path / name, std::ios::binary) << text;
  }
  std::string refusal(const std::string& bufferUri) const {
    write("inner/room.gltf", ordered_json({{"asset", {{"version", "2.0"}}},
                                           {"buffers", {{{"byteLength", 4}, {"uri", bufferUri}}}}})
                                 .dump());
    const auto scene = readSourceScene((path / "inner/room.gltf").string(), 1);
    EXPECT_FALSE(scene) << "opened " << bufferUri;
    return scene ? "" : scene.error().message;
  }
};

TEST(HostileGltf, TheRoomOfTheseTestsIsSound) {
  TestGltf gltf = plainRoom();
  const auto room = gltf.build();
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_EQ(room->sites.size(), 20u);
}

TEST(HostileGltf, CountsAndExtentsBeyondTheirBuffers) {
  TestGltf gltf = plainRoom();
  gltf.glb.json["accessors"][0]["count"] = 2147483647;
  EXPECT_THAT(refusal(gltf), HasSubstr("accessor 0"));
  gltf = plainRoom();
  gltf.glb.json["bufferViews"][1]["byteOffset"] = 4294967292u;
  EXPECT_THAT(refusal(gltf), HasSubstr("buffer view 1"));
  gltf = plainRoom();
  gltf.glb.json["accessors"][0]["count"] = -1;
  EXPECT_THAT(refusal(gltf), HasSubstr("accessor 0"));
  gltf = plainRoom();
  gltf.glb.json["accessors"][0]["count"] = 1.5;
  EXPECT_THAT(refusal(gltf), HasSubstr("not a whole number"));
  gltf = plainRoom();
  gltf.glb.json["accessors"][0]["byteOffset"] = 18446744073709551615u;
  EXPECT_THAT(refusal(gltf), HasSubstr("accessor 0"));
}

TEST(HostileGltf, IndexOutOfRange) {
  TestGltf gltf;
  TestMesh mesh;
  mesh.box({}, {4, 3, 5}, true);
  mesh.indices[7] = 4000000000u;
  gltf.node("room", gltf.mesh(mesh));
  EXPECT_THAT(refusal(gltf), HasSubstr("index 4000000000 is out of range"));
}

TEST(HostileGltf, IndicesAndJointsThatAreNoWholeNumbers) {
  for (const int type : {5120, 5122, 5126}) {
    TestGltf gltf = plainRoom();
    const int indices = gltf.glb.json["meshes"][0]["primitives"][0]["indices"];
    gltf.glb.json["accessors"][indices]["componentType"] = type;
    EXPECT_THAT(refusal(gltf), HasSubstr("its indices are not unsigned whole numbers"));
  }
  TestGltf gltf = plainRoom();
  ordered_json& attributes = gltf.glb.json["meshes"][0]["primitives"][0]["attributes"];
  const std::size_t vertices = gltf.glb.json["accessors"][attributes["POSITION"].get<int>()]["count"];
  const std::vector<float> joints(4 * vertices, -1);
  const int view = gltf.glb.addView(joints.data(), 4 * joints.size(), 0, 0);
  attributes["JOINTS_0"] = attributes["WEIGHTS_0"] =
      gltf.glb.addAccessor(view, 5126, false, vertices, "VEC4");
  EXPECT_THAT(refusal(gltf), HasSubstr("JOINTS_0 are not unsigned whole numbers"));
}

TEST(HostileGltf, VerticesThatAreNoNumbers) {
  for (const float bad : {NAN, INFINITY, -INFINITY}) {
    TestGltf gltf;
    TestMesh mesh;
    mesh.box({}, {4, 3, 5}, true);
    mesh.positions[5][1] = bad;
    gltf.node("room", gltf.mesh(mesh));
    EXPECT_THAT(refusal(gltf), HasSubstr("vertex 5"));
  }
}

TEST(HostileGltf, NodeCycle) {
  TestGltf gltf = plainRoom();
  gltf.glb.json["nodes"][0]["children"] = {1};
  gltf.glb.json["nodes"][1]["children"] = {2};
  gltf.glb.json["nodes"][2]["children"] = {0};
  EXPECT_THAT(refusal(gltf), HasSubstr("its own ancestor"));
  gltf.glb.json["nodes"][2]["children"] = {2};
  EXPECT_THAT(refusal(gltf), HasSubstr("node"));
}

TEST(HostileGltf, NodeChainOfAHundredThousand) {  // a flat walk opens it
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

TEST(HostileGltf, TwoHundredThousandInstances) {
  TestGltf gltf = plainRoom();
  TestMesh small;
  small.triangle({1, 1, 1}, {1.1, 1, 1}, {1, 1.1, 1});
  const int m = gltf.mesh(small);
  for (int i = 0; i < 200000; ++i) {
    gltf.glb.json["scenes"][0]["nodes"].push_back(gltf.glb.json["nodes"].size());
    gltf.glb.json["nodes"].push_back(
        {{"mesh", m}, {"translation", {i % 100 * 0.02, i / 100 % 100 * 0.01, i / 10000 * 0.1}}});
  }
  const auto room = gltf.build();
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_EQ(room->triangles.size(), 200012u);
  EXPECT_THAT(allWarnings(room->warnings), HasSubstr("200006 nodes"));

  TestMesh large;
  large.box({1, 1, 1}, {0.1, 0.1, 0.1}, false, 2);
  gltf.glb.json["meshes"][m] = {{"primitives", {gltf.primitive(large)}}};
  EXPECT_THAT(refusal(gltf), HasSubstr("5 million are accepted"));
}

TEST(HostileGltf, AddressesOutsideTheFolderAreNeverOpened) {
  const Folder folder;
  folder.write("secret.bin", "abcd");
  EXPECT_THAT(folder.refusal("../secret.bin"), HasSubstr("outside the file's folder"));
  EXPECT_THAT(folder.refusal("%2e%2e/secret.bin"), HasSubstr("outside the file's folder"));
  EXPECT_THAT(folder.refusal("x/%2E%2E/../secret.bin"), HasSubstr("outside the file's folder"));
  EXPECT_THAT(folder.refusal("/etc/passwd"), HasSubstr("plain relative name"));
  EXPECT_THAT(folder.refusal("..\\secret.bin"), HasSubstr("plain relative name"));
  EXPECT_THAT(folder.refusal("~/secret.bin"), HasSubstr("plain relative name"));
  EXPECT_THAT(folder.refusal("http://localhost:1/room.bin"), HasSubstr("nothing is fetched"));
  EXPECT_THAT(folder.refusal("file:///etc/passwd"), HasSubstr("nothing is fetched"));
  EXPECT_THAT(folder.refusal("//host/room.bin"), HasSubstr("nothing is fetched"));
  EXPECT_THAT(folder.refusal("nowhere.bin"), HasSubstr("not there"));
  std::filesystem::create_symlink(folder.path / "secret.bin", folder.path / "inner/link.bin");
  EXPECT_THAT(folder.refusal("link.bin"), HasSubstr("links to outside"));
  EXPECT_THAT(folder.refusal("data:application/octet-stream;base64,AA!AA==="), HasSubstr("bad base64"));
  EXPECT_THAT(folder.refusal("data:application/octet-stream;base64,AAAA"),
              HasSubstr("should have 4 bytes but has 3"));
  EXPECT_THAT(folder.refusal("data:text/plain,AAAA"), HasSubstr("not base64"));
}

TEST(HostileGltf, SparseIndexOutOfRange) {
  TestGltf gltf = plainRoom();
  const std::uint16_t index = 60000;
  const float value[3] = {0, 0, 0};
  const int indices = gltf.glb.addView(&index, 2, 0, 0), values = gltf.glb.addView(value, 12, 0, 0);
  gltf.glb.json["accessors"][0]["sparse"] = {{"count", 1},
                                             {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                                             {"values", {{"bufferView", values}}}};
  EXPECT_THAT(refusal(gltf), HasSubstr("sparse index is out of range"));
  gltf.glb.json["accessors"][0]["sparse"]["count"] = 3;
  EXPECT_THAT(refusal(gltf), HasSubstr("do not fit"));
}

TEST(HostileGltf, RequiredExtensionsAreNamed) {
  for (const char* name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "VENDOR_unheard_of"}) {
    TestGltf gltf = plainRoom();
    gltf.glb.json["extensionsRequired"] = {name};
    EXPECT_THAT(refusal(gltf), HasSubstr(name));
  }
  TestGltf gltf = plainRoom();
  gltf.glb.json["extensionsUsed"] = {"KHR_draco_mesh_compression"};
  gltf.glb.json["meshes"][0]["primitives"][0]["extensions"] = {
      {"KHR_draco_mesh_compression", {{"bufferView", 0}, {"attributes", {{"POSITION", 0}}}}}};
  gltf.glb.json["accessors"][0].erase("bufferView");
  EXPECT_THAT(refusal(gltf), HasSubstr("KHR_draco_mesh_compression"));
}

TEST(HostileGltf, NothingToLight) {
  TestGltf empty;
  EXPECT_THAT(refusal(empty), HasSubstr("no surfaces"));
  for (const int mode : {0, 1, 2, 3}) {
    TestGltf gltf = plainRoom();
    for (auto& mesh : gltf.glb.json["meshes"]) mesh["primitives"][0]["mode"] = mode;
    EXPECT_THAT(refusal(gltf), HasSubstr("no surfaces"));
  }
  TestGltf flat;
  TestMesh mesh;
  for (int i = 0; i < 50; ++i) mesh.triangle({0, 0, 0}, {1, 0, 0}, {i * 1.0, 0, 0});
  flat.node("line", flat.mesh(mesh));
  EXPECT_THAT(refusal(flat), HasSubstr("zero area"));
}

TEST(HostileGltf, ScalesWithoutMeasure) {
  for (const double scale : {1e30, 0.0, 1e300, -1e30}) {
    TestGltf gltf;
    TestMesh mesh;
    mesh.box({}, {4, 3, 5}, true);
    gltf.node("room", gltf.mesh(mesh), {{"scale", {scale, scale, scale}}});
    refusal(gltf);
  }
  TestGltf gltf = plainRoom();
  for (const double scale : {0.0, -1.0, 1e30, double{NAN}}) EXPECT_FALSE(gltf.read(scale));
}

TEST(HostileGltf, ColoursOutsideTheirRange) {
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

TEST(HostileGltf, NamesAreTextAndShort) {
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

TEST(HostileGltf, KeysOfPrototypesMeanNothing) {
  TestGltf gltf = plainRoom();
  gltf.glb.json["__proto__"] = {{"polluted", true}};
  gltf.glb.json["nodes"][0]["extras"] = {{"__proto__", {{"fiatlux", {{"mount", true}}}}},
                                         {"constructor", {{"prototype", 1}}}};
  EXPECT_TRUE(gltf.build());
}

TEST(HostileGltf, JsonNestedThirtyThousandDeep) {
  for (const char open : {'[', '{'}) {
    std::string text = "{\"asset\":{\"version\":\"2.0\"},\"extras\":";
    for (int i = 0; i < 30000; ++i) text += open == '[' ? "[" : "{\"a\":";
    EXPECT_THAT(refusal(bytesOf(text)), HasSubstr("64 levels"));
  }
}

TEST(HostileGltf, ThingsThatAreNoGltf) {
  EXPECT_THAT(refusal(bytesOf("")), HasSubstr("empty"));
  EXPECT_THAT(refusal(bytesOf("<!doctype html><html></html>")), HasSubstr("neither a GLB nor glTF"));
  EXPECT_THAT(refusal(bytesOf(std::string("\xff\xfe{\0\"\0", 6))), HasSubstr("neither a GLB nor glTF"));
  EXPECT_THAT(refusal(bytesOf("{\"asset\":{\"version\":\"2.0\"")), HasSubstr("broken"));
  EXPECT_THAT(refusal(bytesOf("{}")), HasSubstr("asset.version"));
  EXPECT_THAT(refusal(bytesOf("{\"asset\":{\"version\":\"1.0\"}}")), HasSubstr("2.0"));
  EXPECT_THAT(refusal(bytesOf("{\"asset\":{\"version\":\"2.0\"},\"x\":1e999}")), HasSubstr("out of range"));
  EXPECT_FALSE(readSourceScene(std::string("/dev/zero"), 1));
  EXPECT_FALSE(readSourceScene(std::filesystem::temp_directory_path().string(), 1));
  EXPECT_FALSE(readSourceScene(std::string("/nowhere/at/all.glb"), 1));
}

TEST(HostileGltf, GlbLengthsThatLie) {
  TestGltf gltf = plainRoom();
  const std::vector<std::uint8_t> good = gltf.glb.bytes();
  for (const std::size_t word : {8u, 12u})
    for (const std::uint32_t value : {0u, 1u, 19u, 0x7fffffffu, 0xffffffffu}) {
      std::vector<std::uint8_t> bytes = good;
      std::memcpy(bytes.data() + word, &value, 4);
      refusal(bytes);
    }
  for (std::size_t size = 0; size < good.size(); size += 97)
    refusal({good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size)});
}

TEST(HostileGltf, MoreThanTheBudgets) {
  const Folder folder;
  const std::string large = (folder.path / "large.glb").string();
  std::ofstream(large).close();
  std::filesystem::resize_file(large, (std::uintmax_t{256} << 20) + 1);  // sparse: it takes no disk
  const auto file = readSourceScene(large, 1);
  ASSERT_FALSE(file);
  EXPECT_THAT(file.error().message, HasSubstr("256 MB"));

  TestGltf gltf = plainRoom();
  gltf.glb.json["buffers"] = {{{"byteLength", 300 << 20}}};
  std::string text = gltf.glb.json.dump();
  EXPECT_THAT(refusal(bytesOf(text)), HasSubstr("byteLength"));

  text = "{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{}";
  for (int i = 0; i < 1000000; ++i) text += ",{}";
  EXPECT_THAT(refusal(bytesOf(text + "]}")), HasSubstr("more than a million nodes"));
}

TEST(HostileGltf, DracoWithGarbageIsRefusedByName) {
  TestGltf gltf = plainRoom();
  const std::vector<std::uint8_t> garbage(64, 0xd7);
  const int view = gltf.glb.addView(garbage.data(), garbage.size(), 0, 0);
  gltf.glb.json["extensionsUsed"] = gltf.glb.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  for (auto& mesh : gltf.glb.json["meshes"])
    mesh["primitives"][0]["extensions"] = {
        {"KHR_draco_mesh_compression", {{"bufferView", view}, {"attributes", {{"POSITION", 0}}}}}};
  EXPECT_THAT(refusal(gltf), HasSubstr("KHR_draco_mesh_compression"));
}

TEST(HostileGltf, JsonOfTheWrongShape) {
  const ordered_json values[] = {
      nullptr, true, -1, 1e18, "text", ordered_json::array(), ordered_json::object(), {1, "x", nullptr}};
  for (const char* list : {"nodes", "meshes", "accessors", "bufferViews", "buffers", "materials", "scenes"})
    for (const ordered_json& value : values) {
      TestGltf whole = plainRoom(), first = plainRoom();
      whole.glb.json[list] = value;
      first.glb.json[list][0] = value;
      for (TestGltf* gltf : {&whole, &first})
        if (const auto scene = readSourceScene(gltf->glb.bytes(), "shape.glb", 1))
          (void)buildRoom(*scene, {});
      TestGltf plain = plainRoom();  // kept: items() only refers to it
      for (const auto& [key, unused] : plain.glb.json[list][0].items()) {
        TestGltf inner = plainRoom();
        inner.glb.json[list][0][key] = value;
        if (const auto scene = readSourceScene(inner.glb.bytes(), "shape.glb", 1))
          (void)buildRoom(*scene, {});
      }
    }
}

}  // namespace
}  // namespace fiatlux
