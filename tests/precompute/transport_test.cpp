// The whole precomputation on boxes whose answers are known in closed form.
#include "precompute/transport.h"

#include <gtest/gtest.h>

#include <cmath>

#include "precompute/rectangle_room.h"

namespace fiatlux {
namespace {

/// A closed box of one reflectance, 3 x 2.5 x 4 m, with a grid of sites on its ceiling.
Room litBox(double reflectance, double patch = 0.25) {
  const auto faces = boxSurfaces({0, 0, 0}, {3, 2.5, 4}, reflectance, patch);
  Room room = rectangleRoom(faces);
  room.sites = siteGrid(faces[1], 3, 4, 0.5);
  return room;
}

double energy(const Room& room, const float* illuminance) {
  double sum = 0;
  for (std::uint32_t p = 0; p < room.patches.count; ++p) {
    sum += room.patches.area[p] * (1 - room.patches.reflectance[p]) * illuminance[p];
  }
  return sum;
}

TEST(Transport, ClosedBoxOfOneReflectanceHasItsKnownMean) {
  for (const double rho : {0.2, 0.8}) {
    const Room room = litBox(rho);
    const auto transport = computeTransport(room, {});
    ASSERT_TRUE(transport) << transport.error().message;
    double area = 0;
    for (const Surface& s : room.surfaces) area += s.area;
    for (std::uint32_t j = 0; j < transport->responses.sites; ++j) {
      double mean = 0;
      for (std::size_t s = 0; s < room.surfaces.size(); ++s) {
        mean += room.surfaces[s].area / area * transport->exitance[s].mean[j];
      }
      EXPECT_NEAR(mean / (rho / ((1 - rho) * area)), 1, 0.005) << "site " << j;
      EXPECT_NEAR(energy(room, transport->responses.column(j)), 1, 0.005) << "site " << j;
    }
  }
}

}  // namespace
}  // namespace fiatlux
