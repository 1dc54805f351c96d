// Bounds on a variance against every way to hang luminaires of different fluxes.
#include "core/bound/relaxed_intentions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/random.h"

namespace fiatlux {
namespace {

/// The largest x^T C x over all placements of the fluxes on usable sites.
double bruteForceVariance(const std::vector<double>& c, const LuminaireRules& rules, std::uint32_t m) {
  std::vector<std::uint32_t> order(m);
  std::iota(order.begin(), order.end(), 0u);
  double best = 0;
  do {
    double sum = 0;
    bool allowed = true;
    for (std::uint32_t a = 0; a < rules.count; ++a) {
      allowed = allowed && (!isPinned(rules, a) || order[a] == rules.pinned[a]);
      allowed = allowed && std::count(rules.excluded.begin(), rules.excluded.end(), order[a]) == 0;
      for (std::uint32_t b = 0; b < rules.count; ++b)
        sum += rules.flux[a] * rules.flux[b] * c[order[a] * m + order[b]];
    }
    if (allowed) best = std::max(best, sum);
  } while (std::next_permutation(order.begin(), order.end()));
  return best * rules.dimmingHigh * rules.dimmingHigh;
}

TEST(RelaxedIntentions, LargestVarianceHoldsWhereSitesWorkAgainstEachOther) {
  // Two bright luminaires on the sites that hardly disturb each other, the dim one on the third: 1.8.
  const std::vector<double> c = {1, -0.1, -0.45, -0.1, 1, -0.45, -0.45, -0.45, 1};
  LuminaireRules rules;
  rules.count = 3;
  rules.flux = {1, 1, 1e-6};
  EXPECT_NEAR(bruteForceVariance(c, rules, 3), 1.8, 1e-5);
  EXPECT_GE(largestVariance(c, rules, 3), bruteForceVariance(c, rules, 3));
}

TEST(RelaxedIntentions, LargestVarianceIsExactWhereAllIsPinned) {
  const std::vector<double> c = {1, -0.1, -0.45, -0.1, 1, -0.45, -0.45, -0.45, 1};
  LuminaireRules rules;
  rules.count = 2;
  rules.flux = {2, 3};
  rules.pinned = {0, 2};
  EXPECT_NEAR(largestVariance(c, rules, 3), 4 + 9 - 2 * 0.45 * 6, 1e-12);
}

TEST(RelaxedIntentions, LargestVarianceIsNeverBelowBruteForce) {
  Random random(3);
  constexpr std::uint32_t m = 6;
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<double> l(m * m), c(m * m);
    for (double& v : l) v = 2 * random.unit() - 1;
    for (std::uint32_t i = 0; i < m; ++i)
      for (std::uint32_t j = 0; j < m; ++j)
        for (std::uint32_t k = 0; k < m; ++k) c[i * m + j] += l[i * m + k] * l[j * m + k];
    LuminaireRules rules;
    rules.count = 2 + random.below(3);
    rules.flux.clear();
    for (std::uint32_t i = 0; i < rules.count; ++i) rules.flux.push_back(0.05 + random.unit());
    if (random.below(2)) rules.excluded = {random.below(m)};
    if (const std::uint32_t site = random.below(m); rules.excluded != std::vector<std::uint32_t>{site})
      rules.pinned =
          random.below(2) ? std::vector<std::uint32_t>{site} : std::vector<std::uint32_t>{kNone, site};
    rules.dimmingHigh = 0.5;
    const double truth = bruteForceVariance(c, rules, m);
    EXPECT_GE(largestVariance(c, rules, m), truth * (1 - 1e-12)) << "trial " << trial;
  }
}

}  // namespace
}  // namespace fiatlux
