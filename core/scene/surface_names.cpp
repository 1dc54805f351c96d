// The one place that knows what "all" means; see surface_names.h.
#include "core/scene/surface_names.h"

#include <set>

namespace fiatlux {

SurfaceSet leavesOf(const Scene& scene, const SurfaceSet& surfaces) {
  if (!surfaces.empty()) return surfaces;
  SurfaceSet all;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s)
    if (!scene.surfaces[s].measuring) all.push_back(s);
  return all;
}

SurfaceSet leavesNamed(const Scene& scene, const std::string& name) {
  if (name == "all") return leavesOf(scene, {});
  SurfaceSet leaves;
  for (std::uint32_t s = 0; s < scene.surfaces.size(); ++s) {
    const std::string& leaf = scene.surfaces[s].name;
    if (leaf == name || leaf.compare(0, name.size() + 1, name + "/") == 0) leaves.push_back(s);
  }
  return leaves;
}

SurfaceSet setOfLeaves(const Scene& scene, const SurfaceSet& leaves) {
  return leaves == leavesOf(scene, {}) ? SurfaceSet{} : leaves;
}

std::vector<std::string> knownSurfaceNames(const Scene& scene) {
  std::set<std::string> names;
  for (const Surface& surface : scene.surfaces) {
    names.insert(surface.name);
    for (std::size_t slash = surface.name.find('/'); slash != std::string::npos;
         slash = surface.name.find('/', slash + 1))
      names.insert(surface.name.substr(0, slash));
  }
  return {names.begin(), names.end()};
}

std::string surfaceSetName(const Scene& scene, const SurfaceSet& surfaces) {
  if (surfaces.empty()) return "all";
  std::string name;
  for (std::uint32_t s : surfaces) name += (name.empty() ? "" : " + ") + scene.surfaces[s].name;
  return name;
}

}  // namespace fiatlux
