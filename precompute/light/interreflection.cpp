#include "precompute/light/interreflection.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/transport/site_responses.h"
#include "precompute/base/error.h"
#include "precompute/light/exchange_groups.h"

namespace fiatlux {

Interreflection::Interreflection(const Room& room, const RayTracer& tracer, const CastLight& cast,
                                 const TransportOptions& options)
    : room_(room),
      cast_(cast),
      refine_(options.refine),
      lowRank_(orThrow(LowRankRadiosity::factorize(cast.factors, room.patches))) {
  assert(!options.paper && cast.factors.rows == room.patches.rows());
  assert(cast.direct.size() == std::size_t{room.patches.rows()} * room.sites.size());
  if (!options.exchange) return;
  groups_ = exchangeGroups(room, tracer);
  exchange_ = std::make_unique<ExchangeColumns>(room, cast.factors, lowRank_, groups_);
  surfaces_ = std::make_unique<SurfaceExchangeRows>(room, cast.factors, lowRank_);
}

std::uint32_t Interreflection::siteBlocks() const {
  return (static_cast<std::uint32_t>(room_.sites.size()) + kBlockWidth - 1) / kBlockWidth;
}

std::uint32_t Interreflection::firstOfSurfaces() const {
  return siteBlocks() + (exchange_ ? exchange_->blocks() : 0);
}

std::uint32_t Interreflection::blocks() const {
  return firstOfSurfaces() + (surfaces_ ? surfaces_->blocks() : 0);
}

std::uint32_t Interreflection::usedSites(std::uint32_t block) const {
  return std::min(kBlockWidth, static_cast<std::uint32_t>(room_.sites.size()) - block * kBlockWidth);
}

SolvedBlock Interreflection::solve(std::uint32_t index) const {
  if (index >= firstOfSurfaces()) return {{}, {}, {}, surfaces_->solve(index - firstOfSurfaces())};
  if (index >= siteBlocks()) return {{}, {}, exchange_->solve(index - siteBlocks()), {}};
  const std::uint32_t rows = room_.patches.rows(), used = usedSites(index);
  ResponseBlock block;
  block.width = paddedSources(used);
  block.direct.assign(std::size_t{rows} * block.width, 0.0f);
  for (std::uint32_t j = 0; j < used; ++j) {
    const float* column = cast_.direct.data() + (std::size_t{index} * kBlockWidth + j) * rows;
    for (std::uint32_t p = 0; p < rows; ++p) block.direct[std::size_t{p} * block.width + j] = column[p];
  }
  solveResponses(cast_.factors, room_.patches, lowRank_, refine_, kSettled, block);

  SolvedBlock solved;
  solved.illuminance.resize(std::size_t{rows} * used);
  // note: refinement may leave a rounding error below zero where it is dark; light is never negative.
  for (std::uint32_t j = 0; j < used; ++j)
    for (std::uint32_t p = 0; p < rows; ++p)
      solved.illuminance[std::size_t{j} * rows + p] =
          std::max(0.0f, block.irradiance[std::size_t{p} * block.width + j]);
  for (std::size_t step = 0; step * block.width < block.residuals.size(); ++step) {
    double sum = 0;
    for (std::uint32_t j = 0; j < used; ++j) sum += std::pow(block.residuals[step * block.width + j], 2);
    solved.squares.push_back(sum);
  }
  return solved;
}

SolvedLight Interreflection::unsolved() const {
  SolvedLight light;
  light.responses.rows = room_.patches.rows();
  light.responses.sites = static_cast<std::uint32_t>(room_.sites.size());
  light.responses.illuminance.resize(std::size_t{light.responses.rows} * light.responses.sites);
  light.squares.resize(siteBlocks());
  light.groups = groups_;
  light.exchange.resize(firstOfSurfaces() - siteBlocks());
  light.surfaces.resize(blocks() - firstOfSurfaces());
  return light;
}

bool Interreflection::isOf(std::uint32_t block, const SolvedBlock& solved) const {
  const std::size_t rows = room_.patches.rows();
  if (block < siteBlocks()) return solved.illuminance.size() == rows * usedSites(block);
  if (block >= blocks()) return false;
  if (block >= firstOfSurfaces())
    return solved.surfaces.size() ==
           std::size_t{room_.patches.count} * surfaces_->used(block - firstOfSurfaces());
  const std::uint32_t first = (block - siteBlocks()) * kBlockWidth;
  const std::size_t used = std::min(kBlockWidth, groups_.count - first);
  const auto isInside = [&](const ExchangeRest& entry) {
    return entry.row < rows && entry.group < groups_.count;
  };
  const ExchangeBlock& exchange = solved.exchange;
  return exchange.means.size() == groups_.total * used &&
         std::all_of(exchange.rest.begin(), exchange.rest.end(), isInside);
}

void Interreflection::put(std::uint32_t block, SolvedBlock&& solved, SolvedLight& light) const {
  assert(isOf(block, solved));
  if (block >= firstOfSurfaces()) {
    light.surfaces[block - firstOfSurfaces()] = std::move(solved.surfaces);
    return;
  }
  if (block >= siteBlocks()) {
    light.exchange[block - siteBlocks()] = std::move(solved.exchange);
    return;
  }
  const std::size_t at = std::size_t{block} * kBlockWidth * room_.patches.rows();
  std::copy(solved.illuminance.begin(), solved.illuminance.end(), light.responses.illuminance.begin() + at);
  light.squares[block] = std::move(solved.squares);
}

}  // namespace fiatlux
