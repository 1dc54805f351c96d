// Patches are rectangles and bodies are boxes, so each pair is asked for an axis that parts them (Gottschalk,
// Lin and Manocha 1996): the normals of both and the cross products of their edges.
#include "core/transport/candidate_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fiatlux {
namespace {

/// By its centre and half edges, m; a rectangle is a box without height.
struct Box {
  Vec3 center;
  std::array<Vec3, 3> half;
};

/// Where the two overlap along `axis`, which may have no length.
bool overlap(const Box& a, const Box& b, const Vec3& axis) {
  double reach = 0;
  for (const Box* box : {&a, &b})
    for (const Vec3& half : box->half) reach += std::abs(dot(half, axis));
  return std::abs(dot(b.center - a.center, axis)) <= reach;
}

bool intersect(const Box& body, const Box& tile, const Vec3& normal) {
  if (!overlap(body, tile, normal)) return false;
  for (const Vec3& edge : body.half)
    if (!overlap(body, tile, edge)) return false;
  for (const Vec3& edge : body.half)
    for (int i = 0; i < 2; ++i) {
      const Vec3 axis = cross(edge, tile.half[i]);
      // note: edges side by side part nothing, and their product is rounding.
      if (length(axis) > 1e-6 * length(edge) * length(tile.half[i]) && !overlap(body, tile, axis))
        return false;
    }
  return true;
}

}  // namespace

CandidateFit::CandidateFit(const Scene& scene)
    : scene_(scene), tiles_(patchTiles(scene.patches, scene.lightOperator->charts)) {}

bool CandidateFit::fits(const Luminaire& luminaire, double depth) const {
  // The body, a hair smaller on all sides and clear of what it hangs on.
  const double thick = std::max(depth, 2 * kFitSlack) - kFitSlack;
  const auto within = [](double size) { return std::max(0.5 * size - kFitSlack, 1e-3); };
  const Vec3 across = cross(luminaire.normal, luminaire.axis);
  const Box body{luminaire.position + (kFitSlack + 0.5 * thick) * luminaire.normal,
                 {within(luminaire.width) * luminaire.axis, within(luminaire.height) * across,
                  0.5 * thick * luminaire.normal}};
  const double radius = length(body.half[0] + body.half[1] + body.half[2]);
  const Patches& patches = scene_.patches;
  for (std::uint32_t p = 0; p < patches.count; ++p) {
    const Vec3 apart = patches.center[p] - body.center;
    const double reach = radius + 0.5 * (tiles_[p].lengthU + tiles_[p].lengthV);
    if (dot(apart, apart) > reach * reach) continue;
    const Box tile{patches.center[p], {0.5 * tiles_[p].edgeU, 0.5 * tiles_[p].edgeV, Vec3{}}};
    if (intersect(body, tile, patches.normal[p])) return false;
  }
  return true;
}

}  // namespace fiatlux
