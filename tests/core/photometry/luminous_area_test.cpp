// The 14 bodies of LM-63, and what is seen of them.
#include "core/photometry/luminous_area.h"

#include <gtest/gtest.h>

#include <array>

#include "core/photometry/ies_opening.h"
#include "tests/core/photometry/photometric_files.h"

namespace fiatlux {
namespace {

constexpr double kPi = std::numbers::pi;

struct Case {
  double width, length, height;  // as the file has them
  LuminousShape shape;
  std::array<double, 3> sizes;  // length, width, height
};

TEST(IesOpening, TheBodiesSince2002) {
  using enum LuminousShape;
  const Case cases[] = {{0, 0, 0, kBox, {0, 0, 0}},
                        {2, 3, 0, kBox, {3, 2, 0}},
                        {2, 3, 1, kBox, {3, 2, 1}},
                        {-2, -2, 0, kUprightCylinder, {2, 2, 0}},
                        {-2, -3, 0, kUprightCylinder, {3, 2, 0}},
                        {-2, -2, 1, kUprightCylinder, {2, 2, 1}},
                        {-2, -3, 1, kUprightCylinder, {3, 2, 1}},
                        {-2, -2, -2, kEllipsoid, {2, 2, 2}},
                        {-2, -3, -1, kEllipsoid, {3, 2, 1}},
                        {-2, 3, -2, kCylinderAlong, {3, 2, 2}},
                        {-2, 3, -1, kCylinderAlong, {3, 2, 1}},
                        {2, -3, -3, kCylinderAcross, {3, 2, 3}},
                        {2, -3, -1, kCylinderAcross, {3, 2, 1}},
                        {-2, 0, -2, kCylinderAlong, {0, 2, 2}},
                        {-2, 0, -1, kCylinderAlong, {0, 2, 1}}};
  for (const Case& c : cases) {
    const LuminousArea area = areaOf({c.width, c.length, c.height});
    EXPECT_EQ(area.shape, c.shape) << c.width << " " << c.length << " " << c.height;
    EXPECT_EQ((std::array{area.length, area.width, area.height}), c.sizes) << c.width << " " << c.length;
    EXPECT_EQ(area.round, c.shape != kBox);
  }
}

TEST(IesOpening, TheBodiesBefore2002) {
  using enum LuminousShape;
  const Case cases[] = {{2, 3, 1, kBox, {3, 2, 1}},
                        {-2, 0, 0, kUprightCylinder, {2, 2, 0}},
                        {-2, 0, 1, kUprightCylinder, {2, 2, 1}},
                        {-2, 0, -2, kEllipsoid, {2, 2, 2}},
                        {0, 3, -1, kCylinderAlong, {3, 1, 1}},
                        {3, 0, -1, kCylinderAcross, {1, 3, 1}},
                        {-2, 3, 0, kUprightCylinder, {3, 2, 0}},
                        {-2, 3, -1, kEllipsoid, {3, 2, 1}}};
  for (const Case& c : cases) {
    const LuminousArea area = areaOf({c.width, c.length, c.height, true});
    EXPECT_EQ(area.shape, c.shape) << c.width << " " << c.length << " " << c.height;
    EXPECT_EQ((std::array{area.length, area.width, area.height}), c.sizes) << c.width << " " << c.length;
  }
  EXPECT_EQ(areaOf({-2, 0, 0}).shape, kUprightCylinder);  // as makers still write it
}

double seen(const IesOpening& opening, const Vec3& direction, PhotometricAxis axis = PhotometricAxis::kC0) {
  return projectedArea(areaOf(opening), axis, direction);
}

TEST(LuminousArea, BodiesSeenAlongTheirAxes) {
  const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  EXPECT_NEAR(seen({2, 3, 0.5}, z), 6, 1e-12);
  EXPECT_NEAR(seen({2, 3, 0.5}, x), 1, 1e-12);
  EXPECT_NEAR(seen({2, 3, 0.5}, y), 1.5, 1e-12);
  EXPECT_NEAR(seen({2, 3, 0.5}, x, PhotometricAxis::kC90), 1.5, 1e-12);
  EXPECT_NEAR(seen({-2, -3, 0.5}, z), kPi * 1 * 1.5, 1e-12);
  EXPECT_NEAR(seen({-2, -3, 0.5}, x), 2 * 0.5, 1e-12);
  EXPECT_NEAR(seen({-2, -3, 0.5}, y), 3 * 0.5, 1e-12);
  EXPECT_NEAR(seen({-2, -3, -4}, x), kPi * 1 * 2, 1e-12);
  EXPECT_NEAR(seen({-2, -3, -4}, y), kPi * 1.5 * 2, 1e-12);
  EXPECT_NEAR(seen({-2, 3, -4}, x), kPi * 1 * 2, 1e-12);
  EXPECT_NEAR(seen({-2, 3, -4}, y), 3 * 4, 1e-12);
  EXPECT_NEAR(seen({-2, 3, -4}, z), 3 * 2, 1e-12);
  EXPECT_NEAR(seen({2, -3, -4}, y), kPi * 1.5 * 2, 1e-12);
  EXPECT_NEAR(seen({2, -3, -4}, x), 2 * 4, 1e-12);
  EXPECT_NEAR(seen({-2, 0, -4}, x), kPi * 1 * 2, 1e-12);
  EXPECT_NEAR(seen({0, 0, 0}, z), 0, 1e-12);
}

TEST(LuminousArea, AConvexBodyShowsAQuarterOfItsSurfaceOnAverage) {
  // Cauchy: the mean projection over all directions is a quarter of the surface.
  const std::pair<IesOpening, double> bodies[] = {{{2, 3, 0.5}, 2 * (6 + 1 + 1.5)},
                                                  {{-2, -2, 1}, 2 * kPi + 2 * kPi},
                                                  {{-2, -2, -2}, 4 * kPi},
                                                  {{-2, 3, -2}, 2 * kPi + 6 * kPi},
                                                  {{5, -2, -2}, 2 * kPi + 10 * kPi}};
  constexpr int kSteps = 200;
  for (const auto& [opening, surface] : bodies) {
    double sum = 0;
    for (int i = 0; i < kSteps; ++i)
      for (int j = 0; j < kSteps; ++j) {
        const double z = -1 + (i + 0.5) * 2 / kSteps, r = std::sqrt(1 - z * z),
                     a = (j + 0.5) * 2 * kPi / kSteps;
        sum += seen(opening, {r * std::cos(a), r * std::sin(a), z}) / (kSteps * kSteps);
      }
    EXPECT_NEAR(sum, surface / 4, 1e-3 * surface);
  }
}

TEST(LuminousArea, SidesOfABoxMayDiffer) {
  LuminousArea area{LuminousShape::kBox, 3, 2, 0.4, false, {0.1, 0.2, 0.3, 0.4}};
  EXPECT_NEAR(projectedArea(area, PhotometricAxis::kC0, {1, 0, 0}), 0.2, 1e-12);
  EXPECT_NEAR(projectedArea(area, PhotometricAxis::kC0, {-1, 0, 0}), 0.6, 1e-12);
  EXPECT_NEAR(projectedArea(area, PhotometricAxis::kC0, {0, 1, 0}), 0.6, 1e-12);
  EXPECT_NEAR(projectedArea(area, PhotometricAxis::kC0, {0, -1, 0}), 1.2, 1e-12);
}

}  // namespace
}  // namespace fiatlux
