// The light that leaves a luminaire: from where, which way and how much. The one place that knows how a
// luminaire shines: Lambertian areas, points that are Lambertian or isotropic, and those of any photometry,
// each part of whose area has the whole's distribution.
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "core/scene/luminaire.h"
#include "precompute/rays/hemisphere.h"

namespace fiatlux {

/// A luminaire prepared for many receivers and rays. (u, v) in [0, 1]^2 are a place on its rectangle, u along
/// its axis; of a point all places are one.
class Emission {
 public:
  explicit Emission(const Luminaire& luminaire)
      : luminaire_(luminaire),
        frame_(luminaire.normal),
        halfU_(0.5 * luminaire.width * luminaire.axis),
        halfV_(0.5 * luminaire.height * cross(luminaire.normal, luminaire.axis)),
        isPoint_(!(luminaire.width > 0 && luminaire.height > 0)),
        isIsotropic_(isPoint_ && luminaire.distribution == Luminaire::Distribution::kIsotropic),
        corners_(part(0, 1, 0, 1)) {}

  bool isPoint() const { return isPoint_; }
  bool isPhotometric() const { return luminaire_.distribution == Luminaire::Distribution::kPhotometric; }
  double width() const { return luminaire_.width; }    // m
  double height() const { return luminaire_.height; }  // m
  const Vec3& position() const { return luminaire_.position; }
  const Vec3& normal() const { return luminaire_.normal; }

  /// Whether it sends nothing there: it shines to one side, and the point is not before it by more than
  /// rounding.
  bool isBehind(const Vec3& point) const {
    constexpr double kFront = 1e-5;  // m: what lies in the plane that it hangs on, rounded
    return !isIsotropic_ && !isPhotometric() && dot(point - luminaire_.position, luminaire_.normal) <= kFront;
  }

  Vec3 at(double u, double v) const {
    return luminaire_.position + (2 * u - 1) * halfU_ + (2 * v - 1) * halfV_;
  }
  /// Where light starts and shadow rays end: clear of what the luminaire hangs on.
  Vec3 startAt(double u, double v) const { return at(u, v) + kLuminaireClearance * luminaire_.normal; }
  /// Corners of the rectangle, counter-clockwise from its front, and of a part of it.
  const std::array<Vec3, 4>& corners() const { return corners_; }
  std::array<Vec3, 4> part(double u0, double u1, double v0, double v1) const {
    return {at(u0, v0), at(u1, v0), at(u1, v1), at(u0, v1)};
  }

  /// cd of a point, or of all of a photometric area, towards what lies `way` from it (m; of any length but 0,
  /// and not behind it).
  double intensity(const Vec3& way) const {
    assert((isPoint_ || isPhotometric()) && dot(way, way) > 0);
    if (isPhotometric()) {
      const Vec3 d = normalized(way);
      const Vec3 across = cross(luminaire_.normal, luminaire_.axis);
      return luminaire_.intensity({dot(d, luminaire_.axis), dot(d, across), dot(d, luminaire_.normal)});
    }
    if (isIsotropic_) return luminaire_.flux / (4 * std::numbers::pi);
    return luminaire_.flux / std::numbers::pi * dot(way, luminaire_.normal) / length(way);
  }
  /// lm/m2 of an area, the same at every place and Lambertian.
  double exitance() const { return luminaire_.flux / (luminaire_.width * luminaire_.height); }

  /// A unit direction for (s, t) in [0, 1)^2: as many as its light takes, times weight().
  Vec3 direction(double s, double t) const {
    if (!isIsotropic_ && !isPhotometric()) return cosineDirection(frame_, s, t);
    const double z = 1 - 2 * s, r = std::sqrt(std::max(0.0, 1 - z * z));
    const double angle = 2 * std::numbers::pi * t;
    return {r * std::cos(angle), r * std::sin(angle), z};
  }
  /// How much more light goes there than direction() says: of photometric ones, whose directions are even.
  double weight(const Vec3& direction) const { return isPhotometric() ? intensity(direction) : 1; }

 private:
  Luminaire luminaire_;
  Frame frame_;
  Vec3 halfU_, halfV_;  // m, from the centre to the middle of a side
  bool isPoint_, isIsotropic_;
  std::array<Vec3, 4> corners_;
};

}  // namespace fiatlux
