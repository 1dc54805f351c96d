// The walk that shakes: it ends, keeps to the rules, takes worse layouts while it is hot and hardly any at
// its end, and learns how much a broken bound has to cost.
#include "core/search/annealed_walk.h"

#include <gtest/gtest.h>

#include "core/search/start_layout.h"
#include "tests/core/corridor_scene.h"

namespace fiatlux {
namespace {

using fiatlux::testing::longCorridor;

struct Walked {
  std::uint32_t steps = 0, takenFirst = 0, takenLast = 0, worse = 0, met = 0;  // first, last: of tenths
  std::uint64_t trials = 0;
  Evaluation last;
  Prices prices;  // at the end
};

/// A whole walk from a random layout; `each` sees every layout on the way.
template <class Each>
Walked walked(PreparedScene& prepared, const Intentions& asked, std::uint64_t length, Each each) {
  Random random(3);
  const std::vector<std::uint32_t> sites = randomSites(prepared, asked.luminaires, random);
  Evaluator evaluator(prepared, asked);
  FreeSites freeSites(prepared, asked.luminaires, asked.luminaires.count);
  evaluator.load(sites);
  freeSites.load(sites);
  AnnealedWalk walk(asked.luminaires.flux.size() > 1, !asked.constraints.empty(),
                    evaluator.objective().leadingAimShare());
  walk.begin(length, 1, evaluator.current().goal);
  const Surroundings here{evaluator, freeSites, random};
  Walked result;
  Scan scan;
  while (!walk.isDone()) {
    const Evaluation before = evaluator.current();
    walk.open(here, scan);
    while (scan.position < scan.size) result.trials += walk.trySome(here, scan, 3);
    if (scan.found.count > 0) {
      for (std::uint32_t k = 0; k < scan.found.count; ++k)
        freeSites.relocate(evaluator.sites()[scan.found.moves[k].luminaire], scan.found.moves[k].site);
      evaluator.apply(scan.found);
      result.takenFirst += result.trials < length / 10;
      result.takenLast += result.trials > length - length / 10;
      result.worse += isBetter(before, evaluator.current());
    }
    walk.close(scan, evaluator.current());
    ++result.steps;
    result.met += evaluator.current().violation == 0;
    each(evaluator.sites());
  }
  result.last = evaluator.current();
  result.prices = walk.prices();
  return result;
}

TEST(AnnealedWalk, CoolsDownAndKeepsToTheRules) {
  PreparedScene prepared(longCorridor());
  Intentions asked;
  asked.luminaires.flux = {500, 900, 900, 1300, 1700, 2100};
  asked.luminaires.pinned = {kNone, kNone, 40};
  asked.luminaires.minDistance = 1.6;
  asked.goals = {{Statistic::kSigma, Sense::kMinimize, 1, {}, {}}};
  const Walked walk = walked(prepared, asked, 20000, [&](const std::vector<std::uint32_t>& sites) {
    EXPECT_EQ(sites[2], 40u);
    for (std::size_t i = 0; i < sites.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) ASSERT_GE(prepared.distance(sites[i], sites[j]), 1.6);
  });
  EXPECT_GE(walk.trials, 19000u);
  EXPECT_LE(walk.trials, 20004u);
  EXPECT_GT(walk.worse, 100u);
  EXPECT_GT(walk.takenFirst, 4 * walk.takenLast);
}

TEST(AnnealedWalk, KeepsToTheEdgeOfBounds) {
  PreparedScene prepared(longCorridor());
  Intentions asked;
  asked.goals = {{Statistic::kMean, Sense::kMaximize, 1, {2}, {}}};
  asked.constraints = {{Statistic::kMean, 4, 5, 1, {2}, {}}};  // met by few, and against the goal
  const Walked walk = walked(prepared, asked, 20000, [](const std::vector<std::uint32_t>&) {});
  EXPECT_GT(walk.met, walk.steps / 4);
  EXPECT_LT(walk.met, walk.steps);
  EXPECT_LT(walk.last.violation, 0.01);
}

TEST(AnnealedWalk, EndsAtThePriceThatLeadsToAims) {
  PreparedScene prepared(longCorridor());
  const auto shareAfter = [&](double weight) {
    Intentions asked;
    asked.goals = {{Statistic::kSigma, Sense::kMinimize, 1, {}, {}, 0},
                   {Statistic::kMean, Sense::kNear, weight, {2}, {}, 5}};
    return walked(prepared, asked, 20000, [](const std::vector<std::uint32_t>&) {}).prices.aimShare;
  };
  EXPECT_DOUBLE_EQ(shareAfter(10), 0.3);  // three times as much as sigma
  EXPECT_DOUBLE_EQ(shareAfter(2), 1);     // no more than that anyway
}

}  // namespace
}  // namespace fiatlux
