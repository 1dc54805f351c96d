// Photometric files as they shine: CIE 171:2006 through tables of LM-63, an asymmetric table turned by 90
// degrees, lengths in feet, light that goes up, and rooms with many luminaires against a sum of three
// surfaces that knows neither rays nor patches.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <numbers>
#include <numeric>

#include "core/transport/mounted_luminaire.h"
#include "precompute/validation/cie171_points.h"
#include "precompute/validation/validation_scene.h"

namespace fiatlux {

namespace {

constexpr double kAtPoint = 0.02, kOfFlux = 0.01, kOfRoom = 0.03;
constexpr double kDegree = std::numbers::pi / 180;

/// cd at C and gamma, radians.
using Candela = std::function<double(double, double)>;

double lambertian(double, double gamma) { return 1000 * std::max(0.0, std::cos(gamma)); }
double isotropic(double, double) { return 1000; }
/// Brighter in the plane C0 than in C90, the more so the further from the axis.
double unevenness(double c, double gamma) { return 0.9 * std::sin(gamma) * std::cos(2 * c); }
double oblong(double c, double gamma) { return lambertian(c, gamma) * (1 + unevenness(c, gamma)); }

struct TableShape {
  int lastGamma = 90, lastPlane = 0;  // degrees
  double side = 0;                    // of a square luminous area, in the file's unit
  bool feet = false;
};

/// The text of an LM-63-2002 file, a candela each degree of gamma and every five of C.
std::string textOfTable(const Candela& candela, const TableShape& shape) {
  constexpr int kPlaneStep = 5;
  char line[200];
  std::snprintf(line, sizeof line, "1 -1 1 %d %d 1 %d %.7g %.7g 0\n1 1 0\n", shape.lastGamma + 1,
                shape.lastPlane / kPlaneStep + 1, shape.feet ? 1 : 2, shape.side, shape.side);
  std::string text = "IESNA:LM-63-2002\n[LUMINAIRE] analytic\nTILT=NONE\n" + std::string(line);
  for (int gamma = 0; gamma <= shape.lastGamma; ++gamma) text += std::to_string(gamma) + "\n";
  for (int c = 0; c <= shape.lastPlane; c += kPlaneStep) text += std::to_string(c) + "\n";
  for (int c = 0; c <= shape.lastPlane; c += kPlaneStep)
    for (int gamma = 0; gamma <= shape.lastGamma; ++gamma) {
      std::snprintf(line, sizeof line, "%.9g\n", candela(kDegree * c, kDegree * gamma));
      text += line;
    }
  return text;
}

/// Read as any file is; null and a failing row where it cannot be.
std::shared_ptr<const Photometry> readTable(Validation& validation, const Candela& candela,
                                            const TableShape& shape) {
  const std::string text = textOfTable(candela, shape);
  Result<Photometry> table =
      readPhotometry({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  if (table) return std::make_shared<const Photometry>(std::move(*table));
  validation.failure("photometric files", table.error().message);
  return nullptr;
}

/// Shining downwards in z-up coordinates, C0 along x before it is turned (degrees), the flux that it holds.
Luminaire hung(const std::shared_ptr<const Photometry>& table, double x, double y, double z,
               double turn = 0) {
  const Site site{zUp(x, y, z), zUp(0, 0, -1), zUp(1, 0, 0), 0};
  Mounting mounting;
  mounting.turn = turn;
  return mountedLuminaire(exactType(table), 0, site, mounting);
}

std::string placed(const char* what, double x, double y) {
  char text[80];
  std::snprintf(text, sizeof text, "%s, lx at %g, %g", what, x, y);
  return text;
}

/// CIE 171 5.2 and a table that is not alike in all planes, 3 m over a floor.
void pointTables(Validation& validation) {
  const ValidationScene scene(
      validation, "photometric files",
      sceneOfRectangles({zUpRectangle("floor", {-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, 0)}), 0.25);
  const auto flat = readTable(validation, lambertian, {}), round = readTable(validation, isotropic, {180}),
             wide = readTable(validation, oblong, {90, 90});
  if (!scene || !flat || !round || !wide) return;
  std::vector<MeasuringPoint> points;
  for (const auto& [x, y] : kCie171Places) points.push_back({zUp(x, y, 0), zUp(0, 0, 1)});
  const auto byFlat = scene.read(points, {hung(flat, 0, 0, 3)}, {}),
             byRound = scene.read(points, {hung(round, 0, 0, 3)}, {}),
             byWide = scene.read(points, {hung(wide, 0, 0, 3)}, {}),
             turned = scene.read(points, {hung(wide, 0, 0, 3, 90)}, {});
  for (int i = 0; i < kCie171Points; ++i) {
    const auto& [x, y] = kCie171Places[i];
    validation.relative("photometric files", placed("CIE 171 5.2, Lambertian .ies", x, y),
                        kCie171Lambertian[i], byFlat[i].total, kAtPoint);
    validation.relative("photometric files", placed("CIE 171 5.2, isotropic .ies", x, y), kCie171Isotropic[i],
                        byRound[i].total, kAtPoint);
    const double share = unevenness(std::atan2(y, x), std::atan(std::hypot(x, y) / 3));
    validation.relative("photometric files", placed("asymmetric .ies", x, y),
                        kCie171Lambertian[i] * (1 + share), byWide[i].total, kAtPoint);
    validation.relative("photometric files", placed("asymmetric .ies turned by 90 degrees", x, y),
                        kCie171Lambertian[i] * (1 - share), turned[i].total, kAtPoint);
  }
}

/// CIE 171 5.3, a luminous area of 1 m, told in metres and in feet; 5.4, where half of the light goes up.
void tablesInABox(Validation& validation) {
  const ValidationScene scene(validation, "photometric files", sceneOfRectangles(zUpBox(4, 4, 3, 0)), 0.25);
  const auto metres = readTable(validation, lambertian, {90, 0, 1}),
             feet = readTable(validation, lambertian, {90, 0, 1 / 0.3048, true}),
             round = readTable(validation, isotropic, {180});
  if (!scene || !metres || !feet || !round) return;
  constexpr double kWall[6] = {32.68, 75.19, 81.32, 69.06, 53.40, 40.00};
  std::vector<MeasuringPoint> points;
  for (int i = 0; i < 6; ++i) points.push_back({zUp(2, 0, 2.75 - 0.5 * i), zUp(0, 1, 0)});
  const auto byMetres = scene.read(points, {hung(metres, 2, 2, 3)}, {}),
             byFeet = scene.read(points, {hung(feet, 2, 2, 3)}, {});
  for (int i = 0; i < 6; ++i) {
    const double z = 2.75 - 0.5 * i;
    validation.relative("photometric files", placed("CIE 171 5.3, area in metres, x, z", 2, z), kWall[i],
                        byMetres[i].total, kAtPoint);
    validation.relative("photometric files", placed("the same area in feet, x, z", 2, z), byMetres[i].total,
                        byFeet[i].total, 1e-6);
  }
  Luminaire centre = hung(round, 2, 2, 1.5);
  const double scale = 10000 / centre.flux;
  const ForwardLight light = scene.light({centre});
  for (const char* name : {"floor", "ceiling", "wall x=0", "wall y=max"}) {
    const double expected = name[0] == 'w' ? 1394.67 : 2210.66;
    validation.relative("photometric files", std::string("CIE 171 5.4, isotropic .ies, lm on ") + name,
                        expected, scale * scene.mean(light.illuminance, name) * scene.area(name), kOfFlux);
  }
}

// Rooms of 10 x 10 m with 16 luminaires on the ceiling.
constexpr double kSide = 10, kSpacing = 2.5, kPanel = 0.6;          // m
constexpr double kOfCeiling = 0.8, kOfWalls = 0.5, kOfFloor = 0.2;  // reflectances
constexpr double kPanelFlux = 1000 * std::numbers::pi;              // lm

/// Flux (lm) of the 16 panels that reaches the floor `h` below at once: points of the panels to points of
/// the floor.
double fluxOnFloor(double h) {
  constexpr int kParts = 6, kCells = 100;
  double sum = 0;
  for (int panel = 0; panel < 16; ++panel)
    for (int part = 0; part < kParts * kParts; ++part) {
      const double x = (panel % 4 + 0.5) * kSpacing + ((part % kParts + 0.5) / kParts - 0.5) * kPanel;
      const double y = (panel / 4 + 0.5) * kSpacing + ((part / kParts + 0.5) / kParts - 0.5) * kPanel;
      for (int cell = 0; cell < kCells * kCells; ++cell) {
        const double dx = (cell % kCells + 0.5) * kSide / kCells - x;
        const double dy = (cell / kCells + 0.5) * kSide / kCells - y;
        const double squared = dx * dx + dy * dy + h * h, cosine = h / std::sqrt(squared);
        sum += 1000 * cosine * cosine / squared;
      }
    }
  return sum * kSide * kSide / (kCells * kCells) / (kParts * kParts);
}

/// Of opposed squares `h` apart; X = Y = kSide / h.
double opposedSquares(double h) {
  const double x = kSide / h, edge = std::sqrt(1 + x * x);
  return 2 / (std::numbers::pi * x * x) *
         (std::log(std::sqrt((1 + x * x) * (1 + x * x) / (1 + 2 * x * x))) +
          2 * x * edge * std::atan(x / edge) - 2 * x * std::atan(x));
}

/// Mean lx of floor, walls and ceiling; floor, ceiling and each of the walls' level bands shine evenly. (One
/// band would be some 4 % low on the ceiling of a high room, which sees most of the upper walls.)
std::array<double, 3> threeSurfaces(double h) {
  constexpr int kBands = 20;
  const double horizontal = kSide * kSide, band = 4 * kSide * h / kBands;
  std::array<double, kBands + 1> below,
      across;  // from the ceiling, by depth: flux of the panels, share of its own
  for (int i = 0; i <= kBands; ++i) {
    below[i] = i > 0 ? fluxOnFloor(i * h / kBands) : 16 * kPanelFlux;
    across[i] = i > 0 ? opposedSquares(i * h / kBands) : 1;
  }
  // Of what a level square emits, the band between two depths gets what passes one and not the other; of what
  // a band emits, a level square at its edge or beyond gets as much for its area, and bands what passes
  // between.
  const auto toBand = [&](int depth) { return across[depth] - across[depth + 1]; };
  const double scale = horizontal / band;
  const auto between = [&](int i, int j) {
    const int apart = std::abs(i - j);
    return apart == 0 ? 1 - 2 * scale * toBand(0) : scale * (toBand(apart - 1) - toBand(apart));
  };
  double floor = 0, ceiling = 0;
  std::array<double, kBands> walls{};
  for (int bounce = 0; bounce < 200; ++bounce) {
    const double f = kOfFloor * floor, c = kOfCeiling * ceiling;
    const std::array<double, kBands> last = walls;
    floor = below[kBands] / horizontal + across[kBands] * c;
    ceiling = across[kBands] * f;
    for (int i = 0; i < kBands; ++i) {
      const int up = kBands - 1 - i;
      floor += kOfWalls * toBand(up) * last[i];
      ceiling += kOfWalls * toBand(i) * last[i];
      walls[i] = (below[i] - below[i + 1]) / band + scale * (toBand(i) * c + toBand(up) * f);
      for (int j = 0; j < kBands; ++j) walls[i] += kOfWalls * between(i, j) * last[j];
    }
  }
  return {floor, std::accumulate(walls.begin(), walls.end(), 0.0) / kBands, ceiling};
}

/// The room cavity ratio 5 h (10 + 10) / (10 x 10) is h.
void manyPanels(Validation& validation) {
  const auto table = readTable(validation, lambertian, {90, 0, kPanel});
  if (!table) return;
  for (const double h : {1.0, 2.0, 5.0}) {
    std::vector<RectangleSurface> surfaces = zUpBox(kSide, kSide, h, kOfWalls);
    surfaces[0].reflectance = kOfFloor;
    surfaces[1].reflectance = kOfCeiling;
    const ValidationScene scene(validation, "photometric files", sceneOfRectangles(surfaces), 0.5);
    if (!scene) return;
    std::vector<Luminaire> panels;
    for (int i = 0; i < 16; ++i)
      panels.push_back(hung(table, (i % 4 + 0.5) * kSpacing, (i / 4 + 0.5) * kSpacing, h));
    const ForwardLight light = scene.light(panels);
    double walls = 0;
    for (const char* name : {"wall x=0", "wall x=max", "wall y=0", "wall y=max"})
      walls += scene.mean(light.illuminance, name) / 4;
    const std::array<double, 3> expected = threeSurfaces(h);
    const double got[3] = {scene.mean(light.illuminance, "floor"), walls,
                           scene.mean(light.illuminance, "ceiling")};
    const char* names[3] = {"floor", "walls", "ceiling"};
    for (int i = 0; i < 3; ++i) {
      char name[80];
      std::snprintf(name, sizeof name, "16 luminaires, room cavity ratio %g, mean lx of the %s", h, names[i]);
      validation.relative("photometric files", name, expected[i], got[i], kOfRoom);
    }
  }
}

}  // namespace

void validatePhotometricFiles(Validation& validation) {
  pointTables(validation);
  tablesInABox(validation);
  manyPanels(validation);
}

}  // namespace fiatlux
