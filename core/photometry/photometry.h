// What a maker's photometric file says of a luminaire, in one form whatever the file's: luminous intensities
// of type C with gamma 0 downwards, candela as emitted (all factors applied), lengths in metres.
//
// Directions: gamma 0 is along the luminaire's normal, 180 against it; C is the angle about it, C 0 along its
// x axis. LM-63 lays the 0-180 plane along a luminaire, EULUMDAT across it; the table stands as the file has
// it, and `longAxis` says which plane holds the length.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace fiatlux {

enum class PhotometricFormat : std::uint8_t {
  kLm63_1986,
  kLm63_1991,
  kLm63_1995,
  kLm63_2002,
  kLm63_2019,
  kEulumdat
};
/// "LM-63-2002", "EULUMDAT".
const char* nameOf(PhotometricFormat format);

/// Which planes `Photometry::c` holds, the others being their mirror images.
enum class PhotometricSymmetry : std::uint8_t {
  kAxial,     // c = {0}: all planes alike
  kQuadrant,  // c from 0 to 90: mirrored in C0-C180 and in C90-C270
  kC0C180,    // c from 0 to 180: mirrored in the plane C0-C180
  kC90C270,   // c from 90 to 270: mirrored in the plane C90-C270
  kNone       // c from 0 to 360, the last plane equal to the first
};
/// "axial", "quadrant", "C0-C180", "C90-C270", "none".
const char* nameOf(PhotometricSymmetry symmetry);

enum class PhotometricAxis : std::uint8_t { kC0, kC90 };

/// The body of the luminous area. Along `longAxis` lies `length`, across it `width`, along gamma 0 `height`.
enum class LuminousShape : std::uint8_t {
  kBox,              // rectangle, or box with luminous sides where height > 0
  kUprightCylinder,  // disc or ellipse, with a luminous side where height > 0
  kEllipsoid,        // sphere where all are equal
  kCylinderAlong,    // lying, its axis along `length`; a disc facing that way where length = 0
  kCylinderAcross    // lying, its axis along `width`
};

struct LuminousArea {
  LuminousShape shape = LuminousShape::kBox;
  double length = 0, width = 0, height = 0;  // m; all 0: a point
  bool round = false;                        // not a box
  /// Heights of the sides facing C0, C90, C180, C270, m; they differ in EULUMDAT only.
  std::array<double, 4> sides{};
};

struct Photometry {
  std::string name, maker;  // UTF-8, one line each, may be empty
  PhotometricFormat format = PhotometricFormat::kLm63_2002;
  /// lm that the file states: of its lamps (LM-63), of its lamps by its light output ratio (EULUMDAT); of its
  /// table where photometry is absolute and nothing is stated.
  double flux = 0;
  double watts = 0;           // with ballast; 0: not stated
  std::optional<double> cct;  // K
  LuminousArea luminous;
  PhotometricAxis longAxis = PhotometricAxis::kC0;
  PhotometricSymmetry symmetry = PhotometricSymmetry::kAxial;
  std::vector<double> gamma;    // degrees, ascending within [0, 180]; no light outside them
  std::vector<double> c;        // degrees, ascending, the range that `symmetry` names
  std::vector<double> candela;  // c.size() x gamma.size(), plane by plane, each >= 0 and <= 1e7
  std::vector<std::string> warnings;

  double at(std::size_t plane, std::size_t g) const { return candela[plane * gamma.size() + g]; }
};

inline constexpr std::size_t kMaxPhotometricBytes = 4u << 20;
inline constexpr std::uint32_t kMaxGammas = 361, kMaxPlanes = 721;
inline constexpr double kMaxCandela = 1e7;

/// Reads LM-63 (1986 to 2019) or EULUMDAT, told apart by what is in them. An error is one line: the file's
/// line number, what is wrong there and the cure; other kinds of files are named with what to do instead.
Result<Photometry> readPhotometry(std::span<const std::uint8_t> bytes);

}  // namespace fiatlux
