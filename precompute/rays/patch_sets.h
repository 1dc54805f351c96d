// Points on sets of patches, uniform by area. Rays go to another set every time, so all that tells where its
// points are lies in one row of memory.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "precompute/rays/patch_sampler.h"
#include "precompute/room/room.h"

namespace fiatlux {

class PatchSets {
 public:
  /// In single precision, m, from `center`: as the tracer's packets have them.
  struct Point {
    std::array<float, 3> position, normal;
  };

  PatchSets(const Room& room, const Vec3& center);

  /// The next set, of patches of one chart; they must not be none.
  void add(std::span<const std::uint32_t> patches);

  /// For (u, v) in [0, 1)^2; stratified where these are, on a rectangle of full cells that is one square.
  Point at(std::uint32_t set, float u, float v) const;

 private:
  /// A triangle by a corner and the edges from there, or a parallelogram.
  struct alignas(64) Piece {
    std::array<float, 3> corner, first, second, normal;  // m; unit
    float perShare;                                      // 1 over its share of the set's area
    bool isTriangle;
  };

  bool addRectangle(std::span<const std::uint32_t> patches);
  void addPatch(std::uint32_t patch, double before, double share);
  void addPiece(const Vec3& corner, const Vec3& first, const Vec3& second, const Vec3& normal, double before,
                double share, bool isTriangle);

  const Room& room_;
  Vec3 center_;                              // m
  std::vector<Piece> pieces_;                // by set
  std::vector<float> before_;                // pieces: share of the set's area that those before it have
  std::vector<std::uint32_t> firstOf_{{0}};  // sets + 1
};

inline PatchSets::Point PatchSets::at(std::uint32_t set, float u, float v) const {
  // note: halved without a branch, for nobody can foretell it.
  std::uint32_t found = firstOf_[set];
  for (std::uint32_t count = firstOf_[set + 1] - found; count > 1;) {
    const std::uint32_t half = count / 2;
    found = u >= before_[found + half] ? found + half : found;
    count -= half;
  }
  const Piece* const piece = &pieces_[found];
  float along = std::clamp((u - before_[found]) * piece->perShare, 0.0f, 1.0f), across = v;
  if (piece->isTriangle) {
    const float root = std::sqrt(along);
    along = root * (1 - v);
    across = root * v;
  }
  Point point{{}, piece->normal};
  for (int axis = 0; axis < 3; ++axis) {
    point.position[axis] = piece->corner[axis] + along * piece->first[axis] + across * piece->second[axis];
  }
  return point;
}

}  // namespace fiatlux
