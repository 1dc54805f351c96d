// Layouts that are called back towards the one that was shown before.
#include "core/search/steady.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/search/evaluator.h"
#include "core/search/identity.h"
#include "core/search/layout_search.h"
#include "tests/core/corridor_scene.h"

namespace fiatlux {
namespace {

using fiatlux::testing::longCorridor;

/// Even light of at least so much.
Intentions evenAbove(double lux) {
  Intentions intentions;
  intentions.luminaires.count = 8;
  intentions.luminaires.flux = {2000};
  intentions.goals = {{Statistic::kSigma, Sense::kMinimize, 1, {}, {}}};
  intentions.constraints = {{Statistic::kMean, lux, kUnbounded, 1, {}, {}}};
  return intentions;
}

Layout searched(PreparedScene& prepared, const Intentions& intentions, const Layout* start = nullptr) {
  LayoutSearch search(prepared, intentions, 1, start);
  search.advance(60000);
  return search.incumbent();
}

TEST(Steady, WhoeverGainsHardlyAnythingComesHome) {
  PreparedScene prepared(longCorridor());
  const Intentions intentions = evenAbove(1);
  const Layout home = searched(prepared, intentions);
  Layout away = home;
  for (const std::uint32_t i : {0u, 3u, 5u}) {
    const std::uint32_t* near = prepared.nearSites(home.sites[i]);
    while (std::find(away.sites.begin(), away.sites.end(), *near) != away.sites.end()) ++near;
    away.sites[i] = *near;
  }
  EXPECT_EQ(steadied(prepared, intentions, away, home).layout.sites, home.sites);
  Intentions pinned = intentions;
  pinned.luminaires.pinned = {away.sites[0]};
  EXPECT_EQ(steadied(prepared, pinned, away, home).layout.sites[0], away.sites[0]);
  Intentions tied = intentions;
  tied.luminaires.arrangement.rule = Rule::kRows;
  EXPECT_EQ(steadied(prepared, tied, away, home).layout.sites, away.sites);
}

TEST(Steady, AnotherBoundCostsNoMoreThanItsShareAndIsMet) {
  PreparedScene prepared(longCorridor());
  const Layout before = searched(prepared, evenAbove(1));
  Evaluator evaluator(prepared, evenAbove(1));
  evaluator.load(before.sites);
  const double lux = 1.01 * evaluator.moments()[0].mean;
  const Intentions intentions = evenAbove(lux);
  const LuminaireRules& rules = intentions.luminaires;
  const Layout best = numberedAs(longCorridor(), rules, searched(prepared, intentions, &before), before);
  const Evaluation found = Evaluator(prepared, intentions).evaluate(best.sites);
  const Steadied calm = steadied(prepared, intentions, best, before);
  EXPECT_LE(calm.evaluation.violation, found.violation);
  EXPECT_LE(calm.evaluation.goal, found.goal + kSteadyShare * std::fabs(found.goal));
  const auto walked = [&](const Layout& to) {
    double sum = 0;
    for (std::size_t i = 0; i < to.sites.size(); ++i) sum += prepared.distance(to.sites[i], before.sites[i]);
    return sum;
  };
  EXPECT_LE(walked(calm.layout), walked(best));
  const Evaluation told = Evaluator(prepared, intentions).evaluate(calm.layout.sites);
  EXPECT_EQ(told.goal, calm.evaluation.goal);
}

}  // namespace
}  // namespace fiatlux
