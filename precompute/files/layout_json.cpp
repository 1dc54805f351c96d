// JSON to luminaires; see layout_json.h.
#include "precompute/files/layout_json.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>

#include "core/photometry/photometric_values.h"
#include "precompute/files/files_on_disk.h"
#include "precompute/files/json_fields.h"

namespace fiatlux {
namespace {

constexpr std::size_t kMostLuminaires = 10000;
constexpr double kSmallestSize = 1e-6, kLargestSize = 1000;  // m
constexpr double kLargestDimming = 1000;
constexpr double kSamePlace = 0.01;  // m: a site and the position written beside it

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

/// m, along the axis and across it.
std::pair<double, double> sidesOf(const JsonField& size) {
  const std::vector<double> sides = size.numbers(2, "[width, height] in metres", kSmallestSize, kLargestSize);
  return {sides[0], sides[1]};
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
  if (const auto size = json.find("size")) std::tie(luminaire.width, luminaire.height) = sidesOf(*size);
  if (const auto name = json.find("distribution")) {
    luminaire.distribution = name->oneOf<Distribution>(
        {{"lambertian", Distribution::kLambertian}, {"isotropic", Distribution::kIsotropic}});
    if (luminaire.distribution == Distribution::kIsotropic && luminaire.width > 0)
      name->fail("only a point is isotropic: leave out \"size\"");
  }
  return luminaire;
}

PhotometricEntry photometricOf(const JsonField& json, const JsonField& name, double flux,
                               const ReadNamed& read) {
  if (const auto distribution = json.find("distribution"))
    distribution->fail("the photometric file says it; leave one of them out");
  PhotometricEntry entry{photometryOf(name, read), flux, {}};
  Mounting& mounting = entry.mounting;
  if (const auto turn = json.find("turn")) mounting.turn = turn->number(-kMostTurn, kMostTurn);
  if (const auto aim = json.find("aim")) mounting.aim = vectorOf(*aim);
  if (const auto normal = json.find("normal")) mounting.normal = directionOf(*normal);
  if (const auto axis = json.find("axis")) mounting.axis = directionOf(*axis);
  if (mounting.normal && mounting.aim) json.fail("give \"aim\" or \"normal\", not both");
  if (const auto size = json.find("size")) std::tie(mounting.width, mounting.height) = sidesOf(*size);
  return entry;
}

/// The luminaire of a file where `place` says.
Luminaire photometricAt(const PhotometricEntry& entry, const Luminaire& place) {
  Luminaire luminaire = photometricLuminaire(exactType(entry.photometry), entry.flux, entry.mounting.width,
                                             entry.mounting.height);
  luminaire.position = place.position;
  luminaire.normal = place.normal;
  luminaire.axis = place.axis;
  return luminaire;
}

LayoutEntry entryOf(const JsonField& json, const ReadNamed& read) {
  json.requireKeys(
      {"site", "position", "flux", "normal", "size", "axis", "distribution", "photometry", "turn", "aim"});
  LayoutEntry entry;
  if (const auto name = json.find("photometry")) {
    if (const auto flux = json.find("flux")) entry.flux = flux->number(kLeastFlux, kLargestFlux);
    entry.photometric = photometricOf(json, *name, entry.flux, read);
    if (entry.flux == 0) entry.flux = integratedFlux(*entry.photometric->photometry);
  } else {
    for (const char* key : {"turn", "aim"})
      if (const auto member = json.find(key)) member->fail("it is of luminaires with a \"photometry\"");
    entry.flux = json.at("flux", "give it in lumens").number(0, kLargestFlux);
  }
  if (const auto site = json.find("site")) entry.site = site->whole();
  if (const auto position = json.find("position")) entry.free = freeLuminaire(json, *position, entry.flux);
  if (entry.free && entry.photometric) entry.free = photometricAt(*entry.photometric, *entry.free);
  if (!entry.site && !entry.free) json.fail("neither \"site\" nor \"position\"; say where it hangs");
  for (const char* key : {"normal", "size", "axis", "distribution"})
    if (json.has(key) && !entry.photometric) entry.freeKeys.push_back(key);
  return entry;
}

LayoutFile layoutOf(const JsonField& json, const ReadNamed& read) {
  json.requireKeys({"dimming", "luminaires", "observers", "paint", "planes", "taskAreas", "quantity"});
  LayoutFile file;
  if (const auto quantity = json.find("quantity"))
    file.directOnly = quantity->oneOf<bool>({{"illuminance", false}, {"direct", true}});
  if (const auto observers = json.find("observers")) file.observers = observersOf(*observers);
  if (const auto paint = json.find("paint")) file.paint = paintOf(*paint);
  if (const auto planes = json.find("planes")) file.planes = planesOf(*planes);
  if (const auto areas = json.find("taskAreas")) file.taskAreas = taskAreasOf(*areas);
  if (const auto dimming = json.find("dimming")) file.dimming = dimming->number(0, kLargestDimming);
  for (const JsonField& luminaire :
       json.at("luminaires", "list them: [{\"site\": 12, \"flux\": 3000}]").list(kMostLuminaires))
    file.luminaires.push_back(entryOf(luminaire, read));
  return file;
}

std::uint32_t nearestSite(const Scene& scene, const Vec3& position) {
  std::uint32_t best = 0;
  for (std::uint32_t j = 1; j < scene.sites.size(); ++j)
    if (length(scene.sites[j].position - position) < length(scene.sites[best].position - position)) best = j;
  return best;
}

/// Nobody can say which way C0 lies where its axis runs along gamma 0.
Result<Done> checkAxis(const LayoutEntry& entry, const Site& site) {
  if (!entry.photometric || !entry.photometric->mounting.axis) return Done{};
  const auto& [photometry, flux, mounting] = *entry.photometric;
  const Vec3 normal = mountedLuminaire(exactType(photometry), flux, site, mounting).normal;
  if (length(inPlane(*mounting.axis, normal)) > 0) return Done{};
  return Error{"\"axis\" must not be parallel to the direction in which the luminaire points"};
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
  if (!entry.photometric) return luminaireOf(site);
  if (Result<Done> sound = checkAxis(entry, site); !sound) return sound.error();
  const auto& [photometry, flux, mounting] = *entry.photometric;
  return mountedLuminaire(exactType(photometry), flux, site, mounting);
}

}  // namespace

Result<LayoutFile> parseLayout(const std::string& text, const ReadNamed& read) {
  LayoutFile file;
  const Result<Done> done = readJson(text, [&](const JsonField& json) { file = layoutOf(json, read); });
  if (!done) return done.error();
  return file;
}

Result<LayoutFile> readLayoutFile(const std::string& path) {
  return parsedFile(path, kLongestJson,
                    [&](const std::string& text) { return parseLayout(text, filesBeside(path, "layout")); });
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
    if (Result<Done> sound = checkAxis(entry, scene.sites[site]); !sound)
      return Error{where + ": " + sound.error().message};
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
    if (entry.photometric)
      luminaires.back().intensity = [whole = luminaire->intensity, dimming = file.dimming](const Vec3& way) {
        return dimming * whole(way);
      };
  }
  return luminaires;
}

nlohmann::ordered_json luminaireJson(std::uint32_t site, const Vec3& position, double flux) {
  return {{"site", site}, {"position", {position.x, position.y, position.z}}, {"flux", flux}};
}

nlohmann::ordered_json layoutJson(const Layout& layout, const Scene& scene) {
  nlohmann::ordered_json luminaires = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < layout.sites.size(); ++i)
    luminaires.push_back(
        luminaireJson(layout.sites[i], scene.sites[layout.sites[i]].position, layout.flux[i]));
  return {{"dimming", layout.dimming}, {"luminaires", std::move(luminaires)}};
}

}  // namespace fiatlux
