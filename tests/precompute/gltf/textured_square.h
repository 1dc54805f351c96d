// A scene of one square with a picture of two texels.
#pragma once

#include <array>
#include <cstdint>

#include "precompute/gltf/source_scene.h"

namespace fiatlux::testing {

/// One square over uv [0, 1]^2 with a 2 x 1 texture: left black, right white (or another colour).
inline SourceScene texturedSquare(std::array<std::uint8_t, 3> right = {255, 255, 255}) {
  SourceScene scene;
  SourceImage image;
  image.width = 2, image.height = 1;
  image.rgba = {0, 0, 0, 255, right[0], right[1], right[2], 255};
  scene.images.push_back(image);
  SourceMaterial material;
  material.name = "paint";
  material.image = 0;
  scene.materials.push_back(material);
  SourceMesh mesh;
  mesh.node = "square", mesh.material = 0;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 0, -1}, {0, 0, -1}};
  mesh.uv = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  scene.meshes.push_back(mesh);
  return scene;
}

}  // namespace fiatlux::testing
