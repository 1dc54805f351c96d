// The tabular UGR against a sum of its own: every luminaire traced through the room, every surface cut into
// tiles.
#include "core/photometry/unified_glare.h"

#include <gtest/gtest.h>

#include <array>

#include "core/base/vec3.h"
#include "core/photometry/intensity.h"
#include "core/photometry/photometric_values.h"
#include "tests/core/photometry/photometric_files.h"

namespace fiatlux {
namespace {

using samples::angles;
using samples::cosine;
using samples::IesFile;
using samples::read;
using samples::sine;

constexpr double kPi = std::numbers::pi;

Photometry panel(samples::Distribution candela, double width = 0.6, double length = 0.6) {
  IesFile file;
  file.width = width, file.length = length;
  file.gamma = angles(0, 180, 2.5), file.c = angles(0, 90, 15);
  file.candela = [=](double c, double gamma) { return std::max(0.0, candela(c, gamma)); };
  return read(file.text()).value();
}

/// A room 8 x 16 m and 2 m high between eye level (z = 0) and luminaires, its floor and ceiling in tiles of 1
/// m, its walls in tiles of 1 x 1 m. Knows nothing of form factors but the differential one between tiles cut
/// 4 x 4.
class TiledRoom {
 public:
  TiledRoom() {
    addPlane({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 8, 16, 0.2, 0);
    addPlane({0, 0, 2}, {1, 0, 0}, {0, 1, 0}, 8, 16, 0.7, 1);
    addPlane({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, 8, 2, 0.5, 2);
    addPlane({0, 16, 0}, {1, 0, 0}, {0, 0, 1}, 8, 2, 0.5, 2);
    addPlane({0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 16, 2, 0.5, 2);
    addPlane({8, 0, 0}, {0, 1, 0}, {0, 0, 1}, 16, 2, 0.5, 2);
  }

  /// Mean indirect lx of the walls under the direct lm on floor, ceiling and walls, spread evenly over each.
  double wallIndirect(const std::array<double, 3>& direct) const {
    // Means over the three surfaces of the tiles' exchange; rows scaled to be closed.
    std::array<std::array<double, 3>, 3> exchange{};
    std::array<double, 3> area{}, light{}, indirect{};
    for (const Tile& to : tiles_) area[to.surface] += 1;
    for (const Tile& from : tiles_)
      for (const Tile& to : tiles_)
        exchange[from.surface][to.surface] += factor(from, to) / area[from.surface];
    for (auto& row : exchange) {
      const double sum = row[0] + row[1] + row[2];
      for (double& share : row) share /= sum;
    }
    constexpr std::array<double, 3> kReflectance = {0.2, 0.7, 0.5};
    for (int bounce = 0; bounce < 100; ++bounce) {
      for (int s = 0; s < 3; ++s) light[s] = kReflectance[s] * (direct[s] / area[s] + indirect[s]);
      for (int s = 0; s < 3; ++s)
        indirect[s] = exchange[s][0] * light[0] + exchange[s][1] * light[1] + exchange[s][2] * light[2];
    }
    return indirect[2];
  }

 private:
  struct Tile {
    Vec3 corner, u, v;
    double reflectance;
    std::size_t surface;
  };
  void addPlane(Vec3 corner, Vec3 u, Vec3 v, int across, int up, double reflectance, std::size_t surface) {
    for (int i = 0; i < across; ++i)
      for (int j = 0; j < up; ++j)
        tiles_.push_back({corner + double(i) * u + double(j) * v, u, v, reflectance, surface});
  }
  /// From the middle of one tile of 1 m2 to another, in 4 x 4 parts.
  static double factor(const Tile& from, const Tile& to) {
    const Vec3 n = cross(from.u, from.v), m = cross(to.u, to.v), p = from.corner + 0.5 * (from.u + from.v);
    double sum = 0;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        const Vec3 d = to.corner + (i + 0.5) / 4 * to.u + (j + 0.5) / 4 * to.v - p;
        const double r2 = dot(d, d);
        if (r2 < 1e-9) continue;
        sum += std::abs(dot(n, d) * dot(m, d)) / (kPi * r2 * r2) / 16;
      }
    return sum;
  }
  std::vector<Tile> tiles_;
};

/// Direct lm of one luminaire at (x, y) on the ceiling, its C 0 turned by `turn` degrees: floor, ceiling,
/// walls.
std::array<double, 3> tracedLight(const Photometry& p, double x, double y, double turn) {
  std::array<double, 3> lumens{};
  for (double gamma = 0.5; gamma < 180; gamma += 1)
    for (double c = 1; c < 360; c += 2) {
      const double weight = (cosine(gamma - 0.5) - cosine(gamma + 0.5)) * 2 * kPi / 180;
      const double light = intensityAt(p, c - turn, gamma) * weight;
      const double reach = gamma < 90 ? 2 * std::tan(gamma * kPi / 180) : 0;
      const double px = x + reach * cosine(c), py = y + reach * sine(c);
      const bool inside = px >= 0 && px <= 8 && py >= 0 && py <= 16;
      lumens[gamma > 90 ? 1 : inside ? 0 : 2] += light;
    }
  return lumens;
}

/// UGR of the whole room with the luminaires turned by `turn` degrees; panels that lie flat only.
double bruteForce(const Photometry& p, double turn) {
  std::array<double, 3> direct{};
  double glare = 0;
  for (int i = 0; i < 16; ++i)
    for (int j = 0; j < 32; ++j) {
      const Vec3 place{0.25 + 0.5 * i, 0.25 + 0.5 * j, 2}, toEye = Vec3{4, 0, 0} - place;
      // every fourth luminaire stands for its neighbours: their light differs little
      if (i % 2 == 0 && j % 2 == 0)
        for (const double dx : {0.25})
          for (std::size_t s = 0; s < 3; ++s)
            direct[s] += 4 * tracedLight(p, place.x + dx, place.y + dx, turn)[s];
      const double h = 2, t = std::abs(toEye.x), r = -toEye.y, d = length(toEye);
      if (h / r > 1.9 || t / r > 3) continue;
      const double gamma = std::acos(h / d) * 180 / kPi;
      const double c = std::atan2(toEye.y, toEye.x) * 180 / kPi - turn;
      const double luminance = intensityAt(p, c, gamma) / (p.luminous.width * p.luminous.length * h / d);
      const double solidAngle = p.luminous.width * p.luminous.length * h / d / (d * d);
      const double tau = std::atan(t / h) * 180 / kPi, sigma = std::acos(r / d) * 180 / kPi;
      const double index = positionIndex(tau, sigma);
      glare += luminance * luminance * solidAngle / (index * index);
    }
  const double background = TiledRoom().wallIndirect(direct) / kPi;
  return 8 * std::log10(0.25 / background * glare);
}

TEST(UnifiedGlare, IsTheBruteForceSum) {
  const auto lambert = [](double, double gamma) { return gamma < 90 ? 1000 * cosine(gamma) : 0; };
  const auto lengthwise = [](double c, double gamma) {
    return gamma < 90 ? 1500 * cosine(gamma) * (1 + 0.6 * cosine(2 * c)) : 80 * -cosine(gamma);
  };
  EXPECT_NEAR(ugr4h8h(panel(lambert)).value(), bruteForce(panel(lambert), 0), 0.05);
  const Photometry uneven = panel(lengthwise, 0.3, 1.2);
  EXPECT_NEAR(ugr4h8h(uneven).value(), std::max(bruteForce(uneven, 0), bruteForce(uneven, 90)), 0.05);
}

TEST(UnifiedGlare, AnOpalPanelRatesAsTheTradeKnowsIt) {
  // 3600 lm from 0.6 x 0.6 m, Lambertian: makers print 20 to 22 for such a panel.
  const auto opal = [](double, double gamma) { return gamma < 90 ? 3600 / kPi * cosine(gamma) : 0; };
  EXPECT_NEAR(ugr4h8h(panel(opal)).value(), 21, 1.2);
}

TEST(UnifiedGlare, GrowsByEightPerDecadeOfLightAndFallsByEightPerDecadeOfArea) {
  const auto light = [](double peak) {
    return [=](double, double gamma) { return gamma < 90 ? peak * cosine(gamma) : 0; };
  };
  const double one = ugr4h8h(panel(light(100))).value();
  EXPECT_NEAR(ugr4h8h(panel(light(1000))).value(), one + 8, 1e-9);
  EXPECT_NEAR(ugr4h8h(panel(light(100), 0.6, 6)).value(), one - 8, 1e-9);
}

TEST(UnifiedGlare, TurningTheTableChangesNothing) {
  const auto lopsided = [](double c, double gamma) {
    return gamma < 90 ? (300 + 200 * cosine(c)) * cosine(gamma) : 0;
  };
  IesFile file;
  file.width = file.length = 0.5;
  file.gamma = angles(0, 90, 5), file.c = angles(0, 360, 15);
  file.candela = lopsided;
  const double straight = ugr4h8h(read(file.text()).value()).value();
  file.candela = [&](double c, double gamma) { return lopsided(c + 90, gamma); };
  EXPECT_NEAR(ugr4h8h(read(file.text()).value()).value(), straight, 0.02);
}

TEST(UnifiedGlare, OfMirroredLightAQuadrantSaysAll) {
  const auto batwing = [](double c, double gamma) {
    return std::max(0.0, gamma < 90 ? (400 + 150 * cosine(2 * c)) * cosine(gamma) : -30 * cosine(gamma));
  };
  IesFile file;
  file.width = 0.3, file.length = 1.2;
  file.gamma = angles(0, 180, 5);
  file.candela = batwing;
  file.c = angles(0, 90, 15);
  const double quadrant = ugr4h8h(read(file.text()).value()).value();
  file.c = angles(0, 360, 15);
  EXPECT_NEAR(ugr4h8h(read(file.text()).value()).value(), quadrant, 1e-9);
}

TEST(UnifiedGlare, NeedsALuminousArea) {
  const auto lambert = [](double, double gamma) { return gamma < 90 ? 1000 * cosine(gamma) : 0; };
  EXPECT_FALSE(ugr4h8h(panel(lambert, 0, 0)));
  EXPECT_FALSE(ugr4h8h(panel(lambert, 0.3, 1e-308)));  // none to speak of: its luminance has no number
}

TEST(UnifiedGlare, PositionIndexOfCiesTable) {
  // T/R, H/R and p of CIE 117's table, straight ahead, above and beside.
  EXPECT_NEAR(positionIndex(0, 0), 1, 1e-12);
  const auto at = [](double tr, double hr) {
    return positionIndex(std::atan2(tr, hr) * 180 / kPi, std::atan(std::hypot(tr, hr)) * 180 / kPi);
  };
  EXPECT_NEAR(at(0, 0.5), 2.86, 0.01 * 2.86);
  EXPECT_NEAR(at(0, 1), 7.03, 0.01 * 7.03);
  EXPECT_NEAR(at(1, 0), 2.11, 0.07 * 2.11);
}

}  // namespace
}  // namespace fiatlux
