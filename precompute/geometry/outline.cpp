// Boundary edges -> loops -> straight sides.
#include "precompute/geometry/outline.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

namespace fiatlux {

std::vector<BoundaryStep> boundaryOf(const FaceSet& set, const std::vector<std::uint32_t>& faces) {
  std::vector<std::uint32_t> pieces;  // of the set's edges, which are in order
  for (const std::uint32_t f : faces)
    pieces.insert(pieces.end(), set.faceEdges.begin() + set.faceEdgeOffset[f],
                  set.faceEdges.begin() + set.faceEdgeOffset[f + 1]);
  std::sort(pieces.begin(), pieces.end());
  std::vector<BoundaryStep> steps;
  for (std::size_t i = 0, j; i < pieces.size(); i = j) {
    const SubEdge& edge = set.edges[pieces[i]];
    int balance = 0;
    for (j = i; j < pieces.size() && set.edges[pieces[j]].a == edge.a && set.edges[pieces[j]].b == edge.b;
         ++j)
      balance += set.edges[pieces[j]].forward ? 1 : -1;
    for (; balance > 0; --balance) steps.emplace_back(edge.a, edge.b);
    for (; balance < 0; ++balance) steps.emplace_back(edge.b, edge.a);
  }
  std::sort(steps.begin(), steps.end());
  return steps;
}

namespace {

using Step = BoundaryStep;

/// A chain of boundary points -> its straight sides; calls side(from, to) for each.
template <class Side>
void straightSides(const std::vector<Vec3>& loop, double tolerance, Side side) {
  const std::size_t n = loop.size();
  if (n < 2) return;
  // Start where the chain turns most, so that no side is cut in two by the start.
  std::size_t start = 0;
  double sharpest = 2;
  for (std::size_t i = 0; i < n; ++i) {
    const double turn =
        dot(normalized(loop[i] - loop[(i + n - 1) % n]), normalized(loop[(i + 1) % n] - loop[i]));
    if (turn < sharpest) sharpest = turn, start = i;
  }
  Vec3 from = loop[start], direction = normalized(loop[(start + 1) % n] - from), last = from;
  for (std::size_t i = 1; i <= n; ++i) {
    const Vec3 p = loop[(start + i) % n], d = p - from;
    const bool onLine =
        length(d - dot(d, direction) * direction) < 4 * tolerance && dot(p - last, direction) > 0;
    if (!onLine) {
      side(from, last);
      from = last;
      direction = normalized(p - from);
    } else if (length(d) > 0) {
      direction = normalized(d);
    }
    last = p;
  }
  side(from, last);
}

/// Walks along boundaries, loop by loop, each step once.
class BoundaryWalk {
 public:
  /// `steps` sorted.
  BoundaryWalk(const WeldedMesh& mesh, std::vector<Step> steps)
      : mesh_(mesh), steps_(std::move(steps)), used_(steps_.size(), false), firstFree_(steps_.size()) {
    assert(std::is_sorted(steps_.begin(), steps_.end()));
    for (std::size_t s = 0; s < steps_.size(); ++s) firstFree_[s] = s;
  }

  /// Walks the next loop; false where there is none left.
  bool nextLoop() {
    while (first_ < steps_.size() && used_[first_]) ++first_;
    if (first_ == steps_.size()) return false;
    loop_.clear();
    const std::uint32_t start = steps_[first_].first;
    std::uint32_t at = start;
    do {
      const std::size_t next = straightestFrom(at);
      loop_.push_back(mesh_.positions[at]);
      if (next == steps_.size()) break;
      used_[next] = true;
      at = steps_[next].second;
    } while (at != start);
    return true;
  }
  const std::vector<Vec3>& loop() const { return loop_; }

 private:
  /// Where boundaries touch, go on as straight as possible (among the first few, where very many touch).
  std::size_t straightestFrom(std::uint32_t at) {
    const auto begin = static_cast<std::size_t>(std::lower_bound(steps_.begin(), steps_.end(), Step{at, 0u}) -
                                                steps_.begin());
    std::size_t best = steps_.size();
    if (begin == steps_.size()) return best;
    std::size_t& free = firstFree_[begin];
    while (free < steps_.size() && used_[free] && steps_[free].first == at) ++free;
    double straightest = -3;
    int looked = 0;
    for (std::size_t s = free; s < steps_.size() && steps_[s].first == at && looked < 64; ++s) {
      if (used_[s]) continue;
      ++looked;
      const Vec3& here = mesh_.positions[at];
      const double straight = loop_.empty() ? 0
                                            : dot(normalized(here - loop_.back()),
                                                  normalized(mesh_.positions[steps_[s].second] - here));
      if (straight > straightest) straightest = straight, best = s;
    }
    return best;
  }

  const WeldedMesh& mesh_;
  std::vector<Step> steps_;
  std::vector<bool> used_;
  std::vector<std::size_t> firstFree_;  // at the first step of a vertex: its first unused one
  std::size_t first_ = 0;               // all steps before it are used
  std::vector<Vec3> loop_;
};

/// The outline that straight sides make, added one by one.
struct SideCollector {
  Outline outline;
  double longest = 0;  // m, of the sides so far

  void add(const Vec3& from, const Vec3& to) {
    const Vec3 d = to - from;
    const double l = length(d);
    outline.perimeter += l;
    if (l < longest * (1 - 1e-3) || l <= 0) return;
    const Vec3 unit = forward((1 / l) * d);
    if (l > longest * (1 + 1e-3) || rank(unit) > rank(outline.longestDirection))
      outline.longestDirection = unit;
    longest = std::max(longest, l);
  }

 private:
  /// Of u and -u the one whose largest component (x before y before z) is positive.
  static Vec3 forward(const Vec3& u) {
    const double largest = std::max({std::abs(u.x), std::abs(u.y), std::abs(u.z)});
    const double lead = std::abs(u.x) > largest - 1e-9 ? u.x : std::abs(u.y) > largest - 1e-9 ? u.y : u.z;
    return lead < 0 ? -u : u;
  }
  /// How near a direction is to the axes, x before y before z, beyond noise.
  static std::array<double, 3> rank(const Vec3& u) {
    const auto rounded = [](double x) { return std::round(std::abs(x) * 1e4); };
    return {rounded(u.x), rounded(u.y), rounded(u.z)};
  }
};

}  // namespace

Outline outlineOf(const WeldedMesh& mesh, const FaceSet& set, const std::vector<std::uint32_t>& faces) {
  SideCollector sides;
  BoundaryWalk walk(mesh, boundaryOf(set, faces));
  while (walk.nextLoop())
    straightSides(walk.loop(), mesh.tolerance,
                  [&](const Vec3& from, const Vec3& to) { sides.add(from, to); });
  return sides.outline;
}

}  // namespace fiatlux
