#include "precompute/geometry/source_changes.h"

#include <algorithm>

#include "precompute/base/error.h"
#include "precompute/base/names.h"
#include "precompute/gltf/reflectance.h"

namespace fiatlux {
namespace {

[[noreturn]] void unknownMaterial(const std::string& name, const SourceScene& source) {
  std::vector<std::string> names;
  for (const SourceMaterial& material : source.materials) names.push_back(material.name);
  const std::string which =
      names.empty() ? "the model has none" : "the closest are " + closestNames(name, names);
  throw CommandError("--reflectance '" + cleanText(name) + "': no material is called that; " + which);
}

void paint(SourceMaterial& material, double wanted) {
  auto& color = material.baseColor;
  if (material.image >= 0) color[0] = color[1] = color[2] = 1;
  material.image = -1;
  const double now = luminanceOf(color[0], color[1], color[2]);
  const double most = std::max({color[0], color[1], color[2]});
  const bool keepsHue = now > 0 && most * wanted <= now;
  for (int c = 0; c < 3; ++c) color[c] = keepsHue ? color[c] * wanted / now : wanted;
}

}  // namespace

void standUpright(SourceScene& source) {
  for (SourceMesh& mesh : source.meshes) {
    for (Vec3& p : mesh.positions) p = {p.x, p.z, -p.y};
    for (auto& n : mesh.normals) n = {n[0], n[2], -n[1]};
  }
}

void repaint(const std::vector<NamedReflectance>& reflectances, SourceScene& source) {
  for (const auto& [given, value] : reflectances) {
    const std::string name = cleanName(given);
    const auto isAsked = [&](const SourceMaterial& m) { return m.name == name; };
    if (std::none_of(source.materials.begin(), source.materials.end(), isAsked))
      unknownMaterial(name, source);
    for (SourceMaterial& material : source.materials)
      if (isAsked(material)) paint(material, value);
    for (SourceMesh& mesh : source.meshes)
      if (mesh.material >= 0 && isAsked(source.materials[mesh.material]))
        mesh.extras.reflectance.reset(), mesh.colors.clear();
  }
}

}  // namespace fiatlux
