// Compressed models are the same rooms as plain ones (packed_mesh, unpack); as Wasm they are refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "precompute/gltf/packed_mesh.h"
#include "tests/precompute/gltf/gltf_builder.h"

#ifndef __EMSCRIPTEN__
#include <draco/compression/encode.h>
#include <draco/mesh/triangle_soup_mesh_builder.h>
#include <meshoptimizer.h>
#endif

namespace fiatlux {
namespace {

using ::testing::HasSubstr;
using testing::ordered_json;
using testing::TestGltf;
using testing::TestMesh;
using Bytes = std::vector<std::uint8_t>;

/// A .gltf beside its one file of bytes.
struct Packed {
  ordered_json json = {{"asset", {{"version", "2.0"}}},
                       {"scene", 0},
                       {"scenes", {{{"nodes", {0}}}}},
                       {"nodes", {{{"name", "room"}, {"mesh", 0}}}}};
  Bytes bytes;

  ordered_json placeOf(const Bytes& part) {
    const std::size_t offset = bytes.size();
    bytes.insert(bytes.end(), part.begin(), part.end());
    return {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", part.size()}};
  }
  Result<SourceScene> read() {
    json["buffers"][0] = {{"uri", "packed.bin"}, {"byteLength", bytes.size()}};
    const std::string text = json.dump();
    return readSourceScene(
        Bytes(text.begin(), text.end()), "packed.gltf", 1,
        [&](const std::string&) -> Result<std::optional<Bytes>> { return std::optional(bytes); });
  }
  std::string fault() {
    const auto scene = read();
    return scene ? "read" : scene.error().message;
  }
};

TestMesh room() {
  TestMesh mesh;
  mesh.box({}, {4, 3, 5}, true, 6);
  return mesh;
}

#ifdef __EMSCRIPTEN__

TEST(Unpack, IsLeftToThePage) {
  TestGltf gltf;
  gltf.node("room", gltf.mesh(room()));
  gltf.glb.json["meshes"][0]["primitives"][0]["extensions"][kDraco] = {{"bufferView", 0}};
  gltf.glb.json["accessors"][0].erase("bufferView");
  const auto scene = gltf.read();
  ASSERT_FALSE(scene);
  EXPECT_THAT(scene.error().message, HasSubstr("export without compression"));
}

#else

/// One by one, whatever their order.
void expectSameTriangles(const SourceScene& scene, const TestMesh& mesh, double tolerance) {
  using Centre = std::array<double, 3>;
  const auto sorted = [](std::vector<Centre> centres) {
    for (Centre& centre : centres)
      for (double& x : centre) x = std::round(x * 100) / 100;
    std::sort(centres.begin(), centres.end());
    return centres;
  };
  std::vector<Centre> found, expected;
  double area = 0;
  for (const SourceMesh& part : scene.meshes)
    for (const auto& t : part.triangles) {
      const Vec3 a = part.positions[t[0]], b = part.positions[t[1]], c = part.positions[t[2]];
      const Vec3 centre = (1.0 / 3) * (a + b + c);
      found.push_back({centre.x, centre.y, centre.z});
      area += 0.5 * length(cross(b - a, c - a));
    }
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    Centre centre{};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t c = 0; c < 3; ++c) centre[c] += mesh.positions[mesh.indices[i + k]][c] / 3.0;
    expected.push_back(centre);
  }
  EXPECT_EQ(sorted(found), sorted(expected));
  EXPECT_NEAR(area, 2 * (4 * 3 + 4 * 5 + 3 * 5), tolerance);
}

Packed packedWithDraco() {
  const TestMesh mesh = room();
  draco::TriangleSoupMeshBuilder builder;
  const std::size_t triangles = mesh.indices.size() / 3;
  builder.Start(static_cast<int>(triangles));
  const int position = builder.AddAttribute(draco::GeometryAttribute::POSITION, 3, draco::DT_FLOAT32);
  for (std::size_t t = 0; t < triangles; ++t) {
    const auto corner = [&](std::size_t k) { return mesh.positions[mesh.indices[3 * t + k]].data(); };
    builder.SetAttributeValuesForFace(position, draco::FaceIndex(static_cast<std::uint32_t>(t)), corner(0),
                                      corner(1), corner(2));
  }
  const auto made = builder.Finalize();
  draco::Encoder encoder;
  encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, 14);
  draco::EncoderBuffer buffer;
  EXPECT_TRUE(encoder.EncodeMeshToBuffer(*made, &buffer).ok());
  Packed packed;
  packed.json["bufferViews"] = {packed.placeOf(Bytes(buffer.data(), buffer.data() + buffer.size()))};
  packed.json["accessors"] = {{{"componentType", 5126}, {"type", "VEC3"}, {"count", made->num_points()}},
                              {{"componentType", 5125}, {"type", "SCALAR"}, {"count", 3 * triangles}}};
  const ordered_json extension = {{"bufferView", 0}, {"attributes", {{"POSITION", 0}}}};
  packed.json["meshes"] = {
      {{"primitives",
        {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}, {"extensions", {{kDraco, extension}}}}}}}};
  packed.json["extensionsRequired"] = {kDraco};
  return packed;
}

/// As gltfpack does it: the second buffer is only where things are unpacked to.
Packed packedWithMeshopt() {
  TestMesh mesh = room();
  std::vector<float> filtered(mesh.positions.size() * 3);
  meshopt_encodeFilterExp(filtered.data(), mesh.positions.size(), 12, 20, mesh.positions[0].data());
  Bytes vertices(meshopt_encodeVertexBufferBound(mesh.positions.size(), 12));
  vertices.resize(meshopt_encodeVertexBuffer(vertices.data(), vertices.size(), filtered.data(),
                                             mesh.positions.size(), 12));
  Bytes corners(meshopt_encodeIndexBufferBound(mesh.indices.size(), mesh.positions.size()));
  corners.resize(
      meshopt_encodeIndexBuffer(corners.data(), corners.size(), mesh.indices.data(), mesh.indices.size()));
  Packed packed;
  std::size_t end = 0;
  const auto view = [&](const Bytes& part, std::size_t count, std::size_t stride, ordered_json more) {
    ordered_json extension = packed.placeOf(part);
    extension.update({{"count", count}, {"byteStride", stride}});
    extension.update(more);
    ordered_json made = {{"buffer", 1}, {"byteOffset", end}, {"byteLength", count * stride}};
    made["extensions"][kMeshopt] = extension;
    end += count * stride;
    return made;
  };
  packed.json["bufferViews"] = {
      view(vertices, mesh.positions.size(), 12, {{"mode", "ATTRIBUTES"}, {"filter", "EXPONENTIAL"}}),
      view(corners, mesh.indices.size(), 4, {{"mode", "TRIANGLES"}})};
  packed.json["buffers"][1] = {{"byteLength", end}, {"extensions", {{kMeshopt, {{"fallback", true}}}}}};
  packed.json["accessors"] = {
      {{"bufferView", 0}, {"componentType", 5126}, {"type", "VEC3"}, {"count", mesh.positions.size()}},
      {{"bufferView", 1}, {"componentType", 5125}, {"type", "SCALAR"}, {"count", mesh.indices.size()}}};
  packed.json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}};
  packed.json["extensionsRequired"] = {kMeshopt};
  return packed;
}

TEST(Unpack, DracoHoldsTheSameTriangles) {
  const auto scene = packedWithDraco().read();
  ASSERT_TRUE(scene) << scene.error().message;
  expectSameTriangles(*scene, room(), 0.05);
}

TEST(Unpack, MeshoptHoldsTheSameTriangles) {
  const auto scene = packedWithMeshopt().read();
  ASSERT_TRUE(scene) << scene.error().message;
  expectSameTriangles(*scene, room(), 1e-3);
}

TEST(Unpack, DamagedBytesAreToldAndNeverBelieved) {
  for (const auto& make : {packedWithDraco, packedWithMeshopt}) {
    Packed cut = make();
    cut.bytes.resize(cut.bytes.size() / 2);
    for (auto& view : cut.json["bufferViews"])
      for (auto* place : {&view, &view["extensions"][kMeshopt]})
        if (place->contains("byteLength") && place->value("buffer", 1) == 0)
          (*place)["byteOffset"] = 0, (*place)["byteLength"] = cut.bytes.size();
    EXPECT_THAT(cut.fault(), HasSubstr("damaged"));
    // Whatever bytes say, reading ends.
    for (std::size_t at = 0; at < 400; at += 3) {
      Packed turned = make();
      turned.bytes[at * 7 % turned.bytes.size()] ^= static_cast<std::uint8_t>(1 + at % 255);
      EXPECT_EQ(turned.fault().find('\n'), std::string::npos);
    }
  }
}

TEST(Unpack, ExtentsAndKindsThatLieAreTold) {
  const auto faultWith = [](const char* key, const ordered_json& value) {
    Packed packed = packedWithMeshopt();
    packed.json["bufferViews"][0]["extensions"][kMeshopt][key] = value;
    return packed.fault();
  };
  EXPECT_THAT(faultWith("count", 1'000'000), HasSubstr("unpacks to more than it has room for"));
  EXPECT_THAT(faultWith("byteLength", 1'000'000), HasSubstr("beyond"));
  EXPECT_THAT(faultWith("byteStride", 0), HasSubstr("room for"));
  EXPECT_THAT(faultWith("buffer", 7), HasSubstr("beyond"));
  EXPECT_THAT(faultWith("mode", "NEWER"), HasSubstr("of a newer kind"));
  EXPECT_THAT(faultWith("mode", 3), HasSubstr("not text"));
  EXPECT_THAT(faultWith("filter", "NEWER"), HasSubstr("of a newer kind"));

  Packed empty = packedWithMeshopt();
  empty.json["bufferViews"][0].erase("extensions");
  EXPECT_THAT(empty.fault(), HasSubstr("a buffer that holds nothing"));
  Packed other = packedWithDraco();
  other.json["meshes"][0]["primitives"][0]["extensions"][kDraco]["attributes"]["POSITION"] = 9;
  EXPECT_THAT(other.fault(), HasSubstr("an attribute of its compressed mesh is missing"));
}

#endif

}  // namespace
}  // namespace fiatlux
