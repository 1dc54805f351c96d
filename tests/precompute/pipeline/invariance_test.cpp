// The same room said in another way has the same light; a room with faults has nearly the same, and says so
// (lost_light).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "precompute/light/lost_light.h"
#include "tests/precompute/gltf/gltf_builder.h"
#include "tests/precompute/transport_of.h"

namespace fiatlux {
namespace {

using ::testing::AllOf;
using testing::allWarnings;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::ordered_json;
using testing::surfaceIndex;
using testing::TestGltf;
using testing::TestMesh;
using testing::transportOf;

constexpr double kPatch = 0.25;  // m
const Vec3 kSize{3, 2.5, 4};     // m

/// How the furnished box is written down.
struct Writing {
  int cutsU = 1, cutsV = 1;                               // pieces of every rectangle
  double unit = 1;                                        // units of the file in a metre
  double crack = 0;                                       // m, by which every wall stands off
  bool flipEast = false;                                  // one wall looks outward
  std::function<void(TestMesh&)> spoil;                   // what else happens to a mesh
  ordered_json node = ordered_json::object();             // what every node carries
  std::function<void(TestGltf&, ordered_json&)> rewrite;  // what happens to a primitive
};

/// Two boxes of furniture in a room of one node a side, reflectances from 0.3 to 0.7; sites under the
/// ceiling.
TestGltf furnishedBox(const Writing& how = {}) {
  TestGltf gltf;
  const auto add = [&](const char* name, TestMesh mesh, int material, ordered_json extras = {}) {
    for (auto& p : mesh.positions)
      for (float& x : p) x = static_cast<float>(x * how.unit);
    if (how.spoil) how.spoil(mesh);
    ordered_json primitive = gltf.primitive(mesh, material);
    if (how.rewrite) how.rewrite(gltf, primitive);
    ordered_json node = how.node;
    if (!extras.is_null()) node.update(TestGltf::extras(extras));
    gltf.node(name, gltf.mesh(ordered_json::array({primitive})), node);
  };
  const int dark = gltf.material("dark", 0.3), grey = gltf.material("grey", 0.5),
            light = gltf.material("light", 0.7);
  const auto side = [&](const Vec3& o, const Vec3& u, const Vec3& v) {
    TestMesh mesh;
    mesh.quad(o, u, v, how.cutsU, how.cutsV);
    return mesh;
  };
  const Vec3 x{kSize.x, 0, 0}, y{0, kSize.y, 0}, z{0, 0, kSize.z};
  const double c = how.crack;
  add("floor", side({}, z, x), dark);
  add("ceiling", side(y, x, z), light, {{"mount", true}, {"siteSpacing", 1}});
  add("south", side({0, 0, -c}, x, y), grey), add("north", side(z + Vec3{0, 0, c}, y, x), grey);
  add("west", side({-c, 0, 0}, y, z), grey);
  add("east", how.flipEast ? side(x, y, z) : side(x + Vec3{c, 0, 0}, z, y), light);
  TestMesh cupboard, bench;
  cupboard.box({0.1, 0.1, 0.5}, {0.5, 1.5, 1}, false, how.cutsU);
  bench.box({1.5, 0.3, 2}, {0.75, 0.25, 1.25}, false, how.cutsU);
  add("cupboard", cupboard, light, {{"surface", "cupboard"}});
  add("bench", bench, grey, {{"surface", "bench"}});
  return gltf;
}

struct Lit {
  double mean = 0, sigma = 0, lost = 0;
};

struct RoomLight {
  std::map<std::string, Lit> surfaces;
  std::vector<std::string> warnings;
  std::uint32_t patches = 0;
};

using Move = std::function<Vec3(const Vec3&)>;
Vec3 stay(const Vec3& p) { return p; }

/// Surfaces under three luminaires that hang on the sites nearest to where `move` takes their places.
RoomLight lightOf(TestGltf gltf, double scale = 1, const Move& move = stay, const Vec3& from = {}) {
  RoomLight light;
  const auto source = gltf.read(scale);
  EXPECT_TRUE(source) << source.error().message;
  if (!source) return light;
  RoomOptions options;
  options.patch = kPatch;
  const auto room = buildRoom(*source, options);
  EXPECT_TRUE(room) << room.error().message;
  if (!room) return light;
  const auto transport = transportOf(*room);
  EXPECT_TRUE(transport) << transport.error().message;
  if (!transport) return light;

  const std::size_t m = room->sites.size();
  std::vector<double> flux(m, 0.0);
  for (const auto& [place, lumens] : {std::pair{Vec3{0.5, 2.5, 0.5}, 1000.0},
                                      {Vec3{1.5, 2.5, 2.5}, 700.0},
                                      {Vec3{2.5, 2.5, 3.5}, 1500.0}}) {
    const Vec3 at = move(place + from);
    const auto nearest = std::min_element(
        room->sites.begin(), room->sites.end(),
        [&](const Site& a, const Site& b) { return length(a.position - at) < length(b.position - at); });
    EXPECT_LT(length(nearest->position - at), 0.01);
    flux[nearest - room->sites.begin()] = lumens;
  }
  for (std::size_t s = 0; s < room->surfaces.size(); ++s) {
    const SurfaceStatistics& statistics = transport->illuminance[s];
    Lit& lit = light.surfaces[room->surfaces[s].name];
    double variance = 0;
    for (std::size_t i = 0; i < m; ++i) {
      lit.mean += flux[i] * statistics.mean[i];
      for (std::size_t j = 0; j < m; ++j) variance += flux[i] * flux[j] * statistics.covariance[i * m + j];
    }
    lit.sigma = std::sqrt(std::max(0.0, variance));
    lit.lost = transport->lost[s];
  }
  light.warnings = room->warnings;
  const auto tracer = RayTracer::build(*room);
  for (const std::string& warning : lostLight(*room, {}, *tracer).warnings) light.warnings.push_back(warning);
  light.patches = room->patches.count;
  return light;
}

const RoomLight& plain() {
  static const RoomLight light = lightOf(furnishedBox());
  return light;
}

/// Means within 0.5 %, sigmas within 2 % of the plainly written room.
void expectSame(const RoomLight& light, const std::string& how) {
  for (const auto& [name, expected] : plain().surfaces) {
    const auto found = light.surfaces.find(name);
    ASSERT_NE(found, light.surfaces.end()) << how << ": " << name;
    EXPECT_NEAR(found->second.mean / expected.mean, 1, 0.005) << how << ": mean of " << name;
    EXPECT_NEAR(found->second.sigma / expected.sigma, 1, 0.02) << how << ": sigma of " << name;
  }
  EXPECT_EQ(light.surfaces.size(), plain().surfaces.size()) << how;
}

Vec3 rotated(const ordered_json& quaternion, const Vec3& p) {
  const Vec3 q{quaternion[0], quaternion[1], quaternion[2]};
  const double w = quaternion[3];
  const Vec3 t = 2.0 * cross(q, p);
  return p + w * t + cross(q, t);
}

TEST(Invariance, ThePlainRoomIsClosedAndUnevenlyLit) {
  EXPECT_GT(plain().patches, 1000u);
  EXPECT_LT(plain().patches, 2000u);
  ASSERT_EQ(plain().surfaces.size(), 8u);
  for (const auto& [name, lit] : plain().surfaces) {
    EXPECT_EQ(lit.lost, 0) << name;
    EXPECT_GT(lit.sigma, 0.05 * lit.mean) << name;
  }
}

TEST(Invariance, HoweverTriangulated) {
  Writing finer, slivers;
  finer.cutsU = 5, finer.cutsV = 3;
  slivers.cutsU = 97;  // triangles a hundred times as long as wide
  expectSame(lightOf(furnishedBox(finer)), "finer");
  expectSame(lightOf(furnishedBox(slivers)), "slivers");
}

TEST(Invariance, IndexedOrNot) {
  Writing flat, shared;
  flat.rewrite = [](TestGltf&, ordered_json& primitive) { primitive.erase("indices"); };
  shared.cutsU = shared.cutsV = 4;
  shared.spoil = [](TestMesh& mesh) {  // equal corners become one vertex
    TestMesh welded;
    std::map<std::array<float, 3>, std::uint32_t> seen;
    for (const std::uint32_t i : mesh.indices) {
      const auto [at, fresh] =
          seen.try_emplace(mesh.positions[i], static_cast<std::uint32_t>(welded.positions.size()));
      if (fresh) welded.positions.push_back(mesh.positions[i]);
      welded.indices.push_back(at->second);
    }
    mesh = welded;
  };
  expectSame(lightOf(furnishedBox(flat)), "without indices");
  expectSame(lightOf(furnishedBox(shared)), "with shared vertices");
}

TEST(Invariance, InCentimetres) {
  Writing centimetres;
  centimetres.unit = 100;
  expectSame(lightOf(furnishedBox(centimetres), 0.01), "--scale 0.01");
}

TEST(Invariance, MirroredAndRotated) {
  Writing mirrored, turned;
  mirrored.node = {{"scale", {-1, 1, 1}}};
  expectSame(lightOf(furnishedBox(mirrored), 1,
                     [](const Vec3& p) {
                       return Vec3{-p.x, p.y, p.z};
                     }),
             "mirrored");
  // 37 degrees about (1, 2, 3): no axis of the room stays an axis of the world.
  const double s = std::sin(0.3229) / std::sqrt(14.0), c = std::cos(0.3229);
  turned.node = {{"rotation", {s, 2 * s, 3 * s, c}}};
  expectSame(
      lightOf(furnishedBox(turned), 1, [&](const Vec3& p) { return rotated(turned.node["rotation"], p); }),
      "rotated");
}

TEST(Invariance, WithQuantisedVertices) {
  // 12 bits over 4 m: vertices move by up to half a millimetre.
  Writing quantised;
  quantised.spoil = [](TestMesh& mesh) {
    for (auto& p : mesh.positions)
      for (float& x : p) x = std::round(x * 4095 / 4.13f);
  };
  quantised.node = {{"scale", {4.13 / 4095, 4.13 / 4095, 4.13 / 4095}}};
  quantised.rewrite = [](TestGltf& gltf, ordered_json& primitive) {
    // The floats of this accessor again, as 16-bit numbers.
    const int accessor = primitive["attributes"]["POSITION"];
    const std::size_t count = gltf.glb.json["accessors"][accessor]["count"];
    std::vector<std::uint8_t> glb = gltf.glb.bytes();
    const std::size_t offset =
        gltf.glb
            .json["bufferViews"][gltf.glb.json["accessors"][accessor]["bufferView"].get<int>()]["byteOffset"];
    const std::size_t bin = 12 + 8 + (glb[12] | glb[13] << 8 | glb[14] << 16) + 8;
    std::vector<std::array<std::uint16_t, 4>> packed(count);
    for (std::size_t i = 0; i < count; ++i) {
      std::array<float, 3> p;
      std::copy_n(glb.begin() + static_cast<std::ptrdiff_t>(bin + offset + 12 * i), 12,
                  reinterpret_cast<std::uint8_t*>(p.data()));
      for (int c = 0; c < 3; ++c) packed[i][c] = static_cast<std::uint16_t>(p[c]);
    }
    const int view = gltf.glb.addView(packed.data(), 8 * count, 8, 0);
    primitive["attributes"]["POSITION"] = gltf.glb.addAccessor(view, 5123, false, count, "VEC3");
    gltf.glb.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  };
  const RoomLight light = lightOf(furnishedBox(quantised));
  expectSame(light, "quantised");
}

TEST(Invariance, CracksOfAMillimetreLoseLittleAndSaySo) {
  Writing cracked;
  cracked.crack = 0.001;
  const RoomLight light = lightOf(furnishedBox(cracked));
  expectSame(light, "cracked");
  double lost = 0;
  for (const auto& [name, lit] : light.surfaces) {
    EXPECT_LT(lit.lost, 0.01) << name;
    lost = std::max(lost, lit.lost);
  }
  EXPECT_GT(lost, 0);
  EXPECT_THAT(light.warnings, IsEmpty());  // a few hundredths of a per cent are not worth a line
}

TEST(Invariance, TrianglesWithoutAreaAndTwiceTheSame) {
  Writing spoilt;
  spoilt.spoil = [](TestMesh& mesh) {
    const std::size_t before = mesh.indices.size();
    for (std::size_t i = 0; i < before; ++i) mesh.indices.push_back(mesh.indices[i]);  // all of it again
    mesh.indices.insert(mesh.indices.end(), {mesh.indices[0], mesh.indices[1], mesh.indices[1]});
  };
  const RoomLight light = lightOf(furnishedBox(spoilt));
  expectSame(light, "spoilt");
  EXPECT_THAT(allWarnings(light.warnings), HasSubstr("triangles without area are left out: 8"));
  EXPECT_THAT(allWarnings(light.warnings), HasSubstr("triangles that repeat others are left out"));
}

TEST(Invariance, AFlippedWallIsTurnedAndReported) {
  Writing flipped;
  flipped.flipEast = true;
  const RoomLight light = lightOf(furnishedBox(flipped));
  expectSame(light, "flipped");
  EXPECT_THAT(light.warnings,
              ElementsAre(HasSubstr("10 m2 have one side, which looks away from the room they "
                                    "enclose, and are turned: 'east' 10 m2")));
}

/// A room A of 3 x 2.5 x 4 m and beyond a wall of 0.25 m another, B, of the same size; perhaps a door
/// between.
TestGltf twoRooms(bool door) {
  TestGltf gltf;
  const int grey = gltf.material("grey", 0.5);
  const auto add = [&](const std::string& name, const TestMesh& mesh, ordered_json more = {}) {
    gltf.node(name, gltf.mesh(mesh, grey), more.is_null() ? ordered_json::object() : more);
  };
  const Vec3 y{0, 2.5, 0}, z{0, 0, 4};
  for (const bool second : {false, true}) {
    const std::string room = second ? "B " : "A ";
    const double at = second ? 3.25 : 0;
    const Vec3 o{at, 0, 0}, x{3, 0, 0};
    TestMesh floor, ceiling, rest, shared;
    floor.quad(o, z, x), ceiling.quad(o + y, x, z);
    rest.quad(o, x, y), rest.quad(o + z, y, x);
    second ? rest.quad(o + x, z, y) : rest.quad(o, y, z);
    const auto piece = [&](double z0, double z1, double y0, double y1) {
      const Vec3 corner{second ? at : 3, y0, z0}, along{0, 0, z1 - z0}, up{0, y1 - y0, 0};
      second ? shared.quad(corner, up, along) : shared.quad(corner, along, up);
    };
    if (door)
      piece(0, 1.5, 0, 2.5), piece(2.5, 4, 0, 2.5), piece(1.5, 2.5, 2, 2.5);
    else
      piece(0, 4, 0, 2.5);
    add(room + "floor", floor), add(room + "walls", rest, TestGltf::extras({{"surface", room + "walls"}}));
    add(room + "partition", shared);
    add(room + "ceiling", ceiling,
        second ? ordered_json{} : TestGltf::extras({{"mount", true}, {"siteSpacing", 1}}));
  }
  if (door) {
    TestMesh frame;
    const Vec3 o{3, 0, 1.5}, x{0.25, 0, 0}, up{0, 2, 0}, along{0, 0, 1};
    frame.quad(o, along, x), frame.quad(o + up, x, along);
    frame.quad(o, x, up), frame.quad(o + along, up, x);
    add("frame", frame, TestGltf::extras({{"surface", "frame"}}));
  }
  return gltf;
}

/// Largest and smallest mean of the surfaces whose names begin so.
std::pair<double, double> rangeOf(const RoomLight& light, const std::string& prefix) {
  double low = 1e30, high = 0;
  for (const auto& [name, lit] : light.surfaces) {
    if (name.rfind(prefix, 0) != 0) continue;
    low = std::min(low, lit.mean), high = std::max(high, lit.mean);
  }
  return {low, high};
}

TEST(Invariance, LightGoesThroughADoorAndNotThroughAWall) {
  const RoomLight open = lightOf(twoRooms(true)), closed = lightOf(twoRooms(false));
  // Room B is lit by the door alone: the flux that comes through, spread by its walls of 0.5.
  EXPECT_GT(rangeOf(open, "B").first, 0.002 * rangeOf(open, "A").second);
  EXPECT_LT(rangeOf(open, "B").second, 0.2 * rangeOf(open, "A").second);
  EXPECT_LE(rangeOf(closed, "B").second, 1e-6 * rangeOf(closed, "A").second);
  // Without the door A keeps what went through it.
  EXPECT_LT(open.surfaces.at("A walls").mean, closed.surfaces.at("A walls").mean);
  for (const auto* light : {&open, &closed})
    for (const auto& [name, lit] : light->surfaces) EXPECT_EQ(lit.lost, 0) << name;
}

TEST(Invariance, ATableTopIsLitOnBothSides) {
  TestGltf gltf = testing::boxRoom(kSize, 1);
  TestMesh top;
  top.quad({1, 0.75, 1}, {0, 0, 2}, {1, 0, 0});
  gltf.node("table", gltf.mesh(top, gltf.material("wood", 0.5, {{"doubleSided", true}})));
  const RoomLight light = lightOf(gltf);
  const Lit &above = light.surfaces.at("table"), &below = light.surfaces.at("table (back)");
  EXPECT_GT(above.mean, 2 * below.mean);  // direct light above, only reflected light below
  EXPECT_GT(below.mean, 0.05 * above.mean);
  for (const auto& [name, lit] : light.surfaces) EXPECT_EQ(lit.lost, 0) << name;

  // One-sided, it hides the floor from above and swallows what comes from below.
  TestGltf thin = testing::boxRoom(kSize, 1);
  thin.node("table", thin.mesh(top, thin.material("wood", 0.5)));
  const RoomLight swallowed = lightOf(thin);
  EXPECT_EQ(swallowed.surfaces.count("table (back)"), 0u);
  EXPECT_GT(swallowed.surfaces.at("floor").lost, 0.03);
  EXPECT_THAT(swallowed.warnings, ElementsAre(HasSubstr("swallowed by backs, those of 'table' (")));
  EXPECT_EQ(swallowed.surfaces.at("ceiling").lost, 0);
}

TEST(Invariance, AnOpenRoomSaysWhatItLoses) {
  // Without the north wall: the south wall sees it by the form factor of opposed rectangles 3 x 2.5 at 4 m.
  TestGltf gltf = testing::boxRoom(kSize, 1);
  auto& nodes = gltf.glb.json["scenes"][0]["nodes"];
  nodes.erase(std::find_if(nodes.begin(), nodes.end(), [&](const ordered_json& node) {
    return gltf.glb.json["nodes"][node.get<int>()]["name"] == "north";
  }));
  const RoomLight light = lightOf(gltf);
  const double a = kSize.x / kSize.z, b = kSize.y / kSize.z, pi = std::acos(-1.0);
  const double factor =
      2 / (pi * a * b) *
      (std::log(std::sqrt((1 + a * a) * (1 + b * b) / (1 + a * a + b * b))) +
       a * std::sqrt(1 + b * b) * std::atan(a / std::sqrt(1 + b * b)) +
       b * std::sqrt(1 + a * a) * std::atan(b / std::sqrt(1 + a * a)) - a * std::atan(a) - b * std::atan(b));
  EXPECT_NEAR(light.surfaces.at("south").lost, factor, 0.02 * factor);
  EXPECT_NEAR(light.surfaces.at("east").lost, light.surfaces.at("west").lost, 0.005);
  EXPECT_EQ(light.surfaces.count("north"), 0u);
  EXPECT_THAT(light.warnings,
              ElementsAre(AllOf(HasSubstr("the room is open"), HasSubstr("it leaves to the south (100 %)"))));
}

}  // namespace
}  // namespace fiatlux
