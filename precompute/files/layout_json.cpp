// JSON to luminaires; see layout_json.h.
#include "precompute/files/layout_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "precompute/files/files_on_disk.h"
#include "precompute/files/json_fields.h"

namespace fiatlux {
namespace {

constexpr std::size_t kMostLuminaires = 10000;
constexpr double kLargestFlux = 1e9;                         // lm
constexpr double kLargestDistance = 1e6;                     // m
constexpr double kSmallestSize = 1e-6, kLargestSize = 1000;  // m
constexpr double kLargestDimming = 1000;
constexpr double kSamePlace = 0.01;  // m: a site and the position written beside it

Vec3 vectorOf(const JsonField& field) {
  const std::vector<double> v = field.numbers(3, "[x, y, z]", -kLargestDistance, kLargestDistance);
  return {v[0], v[1], v[2]};
}

Vec3 directionOf(const JsonField& field) {
  const Vec3 direction = vectorOf(field);
  if (length(direction) < 1e-9) field.fail("a direction must not be zero");
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

Luminaire freeLuminaire(const JsonField& json, const JsonField& position, double flux) {
  using Distribution = Luminaire::Distribution;
  Luminaire luminaire;
  luminaire.flux = flux;
  luminaire.position = vectorOf(position);
  if (const auto normal = json.find("normal")) luminaire.normal = directionOf(*normal);
  luminaire.axis = worldAxisIn(luminaire.normal);
  if (const auto axis = json.find("axis")) {
    luminaire.axis = inPlane(directionOf(*axis), luminaire.normal);
    if (length(luminaire.axis) == 0) axis->fail("it must not be parallel to the normal");
  }
  if (const auto size = json.find("size")) {
    const std::vector<double> sides =
        size->numbers(2, "[width, height] in metres", kSmallestSize, kLargestSize);
    luminaire.width = sides[0];
    luminaire.height = sides[1];
  }
  if (const auto name = json.find("distribution")) {
    luminaire.distribution = name->oneOf<Distribution>(
        {{"lambertian", Distribution::kLambertian}, {"isotropic", Distribution::kIsotropic}});
    if (luminaire.distribution == Distribution::kIsotropic && luminaire.width > 0)
      name->fail("only a point is isotropic: leave out \"size\"");
  }
  return luminaire;
}

LayoutEntry entryOf(const JsonField& json) {
  json.requireKeys({"site", "position", "flux", "normal", "size", "axis", "distribution"});
  LayoutEntry entry;
  entry.flux = json.at("flux", "give it in lumens").number(0, kLargestFlux);
  if (const auto site = json.find("site")) entry.site = site->whole();
  if (const auto position = json.find("position")) entry.free = freeLuminaire(json, *position, entry.flux);
  if (!entry.site && !entry.free) json.fail("neither \"site\" nor \"position\"; say where it hangs");
  for (const char* key : {"normal", "size", "axis", "distribution"})
    if (json.has(key)) entry.freeKeys.push_back(key);
  return entry;
}

LayoutFile layoutOf(const JsonField& json) {
  json.requireKeys({"dimming", "luminaires"});
  LayoutFile file;
  if (const auto dimming = json.find("dimming")) file.dimming = dimming->number(0, kLargestDimming);
  for (const JsonField& luminaire :
       json.at("luminaires", "list them: [{\"site\": 12, \"flux\": 3000}]").list(kMostLuminaires))
    file.luminaires.push_back(entryOf(luminaire));
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
  if (entry.free && length(site.position - entry.free->position) > kSamePlace)
    return Error{name + " of this room is not at the \"position\" beside it" + cure};
  return luminaireOf(site);
}

}  // namespace

Result<LayoutFile> parseLayout(const std::string& text) {
  LayoutFile file;
  const Result<Done> read = readJson(text, [&](const JsonField& json) { file = layoutOf(json); });
  if (!read) return read.error();
  return file;
}

Result<LayoutFile> readLayoutFile(const std::string& path) {
  return parsedFile(path, kLongestJson, [](const std::string& text) { return parseLayout(text); });
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
