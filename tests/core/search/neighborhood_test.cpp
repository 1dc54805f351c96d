// Every row of the table: its scans end, keep to the rules, find the same whatever the slices, and never
// something worse. And free_sites against a look at every pair.
#include "core/search/neighborhood.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "core/search/start_layout.h"
#include "tests/core/corridor_scene.h"

namespace fiatlux {
namespace {

using fiatlux::testing::longCorridor;

Intentions strictRules() {
  Intentions intentions;
  LuminaireRules& rules = intentions.luminaires;
  rules.count = 6;
  rules.flux = {500, 900, 900, 1300, 1700, 2100};
  rules.pinned = {kNone, kNone, 40};
  rules.excluded = {0, 1, 2, 100, 101, 200};
  rules.minDistance = 1.6;
  intentions.goals = {{Statistic::kSigma, Sense::kMinimize, 1, {2}, {}}};
  return intentions;
}

bool isAllowed(const PreparedScene& prepared, const LuminaireRules& rules,
               const std::vector<std::uint32_t>& sites) {
  for (std::uint32_t i = 0; i < sites.size(); ++i) {
    if (isPinned(rules, i) && sites[i] != rules.pinned[i]) return false;
    if (std::count(rules.excluded.begin(), rules.excluded.end(), sites[i]) > 0) return false;
    for (std::uint32_t j = 0; j < i; ++j)
      if (sites[i] == sites[j] || prepared.distance(sites[i], sites[j]) < rules.minDistance) return false;
  }
  return true;
}

constexpr std::uint64_t kLongWalk = 1u << 20;  // trials: every row is worth while after it

/// One scan of a row from where the evaluator stands, in slices; what it found.
Trial scanned(const Neighborhood& row, Evaluator& evaluator, const FreeSites& freeSites,
              std::uint32_t luminaire, std::uint32_t slice) {
  Random random(luminaire);
  const Surroundings here{evaluator, freeSites, random, kLongWalk, 0};
  Scan scan;
  scan.luminaire = luminaire;
  scan.found = {{}, 0, evaluator.current()};
  row.open(here, scan);
  for (int calls = 0; scan.position < scan.size; ++calls) {
    const std::uint32_t before = scan.position, tried = row.trySome(here, scan, slice);
    EXPECT_LE(tried, slice);
    EXPECT_GT(scan.position, before) << "a scan that does not go on never ends";
    if (scan.position <= before || ::testing::Test::HasFailure()) break;
  }
  return scan.found;
}

TEST(Neighborhoods, HaveNamesAndTurns) {
  PreparedScene prepared(longCorridor());
  const Intentions intentions = strictRules();
  Evaluator evaluator(prepared, intentions);
  const FreeSites freeSites(prepared, intentions.luminaires, 6);
  Random random(1);
  std::set<std::string> names;
  ASSERT_FALSE(neighborhoods().empty());
  EXPECT_TRUE(neighborhoods()[0].afterShakes) << "a search begins with the first row";
  for (const Neighborhood& row : neighborhoods()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_GE(row.turn({evaluator, freeSites, random}), 1u) << row.name;
  }
}

TEST(Neighborhoods, KeepToTheRulesAndFindTheSameInAnySlices) {
  PreparedScene prepared(longCorridor());
  const Intentions intentions = strictRules();
  Evaluator evaluator(prepared, intentions), reference(prepared, intentions);
  FreeSites freeSites(prepared, intentions.luminaires, 6);
  Random random(8);
  for (const Neighborhood& row : neighborhoods()) {
    std::uint32_t found = 0;
    for (int layout = 0; layout < 12; ++layout) {
      const auto sites = randomSites(prepared, intentions.luminaires, random);
      ASSERT_TRUE(isAllowed(prepared, intentions.luminaires, sites));
      evaluator.load(sites);
      freeSites.load(sites);
      for (const std::uint32_t luminaire : freeSites.movable()) {
        SCOPED_TRACE(std::string(row.name) + " of luminaire " + std::to_string(luminaire));
        const Trial whole = scanned(row, evaluator, freeSites, luminaire, 1u << 20);
        const Trial sliced = scanned(row, evaluator, freeSites, luminaire, 3);
        EXPECT_EQ(whole.count, sliced.count);
        if (whole.count == 0) continue;
        ++found;
        EXPECT_EQ(whole.evaluation.goal, sliced.evaluation.goal);
        EXPECT_TRUE(isBetter(whole.evaluation, evaluator.current()));
        std::vector<std::uint32_t> after = sites;
        for (std::uint32_t k = 0; k < whole.count; ++k) after[whole.moves[k].luminaire] = whole.moves[k].site;
        EXPECT_TRUE(isAllowed(prepared, intentions.luminaires, after));
        EXPECT_NEAR(reference.evaluate(after).goal, whole.evaluation.goal, 1e-9);
      }
    }
    EXPECT_GT(found, 0u) << row.name << " found nothing anywhere";
  }
}

TEST(FreeSites, AreThoseThatEveryPairAllows) {
  PreparedScene prepared(longCorridor());
  const LuminaireRules rules = strictRules().luminaires;
  FreeSites freeSites(prepared, rules, rules.count);
  Random random(2);
  std::vector<std::uint32_t> sites = randomSites(prepared, rules, random);
  freeSites.load(sites);
  EXPECT_EQ(freeSites.movable(), (std::vector<std::uint32_t>{0, 1, 3, 4, 5}));
  for (int step = 0; step < 20; ++step) {
    const std::uint32_t i = freeSites.randomMovable(random);
    for (std::uint32_t to = 0; to < prepared.candidateCount(); ++to) {
      if (to == sites[i]) continue;
      std::vector<std::uint32_t> after = sites;
      after[i] = to;
      EXPECT_EQ(freeSites.mayMove(sites[i], to), isAllowed(prepared, rules, after)) << to;
    }
    if (step % 2 == 0) {
      std::vector<std::uint32_t> drawn;
      freeSites.drawMoves(sites[i], 16, 30, random, drawn);
      ASSERT_FALSE(drawn.empty());
      for (const std::uint32_t to : drawn) {
        EXPECT_NE(to, sites[i]);
        EXPECT_TRUE(freeSites.mayMove(sites[i], to)) << to;
      }
      freeSites.relocate(sites[i], drawn[0]);
      sites[i] = drawn[0];
    } else {
      freeSites.gather(sites, 2, random);
    }
    EXPECT_TRUE(isAllowed(prepared, rules, sites));
  }
}

}  // namespace
}  // namespace fiatlux
