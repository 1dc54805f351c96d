// A luminaire anywhere in a room: the free form of `fiatlux light`, of which a site is the special case that
// hangs.
#pragma once

#include <functional>

#include "core/base/vec3.h"
#include "core/scene/patches.h"

namespace fiatlux {

/// cd along a unit direction in a luminaire's axes: x along C0, y along C90, z along gamma 0.
using Intensity = std::function<double(const Vec3&)>;

/// A rectangle of width x height metres, or a point where both are 0. It neither blocks nor
/// absorbs light; within 1 mm of a surface it hangs on it and shines from its front.
struct Luminaire {
  Vec3 position;                 // m, centre
  Vec3 normal{0, -1, 0};         // unit, the direction it shines in: gamma 0
  Vec3 axis{1, 0, 0};            // unit, along `width`, perpendicular to normal: C0; C90 is normal x axis
  double width = 0, height = 0;  // m
  double flux = 0;               // lm
  enum class Distribution {
    kLambertian,
    kIsotropic,  // points only
    kPhotometric
  } distribution = Distribution::kLambertian;
  // Photometric: every part of the rectangle has the whole's distribution.
  Intensity intensity;  // cd, at `flux`
  double beam = 2;      // rad, full angle within which the intensity changes little: quadrature is finer
  // m2 as seen from a unit direction in its axes, for glare; nothing: that of the rectangle.
  std::function<double(const Vec3&)> luminousArea;
};

/// Light starts this far in front of a luminaire, and shadow rays end there, m: what it hangs on (within
/// 1 mm) never shadows it.
inline constexpr double kLuminaireClearance = 0.002;

/// A site as a luminaire of 1 lm.
Luminaire luminaireOf(const Site& site);

}  // namespace fiatlux
