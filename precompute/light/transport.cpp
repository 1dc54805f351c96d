#include "precompute/light/transport.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/transport/low_rank_radiosity.h"
#include "core/transport/surface_statistics.h"
#include "precompute/base/error.h"
#include "precompute/base/parallel.h"
#include "precompute/light/cast_light.h"
#include "precompute/light/interreflection.h"
#include "precompute/light/paper_transport.h"

namespace fiatlux {

namespace {

void addStatistics(const Room& room, const TransportOptions& options, Transport& result) {
  beginStage(options.progress, "statistics");
  result.lost = lostShares(room.patches, room.surfaces.size(), result.factors);
  const std::size_t surfaces = room.surfaces.size();
  result.illuminance.resize(surfaces);
  result.exitance.resize(surfaces);
  parallelFor(2 * surfaces, options.threads, [&](std::size_t i) {
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

Transport paperTransportOf(const Room& room, const RayTracer& tracer, CastLight&& cast,
                           const TransportOptions& options) {
  Transport result;
  result.factors = std::move(cast.factors);
  beginStage(options.progress, "low-rank radiosity");
  const LowRankRadiosity lowRank = orThrow(LowRankRadiosity::factorize(result.factors, room.patches));
  result.responses.rows = room.patches.rows();
  result.responses.sites = static_cast<std::uint32_t>(room.sites.size());
  result.responses.illuminance.resize(std::size_t{result.responses.rows} * result.responses.sites);
  const auto progress = beginStage(options.progress, "paper's responses");
  result.paper =
      paperTransport(room, tracer, result.factors, lowRank, options.threads, result.responses, progress);
  addStatistics(room, options, result);
  return result;
}

Transport transportOf(const Room& room, const RayTracer& tracer, CastLight&& cast,
                      const TransportOptions& options) {
  SolvedLight light;
  {
    beginStage(options.progress, "low-rank radiosity");
    const Interreflection solver(room, tracer, cast, options);
    light = solver.unsolved();
    const auto solve = [&](std::uint32_t first, std::uint32_t end, const char* stage) {
      parallelFor(
          end - first, options.threads,
          [&](std::size_t i) {
            const auto block = first + static_cast<std::uint32_t>(i);
            solver.put(block, solver.solve(block), light);
          },
          beginStage(options.progress, stage));
    };
    solve(0, solver.siteBlocks(), "interreflection");
    if (options.exchange) solve(solver.siteBlocks(), solver.blocks(), "exchange");
  }
  return completeTransport(room, std::move(cast), std::move(light), options);
}

constexpr const char* kNoMemory = "not enough memory for the light; pass a larger --patch";

}  // namespace

Transport completeTransport(const Room& room, CastLight&& cast, SolvedLight&& light,
                            const TransportOptions& options) {
  Transport result;
  result.factors = std::move(cast.factors);
  result.direct = std::move(cast.direct);
  result.responses = std::move(light.responses);
  for (const std::vector<double>& squares : light.squares)
    result.residuals.resize(std::max(result.residuals.size(), squares.size()), 0.0);
  for (const std::vector<double>& squares : light.squares)
    for (std::size_t step = 0; step < result.residuals.size() && !squares.empty(); ++step)
      result.residuals[step] += squares[std::min(step, squares.size() - 1)];
  for (double& residual : result.residuals)
    residual = std::sqrt(residual / std::max(1u, result.responses.sites));
  if (options.exchange)
    result.lightOperator = lightOperator(room, std::move(cast.visibility), std::move(light.groups),
                                         light.exchange, surfaceExchangeOf(room, light.surfaces));
  addStatistics(room, options, result);
  return result;
}

CastOptions castOptionsOf(const TransportOptions& options) {
  return {options.rays, options.paper, options.seed, options.threads, {}, options.draft};
}

DirectLightOptions directOptionsOf(const TransportOptions& options) {
  DirectLightOptions direct;
  direct.draft = options.draft;
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
    CastLight cast = castLight(room, tracer, options);
    return options.paper ? paperTransportOf(room, tracer, std::move(cast), options)
                         : transportOf(room, tracer, std::move(cast), options);
  };
  return atDoor(compute, kNoMemory);
}

}  // namespace fiatlux
