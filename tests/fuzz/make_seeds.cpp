// fuzz_seeds <folder>: writes the corpus from which each fuzz target starts, one folder a target. Valid
// files, made by the project's own writers, that between them take the branches a sound file can take.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/scene/opening_light.h"
#include "core/scene/scene_sections.h"
#include "precompute/files/scene_io.h"
#include "tests/core/corridor_scene.h"
#include "tests/core/operator_scene.h"
#include "tests/core/photometry/photometric_files.h"
#include "tests/core/scene/base64.h"
#include "tests/core/scene/golden_scene_v1.h"
#include "tests/core/synthetic_scene.h"
#include "tests/precompute/gltf/gltf_builder.h"

namespace fiatlux {
namespace {

using testing::boxRoom;
using testing::ordered_json;
using testing::TestGltf;
using testing::TestMesh;
using Bytes = std::vector<std::uint8_t>;

void write(const std::filesystem::path& path, const Bytes& bytes) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!file) throw std::runtime_error(path.string() + ": cannot be written");
}

// --- glTF: small rooms, so that patches and display meshes cost little
// ---------------------------------------------------

// A PNG of 2 x 1 pixels, grey and white.
constexpr std::uint8_t kPng[] = {0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d,
                                 0x49, 0x48, 0x44, 0x52, 0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x01,
                                 0x08, 0x02, 0x00, 0x00, 0x00, 0x7b, 0x40, 0xe8, 0xdd, 0x00, 0x00, 0x00,
                                 0x0f, 0x49, 0x44, 0x41, 0x54, 0x78, 0xda, 0x63, 0x68, 0x68, 0x68, 0xf8,
                                 0xff, 0xff, 0x3f, 0x00, 0x0d, 0x81, 0x04, 0x7e, 0x99, 0x07, 0xea, 0x81,
                                 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
constexpr const char* kPngUri =
    "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAIAAAB7QOjdAAAAD0lEQVR42mNoaGj4//8/"
    "AA2BBH6ZB+qBAAAAAElFTkSuQmCC";

/// Nodes a side, a marked ceiling, a table on nested transforms, a measuring plane, glass and a double-sided
/// sheet.
TestGltf furnishedRoom() {
  TestGltf gltf = boxRoom({2, 2, 3}, 1);
  TestMesh table, plane, sheet;
  table.box({0, 0, 0}, {0.5, 0.4, 0.5}, false);
  const int top = gltf.mesh(table, gltf.material("oak", 0.3));
  const int inner = gltf.glb.append("nodes", {{"name", "table"}, {"mesh", top}, {"scale", {1, 1, -1}}});
  gltf.node("furniture", -1,
            {{"children", {inner}}, {"translation", {0.5, 0, 1}}, {"rotation", {0, 0.6, 0, 0.8}}});
  gltf.glb.json["nodes"].back().erase("mesh");
  plane.quad({0.2, 0.75, 0.2}, {0, 0, 2}, {1.5, 0, 0});
  gltf.node("working plane", gltf.mesh(plane), TestGltf::extras({{"measure", true}}));
  sheet.quad({1, 0.5, 0.5}, {0, 0, 0.6}, {0, 0.6, 0});
  gltf.node("glass", gltf.mesh(sheet, gltf.material("glass", 0.9, {{"alphaMode", "BLEND"}})));
  gltf.node("screen", gltf.mesh(sheet, gltf.material("cloth", 0.6, {{"doubleSided", true}})),
            {{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.3, 0, 0.5, 1}},
             {"extras", {{"fiatlux", {{"surface", "screen"}, {"reflectance", 0.55}}}}}});
  return gltf;
}

/// One mesh for the whole room, without a mark, so that regions are found and a ceiling is proposed.
TestGltf oneMeshRoom() {
  TestGltf gltf;
  TestMesh mesh;
  mesh.box({}, {1.5, 1.5, 2}, true);
  gltf.node("room", gltf.mesh(mesh, gltf.material("paint", 0.7)));
  return gltf;
}

/// A room whose floor is textured (image in the file), its vertices short integers, some of them changed
/// sparsely.
TestGltf texturedRoom() {
  TestGltf gltf = boxRoom({1.5, 1.5, 2}, 0.5);
  const int view = gltf.glb.addView(kPng, sizeof kPng, 0, 0);
  gltf.glb.append("images", {{"bufferView", view}, {"mimeType", "image/png"}});
  gltf.glb.append("samplers", {{"wrapS", 33071}, {"wrapT", 33648}});
  gltf.glb.append("textures", {{"source", 0}, {"sampler", 0}});
  gltf.glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {
      {"index", 0}, {"extensions", {{"KHR_texture_transform", {{"offset", {0.1, 0}}, {"scale", {2, 2}}}}}}};
  const float uv[12] = {0, 0, 0, 1, 1, 1, 0, 0, 1, 1, 1, 0}, colors[18] = {1, 1, 1, 0.5f};
  const int uvs = gltf.glb.addAccessor(gltf.glb.addView(uv, sizeof uv, 0, 0), 5126, false, 6, "VEC2");
  const int tints =
      gltf.glb.addAccessor(gltf.glb.addView(colors, sizeof colors, 0, 0), 5126, false, 6, "VEC3");
  ordered_json& floor = gltf.glb.json["meshes"][0]["primitives"][0]["attributes"];
  floor["TEXCOORD_0"] = uvs, floor["COLOR_0"] = tints;
  const std::uint16_t index = 2;
  const float value[3] = {1.5f, 0, 2};
  const int indices = gltf.glb.addView(&index, 2, 0, 0), values = gltf.glb.addView(value, 12, 0, 0);
  gltf.glb.json["accessors"][0]["sparse"] = {{"count", 1},
                                             {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                                             {"values", {{"bufferView", values}}}};
  return gltf;
}

/// A square above a floor: strips and fans, normalized short vertices, byte indices, in plain JSON.
TestGltf quantisedSquares() {
  TestGltf gltf;
  const std::int16_t square[16] = {0, 0, 0, 0, 32767, 0, 0, 0, 0, 0, 32767, 0, 32767, 0, 32767, 0};
  const std::uint8_t strip[4] = {0, 1, 2, 3}, fan[4] = {0, 2, 3, 1};
  const int view = gltf.glb.addView(square, sizeof square, 8, 0);
  const int points = gltf.glb.addAccessor(view, 5122, true, 4, "VEC3");
  const auto primitive = [&](const std::uint8_t* order, int mode) {
    const int indices = gltf.glb.addAccessor(gltf.glb.addView(order, 4, 0, 0), 5121, false, 4, "SCALAR");
    return ordered_json{{"attributes", {{"POSITION", points}}}, {"indices", indices}, {"mode", mode}};
  };
  gltf.glb.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  gltf.node("down", gltf.mesh(ordered_json::array({primitive(strip, 5)})),
            {{"scale", {2, 1, 2}}, {"translation", {0, 2, 0}}, {"extras", {{"fiatlux", {{"mount", true}}}}}});
  gltf.node("up", gltf.mesh(ordered_json::array({primitive(fan, 6)})), {{"scale", {2, 1, 2}}});
  return gltf;
}

/// A room as plain JSON, its buffer and its image in data addresses.
std::string plainJson() {
  TestGltf gltf;
  TestMesh floor;
  floor.quad({}, {0, 0, 2}, {2, 0, 0});
  floor.quad({0, 2, 0}, {2, 0, 0}, {0, 0, 2});
  gltf.node("slabs", gltf.mesh(floor, gltf.material("tiled", 1)));
  gltf.glb.append("images", {{"uri", kPngUri}});
  gltf.glb.append("textures", {{"source", 0}});
  gltf.glb.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
  const Bytes glb = gltf.glb.bytes();
  const std::size_t text = glb[12] | glb[13] << 8, bin = 28 + text;
  static const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string uri = "data:application/octet-stream;base64,";
  for (std::size_t i = bin; i < glb.size(); i += 3) {
    const auto at = [&](std::size_t k) { return k < glb.size() ? std::uint32_t{glb[k]} : 0u; };
    const std::uint32_t bits = at(i) << 16 | at(i + 1) << 8 | at(i + 2);
    for (int shift = 18; shift >= 0; shift -= 6) uri += kDigits[bits >> shift & 63];
  }
  ordered_json json = gltf.glb.json;
  json["buffers"][0]["uri"] = uri;
  return json.dump();
}

void writeRooms(const std::filesystem::path& folder) {
  write(folder / "furnished.glb", furnishedRoom().glb.bytes());
  write(folder / "one-mesh.glb", oneMeshRoom().glb.bytes());
  write(folder / "textured.glb", texturedRoom().glb.bytes());
  write(folder / "quantised.glb", quantisedSquares().glb.bytes());
  const std::string text = plainJson();
  write(folder / "plain.gltf", {text.begin(), text.end()});
}

// --- scene files
// -----------------------------------------------------------------------------------------------------

Bytes sceneFile(const Scene& scene, bool deflate) {
  std::vector<PlainSection> plain = encodeScene(scene).value();
  const Layout layout{{0}, {1000}, 1};
  insertEarly(plain, encodeOpening(scene.patches, static_cast<std::uint32_t>(scene.surfaces.size()),
                                   {layout, illuminanceOf(scene, layout)}));
  const std::string provenance = R"({"rays": 16})";
  plain.push_back(plainSection("provenance", ElementType::kUint8, Encoding::kPlain,
                               static_cast<std::uint32_t>(provenance.size()), 1,
                               {provenance.begin(), provenance.end()}));
  if (deflate) return assembleSceneFile(scene.identity, countsOf(scene), storeSections(plain, zlibDeflate));
  std::vector<StoredSection> stored;
  for (PlainSection& part : plain) stored.push_back({part.section, std::move(part.bytes)});
  return assembleSceneFile(scene.identity, countsOf(scene), stored);
}

void writeScenes(const std::filesystem::path& folder) {
  const Scene small = syntheticScene(2, 2), wide = syntheticScene(4, 9);
  write(folder / "version-1.flux", fromBase64(kSceneFileVersion1));
  write(folder / "small.flux", sceneFile(small, false));
  write(folder / "small-deflated.flux", sceneFile(small, true));
  write(folder / "wide.flux", sceneFile(wide, false));
  write(folder / "operator.flux", sceneFile(operatorScene(4, 2), false));
  write(folder / "operator-deflated.flux", sceneFile(operatorScene(8, 3), true));
  write(folder / "box-deflated.flux", sceneFile(testing::syntheticScene(testing::boxPlan(3, 2, 2), 1), true));
}

// --- photometric files, every format, type and symmetry
// --------------------------------------------------------------

void writeText(const std::filesystem::path& path, const std::string& text) {
  write(path, Bytes(text.begin(), text.end()));
}

void writePhotometry(const std::filesystem::path& folder) {
  using samples::angles;
  const auto shape = [](double c, double gamma) { return std::round(100 + c / 4 + gamma / 2); };
  const char* const tags[] = {"", "IESNA91", "IESNA:LM-63-1995", "IESNA:LM-63-2002", "IES:LM-63-2019"};
  const std::vector<double> planes[] = {
      {0}, angles(0, 90, 30), angles(0, 180, 30), angles(90, 270, 30), angles(0, 330, 30)};
  for (std::size_t i = 0; i < 5; ++i) {
    samples::IesFile ies;
    ies.tag = tags[i], ies.c = planes[i], ies.gamma = angles(0, 180, 30), ies.candela = shape;
    if (i == 1) ies.tilt = "TILT=INCLUDE\n1\n2\n0 90\n1 0.9";
    writeText(folder / ("type-c-" + std::to_string(i) + ".ies"), ies.text());
    samples::LdtFile ldt;
    ldt.symmetry = static_cast<int>(i), ldt.gamma = angles(0, 180, 30), ldt.perKilolumen = shape;
    if (i != 1) ldt.c = angles(0, 330, 30);
    writeText(folder / ("symmetry-" + std::to_string(i) + ".ldt"), ldt.text());
  }
  for (const int type : {2, 3}) {
    samples::IesFile beam;
    beam.type = type, beam.candela = [](double h, double v) { return 200 - std::abs(h) - std::abs(v); };
    beam.gamma = angles(-90, 90, 30), beam.c = angles(type == 2 ? 0 : -90, 90, 30);
    writeText(folder / ("beam-" + std::to_string(type) + ".ies"), beam.text());
  }
  writeText(folder / "product.xml", "<?xml version=\"1.0\"?><File>a.ldt</File>");
}

}  // namespace
}  // namespace fiatlux

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "fuzz_seeds: say into which folder\n");
    return 2;
  }
  try {
    const std::filesystem::path folder = arguments[1];
    fiatlux::writeRooms(folder / "gltf_fuzz");
    fiatlux::writeScenes(folder / "scene_file_fuzz");
    fiatlux::writePhotometry(folder / "photometry_fuzz");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "fuzz_seeds: %s\n", error.what());
    return 1;
  }
}
