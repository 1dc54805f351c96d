// A luminaire is moved by hand, and only those beside it follow.
#include "core/search/near_search.h"

#include <gtest/gtest.h>

#include "core/search/evaluator.h"
#include "tests/core/corridor_scene.h"

namespace fiatlux {
namespace {

using fiatlux::testing::longCorridor;

Intentions evenLight() {
  Intentions intentions;
  intentions.luminaires.count = 8;
  intentions.goals = {{Statistic::kSigma, Sense::kMinimize, 1, {}, {}}};
  return intentions;
}

TEST(NearSearch, FourFollowAtMostAndTheyMakeUpForIt) {
  PreparedScene prepared(longCorridor());
  Intentions intentions = evenLight();
  LayoutSearch search(prepared, intentions, 1);
  search.advance(20000);
  Layout start = search.incumbent();
  const std::uint32_t* near = prepared.nearSites(start.sites[2]) + 8;  // far enough to be felt
  while (std::find(start.sites.begin(), start.sites.end(), *near) != start.sites.end()) ++near;
  start.sites[2] = *near;
  intentions.luminaires.pinned = {kNone, kNone, start.sites[2]};
  const auto found = searchNear(prepared, intentions, 1, start, {2});
  ASSERT_TRUE(found);
  found->advance(20000);
  const Layout after = found->incumbent();
  EXPECT_EQ(after.sites[2], start.sites[2]);
  std::uint32_t followers = 0;
  for (std::uint32_t i = 0; i < start.sites.size(); ++i) followers += after.sites[i] != start.sites[i];
  EXPECT_LE(followers, kMostFollowers);
  EXPECT_GT(followers, 0u);

  LayoutSearch free(prepared, intentions, 1, &start);
  free.advance(20000);
  EXPECT_LE(found->evaluation().goal, 1.01 * free.evaluation().goal);
  EXPECT_LT(found->evaluation().goal, Evaluator(prepared, intentions).evaluate(start.sites).goal);
}

TEST(NearSearch, WhereNobodyMayFollowThereIsNone) {
  PreparedScene prepared(longCorridor());
  Intentions intentions = evenLight();
  const Layout start{{10, 30, 50, 70, 90, 110, 130, 150}, std::vector<double>(8, 1000), 1};
  intentions.luminaires.pinned = start.sites;
  EXPECT_FALSE(searchNear(prepared, intentions, 1, start, {2}));
  intentions.luminaires.pinned.clear();
  intentions.luminaires.count = 9;
  EXPECT_FALSE(searchNear(prepared, intentions, 1, start, {2}));
  intentions.luminaires.count = 8;
  intentions.luminaires.arrangement.rule = Rule::kRows;
  EXPECT_FALSE(searchNear(prepared, intentions, 1, start, {2}));
}

}  // namespace
}  // namespace fiatlux
