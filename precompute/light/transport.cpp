#include "precompute/light/transport.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/transport/low_rank_radiosity.h"
#include "core/transport/site_responses.h"
#include "core/transport/surface_statistics.h"
#include "precompute/base/error.h"
#include "precompute/base/parallel.h"
#include "precompute/light/cast_light.h"
#include "precompute/light/exchange.h"
#include "precompute/light/paper_transport.h"

namespace fiatlux {

namespace {

/// Squares of a block's residuals, so that all blocks can be summed in one order.
struct BlockResidual {
  std::vector<double> squares;  // refine + 1
};

/// Solves columns [first, first + kBlockWidth) of the sites and writes them into the responses.
BlockResidual solveColumns(const Room& room, const LowRankRadiosity& lowRank, const TransportOptions& options,
                           std::uint32_t first, Transport& result) {
  const std::uint32_t rows = room.patches.rows(), sites = result.responses.sites;
  const std::uint32_t used = std::min(kBlockWidth, sites - first);
  ResponseBlock block;
  block.width = used > 8 ? 16 : 8;
  block.direct.assign(std::size_t{rows} * block.width, 0.0f);
  for (std::uint32_t j = 0; j < used; ++j) {
    const float* column = result.direct.data() + std::size_t{first + j} * rows;
    for (std::uint32_t p = 0; p < rows; ++p) block.direct[std::size_t{p} * block.width + j] = column[p];
  }
  solveResponses(result.factors, room.patches, lowRank, options.refine, 0, block);
  for (std::uint32_t j = 0; j < used; ++j) {
    float* column = result.responses.illuminance.data() + std::size_t{first + j} * rows;
    // note: refinement may leave a rounding error below zero where it is dark; light is never negative.
    for (std::uint32_t p = 0; p < rows; ++p)
      column[p] = std::max(0.0f, block.irradiance[std::size_t{p} * block.width + j]);
  }
  BlockResidual residual;
  for (std::size_t step = 0; step * block.width < block.residuals.size(); ++step) {
    double sum = 0;
    for (std::uint32_t j = 0; j < used; ++j) sum += std::pow(block.residuals[step * block.width + j], 2);
    residual.squares.push_back(sum);
  }
  return residual;
}

void solveSites(const Room& room, const LowRankRadiosity& lowRank, const TransportOptions& options,
                Transport& result, const std::function<void(double)>& progress) {
  const std::uint32_t sites = result.responses.sites;
  std::vector<BlockResidual> residuals((sites + kBlockWidth - 1) / kBlockWidth);
  const auto solve = [&](std::size_t block) {
    residuals[block] =
        solveColumns(room, lowRank, options, static_cast<std::uint32_t>(block) * kBlockWidth, result);
  };
  parallelFor(residuals.size(), options.threads, solve, progress);
  result.residuals.assign(options.refine + 1, 0.0);
  for (const BlockResidual& block : residuals) {
    for (std::size_t step = 0; step < block.squares.size(); ++step)
      result.residuals[step] += block.squares[step];
  }
  for (double& residual : result.residuals) residual = std::sqrt(residual / std::max(1u, sites));
}

void collectStatistics(const Room& room, unsigned threads, Transport& result) {
  const std::size_t surfaces = room.surfaces.size();
  result.illuminance.resize(surfaces);
  result.exitance.resize(surfaces);
  parallelFor(2 * surfaces, threads, [&](std::size_t i) {
    const auto surface = static_cast<std::uint32_t>(i / 2);
    if (i % 2 == 0) {
      result.illuminance[surface] =
          responseStatistics(room.patches, result.responses, Quantity::kIlluminance, surface);
    } else {
      result.exitance[surface] =
          responseStatistics(room.patches, result.responses, Quantity::kExitance, surface);
    }
  });
}

CastLight castLight(const Room& room, const RayTracer& tracer, const TransportOptions& options) {
  CastLight cast;
  CastOptions rays = castOptionsOf(options);
  rays.progress = beginStage(options.progress, "form factors");
  cast.factors = castFormFactors(room, tracer, rays);
  if (options.paper) return cast;
  DirectLightOptions direct = directOptionsOf(options);
  direct.progress = beginStage(options.progress, "direct light");
  cast.direct =
      directLight(room, tracer, siteLuminaires(room), direct, options.exchange ? &cast.visibility : nullptr);
  return cast;
}

Transport transportOf(const Room& room, const RayTracer& tracer, CastLight&& cast,
                      const TransportOptions& options) {
  Transport result;
  result.factors = std::move(cast.factors);
  result.direct = std::move(cast.direct);
  result.lost = lostShares(room.patches, room.surfaces.size(), result.factors);

  beginStage(options.progress, "low-rank radiosity");
  const LowRankRadiosity lowRank = orThrow(LowRankRadiosity::factorize(result.factors, room.patches));

  result.responses.rows = room.patches.rows();
  result.responses.sites = static_cast<std::uint32_t>(room.sites.size());
  result.responses.illuminance.resize(std::size_t{result.responses.rows} * result.responses.sites);
  if (options.paper) {
    const auto progress = beginStage(options.progress, "paper's responses");
    result.paper =
        paperTransport(room, tracer, result.factors, lowRank, options.threads, result.responses, progress);
  } else {
    solveSites(room, lowRank, options, result, beginStage(options.progress, "interreflection"));
    if (options.exchange)
      result.lightOperator = lightOperator(room, tracer, result.factors, lowRank, std::move(cast.visibility),
                                           {0, options.threads, beginStage(options.progress, "exchange")});
  }
  beginStage(options.progress, "statistics");
  collectStatistics(room, options.threads, result);
  return result;
}

constexpr const char* kNoMemory = "not enough memory for the light; pass a larger --patch";

}  // namespace

CastOptions castOptionsOf(const TransportOptions& options) {
  return {options.rays, options.paper, options.seed, options.threads, {}};
}

DirectLightOptions directOptionsOf(const TransportOptions& options) {
  DirectLightOptions direct;
  direct.seed = options.seed;
  direct.threads = options.threads;
  return direct;
}

std::vector<Luminaire> siteLuminaires(const Room& room) {
  std::vector<Luminaire> luminaires;
  for (const Site& site : room.sites) luminaires.push_back(luminaireOf(site));
  return luminaires;
}

Result<Transport> computeTransport(const Room& room, const RayTracer& tracer,
                                   const TransportOptions& options) {
  const auto compute = [&] {
    if (room.patches.count == 0) throw CommandError("the room has no surfaces");
    if (options.rays == 0) throw CommandError("--rays must be at least 1");
    return transportOf(room, tracer, castLight(room, tracer, options), options);
  };
  return atDoor(compute, kNoMemory);
}

Result<Transport> completeTransport(const Room& room, const RayTracer& tracer, CastLight&& cast,
                                    const TransportOptions& options) {
  assert(!options.paper && cast.factors.rows == room.patches.rows());
  assert(cast.direct.size() == std::size_t{room.patches.rows()} * room.sites.size());
  return atDoor([&] { return transportOf(room, tracer, std::move(cast), options); }, kNoMemory);
}

}  // namespace fiatlux
