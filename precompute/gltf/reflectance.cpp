// Base colour factor x texture x vertex colour, weighted by how bright the eye finds red, green and blue
// (Rec. 709).
#include "precompute/gltf/reflectance.h"

#include <algorithm>
#include <cmath>

namespace fiatlux {
namespace {

/// Texel of coordinate x in an image of `size` under a wrap mode of glTF; those unknown repeat.
std::uint32_t wrapped(double x, std::uint32_t size, int mode) {
  if (mode == gltf::kClampToEdge)
    x = std::clamp(x, 0.0, 1.0);
  else if (mode == gltf::kMirroredRepeat)
    x = 1 - std::abs(x - 2 * std::floor(x / 2) - 1);
  else
    x -= std::floor(x);
  return std::min(static_cast<std::uint32_t>(std::max(x, 0.0) * size), size - 1);
}

}  // namespace

ReflectanceMap::ReflectanceMap(const SourceScene& source, const Assumed* assumed)
    : source_(source), assumed_(assumed) {
  for (int i = 0; i < 256; ++i) {
    const double s = i / 255.0;
    linear_[i] = static_cast<float>(s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4));
  }
}

bool ReflectanceMap::isConstant(std::uint32_t m) const {
  const SourceMesh& mesh = source_.meshes[m];
  if (mesh.extras.reflectance) return true;
  if (isAssumed(m)) return false;
  const bool textured = mesh.material >= 0 && source_.materials[mesh.material].image >= 0 && !mesh.uv.empty();
  return !textured && mesh.colors.empty();
}

double ReflectanceMap::at(std::uint32_t m, std::uint32_t triangle,
                          const std::array<double, 3>& weights) const {
  const SourceMesh& mesh = source_.meshes[m];
  if (mesh.extras.reflectance) return *mesh.extras.reflectance;
  if (isAssumed(m)) return (*assumed_)[m][triangle];
  const std::array<double, 3> color = colorAt(m, triangle, weights);
  return luminanceOf(color[0], color[1], color[2]);
}

std::array<double, 3> ReflectanceMap::colorAt(std::uint32_t m, std::uint32_t triangle,
                                              const std::array<double, 3>& weights) const {
  const SourceMesh& mesh = source_.meshes[m];
  std::array<double, 3> color{1, 1, 1};
  const auto& v = mesh.triangles[triangle];
  if (mesh.material >= 0) {
    const SourceMaterial& material = source_.materials[mesh.material];
    for (int c = 0; c < 3; ++c) color[c] = material.baseColor[c];
    if (material.image >= 0 && !mesh.uv.empty() && source_.images[material.image].width > 0) {
      const SourceImage& image = source_.images[material.image];
      double s = 0, t = 0;
      for (int i = 0; i < 3; ++i) s += weights[i] * mesh.uv[v[i]][0], t += weights[i] * mesh.uv[v[i]][1];
      // KHR_texture_transform: translate * rotate * scale
      const auto& [du, dv, su, sv, angle] = material.uvTransform;
      const double x = du + std::cos(angle) * su * s + std::sin(angle) * sv * t;
      const double y = dv - std::sin(angle) * su * s + std::cos(angle) * sv * t;
      if (std::isfinite(x) && std::isfinite(y)) {
        const std::size_t texel = std::size_t{wrapped(y, image.height, material.wrapT)} * image.width +
                                  wrapped(x, image.width, material.wrapS);
        for (int c = 0; c < 3; ++c) color[c] *= linear_[image.rgba[4 * texel + c]];
      }
    }
  }
  if (!mesh.colors.empty())
    for (int c = 0; c < 3; ++c) {
      double tint = 0;
      for (int i = 0; i < 3; ++i) tint += weights[i] * mesh.colors[v[i]][c];
      color[c] *= std::clamp(tint, 0.0, 1.0);
    }
  return color;
}

std::string ReflectanceMap::materialName(std::uint32_t m) const {
  const int material = source_.meshes[m].material;
  return material < 0 ? "the default material (of node '" + source_.meshes[m].node + "')"
                      : "material '" + source_.materials[material].name + "'";
}

}  // namespace fiatlux
