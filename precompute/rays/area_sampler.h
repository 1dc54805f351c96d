// Points on triangles, uniform by area: for rays from patches, from pieces of a room, from mounts.
#pragma once

#include <span>
#include <vector>

#include "precompute/room/room.h"

namespace fiatlux {

/// Prepared once, so that a point costs little however many triangles there are.
class AreaSampler {
 public:
  struct Point {
    Vec3 position, normal;  // m; unit, of the triangle
  };
  struct Piece {
    Vec3 corner, first, second;    // m, a corner of the triangle and its edges from there
    Vec3 normal;                   // unit
    double before = 0, share = 0;  // of the whole area
  };

  /// Triangles without area are passed over.
  explicit AreaSampler(std::span<const Fragment> triangles);

  /// Uniform by area for (u, v) in [0, 1)^2. Precondition: not empty.
  Point at(double u, double v) const;

  bool empty() const { return pieces_.empty(); }
  double area() const { return area_; }  // m2
  const std::vector<Piece>& pieces() const { return pieces_; }

 private:
  std::vector<Piece> pieces_;
  double area_ = 0;
};

}  // namespace fiatlux
