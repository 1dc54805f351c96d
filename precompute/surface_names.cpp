// Surface names to leaves, and what a misspelt one may have meant; see intentions_json.h.
#include <algorithm>
#include <set>

#include "precompute/intentions_json.h"

namespace fiatlux {
namespace {

constexpr std::size_t kSuggestions = 3;

/// Letters to insert, delete or replace to get from a to b (Levenshtein), case apart.
std::size_t editDistance(const std::string& a, const std::string& b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row[b.size()];
}

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
  const std::string asked = name.substr(0, 200);
  std::vector<std::pair<std::size_t, std::string>> ranked;
  for (const std::string& known : knownNames(scene))
    ranked.emplace_back(editDistance(asked, known.substr(0, 200)), known);
  std::sort(ranked.begin(), ranked.end());
  std::string text;
  for (std::size_t i = 0; i < ranked.size() && i < kSuggestions; ++i)
    text += (i == 0 ? " The closest are \"" : ", \"") + ranked[i].second.substr(0, 80) + "\"";
  return text.empty() ? " The scene has none." : text + "; or \"all\".";
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
