// The smallest box along the axes that holds some points.
#pragma once

#include <algorithm>
#include <limits>
#include <span>

#include "core/base/vec3.h"

namespace fiatlux {

/// Holds nothing until a point is included: then low <= high.
struct Bounds {
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  Vec3 low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};  // m

  void include(const Vec3& p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  bool empty() const { return !(low.x <= high.x); }
  /// m; zero where empty, as are the next two.
  Vec3 size() const { return empty() ? Vec3{} : high - low; }
  double diagonal() const { return length(size()); }
  double longestEdge() const {
    const Vec3 edges = size();
    return std::max({edges.x, edges.y, edges.z});
  }
};

inline Bounds boundsOf(std::span<const Vec3> points) {
  Bounds bounds;
  for (const Vec3& p : points) bounds.include(p);
  return bounds;
}

}  // namespace fiatlux
