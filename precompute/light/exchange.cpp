#include "precompute/light/exchange.h"

#include <algorithm>
#include <cmath>

#include "core/scene/exchange_codec.h"
#include "core/transport/group_interpolation.h"
#include "core/transport/site_responses.h"
#include "precompute/base/parallel.h"
#include "precompute/light/exchange_groups.h"

namespace fiatlux {
namespace {

struct RestEntry {
  std::uint32_t row, group;
  float value;
};

/// Solves groups [first, first + kBlockWidth) and writes their columns of H; returns their part of the rest.
class ExchangeColumns {
 public:
  ExchangeColumns(const Room& room, const FormFactors& factors, const LowRankRadiosity& lowRank,
                  const ExchangeGroups& groups, std::uint32_t refine)
      : patches_(room.patches),
        factors_(factors),
        lowRank_(lowRank),
        groups_(groups),
        refine_(refine),
        interpolation_(room.patches, groups) {}

  std::vector<RestEntry> solve(std::uint32_t first, std::vector<float>& means) const {
    const std::uint32_t used = std::min(kBlockWidth, groups_.count - first);
    const std::vector<double>& area = interpolation_.areas();
    ResponseBlock block;
    block.width = used > 8 ? 16 : 8;
    block.direct.assign(std::size_t{patches_.rows()} * block.width, 0.0f);
    block.emission.assign(std::size_t{patches_.count} * block.width, 0.0f);
    for (std::uint32_t p = 0; p < patches_.count; ++p) {
      const std::uint32_t d = groups_.ofRow[p];
      if (d >= first && d < first + used)
        block.emission[std::size_t{p} * block.width + d - first] = static_cast<float>(1 / area[d]);
    }
    solveResponses(factors_, patches_, lowRank_, refine_, 0, block);

    std::vector<float> columns(std::size_t{groups_.total} * block.width);
    interpolation_.means(block.irradiance.data(), block.width, columns.data());
    for (std::uint32_t c = 0; c < groups_.total; ++c)
      for (std::uint32_t j = 0; j < used; ++j)
        means[std::size_t{c} * groups_.count + first + j] = columns[std::size_t{c} * block.width + j];
    std::vector<float> smooth(block.irradiance.size());
    interpolation_.apply(columns.data(), block.width, smooth.data());
    std::vector<RestEntry> rest;
    for (std::uint32_t p = 0; p < patches_.rows(); ++p)
      for (std::uint32_t j = 0; j < used; ++j) {
        const std::size_t at = std::size_t{p} * block.width + j;
        const float value = block.irradiance[at] - smooth[at];
        const double least = 0.5 * kExchangeRestStep / std::sqrt(patches_.area[p] * area[first + j]);
        if (std::abs(value) >= least) rest.push_back({p, first + j, value});
      }
    return rest;
  }

 private:
  const Patches& patches_;
  const FormFactors& factors_;
  const LowRankRadiosity& lowRank_;
  const ExchangeGroups& groups_;
  std::uint32_t refine_;
  GroupInterpolation interpolation_;
};

/// The blocks' entries, which ascend by row and then by group, as one list.
void addRest(const std::vector<std::vector<RestEntry>>& blocks, std::uint32_t rows, Exchange& exchange) {
  std::vector<std::uint32_t> count(rows + 1, 0);
  for (const auto& block : blocks)
    for (const RestEntry& entry : block) ++count[entry.row + 1];
  for (std::uint32_t p = 0; p < rows; ++p) count[p + 1] += count[p];
  exchange.offset = count;
  exchange.group.resize(count[rows]);
  exchange.rest.resize(count[rows]);
  for (const auto& block : blocks)
    for (const RestEntry& entry : block) {
      const std::uint32_t at = count[entry.row]++;
      exchange.group[at] = entry.group;
      exchange.rest[at] = entry.value;
    }
}

}  // namespace

Exchange exchangeBetween(const Room& room, const FormFactors& factors, const LowRankRadiosity& lowRank,
                         const ExchangeGroups& groups, const ExchangeOptions& options) {
  const std::uint32_t k = groups.count;
  Exchange exchange;
  exchange.means.resize(std::size_t{groups.total} * k);
  const ExchangeColumns columns(room, factors, lowRank, groups, options.refine);
  std::vector<std::vector<RestEntry>> rest((k + kBlockWidth - 1) / kBlockWidth);
  parallelFor(
      rest.size(), options.threads,
      [&](std::size_t block) {
        rest[block] = columns.solve(static_cast<std::uint32_t>(block) * kBlockWidth, exchange.means);
      },
      options.progress);
  for (std::uint32_t c = 0; c < k; ++c)
    for (std::uint32_t d = 0; d < c; ++d) {
      float &there = exchange.means[std::size_t{c} * k + d], &back = exchange.means[std::size_t{d} * k + c];
      there = back = 0.5f * (there + back);
    }
  addRest(rest, room.patches.rows(), exchange);
  return exchange;
}

LightOperator lightOperator(const Room& room, const RayTracer& tracer, const FormFactors& factors,
                            const LowRankRadiosity& lowRank, SiteVisibility visibility,
                            const ExchangeOptions& options) {
  LightOperator result{std::move(visibility), chartsOf(room), exchangeGroups(room, tracer), {}};
  const Patches& patches = room.patches;
  const Exchange exact = exchangeBetween(room, factors, lowRank, result.groups, options);
  // note: what was just encoded decodes without a fault.
  decodeExchangeMeans(encodeExchangeMeans(patches, result.groups, exact), patches, result.groups,
                      result.exchange);
  decodeExchangeRest(encodeExchangeRest(patches, result.groups, exact), patches, result.groups,
                     result.exchange);
  return result;
}

}  // namespace fiatlux
