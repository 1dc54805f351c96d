#include "precompute/rays/blockers.h"

#include <cassert>
#include <cmath>
#include <utility>

#include "precompute/rays/ray_tracer.h"

namespace fiatlux {

void Blockers::add(const Quads& quads, std::uint32_t lane, float slack) {
  assert(!isFull());
  Blocker& blocker = blockers_[count_++];
  const float n[3]{quads.normal[0][lane], quads.normal[1][lane], quads.normal[2][lane]};
  for (int axis = 0; axis < 3; ++axis) blocker.normal[axis] = n[axis];
  blocker.height = quads.height[lane];
  for (int i = 0; i < 4; ++i) {
    float at[3], along[3];
    for (int axis = 0; axis < 3; ++axis) {
      at[axis] = quads.corner[i][axis][lane];
      along[axis] = quads.corner[(i + 1) % 4][axis][lane] - at[axis];
    }
    float* const edge = blocker.edge[i];
    edge[3] = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const int next = (axis + 1) % 3, last = (axis + 2) % 3;
      edge[axis] = n[next] * along[last] - n[last] * along[next];
      edge[3] += edge[axis] * at[axis];
    }
    // note: a triangle has one edge without length; everything is inside of that.
    edge[3] -= slack * std::sqrt(along[0] * along[0] + along[1] * along[1] + along[2] * along[2]);
  }
}

void Blockers::occluded(const RayPacket& rays, bool* blocked) {
  const Float8 ox = load8(rays.originX), oy = load8(rays.originY), oz = load8(rays.originZ),
               dx = load8(rays.directionX), dy = load8(rays.directionY), dz = load8(rays.directionZ),
               reach = load8(rays.reach);
  const unsigned all = (1u << rays.count) - 1;
  unsigned stopped = 0;
  for (std::uint32_t b = 0; b < count_ && stopped != all; ++b) {
    const Blocker& blocker = blockers_[b];
    const float* const n = blocker.normal;
    const Float8 at =
        (all8(blocker.height) - (ox * n[0] + oy * n[1] + oz * n[2])) / (dx * n[0] + dy * n[1] + dz * n[2]);
    Mask8 met = (at > all8(0)) & (at <= reach);
    if (bitsOf(met) == 0) continue;
    const Float8 x = ox + at * dx, y = oy + at * dy, z = oz + at * dz;
    for (const auto& edge : blocker.edge) met &= x * edge[0] + y * edge[1] + z * edge[2] >= all8(edge[3]);
    stopped |= bitsOf(met) & all;
    if (b > 0 && stopped == all) std::swap(blockers_[0], blockers_[b]);
  }
  for (std::uint32_t i = 0; i < rays.count; ++i) blocked[i] = (stopped >> i & 1) != 0;
}

}  // namespace fiatlux
