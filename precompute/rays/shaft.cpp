// The hull's faces are the two places and, over each side of one, the plane that leans on the other. Any
// plane bounds the hull once it is moved to its outermost corner, so none of them must be exact.
#include "precompute/rays/shaft.h"

#include <algorithm>
#include <cmath>

namespace fiatlux {
namespace {

/// The square of a normal's length, relative to those of its factors, below which it has no direction.
constexpr float kNoDirection = 1e-10f;

struct V {
  float x, y, z;
};
V operator-(const V& a, const V& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
float dot(const V& a, const V& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
V cross(const V& a, const V& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

float leastOf(Float8 a) {
  float least = a[0];
  for (int i = 1; i < 8; ++i) least = std::min(least, a[i]);
  return least;
}
float mostOf(Float8 a) { return -leastOf(-a); }

}  // namespace

Shaft::Shaft(const Place& from, const Place& to, float touch) : touch_(touch) {
  for (int axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < 4; ++i) {
      corner_[axis][i] = from.corner[axis][i];
      corner_[axis][i + 4] = to.corner[axis][i];
    }
    low_[axis] = leastOf(corner_[axis]) + touch;
    high_[axis] = mostOf(corner_[axis]) - touch;
  }
  diagonal_ = std::hypot(high_[0] - low_[0], high_[1] - low_[1], high_[2] - low_[2]);
  addSides(0, 4);
  addSides(4, 0);
}

void Shaft::addPlane(const float (&normal)[3]) {
  const float most = mostOf(heights(normal[0], normal[1], normal[2], touch_));
  planes_[count_++] = {{normal[0], normal[1], normal[2]}, most};
}

/// The plane of the place that begins at lane `own`, and one over each of its sides.
void Shaft::addSides(std::uint32_t own, std::uint32_t other) {
  V mine[4], theirs[4], middle{0, 0, 0}, far{0, 0, 0};
  for (std::uint32_t i = 0; i < 4; ++i) {
    mine[i] = {corner_[0][own + i], corner_[1][own + i], corner_[2][own + i]};
    theirs[i] = {corner_[0][other + i], corner_[1][other + i], corner_[2][other + i]};
    middle = {middle.x + mine[i].x / 4, middle.y + mine[i].y / 4, middle.z + mine[i].z / 4};
    far = {far.x + theirs[i].x / 4, far.y + theirs[i].y / 4, far.z + theirs[i].z / 4};
  }
  // Outwards is where `inside` is not.
  const auto add = [&](const V& n, float scale, const V& through, const V& inside) {
    const float squared = dot(n, n);
    if (!(squared > kNoDirection * scale)) return;
    const float unit = (dot(n, inside - through) > 0 ? -1 : 1) / std::sqrt(squared);
    addPlane({unit * n.x, unit * n.y, unit * n.z});
  };
  const V along = mine[1] - mine[0], across = mine[3] - mine[0];
  add(cross(along, across), dot(along, along) * dot(across, across), mine[0], far);
  for (std::uint32_t i = 0; i < 4; ++i) {
    const V side = mine[(i + 1) % 4] - mine[i], in = middle - mine[i];
    V lean = theirs[0] - mine[i], n = cross(side, lean);
    float sign = dot(n, in) > 0 ? -1 : 1;
    for (std::uint32_t j = 1; j < 4; ++j) {
      const V next = theirs[j] - mine[i];
      if (!(sign * dot(n, next) > 0)) continue;
      lean = next;
      n = cross(side, lean);
      sign = dot(n, in) > 0 ? -1 : 1;
    }
    add(n, dot(side, side) * dot(lean, lean), mine[i], middle);
  }
}

unsigned Shaft::entered(const float (&bounds)[6][8]) const {
  Float8 low[3], high[3];
  Mask8 inside = Mask8{} - 1;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = load8(bounds[axis]);
    high[axis] = load8(bounds[axis + 3]);
    inside &= (low[axis] < all8(high_[axis])) & (high[axis] > all8(low_[axis]));
  }
  if (bitsOf(inside) == 0) return 0;
  for (std::uint32_t i = 0; i < count_; ++i) {
    const Plane& plane = planes_[i];
    Float8 least = all8(0);
    for (int axis = 0; axis < 3; ++axis)
      least += (plane.normal[axis] > 0 ? low[axis] : high[axis]) * plane.normal[axis];
    inside &= least < all8(plane.most);
  }
  return bitsOf(inside);
}

unsigned Shaft::crossed(const Quads& quads) const {
  const Float8 nx = load8(quads.normal[0]), ny = load8(quads.normal[1]), nz = load8(quads.normal[2]);
  const Float8 height = load8(quads.height);
  Float8 lowest = all8(0), highest = all8(0);
  for (int i = 0; i < 8; ++i) {
    const Float8 at = nx * corner_[0][i] + ny * corner_[1][i] + nz * corner_[2][i] - height;
    lowest = min8(lowest, at);
    highest = max8(highest, at);
  }
  Mask8 inside = (lowest < all8(-touch_)) & (highest > all8(touch_));
  if (bitsOf(inside) == 0) return 0;
  Float8 corner[4][3];
  for (int i = 0; i < 4; ++i)
    for (int axis = 0; axis < 3; ++axis) corner[i][axis] = load8(quads.corner[i][axis]);
  const auto leastAlong = [&](const auto& at) { return min8(min8(at(0), at(1)), min8(at(2), at(3))); };
  for (int axis = 0; axis < 3; ++axis) {
    const Float8 low = leastAlong([&](int i) { return corner[i][axis]; });
    const Float8 high = -leastAlong([&](int i) { return -corner[i][axis]; });
    inside &= (low < all8(high_[axis])) & (high > all8(low_[axis]));
  }
  for (std::uint32_t p = 0; p < count_ && bitsOf(inside) != 0; ++p) {
    const float* n = planes_[p].normal;
    const Float8 least =
        leastAlong([&](int i) { return corner[i][0] * n[0] + corner[i][1] * n[1] + corner[i][2] * n[2]; });
    inside &= least < all8(planes_[p].most);
  }
  return bitsOf(inside);
}

/// All segments between two convex places pass a convex hole where those between their corners do.
bool Shaft::isCutBy(const Quads& quads, std::uint32_t lane) const {
  const Float8 over =
      heights(quads.normal[0][lane], quads.normal[1][lane], quads.normal[2][lane], quads.height[lane]);
  const unsigned above = bitsOf(over > all8(touch_)), below = bitsOf(over < all8(-touch_));
  const bool down = above == 0x0f && below == 0xf0;
  if (!down && !(above == 0xf0 && below == 0x0f)) return false;
  const std::uint32_t a = down ? 0 : 4, b = 4 - a;  // lanes above and below
  Float8 start[2][3], ray[2][3];                    // from two corners above to the four below
  for (std::uint32_t pair = 0; pair < 2; ++pair)
    for (int axis = 0; axis < 3; ++axis) {
      const Float8& corner = corner_[axis];
      const float one = corner[a + 2 * pair], two = corner[a + 2 * pair + 1];
      start[pair][axis] = Float8{one, one, one, one, two, two, two, two};
      const Float8 end{corner[b], corner[b + 1], corner[b + 2], corner[b + 3],
                       corner[b], corner[b + 1], corner[b + 2], corner[b + 3]};
      ray[pair][axis] = end - start[pair][axis];
    }
  for (int side = 0; side < 4; ++side) {
    const auto& one = quads.corner[side];
    const auto& two = quads.corner[(side + 1) % 4];
    const float ex = two[0][lane] - one[0][lane], ey = two[1][lane] - one[1][lane],
                ez = two[2][lane] - one[2][lane];
    const Float8 margin = all8(touch_ * std::sqrt(ex * ex + ey * ey + ez * ez) * diagonal_);
    for (std::uint32_t pair = 0; pair < 2; ++pair) {
      Float8 from[3];  // the corner from its start
      for (int axis = 0; axis < 3; ++axis) from[axis] = all8(one[axis][lane]) - start[pair][axis];
      const Float8 volume = (from[1] * ez - from[2] * ey) * ray[pair][0] +
                            (from[2] * ex - from[0] * ez) * ray[pair][1] +
                            (from[0] * ey - from[1] * ex) * ray[pair][2];
      if (bitsOf(volume <= margin) != 0xff) return false;
    }
  }
  return true;
}

}  // namespace fiatlux
