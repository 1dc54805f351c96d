#include "precompute/files/paint_json.h"

#include "precompute/base/names.h"

namespace fiatlux {
namespace {

constexpr std::size_t kMostPaints = 10000;

bool isOf(const Surface& leaf, const std::string& name) {
  return leaf.name == name || leaf.name.rfind(name + "/", 0) == 0;
}

}  // namespace

std::vector<NamedPaint> paintOf(const JsonField& field) {
  std::vector<NamedPaint> paint;
  for (const JsonField& each : field.list(kMostPaints)) {
    each.requireKeys({"surface", "reflectance"});
    paint.push_back(
        {each.at("surface", "name the surface").text(),
         each.at("reflectance", "say what share of light it reflects").number(kLeastPaint, kMostPaint)});
  }
  return paint;
}

Result<std::vector<SurfacePaint>> paintOnLeaves(const std::vector<NamedPaint>& paint,
                                                const std::vector<Surface>& surfaces) {
  std::vector<SurfacePaint> onLeaves;
  for (const auto& [name, reflectance] : paint) {
    const std::size_t before = onLeaves.size();
    for (std::uint32_t s = 0; s < surfaces.size(); ++s)
      if (!surfaces[s].measuring && isOf(surfaces[s], name)) onLeaves.push_back({s, reflectance});
    if (onLeaves.size() > before) continue;
    std::vector<std::string> known;
    for (const Surface& surface : surfaces)
      if (!surface.measuring) known.push_back(cleanText(surface.name));
    return Error{"paint: no surface that can be painted is called \"" + name.substr(0, 80) +
                 "\". The closest are " + closestNames(name, known, '"')};
  }
  return onLeaves;
}

void setReflectance(const std::vector<SurfacePaint>& paint, Patches& patches,
                    std::vector<Surface>& surfaces) {
  for (const auto& [surface, reflectance] : paint) {
    surfaces[surface].reflectance = reflectance;
    for (std::uint32_t p = 0; p < patches.count; ++p)
      if (patches.surface[p] == surface) patches.reflectance[p] = static_cast<float>(reflectance);
  }
}

Result<Done> paintScene(const std::vector<NamedPaint>& paint, Scene& scene, std::vector<float>& light) {
  if (paint.empty()) return Done{};
  const Result<std::vector<SurfacePaint>> onLeaves = paintOnLeaves(paint, scene.surfaces);
  if (!onLeaves) return onLeaves.error();
  const Result<Done> checked = checkPaint(scene, *onLeaves);
  if (!checked) return checked;
  const ExchangeOperator exchange(scene.patches, scene.lightOperator->groups, scene.lightOperator->exchange);
  light = Repaint(scene, exchange, paintedReflectance(scene, *onLeaves)).light(light, 1);
  setReflectance(*onLeaves, scene.patches, scene.surfaces);
  return Done{};
}

}  // namespace fiatlux
