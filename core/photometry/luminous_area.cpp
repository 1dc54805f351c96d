#include "core/photometry/luminous_area.h"

#include <cmath>
#include <numbers>

namespace fiatlux {
namespace {

/// An elliptic cylinder of half axes `a` along u and `b` along v and of length `h` along w: its end, and its
/// side.
double cylinder(double a, double b, double h, double u, double v, double w) {
  return std::numbers::pi * a * b * std::abs(w) + 2 * h * std::hypot(b * u, a * v);
}

}  // namespace

double projectedArea(const LuminousArea& area, PhotometricAxis longAxis, const Vec3& direction) {
  // u along the length, v along the width, w along gamma 0; half of each length is the half axis of a round
  // body.
  const bool alongC0 = longAxis == PhotometricAxis::kC0;
  const double u = alongC0 ? direction.x : direction.y, v = alongC0 ? direction.y : direction.x,
               w = direction.z;
  const double a = area.length / 2, b = area.width / 2, c = area.height / 2;
  switch (area.shape) {
    case LuminousShape::kBox: {
      const double widthC0 = alongC0 ? area.width : area.length,
                   widthC90 = alongC0 ? area.length : area.width;
      return area.length * area.width * std::abs(w) +
             widthC0 * std::abs(direction.x) * area.sides[direction.x >= 0 ? 0 : 2] +
             widthC90 * std::abs(direction.y) * area.sides[direction.y >= 0 ? 1 : 3];
    }
    case LuminousShape::kUprightCylinder:
      return cylinder(a, b, area.height, u, v, w);
    case LuminousShape::kEllipsoid:
      return std::numbers::pi * std::hypot(b * c * u, a * c * v, a * b * w);
    case LuminousShape::kCylinderAlong:
      return cylinder(b, c, area.length, v, w, u);
    default:
      return cylinder(a, c, area.width, u, w, v);
  }
}

}  // namespace fiatlux
