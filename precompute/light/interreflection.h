// What light does after it was cast, column by column: the sites' responses, and the exchange between groups
// and of surfaces.
// Columns are solved in blocks, in any order, on any thread or machine that has all cast light. Throws, as
// everything below a door does, where the system is singular.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/scene/scene.h"
#include "precompute/light/cast_light.h"
#include "precompute/light/exchange.h"
#include "precompute/light/surface_exchange.h"

namespace fiatlux {

/// One block: of sites, of groups, or of surfaces; the others' members are empty.
struct SolvedBlock {
  std::vector<float> illuminance;  // column-major rows x used, lx per lm
  std::vector<double> squares;     // steps + 1: of the residuals, summed over its sites
  ExchangeBlock exchange;
  std::vector<float> surfaces;  // SurfaceExchangeRows::solve
};

/// All blocks.
struct SolvedLight {
  Responses responses;
  std::vector<std::vector<double>> squares;  // of each block of sites
  ExchangeGroups groups;
  std::vector<ExchangeBlock> exchange;       // of each block of groups
  std::vector<std::vector<float>> surfaces;  // of each block of surfaces
};

/// Room, tracer and cast light must outlive it and stay where they are.
class Interreflection {
 public:
  /// Groups only where the options want the exchange.
  Interreflection(const Room& room, const RayTracer& tracer, const CastLight& cast,
                  const TransportOptions& options);
  Interreflection(const Interreflection&) = delete;
  Interreflection& operator=(const Interreflection&) = delete;
  std::uint32_t siteBlocks() const;
  /// Those of the sites, then those of the groups, then those of the surfaces.
  std::uint32_t blocks() const;
  SolvedBlock solve(std::uint32_t block) const;

  /// Room for all blocks.
  SolvedLight unsolved() const;
  /// Whether `solved` can be that block.
  bool isOf(std::uint32_t block, const SolvedBlock& solved) const;
  /// Each block once; different blocks from any thread.
  void put(std::uint32_t block, SolvedBlock&& solved, SolvedLight& light) const;

 private:
  std::uint32_t usedSites(std::uint32_t block) const;
  std::uint32_t firstOfSurfaces() const;

  const Room& room_;
  const CastLight& cast_;
  std::uint32_t refine_;
  LowRankRadiosity lowRank_;
  ExchangeGroups groups_;
  // nullptr where the exchange is not wanted
  std::unique_ptr<ExchangeColumns> exchange_;
  std::unique_ptr<SurfaceExchangeRows> surfaces_;
};

/// What all of it amounts to: the rest of computeTransport, not in paper mode.
Transport completeTransport(const Room& room, CastLight&& cast, SolvedLight&& light,
                            const TransportOptions& options);

}  // namespace fiatlux
