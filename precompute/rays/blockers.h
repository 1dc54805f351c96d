// What may stand between two places, few enough that rays are tested against all of it: far quicker than a
// walk through a whole room's tree for each.
#pragma once

#include <cstdint>

#include "precompute/rays/shaft.h"

namespace fiatlux {

struct RayPacket;

class Blockers {
 public:
  static constexpr std::uint32_t kMost = 128;

  void clear() { count_ = 0; }
  std::uint32_t count() const { return count_; }
  bool isFull() const { return count_ == kMost; }
  /// Adds a lane of some quadrangles. Precondition: not full. `slack`, m: so far it reaches beyond its edges,
  /// that no ray may pass between two that share one.
  void add(const Quads& quads, std::uint32_t lane, float slack);

  /// blocked[i]: one of them crosses ray i, which must go from the one place to the other.
  /// note: what stops all of them comes first for the next, which go nearly the same way.
  void occluded(const RayPacket& rays, bool* blocked);

 private:
  struct Blocker {
    float normal[3], height;  // of the plane
    float edge[4][4];         // of the plane over an edge: normal inwards, height
  };
  std::uint32_t count_ = 0;
  Blocker blockers_[kMost];
};

}  // namespace fiatlux
