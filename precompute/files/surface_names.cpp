// Surfaces by name, and what a misspelt name may have meant; see surface_names.h.
#include "precompute/files/surface_names.h"

#include <set>

#include "core/scene/surface_names.h"
#include "precompute/base/names.h"

namespace fiatlux {
namespace {

std::string suggestions(const Scene& scene, const std::string& name) {
  std::vector<std::string> known = knownSurfaceNames(scene);
  for (std::string& one : known) one = cleanText(one);
  const std::string closest = closestNames(name, known, '"');
  return closest.empty() ? " The scene has none." : " The closest are " + closest + "; or \"all\".";
}

}  // namespace

Result<SurfaceSet> surfacesNamed(const Scene& scene, const std::vector<std::string>& names) {
  std::set<std::uint32_t> members;
  for (const std::string& name : names) {
    const SurfaceSet leaves = leavesNamed(scene, name);
    if (leaves.empty() && name != "all")
      return Error{"no surface is called \"" + name.substr(0, 80) + "\"." + suggestions(scene, name)};
    members.insert(leaves.begin(), leaves.end());
  }
  return setOfLeaves(scene, {members.begin(), members.end()});
}

}  // namespace fiatlux
