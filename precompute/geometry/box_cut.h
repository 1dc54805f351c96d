// What of a mesh lies within a box: its triangles end at the sides, with all that their corners say.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "precompute/gltf/source_scene.h"
#include "precompute/room/bounds.h"

namespace fiatlux {

/// A mesh as it is rebuilt, triangle by triangle. `from` must outlive it.
class BoxCut {
 public:
  explicit BoxCut(const SourceMesh& from);

  /// Takes a triangle of `from` over, as far as it lies in the box.
  void add(const std::array<std::uint32_t, 3>& triangle, const Bounds& box);
  SourceMesh take() { return std::move(mesh_); }

 private:
  struct Corner {
    Vec3 position;
    std::array<float, 3> normal{};
    std::array<float, 2> uv{};
    std::array<float, 4> color{};
  };
  using Polygon = std::vector<Corner>;

  static Polygon cutAt(const Polygon& polygon, double Vec3::*axis, double sign, double limit);
  Corner cornerOf(std::uint32_t vertex) const;
  std::uint32_t kept(std::uint32_t vertex);
  void append(const Corner& corner);

  const SourceMesh& from_;
  SourceMesh mesh_;
  std::map<std::uint32_t, std::uint32_t> taken_;  // vertices that stay as they are
};

}  // namespace fiatlux
