// The bound under arrangements and ranges of counts is never above what a search finds, and says something.
#include "core/bound/layout_bound.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/corridor_scene.h"

namespace fiatlux {
namespace {

using fiatlux::testing::smallRoom;

Intentions ask(std::uint32_t least, std::uint32_t most, Arrangement arrangement) {
  Intentions intentions;
  intentions.luminaires.count = least;
  intentions.luminaires.countHigh = most;
  intentions.luminaires.arrangement = arrangement;
  intentions.goals = {{Statistic::kSigma, Sense::kMinimize, 1, {}, {}}};
  return intentions;
}

TEST(LayoutBound, HoldsForTiesAndRanges) {
  PreparedScene prepared(smallRoom());
  Intentions power = ask(2, 5, {});
  power.goals = {{Statistic::kPower, Sense::kMinimize, 1, {}, {}}};
  power.constraints = {{Statistic::kMean, 60, kUnbounded, 1, {0}, {}}};
  Intentions pinned = ask(5, 0, {Rule::kSymmetric, PlanAxis::kZ});
  pinned.luminaires.pinned = {6};
  for (const Intentions& intentions :
       {ask(4, 0, {Rule::kSymmetric, PlanAxis::kFound}), ask(5, 0, {Rule::kSymmetric, PlanAxis::kZ}), pinned,
        ask(6, 0, {Rule::kRows, PlanAxis::kX}), ask(2, 4, {}), power}) {
    LayoutSearch search(prepared, intentions, 1);
    search.advance(20000);
    ASSERT_LT(search.evaluation().violation, 1e-9);
    LayoutBound bound(prepared, intentions, search);
    for (int slice = 0; slice < 100000 && !bound.done(); ++slice) bound.advance(777);
    ASSERT_TRUE(bound.done() && bound.supported());
    const double best = search.evaluation().goal;
    EXPECT_LE(bound.goal(), best + 1e-6 * std::fabs(best));
    EXPECT_GT(bound.goal(), 0);
    EXPECT_TRUE(bound.within(search.evaluation()));
  }
}

TEST(LayoutBound, OfAFieldIsItsBest) {
  PreparedScene prepared(smallRoom());
  const Intentions intentions = ask(6, 0, {Rule::kField, PlanAxis::kFound});
  LayoutSearch search(prepared, intentions, 1);
  search.advance(100000);
  LayoutBound bound(prepared, intentions, search);
  EXPECT_TRUE(bound.done());
  EXPECT_EQ(bound.within(search.evaluation()), 0);
}

}  // namespace
}  // namespace fiatlux
