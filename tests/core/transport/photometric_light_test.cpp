// Direct light of luminaires (photometric_light by direct_quadrature) against the inverse square law, and
// what turning them must and must not change.
#include "core/transport/photometric_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "core/transport/patch_tiles.h"
#include "core/transport/polygon_form_factor.h"
#include "tests/core/operator_scene.h"

namespace fiatlux {
namespace {

/// Nothing stands in the way of light.
Scene clearScene() {
  Scene scene = operatorScene(12, 3);
  std::fill(scene.lightOperator->visibility.steps.begin(), scene.lightOperator->visibility.steps.end(),
            SiteVisibility::kSteps);
  return scene;
}

/// Twice as bright along C0 as along C90.
double oval(const Vec3& d) { return d.z > 0 ? 100 * d.z * (1.5 + 0.5 * (d.x * d.x - d.y * d.y)) : 0; }

Luminaire on(const Site& site, const Intensity& intensity, double size) {
  Luminaire luminaire = luminaireOf(site);
  luminaire.distribution = Luminaire::Distribution::kPhotometric;
  luminaire.width = luminaire.height = size;
  luminaire.intensity = intensity;
  return luminaire;
}

TEST(PhotometricLight, ASmallLuminaireFollowsTheInverseSquareLaw) {
  const Scene scene = clearScene();
  const Site& site = scene.sites[1];
  const std::vector<float> light = PhotometricLight(scene).direct({{1, on(site, oval, 0)}});
  for (std::uint32_t p = 0; p < scene.patches.rows(); p += 7) {
    const Vec3 d = scene.patches.center[p] - site.position;
    const double distance = length(d), cosine = -dot(d, scene.patches.normal[p]) / distance;
    if (distance < 2 || cosine < 0.3) continue;
    const Vec3 across = cross(site.normal, site.axis);
    const double cd = oval((1 / distance) * Vec3{dot(d, site.axis), dot(d, across), dot(d, site.normal)});
    EXPECT_NEAR(light[p] / (cd * cosine / (distance * distance)), 1, 0.01) << p;
  }
}

TEST(PhotometricLight, ALambertianSquareIsItsFormFactor) {
  const Scene scene = clearScene();
  const Site& site = scene.sites[0];
  const std::vector<float> light = PhotometricLight(scene).direct({{0, lambertianOn(site)}});
  const Vec3 u = 0.5 * site.size * site.axis, v = 0.5 * site.size * cross(site.normal, site.axis);
  const Vec3 corners[4] = {site.position - u - v, site.position + u - v, site.position + u + v,
                           site.position - u + v};
  for (std::uint32_t p = 0; p < scene.patches.rows(); p += 5) {
    const Vec3& center = scene.patches.center[p];
    if (length(center - site.position) < 2) continue;
    const double expected =
        polygonFormFactor(center, scene.patches.normal[p], corners, 4) / (site.size * site.size);
    EXPECT_NEAR(light[p], expected, 0.02 * expected + 1e-6) << p;
  }
}

TEST(PhotometricLight, NothingFallsOnThePlaneThatALuminaireLiesInWhereverRoundingPutsIt) {
  const Scene scene = clearScene();
  const auto round = [](const Vec3& d) { return 100 * (1 + 0.2 * d.z); };  // a part of it backwards
  const auto map = std::make_shared<const IntensityMap>(round);
  const PhotometricLight light(scene);
  const Vec3 normal = scene.patches.normal[0];
  Luminaire luminaire = on(scene.sites[0], round, 0.5);
  luminaire.normal = normal;
  luminaire.axis = normalized(cross(normal, {0.6, 0.7, 0.4}));
  for (const double off : {-5e-8, 0.0, 5e-8}) {
    luminaire.position = scene.patches.center[0] - off * normal;
    EXPECT_EQ(light.direct({{0, luminaire}})[0], 0) << off;
    EXPECT_EQ(light.direct({{0, luminaire, map}})[0], 0) << off;
  }
}

TEST(PhotometricLight, ANarrowBeamIsAsWideAsItsLuminaireMakesIt) {
  // 12 degrees from 10 cm, 0.7 m away: as a point it would be 5 % too bright below and 16 % too dark aside.
  Scene scene = clearScene();
  Site& site = scene.sites[0];
  std::uint32_t below = 0;
  for (std::uint32_t p = 0; p < scene.patches.count; ++p)
    if (dot(scene.patches.normal[p], site.normal) < -0.9) below = p;
  const Vec3 target = scene.patches.center[below];
  const auto spot = [](const Vec3& d) { return d.z > 0 ? 1000 * std::pow(d.z, 126) : 0.0; };
  for (const double aside : {0.0, 0.1, 0.2}) {
    site.position = target - 0.7 * site.normal + aside * site.axis;
    Luminaire luminaire = on(site, spot, 0.1);
    luminaire.beam = 12 * std::numbers::pi / 180;
    const float light = PhotometricLight(scene).direct({{0, luminaire}})[below];
    const Vec3 across = cross(site.normal, site.axis);
    const PatchTile tile = patchTiles(scene.patches, scene.lightOperator->charts)[below];
    constexpr int kParts = 40;
    double sum = 0;
    for (int i = 0; i < kParts * kParts; ++i)
      for (int k = 0; k < 20 * 20; ++k) {
        const Vec3 on = target + ((i % kParts + 0.5) / kParts - 0.5) * tile.edgeU +
                        ((i / kParts + 0.5) / kParts - 0.5) * tile.edgeV;
        const Vec3 from = site.position + ((k % 20 + 0.5) / 20 - 0.5) * 0.1 * site.axis +
                          ((k / 20 + 0.5) / 20 - 0.5) * 0.1 * across;
        const Vec3 d = on - from;
        const double inverse = 1 / length(d);
        sum += spot({0, 0, inverse * dot(d, site.normal)}) * -dot(d, scene.patches.normal[below]) * inverse *
               inverse * inverse;
      }
    const double expected = sum / (kParts * kParts * 400);
    EXPECT_NEAR(light / expected, 1, 0.03) << aside;
  }
}

TEST(PhotometricLight, ReflectedLightHasTheMeansThatTheFileKnows) {
  Scene scene = clearScene();
  const PhotometricCandidate candidate{1, on(scene.sites[1], oval, 0.2)};
  const std::vector<float> direct = PhotometricLight(scene).direct({candidate});
  const std::vector<float> before = PhotometricLight(scene).total({candidate}, direct);
  SurfaceExchange& exchange = scene.lightOperator->surfaces;
  exchange.surfaces = static_cast<std::uint32_t>(scene.surfaces.size());
  const Patches& patches = scene.patches;
  // What the exchange says of each surface, by up to 30 % more.
  std::vector<double> area(exchange.surfaces), reflected(exchange.surfaces);
  double lumens = 0;
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    area[patches.surface[p]] += patches.area[p];
    reflected[patches.surface[p]] += patches.area[p] * (before[p] - direct[p]);
    if (p < patches.count) lumens += patches.area[p] * patches.reflectance[p] * direct[p];
  }
  for (std::uint32_t p = 0; p < patches.count; ++p)
    for (std::uint32_t s = 0; s < exchange.surfaces; ++s)
      exchange.means.push_back(static_cast<float>((1 + 0.15 * s) * reflected[s] / area[s] / lumens));
  const std::vector<float> after = PhotometricLight(scene).total({candidate}, direct);
  for (std::uint32_t p = 0; p < patches.rows(); ++p)
    EXPECT_NEAR(after[p] - direct[p], (1 + 0.15 * patches.surface[p]) * (before[p] - direct[p]),
                1e-4 * before[p])
        << p;
}

TEST(PhotometricLight, TurningByNinetyDegreesSwapsThePlanes) {
  const Scene scene = clearScene();
  const Site& site = scene.sites[1];
  Luminaire turned = on(site, oval, 0.3), swapped = turned;
  turned.axis = cross(site.normal, site.axis);
  swapped.intensity = [](const Vec3& d) { return oval({d.y, -d.x, d.z}); };
  const PhotometricLight light(scene);
  const std::vector<float> a = light.direct({{1, turned}}), b = light.direct({{1, swapped}}),
                           straight = light.direct({{1, on(site, oval, 0.3)}});
  double change = 0;
  for (std::size_t p = 0; p < a.size(); ++p) {
    EXPECT_NEAR(a[p], b[p], 1e-6 + 1e-5 * b[p]) << p;
    change = std::max(change, std::abs(double{a[p]} - straight[p]));
  }
  EXPECT_GT(change, 0.1);
}

TEST(PhotometricLight, ShadowsTakeTheirShare) {
  Scene scene = clearScene();
  const std::vector<float> whole = PhotometricLight(scene).direct({{2, on(scene.sites[2], oval, 0.2)}});
  const std::uint32_t rows = scene.patches.rows();
  auto& steps = scene.lightOperator->visibility.steps;
  steps[2 * rows + 3] = 0;
  steps[2 * rows + 4] = SiteVisibility::stepOf(0.25);
  const std::vector<float> shaded = PhotometricLight(scene).direct({{2, on(scene.sites[2], oval, 0.2)}});
  ASSERT_GT(whole[4], 0);
  EXPECT_EQ(shaded[3], 0);
  const double share = SiteVisibility::shareOf(SiteVisibility::stepOf(0.25));
  EXPECT_NEAR(share, 0.25, std::sqrt(0.25) / SiteVisibility::kSteps + 1e-4);  // half a step of its root
  EXPECT_NEAR(shaded[4] / whole[4], share, 1e-5);
  EXPECT_EQ(shaded[5], whole[5]);
}

TEST(PhotometricLight, ALambertianCandidateIsTheResponseWhereTheOperatorMissesLittle) {
  // Responses that are what the operator says, but for a few per cent: the control variate brings them back.
  Scene scene = clearScene();
  const PhotometricLight plain(scene);
  const PhotometricCandidate candidate{1, lambertianOn(scene.sites[1])};
  const std::vector<float> direct = plain.direct({candidate});
  const ExchangeOperator exchange(scene.patches, scene.lightOperator->groups, scene.lightOperator->exchange);
  const std::vector<float> indirect = exchange.indirect(direct, 1);
  float* response = &scene.responses.illuminance[std::size_t{1} * scene.patches.rows()];
  for (std::uint32_t p = 0; p < scene.patches.rows(); ++p)
    response[p] = direct[p] + (p % 2 ? 1.05f : 0.97f) * std::max(0.0f, indirect[p]);
  const std::vector<float> light = plain.total({candidate}, direct);
  for (std::uint32_t p = 0; p < scene.patches.rows(); ++p)
    EXPECT_NEAR(light[p], response[p], 2e-3 * response[p] + 1e-7) << p;
}

TEST(PhotometricLight, WhatTheExchangeMissesFarFromALuminaireComesFromTheSiteWhoseLightFallsAlike) {
  // The operator knows half of the light of site 1. A luminaire on site 0 that shines as a square on site 1
  // would gets the other half from there, but for what is beside that site.
  Scene scene = clearScene();
  scene.sites[1].position = scene.sites[0].position + Vec3{0.9, 0, 0};
  const PhotometricLight plain(scene);
  Luminaire moved = lambertianOn(scene.sites[1]);
  const PhotometricCandidate candidate{0, moved};
  const std::vector<float> direct = plain.direct({candidate});
  const std::vector<float> indirect = plain.exchange().indirect(direct, 1);
  const std::uint32_t rows = scene.patches.rows();
  for (std::uint32_t p = 0; p < rows; ++p) {
    scene.responses.illuminance[p] = 0;
    scene.responses.illuminance[std::size_t{rows} + p] = direct[p] + 2 * std::max(0.0f, indirect[p]);
  }
  const std::vector<float> light = plain.total({candidate}, direct);
  for (std::uint32_t p = 0; p < rows; ++p) {
    const double distance = length(scene.patches.center[p] - moved.position);
    const double beside = 1.5 * (moved.width + std::sqrt(scene.patches.area[p]));
    if (direct[p] > 0 && distance < beside) continue;
    const double whole = direct[p] + 2 * std::max(0.0f, indirect[p]);
    EXPECT_NEAR(light[p], whole, 2e-3 * whole + 1e-7) << p;
  }
}

TEST(PhotometricLight, InFloatItIsNearlyTheSame) {
  const Scene scene = clearScene();
  const auto map = std::make_shared<const IntensityMap>(oval);
  const PhotometricLight light(scene);
  Luminaire half = on(scene.sites[1], oval, 0.3);
  half.intensity = [](const Vec3& d) { return 0.5 * oval(d); };
  const std::vector<float> exact = light.direct({{1, half}}), looked = light.direct({{1, half, map, 0.5f}});
  for (std::size_t p = 0; p < exact.size(); ++p)
    EXPECT_NEAR(looked[p], exact[p], 2e-3 * exact[p] + 1e-4) << p;
  // What hangs among patches has fewer samples there.
  Luminaire low = half;
  low.position.y = 0.1;
  const std::vector<float> near = light.direct({{1, low}}), sampled = light.direct({{1, low, map, 0.5f}});
  double sum = 0, other = 0;
  for (std::size_t p = 0; p < near.size(); ++p) sum += near[p], other += sampled[p];
  EXPECT_NEAR(other / sum, 1, 0.01);
}

TEST(PhotometricLight, WhatIsKnownOfASiteChangesNothing) {
  const Scene scene = clearScene();
  const std::vector<PhotometricCandidate> first = {{1, on(scene.sites[1], oval, 0.2)}},
                                          both = {{1, on(scene.sites[1], oval, 0.3)},
                                                  {2, on(scene.sites[2], oval, 0.2)}};
  const PhotometricLight light(scene), fresh(scene);
  (void)light.total(first, light.direct(first));
  const std::vector<float> a = light.total(both, light.direct(both)),
                           b = fresh.total(both, fresh.direct(both));
  for (std::size_t p = 0; p < a.size(); ++p) EXPECT_NEAR(a[p], b[p], 1e-5 * b[p]) << p;
}

TEST(PhotometricLight, IsPreparedBeforeTheResponsesAreThere) {
  Scene scene = clearScene();
  const std::vector<PhotometricCandidate> all = {{0, on(scene.sites[0], oval, 0.2)},
                                                 {1, on(scene.sites[1], oval, 0.2)},
                                                 {2, on(scene.sites[2], oval, 0.2)}};
  const PhotometricLight fresh(scene);
  const std::vector<float> b = fresh.total(all, fresh.direct(all));
  const Responses responses = std::exchange(scene.responses, {});
  const PhotometricLight light(scene);
  EXPECT_FALSE(light.prepare(2));
  EXPECT_TRUE(light.prepare(2));
  EXPECT_TRUE(light.prepare(2));
  scene.responses = responses;
  const std::vector<float> a = light.total(all, light.direct(all));
  for (std::size_t p = 0; p < a.size(); ++p) EXPECT_NEAR(a[p], b[p], 1e-5 * b[p]) << p;
}

TEST(PhotometricLight, ATiltedLuminaireHangsBeforeItsMount) {
  const Site site{{0, 3, 0}, {0, -1, 0}, {1, 0, 0}, 0.6};
  const double tilt = std::numbers::pi / 6;
  const Vec3 normal{std::sin(tilt), -std::cos(tilt), 0}, axis{std::cos(tilt), std::sin(tilt), 0};
  const Vec3 at = mountedPosition(site, normal, axis, 0.4, 0.2);
  EXPECT_NEAR(at.y, 3 - 0.1, 1e-12);
  EXPECT_NEAR(mountedPosition(site, site.normal, site.axis, 0.4, 0.2).y, 3, 1e-12);
}

}  // namespace
}  // namespace fiatlux
