#include "precompute/light/surface_exchange.h"

#include <algorithm>
#include <cmath>

#include "core/scene/surface_exchange_codec.h"
#include "core/transport/column_block.h"
#include "core/transport/site_responses.h"

namespace fiatlux {
namespace {

static_assert(kBlockWidth == kColumnBlock);

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
  return (static_cast<std::uint32_t>(area_.size()) + kBlockWidth - 1) / kBlockWidth;
}

std::uint32_t SurfaceExchangeRows::used(std::uint32_t block) const {
  return std::min(kBlockWidth, static_cast<std::uint32_t>(area_.size()) - block * kBlockWidth);
}

/// a, rows x kBlockWidth.
std::vector<float> SurfaceExchangeRows::weightsOf(std::uint32_t block) const {
  const Patches& patches = room_.patches;
  std::vector<float> weights(std::size_t{patches.rows()} * kBlockWidth, 0.0f);
  for (std::uint32_t p = 0; p < patches.rows(); ++p) {
    const std::uint32_t s = patches.surface[p];
    if (patches.counts(p) && s / kBlockWidth == block)
      weights[std::size_t{p} * kBlockWidth + s % kBlockWidth] =
          static_cast<float>(patches.area[p] / area_[s]);
  }
  return weights;
}

/// About w: a + A (I - R F)^-1 A^-1 R F^T a.
std::vector<float> SurfaceExchangeRows::begin(const std::vector<float>& weights) const {
  const Patches& patches = room_.patches;
  std::vector<float> once(std::size_t{patches.count} * kBlockWidth), settled(once.size());
  transposedIrradiance(factors_, weights.data(), once.data());
  for (std::size_t at = 0; at < once.size(); ++at)
    once[at] *= static_cast<float>(patches.reflectance[at / kBlockWidth] / patches.area[at / kBlockWidth]);
  lowRank_.solve(once.data(), kBlockWidth, settled.data());
  std::vector<float> begun = weights;
  for (std::size_t at = 0; at < settled.size(); ++at)
    begun[at] += static_cast<float>(patches.area[at / kBlockWidth]) * settled[at];
  return begun;
}

std::vector<float> SurfaceExchangeRows::solve(std::uint32_t block) const {
  const Patches& patches = room_.patches;
  const std::vector<float> weights = weightsOf(block);
  std::vector<float> all = begin(weights), gathered(std::size_t{patches.count} * kBlockWidth);
  for (std::uint32_t step = 0;; ++step) {
    transposedIrradiance(factors_, all.data(), gathered.data());
    double change = 0, sum = 0;
    for (std::size_t at = 0; at < gathered.size(); ++at) {
      const float next = weights[at] + patches.reflectance[at / kBlockWidth] * gathered[at];
      change += std::pow(next - all[at], 2), sum += std::pow(next, 2);
      all[at] = next;
    }
    if (step == kMostRepeats || change <= kStill * kStill * sum) break;
  }
  std::vector<float> means;
  for (std::uint32_t p = 0; p < patches.count; ++p)
    for (std::uint32_t j = 0; j < used(block); ++j)
      means.push_back(static_cast<float>(gathered[std::size_t{p} * kBlockWidth + j] / patches.area[p]));
  return means;
}

SurfaceExchange surfaceExchangeOf(const Room& room, const std::vector<std::vector<float>>& blocks) {
  const auto surfaces = static_cast<std::uint32_t>(room.surfaces.size());
  SurfaceExchange exact{surfaces, std::vector<float>(std::size_t{room.patches.count} * surfaces)};
  for (std::uint32_t block = 0; block < blocks.size(); ++block) {
    const std::uint32_t first = block * kBlockWidth, used = std::min(kBlockWidth, surfaces - first);
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
