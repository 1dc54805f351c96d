#include "core/photometry/type_c.h"

#include <algorithm>
#include <cmath>

#include "core/photometry/degrees.h"

namespace fiatlux {
namespace {

/// Index of the node at or below `value` (never the last one) and how far it is to the next; false outside.
bool between(const std::vector<double>& nodes, double value, std::size_t& below, double& share) {
  if (value < nodes.front() || value > nodes.back()) return false;
  const auto above = std::upper_bound(nodes.begin(), nodes.end() - 1, value);
  below = static_cast<std::size_t>(above - nodes.begin()) - 1;
  share = (value - nodes[below]) / (nodes[below + 1] - nodes[below]);
  return true;
}

bool mirrored(const std::vector<double>& angles) { return angles.front() == 0; }

double candelaAt(const BeamTable& table, double horizontal, double vertical) {
  std::size_t h = 0, v = 0;
  double sh = 0, sv = 0;
  // note: sines and arc sines meet the table's edge with an error in the last place
  const auto settled = [](double angle) { return std::round(angle * 1e9) / 1e9; };
  horizontal = settled(mirrored(table.horizontal) ? std::abs(horizontal) : horizontal);
  vertical = settled(mirrored(table.vertical) ? std::abs(vertical) : vertical);
  if (!between(table.horizontal, horizontal, h, sh) || !between(table.vertical, vertical, v, sv)) return 0;
  const auto alongPlane = [&](std::size_t plane) {
    const double* row = &table.candela[plane * table.vertical.size() + v];
    return (1 - sv) * row[0] + sv * row[1];
  };
  return (1 - sh) * alongPlane(h) + sh * alongPlane(h + 1);
}

double finestStep(const std::vector<double>& angles) {
  double step = 180;
  for (std::size_t i = 1; i < angles.size(); ++i) step = std::min(step, angles[i] - angles[i - 1]);
  return step;
}

/// first, ..., last in equal steps of at most `step`.
std::vector<double> evenAngles(double first, double last, double step) {
  const auto parts = static_cast<std::size_t>(std::ceil((last - first) / step - 1e-9));
  std::vector<double> angles(parts + 1);
  for (std::size_t i = 0; i <= parts; ++i)
    angles[i] = first + (last - first) * static_cast<double>(i) / static_cast<double>(parts);
  return angles;
}

}  // namespace

void resampleAsTypeC(const BeamTable& table, Photometry& photometry) {
  using enum PhotometricSymmetry;
  const bool sideways = mirrored(table.horizontal), upDown = mirrored(table.vertical);
  const double step =
      std::clamp(std::min(finestStep(table.vertical), finestStep(table.horizontal)), 0.5, 2.5);
  const std::vector<double>& turning = table.typeA ? table.horizontal : table.vertical;
  const bool behind = turning.front() < -90 || turning.back() > 90;
  photometry.symmetry = sideways && upDown ? kQuadrant : sideways ? kC90C270 : upDown ? kC0C180 : kNone;
  photometry.gamma = evenAngles(0, behind ? 180 : 90, step);
  const double first = photometry.symmetry == kC90C270 ? 90 : 0;
  const double last = sideways && upDown ? 90 : sideways ? 270 : upDown ? 180 : 360;
  photometry.c = evenAngles(first, last, step);
  photometry.candela.clear();
  for (const double c : photometry.c) {
    for (const double gamma : photometry.gamma) {
      // The direction: x to the side, y up, z along the beam.
      const double x = std::sin(gamma * kDegree) * std::cos(c * kDegree);
      const double y = std::sin(gamma * kDegree) * std::sin(c * kDegree);
      const double z = std::cos(gamma * kDegree);
      const double around = std::atan2(table.typeA ? x : y, z) / kDegree;
      const double within = std::asin(std::clamp(table.typeA ? y : x, -1.0, 1.0)) / kDegree;
      photometry.candela.push_back(table.typeA ? candelaAt(table, around, within)
                                               : candelaAt(table, within, around));
    }
  }
}

}  // namespace fiatlux
