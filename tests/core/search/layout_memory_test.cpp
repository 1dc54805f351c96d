// What is remembered, and what two layouts give together: sites of theirs only, under the rules, on either
// side of a line as one of them has it.
#include "core/search/layout_memory.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/search/start_layout.h"
#include "tests/core/corridor_scene.h"

namespace fiatlux {
namespace {

using fiatlux::testing::longCorridor;

Evaluation worth(double goal) { return {0, goal, 1}; }

TEST(LayoutMemory, KeepsTheBestAndNoneTwice) {
  PreparedScene prepared(longCorridor());
  LayoutMemory memory(prepared, {1000, 1000});
  EXPECT_TRUE(memory.offer({1, 2}, worth(5), 2));
  EXPECT_FALSE(memory.offer({2, 1}, worth(5), 2)) << "the same light";
  EXPECT_FALSE(memory.hasParents());
  EXPECT_TRUE(memory.offer({3, 4}, worth(4), 2));
  EXPECT_FALSE(memory.offer({5, 6}, worth(6), 2)) << "worse than both";
  EXPECT_TRUE(memory.offer({5, 6}, worth(3), 2));
  EXPECT_TRUE(memory.offer({1, 2}, worth(2), 2)) << "it had to go before";
  LayoutMemory ofFluxes(prepared, {1000, 2000});
  EXPECT_TRUE(ofFluxes.offer({1, 2}, worth(5), 2));
  EXPECT_TRUE(ofFluxes.offer({2, 1}, worth(4), 2)) << "not the same light";
}

TEST(LayoutMemory, KnowsHowFarTheNearestIs) {
  PreparedScene prepared(longCorridor());
  LayoutMemory memory(prepared, {1000, 1000, 1000});
  EXPECT_EQ(memory.distanceTo({1, 2, 3}), 3u) << "nothing is kept";
  memory.offer({1, 2, 3}, worth(5), 2);
  memory.offer({4, 5, 6}, worth(5), 2);
  EXPECT_EQ(memory.distanceTo({3, 1, 2}), 0u) << "the same light";
  EXPECT_EQ(memory.distanceTo({6, 7, 4}), 1u);
  EXPECT_EQ(memory.distanceTo({1, 4, 7}), 2u) << "of two layouts one each";
  EXPECT_EQ(memory.distanceTo({7, 8, 9}), 3u);
  LayoutMemory ofFluxes(prepared, {1000, 2000, 1000});
  ofFluxes.offer({1, 2, 3}, worth(5), 2);
  EXPECT_EQ(ofFluxes.distanceTo({3, 2, 1}), 0u) << "the same light";
  EXPECT_EQ(ofFluxes.distanceTo({2, 1, 3}), 2u) << "not the same light";
}

TEST(LayoutMemory, ChildrenKeepTheRulesAndHaveTheirParentsSites) {
  PreparedScene prepared(longCorridor());
  LuminaireRules rules;
  rules.flux = {500, 900, 900, 1300, 1700, 2100};
  rules.pinned = {kNone, kNone, 40};
  rules.excluded = {0, 1, 2, 100, 101, 200};
  rules.minDistance = 1.6;
  Random random(5);
  LayoutMemory memory(prepared, rules.flux);
  const std::vector<std::uint32_t> one = randomSites(prepared, rules, random),
                                   two = randomSites(prepared, rules, random);
  memory.offer(one, worth(1), 2);
  memory.offer(two, worth(2), 2);
  FreeSites freeSites(prepared, rules, rules.count);
  const auto has = [](const std::vector<std::uint32_t>& sites, std::uint32_t site) {
    return std::count(sites.begin(), sites.end(), site) > 0;
  };
  int mixed = 0;
  for (int n = 0; n < 50; ++n) {
    std::vector<std::uint32_t> child;
    memory.cross(freeSites, random, child);
    ASSERT_EQ(child.size(), 6u);
    EXPECT_EQ(child[2], 40u) << "pinned";
    int ofOne = 0, ofTwo = 0;
    for (std::uint32_t i = 0; i < 6; ++i) {
      EXPECT_TRUE(has(one, child[i]) || has(two, child[i]));
      ofOne += !has(two, child[i]);
      ofTwo += !has(one, child[i]);
      for (std::uint32_t j = 0; j < i; ++j)
        EXPECT_GE(prepared.distance(child[i], child[j]), rules.minDistance);
    }
    mixed += ofOne > 0 && ofTwo > 0;
  }
  EXPECT_GT(mixed, 25);
}

TEST(LayoutMemory, OnEitherSideOfALineAChildIsAsOneParent) {
  PreparedScene prepared(longCorridor());
  LuminaireRules rules;
  rules.count = 4;
  // Two at either end of the corridor, near each other.
  std::vector<std::uint32_t> order(prepared.candidateCount());
  for (std::uint32_t site = 0; site < order.size(); ++site) order[site] = site;
  const auto z = [&](std::uint32_t site) { return prepared.scene().sites[site].position.z; };
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return z(a) < z(b); });
  const std::size_t last = order.size() - 1;
  LayoutMemory memory(prepared, std::vector<double>(4, 1000));
  memory.offer({order[0], order[1], order[last], order[last - 1]}, worth(1), 2);
  memory.offer({order[2], order[3], order[last - 2], order[last - 3]}, worth(2), 2);
  FreeSites freeSites(prepared, rules, rules.count);
  Random random(1);
  int halves = 0;
  for (int n = 0; n < 60; ++n) {
    std::vector<std::uint32_t> child;
    memory.cross(freeSites, random, child);
    std::sort(child.begin(), child.end());
    for (const bool first : {true, false}) {
      const std::size_t low = first ? 0 : 2, high = first ? 2 : 0;
      std::vector<std::uint32_t> half{order[low], order[low + 1], order[last - high], order[last - high - 1]};
      std::sort(half.begin(), half.end());
      halves += child == half;
    }
  }
  EXPECT_GT(halves, 10) << "one parent's end with the other's";
}

TEST(FreeSites, GatherAllAroundASite) {
  PreparedScene prepared(longCorridor());
  LuminaireRules rules;
  rules.excluded = {prepared.nearSites(100)[0]};
  Random random(4);
  std::vector<std::uint32_t> sites = randomSites(prepared, rules, random);
  FreeSites freeSites(prepared, rules, rules.count);
  freeSites.load(sites);
  for (const std::uint32_t center : {100u, 20u, 100u}) {
    freeSites.gatherAll(sites, center);
    std::vector<std::uint32_t> wanted{center}, got = sites;
    for (const std::uint32_t* near = prepared.nearSites(center); wanted.size() < sites.size(); ++near)
      if (*near != rules.excluded[0]) wanted.push_back(*near);
    std::sort(got.begin(), got.end());
    std::sort(wanted.begin(), wanted.end());
    EXPECT_EQ(got, wanted);
  }
}

}  // namespace
}  // namespace fiatlux
