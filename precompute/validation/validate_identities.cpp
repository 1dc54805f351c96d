// What must hold in any room: row sums, reciprocity, energy, the mean of a closed scene, linearity,
// statistics; and the white furnace, in which every patch has radiosity 1 whatever the geometry.
#include <algorithm>
#include <cmath>

#include "precompute/light/cast_form_factors.h"
#include "precompute/light/transport.h"
#include "precompute/validation/validation_scene.h"

namespace fiatlux {

namespace {

const std::string kIdentities = "identities";

/// A closed room with a block in it that stands 0.4 m off the floor, 4 x 2.8 x 5 m.
std::vector<RectangleSurface> furnishedRoom(double floor, double walls, double ceiling) {
  auto surfaces = boxSurfaces({0, 0, 0}, {4, 2.8, 5}, walls, 0.25);
  surfaces[0].reflectance = floor;
  surfaces[1].reflectance = ceiling;
  const auto block = blockSurfaces("block", {1, 0.4, 1.5}, {1.5, 0.6, 2}, walls, 0.25);
  surfaces.insert(surfaces.end(), block.begin(), block.end());
  return surfaces;
}

/// Two rooms, 3 x 2.5 x 3 m each, and a doorway of 1 x 2 m between them; `sealed`: the doorway is walled up.
std::vector<RectangleSurface> twoRooms(bool sealed) {
  auto surfaces = boxSurfaces({0, 0, 0}, {3, 2.5, 3}, 0.5, 0.25);
  auto second = boxSurfaces({3.2, 0, 0}, {3, 2.5, 3}, 0.6, 0.25);
  for (RectangleSurface& s : second) s.name = "second/" + s.name;
  if (!sealed) {
    // Replace the walls at the doorway (z from 1 to 2, y up to 2) by what is left of them, and line it.
    surfaces.erase(surfaces.begin() + 3);
    second.erase(second.begin() + 2);
    const auto add = [&](const std::string& name, Vec3 corner, Vec3 u, Vec3 v) {
      surfaces.push_back({name, corner, u, v, 0.5, 1, 1, false});
    };
    for (const double x : {3.0, 3.2}) {
      const bool first = x < 3.1;
      const std::string side = first ? "door side" : "second/door side";
      const auto wall = [&](const char* name, double z0, double z1, double y0, double y1) {
        const Vec3 corner{x, y0, z0}, up{0, y1 - y0, 0}, along{0, 0, z1 - z0};
        add(side + " " + name, corner, first ? along : up, first ? up : along);
      };
      wall("a", 0, 1, 0, 2.5);
      wall("b", 2, 3, 0, 2.5);
      wall("c", 1, 2, 2, 2.5);
    }
    add("lining floor", {3, 0, 1}, {0, 0, 1}, {0.2, 0, 0});
    add("lining top", {3, 2, 1}, {0.2, 0, 0}, {0, 0, 1});
    add("lining a", {3, 0, 1}, {0.2, 0, 0}, {0, 2, 0});
    add("lining b", {3, 0, 2}, {0, 2, 0}, {0.2, 0, 0});
  }
  surfaces.insert(surfaces.end(), second.begin(), second.end());
  return surfaces;
}

Luminaire ceilingLamp(const Vec3& position, double size) {
  Luminaire luminaire;
  luminaire.position = position;
  luminaire.width = luminaire.height = size;
  luminaire.flux = 1000;
  return luminaire;
}

void formFactorIdentities(Validation& validation) {
  const ValidationScene scene(validation, kIdentities, sceneOfRectangles(furnishedRoom(0.3, 0.5, 0.7)), 0.25);
  if (!scene) return;
  const ValidationOptions& o = validation.options;
  const FormFactors factors =
      castFormFactors(scene.room(), scene.tracer(), {o.rays, false, o.seed, o.threads, {}});
  double worst = 0;
  for (std::uint32_t p = 0; p < factors.count; ++p) {
    double sum = 0;
    for (std::uint32_t c = 0; c < factors.clusters; ++c)
      sum += factors.u[std::size_t{p} * factors.clusters + c];
    worst = std::max(worst, std::abs(sum - 1));
  }
  validation.absolute(kIdentities, "largest distance of a row sum from 1, closed room", 0, worst, 1e-4);
  const auto factor = [&](const std::string& from, const std::string& onto) {
    std::vector<float> shining(factors.count), received(factors.rows);
    for (std::uint32_t p = 0; p < factors.count; ++p) shining[p] = scene.belongs(p, onto) ? 1.0f : 0.0f;
    irradiance(factors, shining.data(), 1, received.data());
    return scene.mean(received, from) * scene.area(from);
  };
  validation.relative(kIdentities, "A F floor to ceiling = back", factor("ceiling", "floor"),
                      factor("floor", "ceiling"), 0.01);
  validation.relative(kIdentities, "A F block to wall = back", factor("wall -x", "block"),
                      factor("block", "wall -x"), 0.01);
}

void energy(Validation& validation) {
  for (const double rho : {0.2, 0.5, 0.8}) {
    const ValidationScene scene(validation, kIdentities, sceneOfRectangles(furnishedRoom(rho, rho, rho)),
                                0.25);
    if (!scene) return;
    const ForwardLight light = scene.light({ceilingLamp({1, 2.8, 1}, 0.5), ceilingLamp({3, 2.8, 3.5}, 0.5)});
    const std::string of = ", reflectance " + std::to_string(rho).substr(0, 3);
    validation.relative(kIdentities, "sum A (1 - rho) E = flux" + of, 2000, light.energy.absorbed, 0.005);
    validation.relative(kIdentities, "mean reflected lm/m2 in a closed room" + of,
                        rho * 2000 / ((1 - rho) * scene.area("")), rho * scene.mean(light.illuminance, ""),
                        0.005);
  }
  const ValidationScene mixed(validation, kIdentities, sceneOfRectangles(furnishedRoom(0.3, 0.5, 0.7)), 0.25);
  if (!mixed) return;
  const ForwardLight light = mixed.light({ceilingLamp({1, 2.8, 1}, 0.5)});
  validation.relative(kIdentities, "sum A (1 - rho) E = flux, mixed reflectances", 1000,
                      light.energy.absorbed, 0.005);
  const ValidationScene sealed(validation, kIdentities, sceneOfRectangles(twoRooms(true)), 0.25);
  if (!sealed) return;
  const ForwardLight one = sealed.light({ceilingLamp({1.5, 2.5, 1.5}, 0.5)});
  validation.absolute(kIdentities, "sealed second room, share of the lit one's mean", 0,
                      sealed.mean(one.illuminance, "second") / sealed.mean(one.illuminance, "floor"), 1e-6);
}

/// Linearity and statistics, on the transport of a room with sites.
void statistics(Validation& validation) {
  const auto surfaces = furnishedRoom(0.3, 0.5, 0.7);
  Result<TracedRoom> traced = roomOf(sceneOfRectangles(surfaces), 0.25);
  if (!traced) return validation.failure(kIdentities, traced.error().message);
  Room& room = traced->room;
  room.sites = siteGrid(surfaces[1], 3, 4, 0.6);
  TransportOptions options;
  options.rays = validation.options.rays;
  options.seed = validation.options.seed;
  options.threads = validation.options.threads;
  const Result<Transport> transport = computeTransport(room, traced->tracer, options);
  if (!transport) return validation.failure(kIdentities, transport.error().message);
  const std::uint32_t m = transport->responses.sites;
  double triangle = 0, least = 0;
  for (const SurfaceStatistics& s : transport->illuminance) {
    double trace = 0;
    for (std::uint32_t i = 0; i < m; ++i) trace += s.covariance[i * m + i];
    for (std::uint32_t i = 0; i < m; ++i) {
      for (std::uint32_t j = 0; j < i; ++j) {
        const double a = s.covariance[i * m + i], b = s.covariance[j * m + j], c = s.covariance[i * m + j];
        const double both = std::sqrt(std::max(0.0, a + b + 2 * c)), sa = std::sqrt(a), sb = std::sqrt(b);
        triangle = std::max({triangle, (both - sa - sb) / (sa + sb), (std::abs(sa - sb) - both) / (sa + sb)});
        least = std::min(least, (a * b - c * c) / (trace * trace));
      }
    }
  }
  validation.absolute(kIdentities, "|s1 - s2| <= s12 <= s1 + s2, largest excess", 0, triangle, 1e-9);
  validation.absolute(kIdentities, "covariances positive semidefinite, least 2 x 2 minor", 0, least, 1e-12);

  // Two lamps on sites: the forward light of both is the sum of their responses.
  const ValidationScene scene(validation, kIdentities, sceneOfRectangles(surfaces), 0.25);
  if (!scene) return;
  std::vector<Luminaire> lamps;
  for (const std::uint32_t site : {1u, 7u}) lamps.push_back(ceilingLamp(room.sites[site].position, 0.6));
  const ForwardLight light = scene.light(lamps);
  for (const std::uint32_t s : {0u, 1u, 4u}) {
    const double sum = 1000 * (transport->illuminance[s].mean[1] + transport->illuminance[s].mean[7]);
    const std::string& name = room.surfaces[s].name;
    validation.relative(kIdentities, "two lamps = sum of their sites, mean of " + name,
                        scene.mean(light.illuminance, name), sum, 0.005);
  }
}

void furnace(Validation& validation, const std::string& name, const SourceScene& source, double patch) {
  const ValidationScene scene(validation, "white furnace", source, patch);
  if (!scene) return;
  const Patches& patches = scene.room().patches;
  std::vector<float> emission(patches.count);
  for (std::uint32_t p = 0; p < patches.count; ++p) emission[p] = 1 - patches.reflectance[p];
  const ForwardLight light = scene.light({}, emission);
  double worst = 0, squares = 0, area = 0;
  for (std::uint32_t p = 0; p < patches.count; ++p) {
    const double deviation = light.radiosity[p] - 1;
    worst = std::max(worst, std::abs(deviation));
    squares += patches.area[p] * deviation * deviation;
    area += patches.area[p];
  }
  validation.absolute("white furnace", name + ", largest |radiosity - 1|", 0, worst, 0.01);
  validation.absolute("white furnace", name + ", rms", 0, std::sqrt(squares / area), 0.002);
}

}  // namespace

void validateIdentities(Validation& validation) {
  formFactorIdentities(validation);
  energy(validation);
  statistics(validation);
}

void validateFurnaces(Validation& validation) {
  furnace(validation, "box", sceneOfRectangles(boxSurfaces({0, 0, 0}, {3, 2.5, 4}, 0.9, 0.25)), 0.25);
  furnace(validation, "furnished room", sceneOfRectangles(furnishedRoom(0.2, 0.6, 0.9)), 0.25);
  furnace(validation, "two rooms and a doorway", sceneOfRectangles(twoRooms(false)), 0.25);
  SourceScene sphere;
  sphere.meshes = {sphereMesh("sphere", {0, 0, 0}, 1, 48)};
  sphere.meshes[0].extras.reflectance = 0.8;
  furnace(validation, "sphere", sphere, 0.15);
}

}  // namespace fiatlux
