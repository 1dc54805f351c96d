// The exchange of light between groups (core/scene/light_operator.h): one more radiosity solution a group,
// which sheds 1 lm evenly.
#pragma once

#include <functional>

#include "core/scene/light_operator.h"
#include "core/transport/form_factors.h"
#include "core/transport/low_rank_radiosity.h"
#include "precompute/rays/ray_tracer.h"
#include "precompute/room/room.h"

namespace fiatlux {

struct ExchangeOptions {
  std::uint32_t refine = 0;  // refinement steps: the low-rank answer, gathered once, is near enough
  unsigned threads = 0;      // 0: all cores; the result does not depend on it
  std::function<void(double)> progress;
};

/// H, the mean of both directions, as cast form factors are reciprocal to a few per cent only; and of the
/// rest what exceeds half the step in which a file counts it (kExchangeRestStep).
Exchange exchangeBetween(const Room& room, const FormFactors& factors, const LowRankRadiosity& lowRank,
                         const ExchangeGroups& groups, const ExchangeOptions& options);

/// All of a scene's operator; `visibility` as directLight found it. The exchange is as a file will hold it.
LightOperator lightOperator(const Room& room, const RayTracer& tracer, const FormFactors& factors,
                            const LowRankRadiosity& lowRank, SiteVisibility visibility,
                            const ExchangeOptions& options);

}  // namespace fiatlux
