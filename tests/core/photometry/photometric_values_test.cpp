// Values of distributions whose integrals and angles are known in closed form.
#include "core/photometry/photometric_values.h"

#include <gtest/gtest.h>

#include "core/photometry/intensity.h"
#include "tests/core/photometry/photometric_files.h"

namespace fiatlux {
namespace {

using samples::angles;
using samples::cosine;
using samples::cosinePower;
using samples::IesFile;
using samples::read;
using samples::sine;
using std::numbers::pi;

Photometry tableOf(std::vector<double> gamma, std::vector<double> c, samples::Distribution candela) {
  IesFile file;
  file.gamma = std::move(gamma), file.c = std::move(c), file.candela = std::move(candela);
  return read(file.text()).value();
}

TEST(PhotometricValues, FluxOfAPowerOfTheCosine) {
  for (const double n : {1.0, 2.0, 4.0, 20.0, 126.0}) {
    const Photometry p = tableOf(angles(0, 90, 0.25), {0}, cosinePower(1000, n));
    EXPECT_NEAR(integratedFlux(p), 2 * pi * 1000 / (n + 1), 2e-3 * 2 * pi * 1000 / (n + 1)) << n;
    EXPECT_EQ(upwardShare(p), 0);
  }
}

TEST(PhotometricValues, FluxIsExactForWhatIsReadBetweenTheAngles) {
  // Coarse and uneven: Gauss points between the nodes must find the same flux as the closed form.
  const Photometry p = tableOf({0, 10, 40, 90, 135, 180}, {0, 30, 50, 90},
                               [](double c, double gamma) { return 100 + c * 3 + 200 * cosine(gamma / 2); });
  constexpr double kNodes[] = {-0.906179845938664, -0.538469310105683, 0, 0.538469310105683,
                               0.906179845938664};
  constexpr double kWeights[] = {0.236926885056189, 0.478628670499366, 0.568888888888889, 0.478628670499366,
                                 0.236926885056189};
  double sum = 0;
  for (std::size_t i = 0; i + 1 < p.c.size(); ++i)
    for (double from = 0; from < 180; from += 5)
      for (int a = 0; a < 5; ++a)
        for (int b = 0; b < 5; ++b) {
          const double half = (p.c[i + 1] - p.c[i]) / 2, c = p.c[i] + half * (1 + kNodes[a]);
          const double gamma = from + 2.5 * (1 + kNodes[b]);
          sum += kWeights[a] * kWeights[b] * half * 2.5 * intensityAt(p, c, gamma) * sine(gamma);
        }
  const double flux = 4 * sum * (pi / 180) * (pi / 180);
  EXPECT_NEAR(integratedFlux(p), flux, 1e-6 * flux);
}

TEST(PhotometricValues, UpwardShareSplitsAStepAtTheHorizontal) {
  const auto even = [](double, double) { return 100; };
  EXPECT_NEAR(upwardShare(tableOf(angles(0, 180, 45), {0}, even)), 0.5, 1e-12);
  EXPECT_NEAR(upwardShare(tableOf({0, 60, 120, 180}, {0}, even)), 0.5, 1e-12);
  EXPECT_NEAR(upwardShare(tableOf({90, 135, 180}, {0}, even)), 1, 1e-12);
}

TEST(PhotometricValues, BeamAndFieldOfAPowerOfTheCosine) {
  for (const double n : {1.0, 4.0, 20.0, 126.0}) {
    const Photometry p = tableOf(angles(0, 90, 0.5), {0}, cosinePower(1000, n));
    const auto full = [&](double share) { return 2 * std::acos(std::pow(share, 1 / n)) * 180 / pi; };
    EXPECT_NEAR(openingAngle(p, 0.5), full(0.5), 0.01) << n;
    EXPECT_NEAR(openingAngle(p, 0.1), full(0.1), 0.02) << n;
    EXPECT_EQ(maxCandela(p), 1000);
  }
}

TEST(PhotometricValues, BeamIsTheMeanOfTwoPlanes) {
  // Linear to 0 at 40 degrees in C0-C180 and at 80 in C90-C270.
  const Photometry p = tableOf(angles(0, 90, 10), angles(0, 90, 90), [](double c, double gamma) {
    return std::max(0.0, 100 * (1 - gamma / (c < 45 ? 40 : 80)));
  });
  EXPECT_NEAR(openingAngle(p, 0.5), (40 + 80) / 2.0, 1e-9);
}

TEST(PhotometricValues, BeamOfABatwingReachesItsOuterFlanks) {
  const Photometry p = tableOf({0, 30, 60, 90}, {0}, [](double, double gamma) {
    return gamma == 30 ? 100.0 : gamma == 0 ? 20.0 : 0.0;
  });
  EXPECT_NEAR(openingAngle(p, 0.5), 2 * 45, 1e-9);
}

TEST(PhotometricValues, BeamOfALeaningSpotLiesOnOneSide) {
  const Photometry p = tableOf(angles(0, 90, 10), angles(0, 180, 90),
                               [](double c, double gamma) { return c == 0 && gamma == 40 ? 100.0 : 0.0; });
  EXPECT_NEAR(openingAngle(p, 0.5), 10, 1e-9);  // 35 to 45 in one plane, nothing in the other
}

TEST(PhotometricValues, BeamBetweenThePlanesIsTheOneOfTheBrightestDirection) {
  const Photometry p = tableOf(angles(0, 90, 10), angles(0, 180, 45),
                               [](double c, double gamma) { return c == 45 && gamma == 40 ? 100.0 : 0.0; });
  EXPECT_NEAR(openingAngle(p, 0.5), 10, 1e-9);
}

TEST(PhotometricValues, BeamOfAnUplightOpensUpwards) {
  const Photometry p = tableOf(angles(0, 180, 0.5), {0},
                               [](double, double gamma) { return gamma > 90 ? 100 * -cosine(gamma) : 0.0; });
  EXPECT_NEAR(openingAngle(p, 0.5), 120, 0.01);
  EXPECT_NEAR(openingAngle(tableOf(angles(0, 180, 5), {0}, [](double, double) { return 10; }), 0.5), 360,
              1e-9);
}

TEST(PhotometricValues, EfficacyNeedsWatts) {
  IesFile file;
  const Photometry p = read(file.text()).value();
  EXPECT_NEAR(efficacy(p).value(), integratedFlux(p) / 30, 1e-12);
  file.watts = 0;
  EXPECT_FALSE(efficacy(read(file.text()).value()));
}

TEST(Intensity, IsBilinearAndDarkOutsideItsAngles) {
  const Photometry p =
      tableOf({0, 10, 20}, {0, 45, 90}, [](double c, double gamma) { return c + gamma + 1; });
  EXPECT_NEAR(intensityAt(p, 10, 5), 16, 1e-12);
  EXPECT_NEAR(intensityAt(p, 350, 5), 16, 1e-12);
  EXPECT_NEAR(intensityAt(p, 170 + 720, 5), 16, 1e-9);
  EXPECT_EQ(intensityAt(p, 0, 20), 21);
  EXPECT_EQ(intensityAt(p, 0, 20.001), 0);
  EXPECT_NEAR(intensity(p, {0, 0, 3}), intensityAt(p, 0, 0), 1e-12);
  EXPECT_EQ(intensity(p, {0, 0, 0}), 0);
}

}  // namespace
}  // namespace fiatlux
