// How much light a point of the source reflects: luminance of its linear base colour. Metal, gloss and glow
// are ignored.
#pragma once

#include <string>
#include <vector>

#include "precompute/gltf/source_scene.h"

namespace fiatlux {

inline constexpr double kMostReflectance = 0.95;  // a closed room of 1 has no finite light

/// Of linear red, green and blue.
inline double luminanceOf(double r, double g, double b) { return 0.2126 * r + 0.7152 * g + 0.0722 * b; }

/// Reads colours of a scene, which must outlive it.
class ReflectanceMap {
 public:
  /// By mesh and triangle: what is assumed instead of colours; empty for a mesh whose own colours count.
  using Assumed = std::vector<std::vector<float>>;

  explicit ReflectanceMap(const SourceScene& source, const Assumed* assumed = nullptr);

  const SourceScene& source() const { return source_; }

  /// True when `at` is the same everywhere on a mesh.
  bool isConstant(std::uint32_t mesh) const;

  /// Linear colour of the material at a point of a triangle of a mesh, given by its barycentric weights.
  std::array<double, 3> colorAt(std::uint32_t mesh, std::uint32_t triangle,
                                const std::array<double, 3>& weights) const;

  /// Luminance 0..1 there, or what was said or assumed instead; not yet clamped to 0.95.
  double at(std::uint32_t mesh, std::uint32_t triangle, const std::array<double, 3>& weights) const;

  /// What a message calls the mesh's material.
  std::string materialName(std::uint32_t mesh) const;

 private:
  bool isAssumed(std::uint32_t mesh) const { return assumed_ && !(*assumed_)[mesh].empty(); }

  const SourceScene& source_;
  const Assumed* assumed_;
  std::array<float, 256> linear_;  // sRGB byte -> linear
};

}  // namespace fiatlux
