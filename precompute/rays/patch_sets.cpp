#include "precompute/rays/patch_sets.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace fiatlux {
namespace {

/// How far an area may differ from that of a rectangle, in parts of it.
constexpr double kSameArea = 1e-6;

}  // namespace

PatchSets::PatchSets(const Room& room, const Vec3& center) : room_(room), center_(center) {}

void PatchSets::add(std::span<const std::uint32_t> patches) {
  assert(!patches.empty());
  if (!addRectangle(patches)) {
    double area = 0, before = 0;
    for (const std::uint32_t p : patches) area += room_.patches.area[p];
    for (const std::uint32_t p : patches) {
      const double share = room_.patches.area[p] / area;
      addPatch(p, before, share);
      before += share;
    }
  }
  firstOf_.push_back(static_cast<std::uint32_t>(pieces_.size()));
}

/// Full cells that fill a rectangle are one piece.
bool PatchSets::addRectangle(std::span<const std::uint32_t> patches) {
  const Chart& chart = room_.charts[room_.chartOfPatch[patches[0]]];
  const Vec3 middle = room_.patches.center[patches[0]];
  double low[2]{}, high[2]{}, area = 0;
  Vec3 normal;
  for (const std::uint32_t p : patches) {
    const PatchSampler sampler(room_, p);
    if (!sampler.isFullCell()) return false;
    const Vec3 d = room_.patches.center[p] - middle;
    const double at[2]{dot(d, chart.uAxis), dot(d, chart.vAxis)};
    for (int axis = 0; axis < 2; ++axis) {
      low[axis] = std::min(low[axis], at[axis]);
      high[axis] = std::max(high[axis], at[axis]);
    }
    area += room_.patches.area[p];
    normal = sampler.at(0, 0).normal;
  }
  const double width = high[0] - low[0] + chart.cellU, height = high[1] - low[1] + chart.cellV;
  if (std::abs(width * height - area) > kSameArea * area) return false;
  const Vec3 corner =
      middle + (low[0] - 0.5 * chart.cellU) * chart.uAxis + (low[1] - 0.5 * chart.cellV) * chart.vAxis;
  addPiece(corner, width * chart.uAxis, height * chart.vAxis, normal, 0, 1, false);
  return true;
}

void PatchSets::addPatch(std::uint32_t patch, double before, double share) {
  const PatchSampler sampler(room_, patch);
  if (sampler.isFullCell()) {
    const auto [corner, normal, weight] = sampler.at(0, 0);
    addPiece(corner, sampler.at(1, 0).position - corner, sampler.at(0, 1).position - corner, normal, before,
             share, false);
    return;
  }
  for (const AreaSampler::Piece& piece : sampler.fragments().pieces())
    addPiece(piece.corner, piece.first, piece.second, piece.normal, before + piece.before * share,
             piece.share * share, true);
  if (sampler.fragments().empty())  // too thin to have area in its fragments
    addPiece(room_.patches.center[patch], {}, {}, room_.patches.normal[patch], before, share, false);
}

void PatchSets::addPiece(const Vec3& corner, const Vec3& first, const Vec3& second, const Vec3& normal,
                         double before, double share, bool isTriangle) {
  pieces_.push_back({inFloats(corner - center_), inFloats(first), inFloats(second), inFloats(normal),
                     static_cast<float>(1 / std::max(share, 1e-12)), isTriangle});
  before_.push_back(static_cast<float>(before));
}

}  // namespace fiatlux
