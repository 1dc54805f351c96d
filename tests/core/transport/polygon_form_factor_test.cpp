// Lambert's polygon against closed forms.
#include "core/transport/polygon_form_factor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace fiatlux {
namespace {

TEST(PolygonFormFactor, PointToOffsetRectangle) {
  const Vec3 corners[4] = {{0, 0, 3}, {2, 0, 3}, {2, 1, 3}, {0, 1, 3}};
  EXPECT_NEAR(polygonFormFactor({0.3, 0.7, 0}, {0, 0, 1}, corners, 4), 0.059156784, 1e-8);
}

TEST(PolygonFormFactor, OrientationOfThePolygonDoesNotMatter) {
  const Vec3 corners[4] = {{0, 1, 3}, {2, 1, 3}, {2, 0, 3}, {0, 0, 3}};
  EXPECT_NEAR(polygonFormFactor({0.3, 0.7, 0}, {0, 0, 1}, corners, 4), 0.059156784, 1e-8);
}

TEST(PolygonFormFactor, WhatIsBelowTheHorizonDoesNotCount) {
  // A wall that reaches as far below the floor as above it: only its upper half is seen.
  const Vec3 whole[4] = {{1, -1, -2}, {1, 1, -2}, {1, 1, 2}, {1, -1, 2}};
  const Vec3 upper[4] = {{1, -1, 0}, {1, 1, 0}, {1, 1, 2}, {1, -1, 2}};
  const double seen = polygonFormFactor({0, 0, 0}, {0, 0, 1}, upper, 4);
  EXPECT_GT(seen, 0.05);
  EXPECT_NEAR(polygonFormFactor({0, 0, 0}, {0, 0, 1}, whole, 4), seen, 1e-12);
  const Vec3 lower[3] = {{1, -1, -2}, {1, 1, -2}, {1, 1, -0.5}};
  EXPECT_EQ(polygonFormFactor({0, 0, 0}, {0, 0, 1}, lower, 3), 0);
}

TEST(PolygonFormFactor, ClosedBoxAroundThePointAddsUpToOne) {
  const double x[2] = {-1, 2}, y[2] = {-3, 0.5}, top = 1.5;
  const Vec3 at{0, 0, 0}, up{0, 0, 1};
  const Vec3 ceiling[4] = {{x[0], y[0], top}, {x[1], y[0], top}, {x[1], y[1], top}, {x[0], y[1], top}};
  double sum = polygonFormFactor(at, up, ceiling, 4);
  for (int i = 0; i < 2; ++i) {
    const Vec3 acrossX[4] = {{x[i], y[0], 0}, {x[i], y[1], 0}, {x[i], y[1], top}, {x[i], y[0], top}};
    const Vec3 acrossY[4] = {{x[0], y[i], 0}, {x[1], y[i], 0}, {x[1], y[i], top}, {x[0], y[i], top}};
    sum += polygonFormFactor(at, up, acrossX, 4) + polygonFormFactor(at, up, acrossY, 4);
  }
  EXPECT_NEAR(sum, 1, 1e-12);
}

TEST(PolygonFormFactor, FarAwayItIsTheInverseSquare) {
  const Vec3 corners[4] = {{0, 0, 50}, {0.1, 0, 50}, {0.1, 0.1, 50}, {0, 0.1, 50}};
  EXPECT_NEAR(polygonFormFactor({0.05, 0.05, 0}, {0, 0, 1}, corners, 4) / (0.01 / (std::numbers::pi * 2500)),
              1, 1e-5);
}

}  // namespace
}  // namespace fiatlux
