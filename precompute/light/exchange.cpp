#include "precompute/light/exchange.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/scene/exchange_codec.h"
#include "core/transport/site_responses.h"
#include "precompute/light/exchange_groups.h"

namespace fiatlux {
namespace {

constexpr std::uint32_t kRefine = 0;  // the low-rank answer, gathered once, is near enough

/// The blocks' entries, which ascend by row and then by group, as one list.
void addRest(const std::vector<ExchangeBlock>& blocks, std::uint32_t rows, Exchange& exchange) {
  std::vector<std::uint32_t> count(rows + 1, 0);
  for (const ExchangeBlock& block : blocks)
    for (const ExchangeRest& entry : block.rest) ++count[entry.row + 1];
  for (std::uint32_t p = 0; p < rows; ++p) count[p + 1] += count[p];
  exchange.offset = count;
  exchange.group.resize(count[rows]);
  exchange.rest.resize(count[rows]);
  for (const ExchangeBlock& block : blocks)
    for (const ExchangeRest& entry : block.rest) {
      const std::uint32_t at = count[entry.row]++;
      exchange.group[at] = entry.group;
      exchange.rest[at] = entry.value;
    }
}

}  // namespace

ExchangeColumns::ExchangeColumns(const Room& room, const FormFactors& factors,
                                 const LowRankRadiosity& lowRank, const ExchangeGroups& groups)
    : patches_(room.patches),
      factors_(factors),
      lowRank_(lowRank),
      groups_(groups),
      interpolation_(room.patches, groups) {}

std::uint32_t ExchangeColumns::blocks() const { return (groups_.count + kBlockWidth - 1) / kBlockWidth; }

ExchangeBlock ExchangeColumns::solve(std::uint32_t index) const {
  const std::uint32_t first = index * kBlockWidth, used = std::min(kBlockWidth, groups_.count - first);
  const std::vector<double>& area = interpolation_.areas();
  ResponseBlock block;
  block.width = paddedSources(used);
  block.direct.assign(std::size_t{patches_.rows()} * block.width, 0.0f);
  block.emission.assign(std::size_t{patches_.count} * block.width, 0.0f);
  for (std::uint32_t p = 0; p < patches_.count; ++p) {
    const std::uint32_t d = groups_.ofRow[p];
    if (d >= first && d < first + used)
      block.emission[std::size_t{p} * block.width + d - first] = static_cast<float>(1 / area[d]);
  }
  solveResponses(factors_, patches_, lowRank_, kRefine, 0, block);

  std::vector<float> columns(std::size_t{groups_.total} * block.width);
  interpolation_.means(block.irradiance.data(), block.width, columns.data());
  ExchangeBlock solved;
  for (std::uint32_t c = 0; c < groups_.total; ++c) {
    const float* row = &columns[std::size_t{c} * block.width];
    solved.means.insert(solved.means.end(), row, row + used);
  }
  std::vector<float> smooth(block.irradiance.size());
  interpolation_.apply(columns.data(), block.width, smooth.data());
  for (std::uint32_t p = 0; p < patches_.rows(); ++p)
    for (std::uint32_t j = 0; j < used; ++j) {
      const std::size_t at = std::size_t{p} * block.width + j;
      const float value = block.irradiance[at] - smooth[at];
      const double least = 0.5 * kExchangeRestStep / std::sqrt(patches_.area[p] * area[first + j]);
      if (std::abs(value) >= least) solved.rest.push_back({p, first + j, value});
    }
  return solved;
}

Exchange exchangeOf(const ExchangeGroups& groups, std::uint32_t rows,
                    const std::vector<ExchangeBlock>& blocks) {
  const std::uint32_t k = groups.count;
  Exchange exchange;
  exchange.means.resize(std::size_t{groups.total} * k);
  for (std::uint32_t first = 0, index = 0; first < k; first += kBlockWidth, ++index) {
    const std::uint32_t used = std::min(kBlockWidth, k - first);
    for (std::uint32_t c = 0; c < groups.total; ++c)
      for (std::uint32_t j = 0; j < used; ++j)
        exchange.means[std::size_t{c} * k + first + j] = blocks[index].means[std::size_t{c} * used + j];
  }
  for (std::uint32_t c = 0; c < k; ++c)
    for (std::uint32_t d = 0; d < c; ++d) {
      float &there = exchange.means[std::size_t{c} * k + d], &back = exchange.means[std::size_t{d} * k + c];
      there = back = 0.5f * (there + back);
    }
  addRest(blocks, rows, exchange);
  return exchange;
}

LightOperator lightOperator(const Room& room, SiteVisibility visibility, ExchangeGroups groups,
                            const std::vector<ExchangeBlock>& blocks, SurfaceExchange surfaces) {
  LightOperator result{std::move(visibility), chartsOf(room), std::move(groups), {}, std::move(surfaces)};
  const Patches& patches = room.patches;
  const Exchange exact = exchangeOf(result.groups, patches.rows(), blocks);
  // note: what was just encoded decodes without a fault.
  decodeExchangeMeans(encodeExchangeMeans(patches, result.groups, exact), patches, result.groups,
                      result.exchange);
  decodeExchangeRest(encodeExchangeRest(patches, result.groups, exact), patches, result.groups,
                     result.exchange);
  return result;
}

}  // namespace fiatlux
