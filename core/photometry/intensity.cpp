#include "core/photometry/intensity.h"

#include <algorithm>
#include <cmath>

#include "core/photometry/degrees.h"
#include "core/photometry/planes.h"

namespace fiatlux {
namespace {

struct Place {
  std::size_t below, above;
  double share;  // of `above`
};

/// Where `value`, within the first and last of `nodes`, lies between them.
Place placeIn(const std::vector<double>& nodes, double value) {
  const auto above = std::upper_bound(nodes.begin(), nodes.end(), value);
  if (above == nodes.begin()) return {0, 0, 0};
  if (above == nodes.end()) return {nodes.size() - 1, nodes.size() - 1, 0};
  const std::size_t i = static_cast<std::size_t>(above - nodes.begin());
  return {i - 1, i, (value - nodes[i - 1]) / (nodes[i] - nodes[i - 1])};
}

}  // namespace

double intensityAt(const Photometry& photometry, double c, double gamma) {
  if (gamma < photometry.gamma.front() || gamma > photometry.gamma.back()) return 0;
  const Place g = placeIn(photometry.gamma, gamma);
  const Place p = placeIn(photometry.c, foldedPlane(photometry.symmetry, c));
  const auto alongPlane = [&](std::size_t plane) {
    return (1 - g.share) * photometry.at(plane, g.below) + g.share * photometry.at(plane, g.above);
  };
  return (1 - p.share) * alongPlane(p.below) + p.share * alongPlane(p.above);
}

double intensity(const Photometry& photometry, const Vec3& direction) {
  const double across = std::hypot(direction.x, direction.y);
  if (across == 0 && direction.z == 0) return 0;
  return intensityAt(photometry, std::atan2(direction.y, direction.x) / kDegree,
                     std::atan2(across, direction.z) / kDegree);
}

}  // namespace fiatlux
