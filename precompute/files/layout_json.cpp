// JSON to luminaires; see layout_json.h.
#include "precompute/files/layout_json.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "precompute/base/error.h"
#include "precompute/base/json_text.h"
#include "precompute/files/files_on_disk.h"
#include "precompute/files/terminal.h"
#include "precompute/light/direct_light.h"

namespace fiatlux {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostLuminaires = 10000;
constexpr double kLargestFlux = 1e9;      // lm
constexpr double kLargestDistance = 1e6;  // m

[[noreturn]] void fail(const std::string& where, const std::string& what) {
  throw CommandError(where + ": " + what);
}

double numberOf(const Json& value, const std::string& where, double low, double high) {
  if (!value.is_number()) fail(where, "expected a number");
  const double number = value.get<double>();
  if (!(number >= low && number <= high)) {
    char range[64];
    std::snprintf(range, sizeof range, " is out of range; give %g to %g", low, high);
    fail(where, printable(value.dump(), 40) + range);
  }
  return number;
}

Vec3 vectorOf(const Json& value, const std::string& where) {
  if (!value.is_array() || value.size() != 3) fail(where, "expected three numbers [x, y, z]");
  double v[3];
  for (int i = 0; i < 3; ++i) v[i] = numberOf(value[i], where, -kLargestDistance, kLargestDistance);
  return {v[0], v[1], v[2]};
}

Vec3 directionOf(const Json& value, const std::string& where) {
  const Vec3 direction = vectorOf(value, where);
  if (length(direction) < 1e-9) fail(where, "a direction must not be zero");
  return normalized(direction);
}

/// The unit vector in the plane of `normal` that is nearest to `wish`; zero where the two are parallel.
Vec3 inPlane(const Vec3& wish, const Vec3& normal) {
  const Vec3 flat = wish - dot(wish, normal) * normal;
  return length(flat) > 1e-6 ? normalized(flat) : Vec3{};
}

/// A side along the world axis that lies nearest to the plane (x before z before y).
Vec3 worldAxisIn(const Vec3& normal) {
  Vec3 best;
  double smallest = 2;
  for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, 1, 0}}) {
    if (std::abs(dot(axis, normal)) >= smallest - 1e-9) continue;
    smallest = std::abs(dot(axis, normal));
    best = axis;
  }
  return inPlane(best, normal);
}

Luminaire freeLuminaire(const Json& json, const std::string& where, double flux) {
  Luminaire luminaire;
  luminaire.flux = flux;
  luminaire.position = vectorOf(json.at("position"), where + ".position");
  if (json.contains("normal")) luminaire.normal = directionOf(json["normal"], where + ".normal");
  luminaire.axis = worldAxisIn(luminaire.normal);
  if (json.contains("axis")) {
    luminaire.axis = inPlane(directionOf(json["axis"], where + ".axis"), luminaire.normal);
    if (length(luminaire.axis) == 0) fail(where + ".axis", "it must not be parallel to the normal");
  }
  if (json.contains("size")) {
    const Json& size = json["size"];
    if (!size.is_array() || size.size() != 2)
      fail(where + ".size", "expected two numbers [width, height] in metres");
    luminaire.width = numberOf(size[0], where + ".size", 1e-6, 1000);
    luminaire.height = numberOf(size[1], where + ".size", 1e-6, 1000);
  }
  if (json.contains("distribution")) {
    const Json& name = json["distribution"];
    if (name == "isotropic")
      luminaire.distribution = Luminaire::Distribution::kIsotropic;
    else if (name != "lambertian")
      fail(where + ".distribution", "known are \"lambertian\" and \"isotropic\"");
    if (name == "isotropic" && luminaire.width > 0)
      fail(where + ".distribution", "only a point is isotropic: leave out \"size\"");
  }
  return luminaire;
}

LayoutEntry entryOf(const Json& json, const std::string& where, std::vector<std::string>& notes) {
  if (!json.is_object()) fail(where, "expected an object such as {\"site\": 12, \"flux\": 3000}");
  LayoutEntry entry;
  for (const auto& item : json.items()) {
    const std::string& key = item.key();
    if (key == "normal" || key == "size" || key == "axis" || key == "distribution")
      entry.freeKeys.push_back(key);
    else if (key != "site" && key != "position" && key != "flux")
      notes.push_back(where + ": unknown key \"" + printable(key, 60) + "\" is ignored");
  }
  if (!json.contains("flux")) fail(where, "\"flux\" in lumens is missing");
  entry.flux = numberOf(json["flux"], where + ".flux", 0, kLargestFlux);
  if (json.contains("site")) {
    const double site = numberOf(json["site"], where + ".site", 0, 4e9);
    if (site != std::floor(site)) fail(where + ".site", "expected a whole number");
    entry.site = static_cast<std::uint32_t>(site);
  }
  if (json.contains("position")) entry.free = freeLuminaire(json, where, entry.flux);
  if (!entry.site && !entry.free) fail(where, "it has neither \"site\" nor \"position\"");
  return entry;
}

LayoutFile layoutOf(const Json& json) {
  LayoutFile file;
  if (!json.is_object()) fail("layout", "expected an object with \"luminaires\"");
  for (const auto& item : json.items())
    if (item.key() != "dimming" && item.key() != "luminaires")
      file.notes.push_back("layout: unknown key \"" + printable(item.key(), 60) + "\" is ignored");
  if (json.contains("dimming")) file.dimming = numberOf(json["dimming"], "dimming", 0, 1000);
  if (!json.contains("luminaires") || !json["luminaires"].is_array())
    fail("layout", "the list \"luminaires\" is missing");
  const Json& luminaires = json["luminaires"];
  if (luminaires.size() > kMostLuminaires) fail("luminaires", "more than " + std::to_string(kMostLuminaires));
  for (std::size_t i = 0; i < luminaires.size(); ++i)
    file.luminaires.push_back(entryOf(luminaires[i], "luminaires[" + std::to_string(i) + "]", file.notes));
  return file;
}

std::uint32_t nearestSite(const Scene& scene, const Vec3& position) {
  std::uint32_t best = 0;
  for (std::uint32_t j = 1; j < scene.sites.size(); ++j)
    if (length(scene.sites[j].position - position) < length(scene.sites[best].position - position)) best = j;
  return best;
}

/// A site where one is named, unless the entry says itself what hangs there.
Result<Luminaire> freeOrOnSite(const LayoutEntry& entry, const std::vector<Site>& sites) {
  if (entry.free && (!entry.site || !entry.freeKeys.empty() || sites.empty())) return *entry.free;
  const std::string cure =
      "; give --mount, --site-spacing and --site-size as to precompute, or a \"position\"";
  if (sites.empty()) return Error{"the room has no sites" + cure};
  const std::string name = "site " + std::to_string(*entry.site);
  if (*entry.site >= sites.size())
    return Error{name + " is not there; the room has sites 0 to " + std::to_string(sites.size() - 1) + cure};
  const Site& site = sites[*entry.site];
  if (entry.free && length(site.position - entry.free->position) > 0.01)
    return Error{name + " of this room is not at the \"position\" beside it" + cure};
  return luminaireOf(site);
}

}  // namespace

Result<LayoutFile> parseLayout(const std::string& text) {
  const Result<Json> json = parseJson(text);
  if (!json) return json.error();
  try {
    return layoutOf(json.value());
  } catch (const CommandError& error) {
    return Error{error.what()};
  }
}

Result<LayoutFile> readLayoutFile(const std::string& path) {
  try {
    const std::vector<std::uint8_t> bytes = readFileBytes(path, 16ull << 20);
    Result<LayoutFile> file = parseLayout(std::string(bytes.begin(), bytes.end()));
    if (!file) return Error{path + ": " + file.error().message};
    return file;
  } catch (const CommandError& error) {
    return Error{error.what()};
  }
}

Result<Layout> layoutOnSites(const LayoutFile& file, const Scene& scene, std::vector<std::string>& notes) {
  Layout layout;
  layout.dimming = file.dimming;
  for (std::size_t i = 0; i < file.luminaires.size(); ++i) {
    const LayoutEntry& entry = file.luminaires[i];
    const std::string where = "luminaires[" + std::to_string(i) + "]";
    std::uint32_t site = entry.site.value_or(0);
    if (entry.site && site >= scene.sites.size())
      return Error{where + ": site " + std::to_string(site) + " is not there; the scene has sites 0 to " +
                   std::to_string(scene.sites.size() - 1)};
    if (!entry.site) {
      site = nearestSite(scene, entry.free->position);
      const double distance = length(scene.sites[site].position - entry.free->position);
      if (distance > 0.5 * scene.sites[site].size)
        notes.push_back(where + ": the nearest site, " + std::to_string(site) + ", is " +
                        std::to_string(distance).substr(0, 5) + " m away");
    }
    if (!entry.freeKeys.empty()) {
      std::string keys;
      for (const std::string& key : entry.freeKeys) keys += (keys.empty() ? "" : ", ") + key;
      notes.push_back(where + ": ignored here, on a site: " + keys);
    }
    if (std::find(layout.sites.begin(), layout.sites.end(), site) != layout.sites.end())
      notes.push_back(where + ": site " + std::to_string(site) +
                      " holds another luminaire already; their light adds up");
    layout.sites.push_back(site);
    layout.flux.push_back(entry.flux);
  }
  return layout;
}

Result<std::vector<Luminaire>> freeLuminaires(const LayoutFile& file, const std::vector<Site>& sites) {
  std::vector<Luminaire> luminaires;
  for (std::size_t i = 0; i < file.luminaires.size(); ++i) {
    const LayoutEntry& entry = file.luminaires[i];
    Result<Luminaire> luminaire = freeOrOnSite(entry, sites);
    if (!luminaire) return Error{"luminaires[" + std::to_string(i) + "]: " + luminaire.error().message};
    luminaires.push_back(*luminaire);
    luminaires.back().flux = file.dimming * entry.flux;
  }
  return luminaires;
}

nlohmann::ordered_json layoutJson(const Layout& layout, const Scene& scene) {
  nlohmann::ordered_json luminaires = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < layout.sites.size(); ++i) {
    const Vec3& position = scene.sites[layout.sites[i]].position;
    luminaires.push_back({{"site", layout.sites[i]},
                          {"position", {position.x, position.y, position.z}},
                          {"flux", layout.flux[i]}});
  }
  return {{"dimming", layout.dimming}, {"luminaires", std::move(luminaires)}};
}

}  // namespace fiatlux
