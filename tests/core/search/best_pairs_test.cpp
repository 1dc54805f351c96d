// When all pairs of the best sites are looked through, and that they find what single moves do not. That they
// keep to the rules: neighborhood_test, types_search_test.
#include "core/search/best_pairs.h"

#include <gtest/gtest.h>

#include "core/search/start_layout.h"
#include "tests/core/corridor_scene.h"

namespace fiatlux {
namespace {

using fiatlux::testing::longCorridor;

constexpr std::uint32_t kCount = 5;
constexpr std::uint64_t kLongWalk = 1u << 20;  // trials

/// An even wall of 30 lx.
Intentions evenWall() {
  Intentions intentions;
  intentions.luminaires.count = kCount;
  const Goal aim{Statistic::kMean, Sense::kNear, 10, {2}, {}, 30};
  intentions.goals = {aim, {Statistic::kSigma, Sense::kMinimize, 1, {2}, {}}};
  return intentions;
}

/// A search for an even wall that stands somewhere.
class BestPairs : public ::testing::Test {
 protected:
  BestPairs()
      : prepared_(longCorridor()),
        evaluator_(prepared_, intentions_),
        freeSites_(prepared_, intentions_.luminaires, kCount) {}

  void stand(const std::vector<std::uint32_t>& sites) {
    evaluator_.load(sites);
    freeSites_.load(sites);
  }

  std::vector<std::uint32_t> anywhere() { return randomSites(prepared_, intentions_.luminaires, random_); }

  Surroundings after(std::uint64_t walked) { return {evaluator_, freeSites_, random_, walked, 0}; }

  Trial bestMove() {
    Trial best{{}, 0, evaluator_.current()};
    std::vector<std::uint32_t> free;
    for (std::uint32_t i = 0; i < kCount; ++i) {
      freeSites_.farMoves(evaluator_.sites()[i], free);
      evaluator_.tryMoves(i, free.data(), static_cast<std::uint32_t>(free.size()), best);
    }
    return best;
  }

  const Intentions intentions_ = evenWall();
  PreparedScene prepared_;
  Evaluator evaluator_;
  FreeSites freeSites_;
  Random random_{4};
};

TEST_F(BestPairs, AreLookedThroughOnlyBesideALongWalk) {
  stand(anywhere());
  const auto trialsAfter = [&](std::uint64_t walked) {
    Scan scan;
    openBestPairs(after(walked), scan);
    return scan.size;
  };
  EXPECT_EQ(trialsAfter(0), 0u) << "no walk";
  const std::uint32_t size = trialsAfter(kLongWalk);
  EXPECT_GT(size, 0u);
  EXPECT_EQ(trialsAfter(4 * size), size);
  EXPECT_EQ(trialsAfter(4 * size - 1), 0u) << "it would take more than a quarter of the walk";
}

TEST_F(BestPairs, FindWhatNoSingleMoveDoes) {
  std::uint32_t found = 0;
  for (int round = 0; round < 30; ++round) {
    std::vector<std::uint32_t> sites = anywhere();
    stand(sites);
    for (Trial best = bestMove(); best.count > 0; best = bestMove()) {
      sites[best.moves[0].luminaire] = best.moves[0].site;
      stand(sites);
    }
    Scan scan;
    scan.found = {{}, 0, evaluator_.current()};
    openBestPairs(after(kLongWalk), scan);
    tryBestPairs(after(kLongWalk), scan, scan.size);
    if (scan.found.count == 0) continue;
    ++found;
    EXPECT_EQ(scan.found.count, 2u);
    EXPECT_TRUE(isBetter(scan.found.evaluation, evaluator_.current()));
    evaluator_.apply(scan.found);
    EXPECT_NEAR(evaluator_.current().goal, scan.found.evaluation.goal, 1e-9);
  }
  EXPECT_GT(found, 0u);
}

}  // namespace
}  // namespace fiatlux
