// Files made to hurt: each is refused in one readable line, or opened with a warning; never a crash, never a
// request (container, document, check, check_data, fields, uri, image_file).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/precompute/gltf/gltf_builder.h"

namespace fiatlux {
namespace {

using testing::boxRoom;
using ::testing::HasSubstr;
using testing::ordered_json;
using testing::TestGltf;
using testing::TestMesh;

std::vector<std::uint8_t> bytesOf(const std::string& text) { return {text.begin(), text.end()}; }

/// The line with which a file is refused; fails the test when it is not, or when the line is not one line.
std::string refusal(const std::vector<std::uint8_t>& bytes, const Resolve& resolve = {}) {
  const auto scene = readSourceScene(bytes, "hostile.glb", 1, resolve);
  EXPECT_FALSE(scene) << "the file was opened";
  const std::string line = scene ? "" : scene.error().message;
  EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  EXPECT_GT(line.size(), 20u);
  EXPECT_LT(line.size(), 700u);
  return line;
}

std::string refusal(TestGltf& gltf) { return refusal(gltf.glb.bytes()); }

TestGltf plainRoom() { return boxRoom({4, 3, 5}, 1); }

/// The same of a .gltf of one buffer, whose siblings `resolve` knows.
std::string refusalOfUri(const std::string& bufferUri, const Resolve& resolve) {
  const ordered_json gltf = {{"asset", {{"version", "2.0"}}},
                             {"buffers", {{{"byteLength", 4}, {"uri", bufferUri}}}}};
  return refusal(bytesOf(gltf.dump()), resolve);
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

TEST(HostileGltf, AddressesThatLeadAwayAreNeverAskedFor) {
  const auto refused = [](const std::string& uri) {
    return refusalOfUri(uri, [&](const std::string& name) {
      ADD_FAILURE() << uri << " was asked for as " << name;
      return std::optional<std::vector<std::uint8_t>>();
    });
  };
  EXPECT_THAT(refused("../secret.bin"), HasSubstr("outside the file's folder"));
  EXPECT_THAT(refused("%2e%2e/secret.bin"), HasSubstr("outside the file's folder"));
  EXPECT_THAT(refused("x/%2E%2E/../secret.bin"), HasSubstr("outside the file's folder"));
  EXPECT_THAT(refused("x/.."), HasSubstr("outside the file's folder"));
  EXPECT_THAT(refused("/etc/passwd"), HasSubstr("plain relative name"));
  EXPECT_THAT(refused("..\\secret.bin"), HasSubstr("plain relative name"));
  EXPECT_THAT(refused("~/secret.bin"), HasSubstr("plain relative name"));
  EXPECT_THAT(refused("room%00.bin"), HasSubstr("plain relative name"));
  EXPECT_THAT(refused("http://localhost:1/room.bin"), HasSubstr("nothing is fetched"));
  EXPECT_THAT(refused("file:///etc/passwd"), HasSubstr("nothing is fetched"));
  EXPECT_THAT(refused("//host/room.bin"), HasSubstr("nothing is fetched"));
  EXPECT_THAT(refused("data:application/octet-stream;base64,AA!AA==="), HasSubstr("bad base64"));
  EXPECT_THAT(refused("data:application/octet-stream;base64,AAAA"),
              HasSubstr("should have 4 bytes but has 3"));
  EXPECT_THAT(refused("data:text/plain,AAAA"), HasSubstr("not base64"));
}

TEST(HostileGltf, SiblingsAreWhatTheResolverSays) {
  using Sibling = Result<std::optional<std::vector<std::uint8_t>>>;
  EXPECT_THAT(refusalOfUri("room.bin", {}), HasSubstr("this file stands alone"));
  EXPECT_THAT(refusalOfUri("a%20b/room.bin",
                           [](const std::string& name) -> Sibling {
                             EXPECT_EQ(name, "a b/room.bin");
                             return std::optional<std::vector<std::uint8_t>>();
                           }),
              HasSubstr("'a b/room.bin', which is not there"));
  EXPECT_THAT(
      refusalOfUri("room.bin", [](const std::string&) -> Sibling { return Error{"is too far; walk"}; }),
      HasSubstr("buffer 0 names 'room.bin', which is too far; walk"));
  EXPECT_THAT(
      refusalOfUri("room.bin",
                   [](const std::string&) -> Sibling { return std::optional(std::vector<std::uint8_t>(3)); }),
      HasSubstr("should have 4 bytes but has 3"));
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
  TestGltf gltf = plainRoom();
  gltf.glb.json["extensionsRequired"] = {"VENDOR_unheard_of"};
  EXPECT_THAT(refusal(gltf), HasSubstr("VENDOR_unheard_of"));
}

TEST(HostileGltf, PicturesThatNobodyNeedsOrReadsRefuseNothing) {
  TestGltf gltf = plainRoom();
  gltf.glb.json["extensionsRequired"] = {"KHR_texture_basisu", "KHR_materials_transmission"};
  const std::string ktx = "\xabKTX 20\xbb\r\n\x1a\n and more";
  const int view = gltf.glb.addView(ktx.data(), ktx.size(), 0, 0);
  gltf.glb.json["images"] = {{{"bufferView", view}, {"mimeType", "image/ktx2"}}};
  gltf.glb.json["textures"] = {{{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}}};
  const auto unused = gltf.read();
  ASSERT_TRUE(unused) << unused.error().message;
  EXPECT_THAT(unused->warnings, ::testing::IsEmpty());

  gltf.glb.json["materials"] = {
      {{"name", "oak"}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  const auto used = gltf.read();
  ASSERT_TRUE(used) << used.error().message;
  ASSERT_EQ(used->warnings.size(), 1u);
  EXPECT_THAT(used->warnings[0], HasSubstr("of material 'oak' is KTX2, which is not read"));
  RoomOptions options;
  options.patch = 0.5;
  const auto room = buildRoom(*used, options);
  ASSERT_TRUE(room) << room.error().message;
  EXPECT_NEAR(room->surfaces[testing::surfaceIndex(*room, "floor")].reflectance, 0.2, 1e-6);
}

TEST(HostileGltf, NothingToLight) {
  TestGltf empty;
  EXPECT_THAT(refusal(empty), HasSubstr("no surfaces"));
  for (const int mode : {0, 1, 2, 3}) {
    TestGltf gltf = plainRoom();
    for (auto& mesh : gltf.glb.json["meshes"]) mesh["primitives"][0]["mode"] = mode;
    EXPECT_THAT(refusal(gltf), HasSubstr("no surfaces"));
  }
}

TEST(HostileGltf, ScalesBeyondAnyRoom) {
  for (const double scale : {1e30, 1e300, -1e30}) {
    TestGltf gltf;
    TestMesh mesh;
    mesh.box({}, {4, 3, 5}, true);
    gltf.node("room", gltf.mesh(mesh), {{"scale", {scale, scale, scale}}});
    EXPECT_THAT(refusal(gltf), HasSubstr("m from the origin"));
  }
  TestGltf gltf = plainRoom();
  for (const double scale : {0.0, -1.0, 1e30, double{NAN}}) EXPECT_FALSE(gltf.read(scale));
}

TEST(HostileGltf, KeysOfPrototypesMeanNothing) {
  TestGltf gltf = plainRoom();
  gltf.glb.json["__proto__"] = {{"polluted", true}};
  gltf.glb.json["nodes"][0]["extras"] = {{"__proto__", {{"fiatlux", {{"mount", true}}}}},
                                         {"constructor", {{"prototype", 1}}}};
  const auto scene = gltf.read();
  ASSERT_TRUE(scene) << scene.error().message;
  EXPECT_FALSE(scene->meshes[0].extras.mount);
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
  TestGltf gltf = plainRoom();
  gltf.glb.json["buffers"] = {{{"byteLength", 300 << 20}}};
  std::string text = gltf.glb.json.dump();
  EXPECT_THAT(refusal(bytesOf(text)), HasSubstr("byteLength"));

  text = "{\"asset\":{\"version\":\"2.0\"},\"nodes\":[{}";
  for (int i = 0; i < 1000000; ++i) text += ",{}";
  EXPECT_THAT(refusal(bytesOf(text + "]}")), HasSubstr("more than 1 million nodes"));
}

TEST(HostileGltf, DracoWithGarbageIsRefusedByPlace) {
  TestGltf gltf = plainRoom();
  const std::vector<std::uint8_t> garbage(64, 0xd7);
  const int view = gltf.glb.addView(garbage.data(), garbage.size(), 0, 0);
  gltf.glb.json["extensionsUsed"] = gltf.glb.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  for (auto& mesh : gltf.glb.json["meshes"])
    mesh["primitives"][0]["extensions"] = {
        {"KHR_draco_mesh_compression", {{"bufferView", view}, {"attributes", {{"POSITION", 0}}}}}};
  for (auto& accessor : gltf.glb.json["accessors"]) accessor.erase("bufferView");
  EXPECT_THAT(refusal(gltf), HasSubstr("mesh 0"));
}

TEST(HostileGltf, JsonOfTheWrongShape) {
  std::size_t tried = 0, refused = 0;
  testing::forEachWrongShape(plainRoom, [&](TestGltf& gltf) {
    ++tried;
    const auto scene = gltf.read();
    if (scene) return;
    ++refused;
    EXPECT_EQ(scene.error().message.find('\n'), std::string::npos);
  });
  EXPECT_GT(refused, tried / 2);
}

}  // namespace
}  // namespace fiatlux
