#include "core/photometry/unified_glare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/photometry/degrees.h"
#include "core/photometry/intensity.h"
#include "core/photometry/luminous_area.h"
#include "core/photometry/photometric_values.h"

namespace fiatlux {
namespace {

constexpr double kPi = std::numbers::pi;

// The room, metres: x across the line of sight, y along it, the eye at (0, 0, 0) below the middle of the wall
// y = 0.
constexpr double kHeight = 2, kAcross = 4 * kHeight, kAlong = 8 * kHeight, kStep = 0.25 * kHeight;
constexpr int kColumns = 16, kRows = 32;
constexpr double kCeiling = 0.7, kWalls = 0.5, kFloor = 0.2;
constexpr double kFloorArea = kAcross * kAlong, kWallArea = 2 * kHeight * (kAcross + kAlong);
constexpr double kMostAbove = 1.9, kMostBeside = 3;  // of CIE's table of the position index

/// The luminaire turned by `turn` quarters about its normal: the direction in its own axes of one in the
/// room.
Vec3 inLuminaire(const Vec3& direction, int turn) {
  const double x = direction.x, y = direction.y, z = direction.z;
  switch (turn) {
    case 0:
      return {x, y, z};
    case 1:
      return {y, -x, z};
    case 2:
      return {-x, -y, z};
    default:
      return {-y, x, z};
  }
}

/// Sum of L^2 w / p^2 at the eye. Directions here have z downwards.
double glareSum(const Photometry& photometry, int turn) {
  double sum = 0;
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const double beside = (column + 0.5) * kStep - kAcross / 2, ahead = (row + 0.5) * kStep;
      const double weight = positionWeight(kHeight, std::abs(beside), ahead);
      if (weight == 0) continue;
      const Vec3 toEye = inLuminaire({-beside, -ahead, kHeight}, turn);
      const double d = length(toEye);
      const double area = projectedArea(photometry.luminous, photometry.longAxis, normalized(toEye));
      if (!(area > 0)) continue;
      const double candela = intensity(photometry, toEye);
      sum += candela * candela / (area * d * d) * weight;
    }
  }
  return sum;
}

/// How many of `count` places in a row, kStep apart and kStep / 2 from both ends, are still within the row
/// after a move by `shift` metres.
double placesWithin(int count, double shift) {
  return std::clamp(std::floor(count - std::abs(shift) / kStep + 0.5), 0.0, static_cast<double>(count));
}

/// Share of the luminaires' flux that falls on the floor directly, mean over the grid, for a luminaire as it
/// is and turned by a quarter: each direction leads from a luminaire to the floor, or, where that point lies
/// outside the room, to a wall. The grid is symmetric, so light is gathered from four mirrored directions at
/// once.
std::array<double, 2> floorShares(const Photometry& photometry, double flux, bool mirrored) {
  constexpr int kGammas = 180;
  constexpr std::size_t kPlanes = 90;  // of a quadrant
  std::array<double, kPlanes> angles, cosines, sines, candela;
  for (std::size_t c = 0; c < kPlanes; ++c) {
    angles[c] = (static_cast<double>(c) + 0.5) * 90 / kPlanes;
    cosines[c] = std::cos(angles[c] * kDegree), sines[c] = std::sin(angles[c] * kDegree);
  }
  std::array<double, 2> shares{};
  for (int g = 0; g < kGammas; ++g) {
    const double gamma = (g + 0.5) * 90 / kGammas, half = 45.0 / kGammas;
    const double reach = kHeight * std::tan(gamma * kDegree);
    for (std::size_t c = 0; c < kPlanes; ++c) {
      const auto at = [&](double plane) { return intensityAt(photometry, plane, gamma); };
      candela[c] = mirrored ? 4 * at(angles[c])
                            : at(angles[c]) + at(180 - angles[c]) + at(180 + angles[c]) + at(-angles[c]);
    }
    const double weight = (std::cos((gamma - half) * kDegree) - std::cos((gamma + half) * kDegree)) * kPi /
                          2 / kPlanes / (flux * kColumns * kRows);
    for (std::size_t c = 0; c < kPlanes; ++c) {
      const double stay = placesWithin(kColumns, reach * cosines[c]) * placesWithin(kRows, reach * sines[c]);
      shares[0] += candela[c] * weight * stay;
      shares[1] += candela[kPlanes - 1 - c] * weight * stay;
    }
  }
  return shares;
}

/// Form factor between opposed equal rectangles a x b at the distance 1.
double opposedRectangles(double a, double b) {
  const double p = std::sqrt(1 + a * a), q = std::sqrt(1 + b * b);
  return 2 / (kPi * a * b) *
         (std::log(p * q / std::sqrt(1 + a * a + b * b)) + a * q * std::atan(a / q) +
          b * p * std::atan(b / p) - a * std::atan(a) - b * std::atan(b));
}

/// lx, indirect, mean over the walls. Direct light in lm.
double wallIndirect(double onFloor, double onWalls, double onCeiling) {
  const double opposed = opposedRectangles(kAcross / kHeight, kAlong / kHeight);
  const double toWalls = 1 - opposed,
               fromWalls = toWalls * kFloorArea / kWallArea;  // wall to floor, to ceiling
  double floor = 0, walls = 0, ceiling = 0;                   // indirect lx
  for (int bounce = 0; bounce < 200; ++bounce) {
    const double ofFloor = kFloor * (onFloor / kFloorArea + floor);
    const double ofWalls = kWalls * (onWalls / kWallArea + walls);
    const double ofCeiling = kCeiling * (onCeiling / kFloorArea + ceiling);
    floor = opposed * ofCeiling + toWalls * ofWalls;
    ceiling = opposed * ofFloor + toWalls * ofWalls;
    walls = fromWalls * (ofFloor + ofCeiling) + (1 - 2 * fromWalls) * ofWalls;
  }
  return walls;
}

}  // namespace

double positionIndex(double alpha, double beta) {
  return std::exp((35.2 - 0.31889 * alpha - 1.22 * std::exp(-2 * alpha / 9)) * 1e-3 * beta +
                  (21 + 0.26667 * alpha - 0.002963 * alpha * alpha) * 1e-5 * beta * beta);
}

double positionWeight(double above, double beside, double ahead) {
  if (!(ahead > 0) || above > kMostAbove * ahead || beside > kMostBeside * ahead) return 0;
  const double off = std::hypot(above, beside);
  const double p = positionIndex(std::atan2(beside, above) / kDegree, std::atan2(off, ahead) / kDegree);
  return 1 / (p * p);
}

std::optional<double> ugr4h8h(const Photometry& photometry) {
  const double flux = integratedFlux(photometry), up = upwardShare(photometry);
  const bool mirrored = photometry.symmetry <= PhotometricSymmetry::kQuadrant;
  const std::array<double, 2> onFloor = floorShares(photometry, flux, mirrored);
  std::array<double, 2> background{};  // cd/m2; the room looks the same from both its ends
  for (std::size_t turn = 0; turn < 2; ++turn) {
    const double floor = onFloor[turn], total = flux * kColumns * kRows;
    background[turn] = wallIndirect(total * floor, total * std::max(0.0, 1 - up - floor), total * up) / kPi;
  }
  std::optional<double> worst;
  for (int turn = 0; turn < (mirrored ? 2 : 4); ++turn) {
    const double glare = glareSum(photometry, turn);
    if (!(glare > 0) || !std::isfinite(glare)) continue;  // nothing shines there, or from no area
    const double ugr = 8 * std::log10(0.25 / background[turn % 2] * glare);
    worst = std::max(worst.value_or(ugr), ugr);
  }
  return worst;
}

}  // namespace fiatlux
