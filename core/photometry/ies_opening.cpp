#include "core/photometry/ies_opening.h"

#include <cmath>

namespace fiatlux {
namespace {

LuminousArea body(LuminousShape shape, double length, double width, double height) {
  LuminousArea area{shape, std::abs(length), std::abs(width), std::abs(height), shape != LuminousShape::kBox,
                    {}};
  area.sides.fill(area.height);
  return area;
}

/// The bodies of 1986 to 1995 that 2002 writes otherwise.
LuminousArea areaBefore2002(double width, double length, double height) {
  using enum LuminousShape;
  if (width < 0 && length == 0) return body(height < 0 ? kEllipsoid : kUprightCylinder, width, width, height);
  if (width == 0 && length > 0 && height < 0) return body(kCylinderAlong, length, height, height);
  if (width > 0 && length == 0 && height < 0) return body(kCylinderAcross, height, width, height);
  return body(height < 0 ? kEllipsoid : kUprightCylinder, length, width, height);
}

}  // namespace

LuminousArea areaOf(const IesOpening& opening) {
  using enum LuminousShape;
  const auto [width, length, height, before2002] = opening;
  const bool square = width >= 0 && length >= 0;
  if (square && height >= 0) return body(kBox, length, width, height);
  // note: makers went on writing the older circle (-d, 0, h) and the older lying tubes after 2002
  if (before2002 || (width < 0 && length == 0 && height >= 0) || square)
    return areaBefore2002(width, length, height);
  if (width < 0 && length < 0) return body(height < 0 ? kEllipsoid : kUprightCylinder, length, width, height);
  if (height >= 0) return body(kUprightCylinder, length, width, height);
  return body(width < 0 ? kCylinderAlong : kCylinderAcross, length, width, height);
}

LuminousArea areaOfBeam(const IesOpening& opening) {
  if (opening.height == 0) return areaOf(opening);
  // The beam turns from the horizontal to straight down: depth (length) becomes height, height becomes
  // length.
  return areaOf({opening.width, opening.height, opening.length, opening.before2002});
}

}  // namespace fiatlux
