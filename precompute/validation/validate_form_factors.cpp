// Form factors between rectangles, discs and inside a sphere: by rays (the solver's F) and by the polygon
// formula (direct light of the second surface as a source), each against the closed form.
#include <cmath>
#include <numbers>

#include "core/transport/polygon_form_factor.h"
#include "precompute/light/cast_form_factors.h"
#include "precompute/validation/validation_scene.h"

namespace fiatlux {

namespace {

constexpr double kRays = 0.01, kPolygon = 0.002;  // well within the 2 % promised for means
const std::string kFormFactors = "form factors";

/// Mean over surface `from` of F b, b = 1 on `onto`: the form factor from one surface to the other.
double castFactor(const ValidationScene& scene, const ValidationOptions& options, const std::string& from,
                  const std::string& onto) {
  const FormFactors factors =
      castFormFactors(scene.room(), scene.tracer(), {options.rays, false, options.seed, options.threads, {}});
  std::vector<float> shining(factors.count, 0.0f), received(factors.rows);
  for (std::uint32_t p = 0; p < factors.count; ++p) shining[p] = scene.belongs(p, onto) ? 1.0f : 0.0f;
  irradiance(factors, shining.data(), 1, received.data());
  return scene.mean(received, from);
}

/// The same with the rectangle as a luminaire of exitance 1.
Luminaire luminaireOn(const RectangleSurface& r) {
  Luminaire luminaire;
  luminaire.position = r.corner + 0.5 * r.u + 0.5 * r.v;
  luminaire.normal = normalized(cross(r.u, r.v));
  luminaire.axis = normalized(r.u);
  luminaire.width = length(r.u);
  luminaire.height = length(r.v);
  luminaire.flux = luminaire.width * luminaire.height;
  return luminaire;
}

void rectangles(Validation& validation, const std::string& name, const RectangleSurface& from,
                const RectangleSurface& onto, double expected) {
  const double patch = std::sqrt(length(from.u) * length(from.v)) / 12;
  const ValidationScene scene(validation, kFormFactors, sceneOfRectangles({from, onto}), patch);
  if (!scene) return;
  validation.relative(kFormFactors, name + ", rays", expected,
                      castFactor(scene, validation.options, "from", "onto"), kRays);
  const ForwardLight light = scene.light({luminaireOn(onto)});
  validation.relative(kFormFactors, name + ", polygon", expected, scene.mean(light.direct, "from"), kPolygon);
}

double opposedFactor(double a, double b, double c) {
  const double x = a / c, y = b / c, x1 = std::sqrt(1 + x * x), y1 = std::sqrt(1 + y * y);
  return 2 / (std::numbers::pi * x * y) *
         (std::log(x1 * y1 / std::sqrt(1 + x * x + y * y)) + x * y1 * std::atan(x / y1) +
          y * x1 * std::atan(y / x1) - x * std::atan(x) - y * std::atan(y));
}

void opposed(Validation& validation, const std::string& name, double a, double b, double c) {
  rectangles(validation, "opposed " + name, zUpRectangle("from", {0, 0, 0}, {a, 0, 0}, {0, b, 0}, 0),
             zUpRectangle("onto", {0, 0, c}, {0, b, 0}, {a, 0, 0}, 0), opposedFactor(a, b, c));
}

void discs(Validation& validation) {
  SourceScene source;
  source.meshes = {discMesh("from", {0, 0, 0}, {0, 1, 0}, 1, 256),
                   discMesh("onto", {0, 2, 0}, {0, -1, 0}, 1.5, 256)};
  source.meshes[1].nodeIndex = 1;
  const ValidationScene scene(validation, kFormFactors, source, 0.1);
  if (!scene) return;
  validation.relative(kFormFactors, "coaxial discs r 1, 1.5 at 2, rays", 0.324905,
                      castFactor(scene, validation.options, "from", "onto"), kRays);
}

void sphere(Validation& validation) {
  SourceScene source;
  source.meshes = {sphereMesh("sphere", {0, 1, 0}, 1, 48)};
  const ValidationScene scene(validation, kFormFactors, source, 0.15);
  if (!scene) return;
  const Patches& patches = scene.room().patches;
  const FormFactors factors = castFormFactors(
      scene.room(), scene.tracer(),
      {validation.options.rays, false, validation.options.seed, validation.options.threads, {}});
  // Any part of a sphere sees another part in proportion to its area alone: here a cap and the rest.
  std::vector<float> shining(factors.count, 0.0f), received(factors.rows);
  double cap = 0, all = 0, low = 0, lowArea = 0, squares = 0;
  for (std::uint32_t p = 0; p < factors.count; ++p) {
    shining[p] = patches.center[p].y > 1.5 ? 1.0f : 0.0f;
    cap += shining[p] * patches.area[p];
    all += patches.area[p];
  }
  irradiance(factors, shining.data(), 1, received.data());
  for (std::uint32_t p = 0; p < factors.count; ++p) {
    if (shining[p] > 0) continue;
    low += patches.area[p] * received[p];
    lowArea += patches.area[p];
    squares += patches.area[p] * std::pow(received[p] / (cap / all) - 1, 2);
  }
  validation.relative(kFormFactors, "sphere: rest to cap = A_cap / S, rays", cap / all, low / lowArea, kRays);
  validation.absolute(kFormFactors, "sphere: rms deviation over the patches", 0, std::sqrt(squares / lowArea),
                      0.05);
}

}  // namespace

void validateFormFactors(Validation& validation) {
  opposed(validation, "1 x 1 at 1", 1, 1, 1);
  opposed(validation, "4 x 4 at 3", 4, 4, 3);
  opposed(validation, "4 x 3 at 4", 4, 3, 4);
  rectangles(validation, "perpendicular, common edge, 1 1 1",
             zUpRectangle("from", {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0),
             zUpRectangle("onto", {0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0), 0.200043776);
  rectangles(validation, "offset parallel", zUpRectangle("from", {0, 0, 0}, {1, 0, 0}, {0, 2, 0}, 0),
             zUpRectangle("onto", {0.5, 1, 1.3}, {0, 0.75, 0}, {2, 0, 0}, 0), 0.096460469);
  rectangles(validation, "offset perpendicular", zUpRectangle("from", {0.5, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0),
             zUpRectangle("onto", {0, 0.5, 0.25}, {0, 1.5, 0}, {0, 0, 1}, 0), 0.076841062);
  const Vec3 corners[4] = {{0, 0, 3}, {2, 0, 3}, {2, 1, 3}, {0, 1, 3}};
  validation.relative(kFormFactors, "point to rectangle, Lambert's polygon", 0.059156784,
                      polygonFormFactor({0.3, 0.7, 0}, {0, 0, 1}, corners, 4), 1e-6);
  discs(validation);
  sphere(validation);
}

}  // namespace fiatlux
