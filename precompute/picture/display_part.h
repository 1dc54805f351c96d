// A piece of the picture: triangles of one surface and one material, whose vertices know the patches they
// blend.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "precompute/gltf/source_scene.h"
#include "precompute/picture/glb_writer.h"
#include "precompute/picture/patch_blend.h"

namespace fiatlux {

/// A vertex of the picture.
struct Vertex {
  std::array<float, 3> position{};
  std::array<std::int8_t, 4> normal{};
  std::array<float, 2> uv{};
  std::array<std::uint8_t, 4> color{255, 255, 255, 255};
  PatchBlend blend;
  bool operator==(const Vertex&) const = default;
};

struct VertexHash {
  std::size_t operator()(const Vertex& v) const {
    std::uint64_t h = 0xcbf29ce484222325ull;
    const auto add = [&](const void* bytes, std::size_t size) {
      const auto* at = static_cast<const unsigned char*>(bytes);
      for (std::size_t i = 0; i < size; ++i) h = (h ^ at[i]) * 0x100000001b3ull;
    };
    add(&v.position, sizeof v.position), add(&v.normal, sizeof v.normal), add(&v.uv, sizeof v.uv),
        add(&v.color, sizeof v.color);
    add(&v.blend.patch[0], sizeof v.blend.patch[0]);
    return h;
  }
};

/// One primitive: the faces of one surface that share a material.
struct Part {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
  std::vector<std::uint32_t> charts;  // of the room, one per triangle; kNone for what is not lit
  std::unordered_map<Vertex, std::uint32_t, VertexHash> known;
  bool textured = false, colored = false, lit = true;

  std::uint32_t vertex(const Vertex& v) {
    const auto [found, fresh] = known.emplace(v, static_cast<std::uint32_t>(vertices.size()));
    if (fresh) vertices.push_back(v);
    return found->second;
  }
  void triangle(const Vertex& a, const Vertex& b, const Vertex& c, std::uint32_t chart) {
    for (const Vertex* v : {&a, &b, &c}) indices.push_back(vertex(*v));
    charts.push_back(chart);
  }
};

/// Numbers that differ only by noise become equal, and short for a compressor.
inline float tidy(double x, double steps) {
  // note: halves go up whatever the noise, and there is no -0
  return static_cast<float>(std::floor(x * steps + 0.501) / steps + 0.0);
}

constexpr double kPositionSteps = 16384;  // in a metre
constexpr double kUvSteps = 65536;        // in a texture

inline std::array<float, 3> tidyPosition(const Vec3& p) {
  return {tidy(p.x, kPositionSteps), tidy(p.y, kPositionSteps), tidy(p.z, kPositionSteps)};
}

inline std::array<std::int8_t, 4> packedNormal(const Vec3& n) {
  const auto byte = [](double x) {
    return static_cast<std::int8_t>(std::lround(127 * std::clamp(x, -1.0, 1.0)));
  };
  return {byte(n.x), byte(n.y), byte(n.z), 0};
}

using PartKey = std::tuple<std::uint32_t, int>;  // surface, material
using Parts = std::map<PartKey, Part>;

/// Adds the source's materials with their textures to a .glb under construction.
void packMaterials(GlbWriter& glb, const SourceScene& source);

/// Adds a part as a node with a mesh of its own; `rows` tells how wide patch indices must be.
void packPart(GlbWriter& glb, const Part& part, int material, std::uint32_t rows, const std::string& name,
              nlohmann::ordered_json extras);

}  // namespace fiatlux
