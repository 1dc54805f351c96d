// CIE 171:2006, test cases 5.2 to 5.8 that have one answer. Published passing rule: 5 % a point, 10 % global;
// here the promises of the program itself: 2 % at a point for direct light, 5 % with reflections, 0.5 % for
// means.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "precompute/validation/cie171_points.h"
#include "precompute/validation/validation_scene.h"

namespace fiatlux {

namespace {

constexpr double kDirect = 0.02, kTotal = 0.05, kMean = 0.005;

std::string at(const char* where, double x, double y) {
  char text[80];
  std::snprintf(text, sizeof text, "%s %g, %g", where, x, y);
  return text;
}

Luminaire pointSource(const Vec3& position, double flux, Luminaire::Distribution distribution) {
  Luminaire luminaire;
  luminaire.position = position;
  luminaire.flux = flux;
  luminaire.distribution = distribution;
  return luminaire;
}

void pointSources(Validation& validation) {
  const ValidationScene scene(
      validation, "CIE 171 5.2",
      sceneOfRectangles({zUpRectangle("floor", {-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, 0)}), 0.25);
  if (!scene) return;
  std::vector<MeasuringPoint> points;
  for (const auto& place : kCie171Places) points.push_back({zUp(place[0], place[1], 0), zUp(0, 0, 1)});
  using Distribution = Luminaire::Distribution;
  const auto flat =
      scene.read(points, {pointSource(zUp(0, 0, 3), 1000 * std::numbers::pi, Distribution::kLambertian)}, {});
  const auto round =
      scene.read(points, {pointSource(zUp(0, 0, 3), 4000 * std::numbers::pi, Distribution::kIsotropic)}, {});
  for (int i = 0; i < kCie171Points; ++i) {
    const auto& [x, y] = kCie171Places[i];
    validation.relative("CIE 171 5.2", at("Lambertian point, lx at", x, y), kCie171Lambertian[i],
                        flat[i].total, kDirect);
    validation.relative("CIE 171 5.2", at("isotropic point, lx at", x, y), kCie171Isotropic[i],
                        round[i].total, kDirect);
  }
}

void areaSource(Validation& validation) {
  const ValidationScene scene(validation, "CIE 171 5.3", sceneOfRectangles(zUpBox(4, 4, 3, 0)), 0.25);
  if (!scene) return;
  Luminaire source = pointSource(zUp(2, 2, 3), 1000 * std::numbers::pi, Luminaire::Distribution::kLambertian);
  source.width = source.height = 1;
  const double wall[6] = {32.68, 75.19, 81.32, 69.06, 53.40, 40.00};
  const double floor[8] = {61.42, 79.26, 95.67, 105.78, 105.78, 95.67, 79.26, 61.42};
  std::vector<MeasuringPoint> points;
  for (int i = 0; i < 6; ++i) points.push_back({zUp(2, 0, 2.75 - 0.5 * i), zUp(0, 1, 0)});
  for (int i = 0; i < 8; ++i) points.push_back({zUp(2, 0.25 + 0.5 * i, 0), zUp(0, 0, 1)});
  const auto readings = scene.read(points, {source}, {});
  for (int i = 0; i < 6; ++i) {
    validation.relative("CIE 171 5.3", at("wall, lx at x, z", 2, 2.75 - 0.5 * i), wall[i], readings[i].total,
                        kDirect);
  }
  for (int i = 0; i < 8; ++i) {
    validation.relative("CIE 171 5.3", at("floor, lx at x, y", 2, 0.25 + 0.5 * i), floor[i],
                        readings[6 + i].total, kDirect);
  }
}

void fluxOnSurfaces(Validation& validation) {
  const ValidationScene scene(validation, "CIE 171 5.4", sceneOfRectangles(zUpBox(4, 4, 3, 0)), 0.25);
  if (!scene) return;
  const ForwardLight light =
      scene.light({pointSource(zUp(2, 2, 1.5), 10000, Luminaire::Distribution::kIsotropic)});
  for (const std::string name : {"floor", "ceiling", "wall x=0", "wall x=max", "wall y=0", "wall y=max"}) {
    const double expected = name == "floor" || name == "ceiling" ? 2210.66 : 1394.67;
    validation.relative("CIE 171 5.4", "lm on " + name, expected,
                        scene.mean(light.illuminance, name) * scene.area(name), kMean);
  }
}

/// Readings in percent of the exitance of the one surface that shines with 1 lm/m2.
std::vector<PointReading> percentOf(const ValidationScene& scene, const std::string& shining,
                                    const std::vector<MeasuringPoint>& points) {
  std::vector<float> emission(scene.room().patches.count, 0.0f);
  for (std::uint32_t p = 0; p < scene.room().patches.count; ++p)
    emission[p] = scene.belongs(p, shining) ? 1.0f : 0.0f;
  std::vector<PointReading> readings = scene.read(points, {}, scene.light({}, emission).radiosity);
  for (PointReading& reading : readings) reading.total *= 100;
  return readings;
}

void evenlyLitFloor(Validation& validation) {
  const ValidationScene scene(validation, "CIE 171 5.6", sceneOfRectangles(zUpBox(4, 4, 3, 0)), 0.25);
  if (!scene) return;
  const double wall[5] = {35.901, 27.992, 21.639, 16.716, 12.967};
  const double ceiling[8] = {26.80, 30.94, 33.98, 35.57, 35.57, 33.98, 30.94, 26.80};
  std::vector<MeasuringPoint> points;
  for (int i = 0; i < 5; ++i) points.push_back({zUp(2, 0, 0.75 + 0.5 * i), zUp(0, 1, 0)});
  for (int i = 0; i < 8; ++i) points.push_back({zUp(2, 0.25 + 0.5 * i, 3), zUp(0, 0, -1)});
  const auto readings = percentOf(scene, "floor", points);
  for (int i = 0; i < 5; ++i) {
    validation.relative("CIE 171 5.6", at("wall, % at x, z", 2, 0.75 + 0.5 * i), wall[i], readings[i].total,
                        kDirect);
  }
  for (int i = 0; i < 8; ++i) {
    validation.relative("CIE 171 5.6", at("ceiling, % at x, y", 2, 0.25 + 0.5 * i), ceiling[i],
                        readings[5 + i].total, kDirect);
  }
}

void litWallBehindBox(Validation& validation) {
  std::vector<RectangleSurface> surfaces = zUpBox(4, 4, 3, 0);
  surfaces.push_back(zUpRectangle("box front", {0, 2.5, 0}, {4, 0, 0}, {0, 0, 1}, 0));
  surfaces.push_back(zUpRectangle("box top", {0, 2.5, 1}, {4, 0, 0}, {0, 0.2, 0}, 0));
  surfaces.push_back(zUpRectangle("box back", {0, 2.7, 0}, {0, 0, 1}, {4, 0, 0}, 0));
  const ValidationScene scene(validation, "CIE 171 5.7", sceneOfRectangles(surfaces), 0.25);
  if (!scene) return;
  const double wall[6] = {16.07, 16.33, 15.40, 13.32, 10.32, 7.08}, floor[5] = {3.38, 3.63, 3.01, 0, 0};
  std::vector<MeasuringPoint> points;
  for (int i = 0; i < 6; ++i) points.push_back({zUp(2, 0, 2.75 - 0.5 * i), zUp(0, 1, 0)});
  for (int i = 0; i < 5; ++i) points.push_back({zUp(2, 0.25 + 0.5 * i, 0), zUp(0, 0, 1)});
  const auto readings = percentOf(scene, "wall y=max", points);
  for (int i = 0; i < 6; ++i) {
    validation.relative("CIE 171 5.7", at("wall, % at x, z", 2, 2.75 - 0.5 * i), wall[i], readings[i].total,
                        kDirect);
  }
  for (int i = 0; i < 5; ++i) {
    const std::string name = at("floor, % at x, y", 2, 0.25 + 0.5 * i);
    if (floor[i] > 0) {
      validation.relative("CIE 171 5.7", name, floor[i], readings[6 + i].total, kTotal);
    } else {
      validation.absolute("CIE 171 5.7", name, 0, readings[6 + i].total, 0.02);
    }
  }
}

void interreflectedCube(Validation& validation) {
  const double reflectance[11] = {.05, .1, .2, .3, .4, .5, .6, .7, .8, .9, .95};
  const double indirect[11] = {5.482,  11.574,  26.042,  44.643, 69.444, 104.167,
                               156.25, 243.056, 416.667, 937.5,  1979.17};
  for (int i = 0; i < 11; ++i) {
    const ValidationScene scene(validation, "CIE 171 5.8", sceneOfRectangles(zUpBox(4, 4, 4, reflectance[i])),
                                0.5);
    if (!scene) return;
    const ForwardLight light =
        scene.light({pointSource(zUp(2, 2, 2), 10000, Luminaire::Distribution::kIsotropic)});
    char name[60];
    std::snprintf(name, sizeof name, "mean indirect lx, reflectance %g", reflectance[i]);
    validation.relative("CIE 171 5.8", name, indirect[i],
                        scene.mean(light.illuminance, "") - scene.mean(light.direct, ""), kMean);
  }
}

}  // namespace

void validateDirectCie171(Validation& validation) {
  pointSources(validation);
  areaSource(validation);
  fluxOnSurfaces(validation);
}

void validateReflectedCie171(Validation& validation) {
  evenlyLitFloor(validation);
  litWallBehindBox(validation);
  interreflectedCube(validation);
}

}  // namespace fiatlux
