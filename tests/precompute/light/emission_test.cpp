// The light that leaves a luminaire: as much as its flux, to the side it shines to.
#include "precompute/light/emission.h"

#include <gtest/gtest.h>

#include <numbers>

namespace fiatlux {
namespace {

using Distribution = Luminaire::Distribution;

Luminaire lamp(double width, double height, Distribution distribution = Distribution::kLambertian) {
  Luminaire luminaire;
  luminaire.position = {1, 2, 3};
  luminaire.width = width, luminaire.height = height;
  luminaire.flux = 1000;
  luminaire.distribution = distribution;
  return luminaire;
}

constexpr double kPi = std::numbers::pi;

/// Integral of the intensity over all directions that are not behind the luminaire.
double fluxOf(const Emission& source) {
  constexpr int kRings = 400, kSectors = 8;
  double flux = 0;
  for (int i = 0; i < kRings; ++i)
    for (int j = 0; j < kSectors; ++j) {
      const double y = 2 * (i + 0.5) / kRings - 1, r = std::sqrt(1 - y * y), angle = 2 * kPi * j / kSectors;
      const Vec3 way{r * std::cos(angle), y, r * std::sin(angle)};
      if (source.isBehind(source.position() + way)) continue;
      flux += source.intensity(3.0 * way) * 4 * kPi / (kRings * kSectors);  // of any length
    }
  return flux;
}

TEST(Emission, IntensityIntegratesToTheFlux) {
  for (const Distribution distribution : {Distribution::kLambertian, Distribution::kIsotropic})
    EXPECT_NEAR(fluxOf(Emission(lamp(0, 0, distribution))), 1000, 1e-6 * 1000);
  EXPECT_NEAR(Emission(lamp(0, 0)).intensity({0, -5, 0}), 1000 / kPi, 1e-9);
}

TEST(Emission, AreasAndLambertianPointsShineToOneSide) {
  const Vec3 before{1, 1, 3}, behind{1, 3, 3}, beside{7, 2, 3};
  for (const Emission& source :
       {Emission(lamp(0.5, 0.2)), Emission(lamp(0, 0)), Emission(lamp(0.5, 0.2, Distribution::kIsotropic))}) {
    EXPECT_FALSE(source.isBehind(before));
    EXPECT_TRUE(source.isBehind(behind));
    EXPECT_TRUE(source.isBehind(beside));
  }
  const Emission point(lamp(0, 0, Distribution::kIsotropic));
  for (const Vec3& place : {before, behind, beside}) EXPECT_FALSE(point.isBehind(place));
}

TEST(Emission, PlacesFillTheRectangleClearOfWhatItHangsOn) {
  const Emission source(lamp(0.6, 0.2));
  EXPECT_FALSE(source.isPoint());
  EXPECT_NEAR(source.exitance(), 1000 / 0.12, 1e-9);
  EXPECT_NEAR(length(source.at(0.5, 0.5) - source.position()), 0, 1e-12);
  const auto& corners = source.corners();
  EXPECT_NEAR(length(corners[1] - corners[0]), 0.6, 1e-12);
  EXPECT_NEAR(length(corners[2] - corners[1]), 0.2, 1e-12);
  EXPECT_GT(dot(cross(corners[1] - corners[0], corners[2] - corners[0]), source.normal()), 0);
  EXPECT_NEAR(source.startAt(0.1, 0.9).y, 2 - kLuminaireClearance, 1e-12);
  EXPECT_TRUE(Emission(lamp(0.6, 0)).isPoint());
}

TEST(Emission, DirectionsAreAsManyAsTheirLight) {
  constexpr int kEdge = 256;
  const auto meanCosine = [&](const Emission& source) {
    double mean = 0;
    for (int i = 0; i < kEdge; ++i)
      for (int j = 0; j < kEdge; ++j) {
        const Vec3 d = source.direction((i + 0.5) / kEdge, (j + 0.5) / kEdge);
        EXPECT_NEAR(length(d), 1, 1e-12);
        mean += dot(d, source.normal()) / (kEdge * kEdge);
      }
    return mean;
  };
  EXPECT_NEAR(meanCosine(Emission(lamp(0.6, 0.2))), 2.0 / 3, 1e-3);
  EXPECT_NEAR(meanCosine(Emission(lamp(0, 0))), 2.0 / 3, 1e-3);
  EXPECT_NEAR(meanCosine(Emission(lamp(0, 0, Distribution::kIsotropic))), 0, 1e-3);
}

}  // namespace
}  // namespace fiatlux
