// Optimal assignment against all permutations, and layouts whose luminaires keep their numbers.
#include "core/search/identity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "core/base/random.h"
#include "tests/core/corridor_scene.h"

namespace fiatlux {
namespace {

using fiatlux::testing::longCorridor;

TEST(Identity, TheAssignmentIsTheBestOfAllPermutations) {
  Random random(5);
  for (int trial = 0; trial < 60; ++trial) {
    const std::uint32_t columns = 1 + random.below(6), rows = 1 + random.below(columns);
    std::vector<double> cost(std::size_t{rows} * columns);
    for (double& entry : cost) entry = 10 * random.unit() - 4;
    const auto costOf = [&](const std::vector<std::uint32_t>& order) {
      double sum = 0;
      for (std::uint32_t i = 0; i < rows; ++i) sum += cost[std::size_t{i} * columns + order[i]];
      return sum;
    };
    std::vector<std::uint32_t> order(columns);
    std::iota(order.begin(), order.end(), 0u);
    double best = kUnbounded;
    do best = std::min(best, costOf(order));
    while (std::next_permutation(order.begin(), order.end()));
    const std::vector<std::uint32_t> found = leastCostColumns(cost, rows, columns);
    std::vector<std::uint32_t> sorted = found;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(std::adjacent_find(sorted.begin(), sorted.end()), sorted.end()) << "each has its own";
    EXPECT_NEAR(costOf(found), best, 1e-9) << trial;
  }
}

TEST(Identity, LuminairesKeepTheirNumbersAndWalkTheShortestWay) {
  const LuminaireRules rules;
  const Layout before{{10, 60, 120}, {1000, 1000, 1000}, 1};
  const Layout after{{121, 11, 61, 200}, {1000, 1000, 1000, 1000}, 0.5, {0, 0, 1, 1}};
  const Layout numbered = numberedAs(longCorridor(), rules, after, before);
  EXPECT_EQ(numbered.sites, (std::vector<std::uint32_t>{11, 61, 121, 200}));
  EXPECT_EQ(numbered.ties, (std::vector<std::uint32_t>{0, 1, 0, 1}));
  EXPECT_EQ(numbered.dimming, 0.5);
  const Layout fewer = numberedAs(longCorridor(), rules, {{121, 11}, {1000, 1000}, 1}, before);
  EXPECT_EQ(fewer.sites, (std::vector<std::uint32_t>{11, 121}));
}

TEST(Identity, APinnedLuminaireStaysWhoItIs) {
  LuminaireRules rules;
  rules.pinned = {kNone, 12};
  const Layout before{{10, 100}, {1000, 1000}, 1};  // the second was thrown to 12, the first pushed on
  EXPECT_EQ(numberedAs(longCorridor(), rules, {{12, 100}, {1000, 1000}, 1}, before).sites,
            (std::vector<std::uint32_t>{100, 12}));
  rules.flux = {500, 900};
  EXPECT_EQ(numberedAs(longCorridor(), rules, {{100, 12}, {500, 900}, 1}, before).sites,
            (std::vector<std::uint32_t>{100, 12}));
}

}  // namespace
}  // namespace fiatlux
