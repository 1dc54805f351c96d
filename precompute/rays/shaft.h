// All rays from one flat place to another at once: the convex hull of both, by planes around it.
#pragma once

#include <cstdint>

#include "precompute/rays/float8.h"

namespace fiatlux {

/// A flat convex place with four corners in turn (or the same one four times), m around a tracer's centre.
struct Place {
  float corner[3][4];  // axis, corner
};

/// What the rays from one place to another meet: nothing, all of them the same flat blocker, or who knows.
enum class Between : std::uint8_t { kUnknown, kNothing, kWall };

/// Eight flat convex quadrangles; a triangle's last corner is there twice. Lanes that are not used are zero.
struct alignas(64) Quads {
  static constexpr std::uint32_t kCount = 8;
  float corner[4][3][kCount];  // corner, axis, lane: counter-clockwise around the normal
  float normal[3][kCount];     // unit
  float height[kCount];        // of the plane over the centre, along the normal
};

class Shaft {
 public:
  /// What reaches into it by less than `touch` (m) is outside.
  Shaft(const Place& from, const Place& to, float touch);

  /// Which of eight boxes (low x, y, z, high x, y, z; a lane each) may reach into it.
  unsigned entered(const float (&bounds)[6][8]) const;
  /// Which of eight quadrangles may.
  unsigned crossed(const Quads& quads) const;
  /// Whether the quadrangle stops every ray, or all but those that pass its edge by less than `touch`.
  bool isCutBy(const Quads& quads, std::uint32_t lane) const;

 private:
  struct Plane {
    float normal[3], most;  // unit; inside, normal . x is less
  };
  static constexpr std::uint32_t kMostPlanes = 10;  // the two places, and one a side of each

  void addPlane(const float (&normal)[3]);
  void addSides(std::uint32_t own, std::uint32_t other);
  /// How high its corners are over a plane, a corner a lane.
  Float8 heights(float x, float y, float z, float height) const {
    return corner_[0] * x + corner_[1] * y + corner_[2] * z - all8(height);
  }

  Float8 corner_[3];  // axis; lanes 0 to 3 of the first place, then those of the other
  float touch_;
  float low_[3], high_[3];
  float diagonal_;
  Plane planes_[kMostPlanes];
  std::uint32_t count_ = 0;
};

}  // namespace fiatlux
