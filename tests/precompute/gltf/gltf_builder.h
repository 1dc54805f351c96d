// Makes small glTF files for tests: boxes, planes, whatever a test wants to say in JSON.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/base/vec3.h"
#include "precompute/geometry/build_room.h"
#include "precompute/gltf/source_scene.h"
#include "precompute/picture/glb_writer.h"

namespace fiatlux::testing {

using nlohmann::ordered_json;

struct TestMesh {
  std::vector<std::array<float, 3>> positions;
  std::vector<std::uint32_t> indices;

  std::uint32_t add(const Vec3& p) {
    positions.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    return static_cast<std::uint32_t>(positions.size() - 1);
  }
  void triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    for (const Vec3& p : {a, b, c}) indices.push_back(add(p));
  }
  /// A parallelogram with its front along u x v, split into nu x nv quads of two triangles.
  void quad(const Vec3& origin, const Vec3& u, const Vec3& v, int nu = 1, int nv = 1) {
    for (int j = 0; j < nv; ++j)
      for (int i = 0; i < nu; ++i) {
        const auto at = [&](int a, int b) { return origin + (double(a) / nu) * u + (double(b) / nv) * v; };
        triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
  }
  /// A box; fronts inward (a room) or outward (a thing). Each side is split into cuts x cuts quads.
  void box(const Vec3& low, const Vec3& size, bool inward, int cuts = 1) {
    const Vec3 x{size.x, 0, 0}, y{0, size.y, 0}, z{0, 0, size.z};
    const auto side = [&](const Vec3& o, const Vec3& u, const Vec3& v) {
      inward ? quad(o, u, v, cuts, cuts) : quad(o, v, u, cuts, cuts);
    };
    side(low, z, x), side(low + y, x, z);  // floor, ceiling
    side(low, x, y), side(low + z, y, x);  // z = low, z = high
    side(low, y, z), side(low + x, z, y);  // x = low, x = high
  }
};

/// A file under construction; `glb.json` may be changed at will before bytes() is taken.
struct TestGltf {
  GlbWriter glb;

  TestGltf() { glb.json["scene"] = 0, glb.json["scenes"] = {{{"nodes", ordered_json::array()}}}; }

  int positions(const TestMesh& mesh) {
    const int view = glb.addView(mesh.positions.data(), mesh.positions.size() * 12, 0, 0);
    return glb.addAccessor(view, 5126, false, mesh.positions.size(), "VEC3");
  }
  int indices(const std::vector<std::uint32_t>& values) {
    return glb.addAccessor(glb.addView(values.data(), values.size() * 4, 0, 0), 5125, false, values.size(),
                           "SCALAR");
  }
  ordered_json primitive(const TestMesh& mesh, int material = -1) {
    ordered_json result = {{"attributes", {{"POSITION", positions(mesh)}}},
                           {"indices", indices(mesh.indices)}};
    if (material >= 0) result["material"] = material;
    return result;
  }
  int mesh(ordered_json primitives) { return glb.append("meshes", {{"primitives", std::move(primitives)}}); }
  int mesh(const TestMesh& m, int material = -1) {
    return mesh(ordered_json::array({primitive(m, material)}));
  }
  /// A root node; `more` is merged into it.
  int node(const std::string& name, int mesh, const ordered_json& more = ordered_json::object()) {
    ordered_json entry = {{"name", name}, {"mesh", mesh}};
    for (const auto& [key, value] : more.items()) entry[key] = value;
    const int index = glb.append("nodes", std::move(entry));
    glb.json["scenes"][0]["nodes"].push_back(index);
    return index;
  }
  int material(const std::string& name, double grey, const ordered_json& more = ordered_json::object()) {
    ordered_json entry = {{"name", name},
                          {"pbrMetallicRoughness", {{"baseColorFactor", {grey, grey, grey, 1}}}}};
    for (const auto& [key, value] : more.items()) entry[key] = value;
    return glb.append("materials", std::move(entry));
  }
  static ordered_json extras(const ordered_json& own) { return {{"extras", {{"fiatlux", own}}}}; }
  Result<SourceScene> read(double scale = 1) { return readSourceScene(glb.bytes(), "test.glb", scale); }
  Result<Room> build(const RoomOptions& options = {}) {
    auto source = read();
    return source ? buildRoom(*source, options) : Result<Room>(source.error());
  }
};

/// A closed room of one node per side: floor, ceiling (a mount when spacing > 0), walls.
inline TestGltf boxRoom(const Vec3& size, double spacing, int cuts = 1) {
  TestGltf gltf;
  const int grey = gltf.material("grey", 0.5);
  const Vec3 x{size.x, 0, 0}, y{0, size.y, 0}, z{0, 0, size.z};
  const auto side = [&](const char* name, const Vec3& o, const Vec3& u, const Vec3& v,
                        const ordered_json& more = ordered_json::object()) {
    TestMesh mesh;
    mesh.quad(o, u, v, cuts, cuts);
    gltf.node(name, gltf.mesh(mesh, grey), more);
  };
  side("floor", {}, z, x);
  side("ceiling", y, x, z,
       spacing > 0 ? TestGltf::extras({{"mount", true}, {"siteSpacing", spacing}}) : ordered_json::object());
  side("south", {}, x, y), side("north", z, y, x), side("west", {}, y, z), side("east", x, z, y);
  return gltf;
}

/// Calls visit(gltf) with every list of the file that `make` makes, every first entry of one and every member
/// of that replaced by something of another kind.
inline void forEachWrongShape(const std::function<TestGltf()>& make,
                              const std::function<void(TestGltf&)>& visit) {
  const ordered_json values[] = {
      nullptr, true, -1, 1e18, "text", ordered_json::array(), ordered_json::object(), {1, "x", nullptr}};
  for (const char* list : {"nodes", "meshes", "accessors", "bufferViews", "buffers", "materials", "scenes"})
    for (const ordered_json& value : values) {
      TestGltf whole = make(), first = make(), plain = make();
      whole.glb.json[list] = value;
      first.glb.json[list][0] = value;
      visit(whole), visit(first);
      for (const auto& [key, unused] : plain.glb.json[list][0].items()) {
        TestGltf inner = make();
        inner.glb.json[list][0][key] = value;
        visit(inner);
      }
    }
}

inline std::vector<std::string> surfaceNames(const Room& room) {
  std::vector<std::string> names;
  for (const Surface& surface : room.surfaces) names.push_back(surface.name);
  return names;
}

/// m2, without measuring planes.
inline double totalArea(const Room& room) {
  double area = 0;
  for (std::uint32_t p = 0; p < room.patches.count; ++p) area += room.patches.area[p];
  return area;
}

inline int surfaceIndex(const Room& room, const std::string& name) {
  for (std::size_t s = 0; s < room.surfaces.size(); ++s)
    if (room.surfaces[s].name == name) return static_cast<int>(s);
  return -1;
}

inline std::string allWarnings(const std::vector<std::string>& warnings) {
  std::string text;
  for (const std::string& w : warnings) text += w + "\n";
  return text;
}

}  // namespace fiatlux::testing
