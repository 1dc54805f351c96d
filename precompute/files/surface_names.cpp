// Surface names to leaves, and what a misspelt one may have meant.
#include "precompute/files/surface_names.h"

#include <set>

#include "precompute/base/names.h"

namespace fiatlux {
namespace {

/// Every name that can be asked for: leaves and inner nodes.
std::set<std::string> knownNames(const Scene& scene) {
  std::set<std::string> names;
  for (const Surface& surface : scene.surfaces) {
    names.insert(surface.name);
    for (std::size_t slash = surface.name.find('/'); slash != std::string::npos;
         slash = surface.name.find('/', slash + 1))
      names.insert(surface.name.substr(0, slash));
  }
  return names;
}

std::string suggestions(const Scene& scene, const std::string& name) {
  std::vector<std::string> known;
  for (const std::string& one : knownNames(scene)) known.push_back(cleanText(one));
  const std::string closest = closestNames(name, known, '"');
  return closest.empty() ? " The scene has none." : " The closest are " + closest + "; or \"all\".";
}

}  // namespace

Result<SurfaceSet> surfacesNamed(const Scene& scene, const std::vector<std::string>& names) {
  const auto leaves = static_cast<std::uint32_t>(scene.surfaces.size());
  std::set<std::uint32_t> members;
  for (const std::string& name : names) {
    bool found = name == "all";
    for (std::uint32_t s = 0; s < leaves; ++s) {
      const Surface& surface = scene.surfaces[s];
      const bool meant =
          name == "all" ? !surface.measuring
                        : surface.name == name || surface.name.compare(0, name.size() + 1, name + "/") == 0;
      if (meant) members.insert(s);
      found = found || meant;
    }
    if (!found)
      return Error{"no surface is called \"" + name.substr(0, 80) + "\"." + suggestions(scene, name)};
  }
  SurfaceSet all;
  for (std::uint32_t s = 0; s < leaves; ++s)
    if (!scene.surfaces[s].measuring) all.push_back(s);
  SurfaceSet set(members.begin(), members.end());
  if (set == all) set.clear();  // "all" has one form
  return set;
}

}  // namespace fiatlux
