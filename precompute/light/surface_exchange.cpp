#include "precompute/light/surface_exchange.h"

#include <algorithm>
#include <cmath>

#include "core/scene/surface_exchange_codec.h"
#include "core/transport/column_block.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kMostRepeats = 30;
constexpr double kStill =
    1e-4;  // of all weights' squares' root: what a step still changes when it was the last

}  // namespace

SurfaceExchangeRows::SurfaceExchangeRows(const Room& room, const FormFactors& factors,
                                         const LowRankRadiosity& lowRank)
    : room_(room), factors_(factors), lowRank_(lowRank), area_(room.surfaces.size(), 0) {
  const Patches& patches = room.patches;
  for (std::uint32_t p = 0; p < patches.rows(); ++p)
    if (patches.counts(p)) area_[patches.surface[p]] += patches.area[p];
}

std::uint32_t SurfaceExchangeRows::blocks() const {
  return (static_cast<std::uint32_t>(area_.size()) + kColumnBlock - 1) / kColumnBlock;
}

std::uint32_t SurfaceExchangeRows::used(std::uint32_t block) const {
  return std::min(kColumnBlock, static_cast<std::uint32_t>(area_.size()) - block * kColumnBlock);
}

/// a, rows x kColumnBlock.
std::vector<float> SurfaceExchangeRows::weightsOf(std::uint32_t block) const {
  const Patches& patches = room_.patches;
  std::vector<float> weights(std::size_t{patches.rows()} * kColumnBlock, 0.0f);
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    const std::uint32_t s = patches.surface[p];
    if (patches.counts(p) && s / kColumnBlock == block)
      weights[std::size_t{p} * kColumnBlock + s % kColumnBlock] =
          static_cast<float>(patches.area[p] / area_[s]);
  }
  return weights;
}

/// About w: a + A (I - R F)^-1 A^-1 R F^T a.
std::vector<float> SurfaceExchangeRows::begin(const std::vector<float>& weights) const {
  const Patches& patches = room_.patches;
  std::vector<float> once(std::size_t{patches.count} * kColumnBlock), settled(once.size());
  transposedIrradiance(factors_, weights.data(), once.data());
  for (std::size_t at = 0; at < once.size(); ++at)
    once[at] *= static_cast<float>(patches.reflectance[at / kColumnBlock] / patches.area[at / kColumnBlock]);
  lowRank_.solve(once.data(), kColumnBlock, settled.data());
  std::vector<float> begun = weights;
  for (std::size_t at = 0; at < settled.size(); ++at)
    begun[at] += static_cast<float>(patches.area[at / kColumnBlock]) * settled[at];
  return begun;
}

std::vector<float> SurfaceExchangeRows::solve(std::uint32_t block) const {
  const Patches& patches = room_.patches;
  const std::vector<float> weights = weightsOf(block);
  std::vector<float> all = begin(weights), gathered(std::size_t{patches.count} * kColumnBlock);
  for (std::uint32_t step = 0;; ++step) {
    transposedIrradiance(factors_, all.data(), gathered.data());
    double change = 0, sum = 0;
    for (std::size_t at = 0; at < gathered.size(); ++at) {
      const float next = weights[at] + patches.reflectance[at / kColumnBlock] * gathered[at];
      change += std::pow(next - all[at], 2), sum += std::pow(next, 2);
      all[at] = next;
    }
    if (step == kMostRepeats || change <= kStill * kStill * sum) break;
  }
  std::vector<float> means;
  for (std::uint32_t p = 0; p < patches.count; ++p)
    for (std::uint32_t j = 0; j < used(block); ++j)
      means.push_back(static_cast<float>(gathered[std::size_t{p} * kColumnBlock + j] / patches.area[p]));
  return means;
}

SurfaceExchange surfaceExchangeOf(const Room& room, const std::vector<std::vector<float>>& blocks) {
  const auto surfaces = static_cast<std::uint32_t>(room.surfaces.size());
  SurfaceExchange exact{surfaces, std::vector<float>(std::size_t{room.patches.count} * surfaces)};
  for (std::uint32_t block = 0; block < blocks.size(); ++block) {
    const std::uint32_t first = block * kColumnBlock, used = std::min(kColumnBlock, surfaces - first);
    for (std::uint32_t p = 0; p < room.patches.count; ++p)
      std::copy_n(&blocks[block][std::size_t{p} * used], used,
                  &exact.means[std::size_t{p} * surfaces + first]);
  }
  SurfaceExchange stored{surfaces, {}};
  // note: what was just encoded decodes without a fault.
  decodeSurfaceExchange(encodeSurfaceExchange(room.patches, exact), room.patches, stored);
  return stored;
}

}  // namespace fiatlux
