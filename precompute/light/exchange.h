// The exchange of light between groups (core/scene/light_operator.h): one more radiosity solution a group,
// which sheds 1 lm evenly. Blocks of groups are solved in any order, on any thread or machine.
#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/light_operator.h"
#include "core/transport/form_factors.h"
#include "core/transport/group_interpolation.h"
#include "core/transport/low_rank_radiosity.h"
#include "precompute/rays/ray_tracer.h"
#include "precompute/room/room.h"

namespace fiatlux {

/// What interpolation between groups leaves over of S between a row and a group, 1/m2.
struct ExchangeRest {
  std::uint32_t row, group;
  float value;
};

/// The share of some groups in the exchange.
struct ExchangeBlock {
  std::vector<float> means;        // their columns of H, total x used, row-major
  std::vector<ExchangeRest> rest;  // ascending by row, then by group; what exceeds half the step in which a
                                   // file counts it (kExchangeRestStep)
};

/// All arguments must outlive it.
class ExchangeColumns {
 public:
  ExchangeColumns(const Room& room, const FormFactors& factors, const LowRankRadiosity& lowRank,
                  const ExchangeGroups& groups);
  std::uint32_t blocks() const;
  /// Of groups [first, first + used) with first = block x kBlockWidth.
  ExchangeBlock solve(std::uint32_t block) const;

 private:
  const Patches& patches_;
  const FormFactors& factors_;
  const LowRankRadiosity& lowRank_;
  const ExchangeGroups& groups_;
  GroupInterpolation interpolation_;
};

/// H of all blocks, the mean of both directions, as cast form factors are reciprocal to a few per cent only;
/// and the rest.
Exchange exchangeOf(const ExchangeGroups& groups, std::uint32_t rows,
                    const std::vector<ExchangeBlock>& blocks);

/// All of a scene's operator; `visibility` as directLight found it. The exchange is as a file will hold it.
LightOperator lightOperator(const Room& room, SiteVisibility visibility, ExchangeGroups groups,
                            const std::vector<ExchangeBlock>& blocks, SurfaceExchange surfaces);

}  // namespace fiatlux
