#include "precompute/validation/generated_scene.h"

#include <cmath>
#include <numbers>

#include "precompute/geometry/build_room.h"
#include "precompute/rays/hemisphere.h"

namespace fiatlux {

SourceScene sceneOfRectangles(const std::vector<RectangleSurface>& rectangles) {
  SourceScene scene;
  for (const RectangleSurface& r : rectangles) {
    SourceMesh mesh;
    mesh.node = r.name;
    mesh.nodeIndex = static_cast<std::uint32_t>(scene.meshes.size());
    mesh.extras.reflectance = r.reflectance;
    mesh.extras.measure = r.measuring;
    mesh.positions = {r.corner, r.corner + r.u, r.corner + r.u + r.v, r.corner + r.v};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    scene.meshes.push_back(std::move(mesh));
  }
  return scene;
}

SourceMesh discMesh(const std::string& name, const Vec3& center, const Vec3& normal, double radius,
                    std::uint32_t sides) {
  const Frame frame(normal);
  SourceMesh mesh;
  mesh.node = name;
  mesh.extras.reflectance = 0;
  mesh.positions.push_back(center);
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double angle = 2 * std::numbers::pi * i / sides;
    mesh.positions.push_back(center + (radius * std::cos(angle)) * frame.x +
                             (radius * std::sin(angle)) * frame.y);
    mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % sides});
  }
  return mesh;
}

SourceMesh sphereMesh(const std::string& name, const Vec3& center, double radius, std::uint32_t rings) {
  SourceMesh mesh;
  mesh.node = name;
  mesh.extras.reflectance = 0;
  const std::uint32_t columns = 2 * rings;
  for (std::uint32_t ring = 0; ring <= rings; ++ring) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      const double polar = std::numbers::pi * ring / rings, around = 2 * std::numbers::pi * column / columns;
      mesh.positions.push_back(center + radius * Vec3{std::sin(polar) * std::cos(around), std::cos(polar),
                                                      std::sin(polar) * std::sin(around)});
    }
  }
  for (std::uint32_t ring = 0; ring < rings; ++ring) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      const std::uint32_t next = (column + 1) % columns;
      const std::uint32_t a = ring * columns + column, b = ring * columns + next;
      const std::uint32_t c = a + columns, d = b + columns;
      if (ring > 0) mesh.triangles.push_back({a, c, b});  // at a pole one of the two has no area
      if (ring + 1 < rings) mesh.triangles.push_back({b, c, d});
    }
  }
  // Fronts look at the centre.
  const auto& [i, j, k] = mesh.triangles[mesh.triangles.size() / 2];
  const Vec3 &p = mesh.positions[i], &q = mesh.positions[j], &r = mesh.positions[k];
  if (dot(cross(q - p, r - p), center - p) < 0) {
    for (auto& triangle : mesh.triangles) std::swap(triangle[1], triangle[2]);
  }
  return mesh;
}

Result<TracedRoom> roomOf(const SourceScene& scene, double patch) {
  RoomOptions options;
  options.patch = patch;
  options.requireSites = false;
  return buildTracedRoom(scene, options);
}

}  // namespace fiatlux
