// Where a luminaire of a photometric file ends up on its site.
#include "core/transport/mounted_luminaire.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/photometry/photometric_values.h"

namespace fiatlux {
namespace {

const Site kSite{{1, 3, 2}, {0, -1, 0}, {1, 0, 0}, 0.6};

/// A quadrant table, brighter in C0 than in C90; 1.2 m long, 0.3 m wide.
std::shared_ptr<const Photometry> table(PhotometricAxis longAxis) {
  auto photometry = std::make_shared<Photometry>();
  photometry->symmetry = PhotometricSymmetry::kQuadrant;
  photometry->longAxis = longAxis;
  photometry->luminous.length = 1.2;
  photometry->luminous.width = 0.3;
  photometry->gamma = {0, 45, 90};
  photometry->c = {0, 90};
  photometry->candela = {1000, 800, 0, 1000, 400, 0};
  return photometry;
}

void expectNear(const Vec3& a, const Vec3& b) { EXPECT_NEAR(length(a - b), 0, 1e-9) << a.x << " " << a.y; }

TEST(MountedLuminaire, LiesAlongTheAxisThatItsFileNames) {
  const Luminaire c0 = mountedLuminaire(exactType(table(PhotometricAxis::kC0)), 0, kSite, {});
  EXPECT_EQ(c0.width, 1.2);
  EXPECT_EQ(c0.height, 0.3);
  const Luminaire c90 = mountedLuminaire(exactType(table(PhotometricAxis::kC90)), 0, kSite, {});
  EXPECT_EQ(c90.width, 0.3);
  EXPECT_EQ(c90.height, 1.2);
  expectNear(c90.axis, kSite.axis);
  expectNear(c90.position, kSite.position);
}

TEST(MountedLuminaire, EmitsWhatIsAskedOrWhatItsTableHolds) {
  const auto photometry = table(PhotometricAxis::kC0);
  const double held = integratedFlux(*photometry);
  const Luminaire own = mountedLuminaire(exactType(photometry), 0, kSite, {}),
                  twice = mountedLuminaire(exactType(photometry), 2 * held, kSite, {});
  EXPECT_NEAR(own.flux, held, 1e-9);
  EXPECT_NEAR(own.intensity({0, 0, 1}), 1000, 1e-9);
  EXPECT_NEAR(twice.intensity({0, 0, 1}), 2000, 1e-9);
}

TEST(MountedLuminaire, TurnsItsPlanes) {
  Mounting mounting;
  mounting.turn = 90;
  const Luminaire turned = mountedLuminaire(exactType(table(PhotometricAxis::kC0)), 0, kSite, mounting);
  expectNear(turned.axis, cross(kSite.normal, kSite.axis));
  // What C0 sent along the site's axis now goes across it.
  const double s = std::sqrt(0.5);
  const Vec3 alongSite = s * kSite.axis + s * kSite.normal;
  const auto seen = [&](const Luminaire& l, const Vec3& d) {
    return l.intensity({dot(d, l.axis), dot(d, cross(l.normal, l.axis)), dot(d, l.normal)});
  };
  const Luminaire straight = mountedLuminaire(exactType(table(PhotometricAxis::kC0)), 0, kSite, {});
  EXPECT_NEAR(seen(straight, alongSite), 800, 1e-6);
  EXPECT_NEAR(seen(turned, alongSite), 400, 1e-6);
}

TEST(MountedLuminaire, AimsBeforeItsMount) {
  Mounting mounting;
  mounting.aim = Vec3{3, 1, 2};  // 45 degrees along the site's axis
  const Luminaire aimed = mountedLuminaire(exactType(table(PhotometricAxis::kC0)), 0, kSite, mounting);
  expectNear(aimed.normal, normalized(Vec3{1, -1, 0}));
  EXPECT_NEAR(dot(aimed.axis, aimed.normal), 0, 1e-12);
  EXPECT_NEAR(aimed.position.y, 3 - 0.6 * std::sqrt(0.5), 1e-9);
}

TEST(MountedLuminaire, TakesADirectionOfItsOwn) {
  Mounting mounting;
  mounting.normal = Vec3{0, 0, 1};
  mounting.axis = Vec3{1, 1, 1};
  mounting.width = mounting.height = 0.1;
  const Luminaire own = mountedLuminaire(exactType(table(PhotometricAxis::kC0)), 0, kSite, mounting);
  expectNear(own.normal, {0, 0, 1});
  expectNear(own.axis, normalized(Vec3{1, 1, 0}));
  EXPECT_EQ(own.width, 0.1);
}

TEST(MountedLuminaire, ASampledTypeIsTheExactOneButForItsLookUp) {
  const PhotometricType exact = exactType(table(PhotometricAxis::kC90)),
                        sampled = sampledType(table(PhotometricAxis::kC90));
  EXPECT_EQ(sampled.flux, exact.flux);
  EXPECT_EQ(sampled.beam, exact.beam);
  const Luminaire a = mountedLuminaire(exact, 500, kSite, {}), b = mountedLuminaire(sampled, 500, kSite, {});
  EXPECT_EQ(a.width, b.width);
  for (double gamma = 0; gamma < 1.5; gamma += 0.07)
    for (double c = 0; c < 6.2; c += 0.4) {
      const Vec3 d{std::sin(gamma) * std::cos(c), std::sin(gamma) * std::sin(c), std::cos(gamma)};
      EXPECT_NEAR(b.intensity(d), a.intensity(d), 0.004 * a.intensity({0, 0, 1}));
    }
}

}  // namespace
}  // namespace fiatlux
