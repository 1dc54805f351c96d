// Types in one search: never worse than any of them alone, their counts kept, their watts summed. Covers
// candidate_list, core/search/type_counts and what the search does with Scene::hangings.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "core/bound/layout_bound.h"
#include "core/candidates/candidate_list.h"
#include "core/search/best_pairs.h"
#include "core/search/identity.h"
#include "core/search/layout_search.h"
#include "core/search/shown.h"
#include "core/search/start_layout.h"
#include "core/search/type_counts.h"
#include "core/search/validate_intentions.h"
#include "tests/core/operator_scene.h"
#include "tests/core/photometry/photometric_files.h"

namespace fiatlux {
namespace {

CandidateType typeOf(double exponent, double flux, double watts) {
  samples::IesFile file;
  file.candela = samples::cosinePower(1000, exponent);
  file.width = file.length = 0.1;
  Result<Photometry> photometry = samples::read(file.text());
  return {sampledType(std::make_shared<const Photometry>(std::move(*photometry))), flux, watts};
}

/// Sites hang over a floor and a wall; type 0 is a flood of 900 lm and 9 W, type 1 a spot of 400 lm and 3 W.
const Scene& room() {
  static const Scene scene = operatorScene(12, 6);
  return scene;
}

Scene sceneOf(const std::vector<TypeWays>& ways) {
  const std::vector<CandidateType> types = {typeOf(1, 900, 9), typeOf(20, 400, 3)};
  std::vector<Candidate> candidates = candidatesOf(room(), types, ways);
  Result<CandidateScene> making = CandidateScene::begin(room(), types, std::move(candidates));
  while (!making->advance(100)) continue;
  return making->finish(Quantity::kIlluminance);
}

const Scene& mixed() {
  static const Scene scene = sceneOf({{}, {}});
  return scene;
}

Intentions evenFloor(std::uint32_t count) {
  Intentions intentions;
  intentions.luminaires.count = count;
  intentions.luminaires.flux = {1};
  intentions.luminaires.minDistance = kCandidatesApart;
  intentions.goals = {{Statistic::kMean, Sense::kNear, 1, {0}, {}, 40}};
  return intentions;
}

std::vector<std::uint32_t> countsIn(const Scene& scene, const Layout& layout) {
  std::vector<std::uint32_t> counts(2, 0);
  for (const std::uint32_t site : layout.sites) ++counts[scene.hangings[site].type];
  return counts;
}

/// The best of all layouts whose luminaires are of the types that `may` names.
Evaluation bestOfAll(const Scene& scene, const Intentions& intentions, const std::vector<bool>& may) {
  PreparedScene prepared(scene);
  Evaluator evaluator(prepared, intentions);
  Evaluation best{kUnbounded, kUnbounded, 1};
  std::vector<std::uint32_t> sites;
  const std::function<void(std::uint32_t)> choose = [&](std::uint32_t from) {
    if (sites.size() == intentions.luminaires.count) {
      evaluator.tryLayout(sites, best);
      return;
    }
    for (std::uint32_t c = from; c < scene.sites.size(); ++c) {
      const bool isTaken = !sites.empty() && scene.hangings[sites.back()].place == scene.hangings[c].place;
      if (isTaken || !may[scene.hangings[c].type]) continue;
      sites.push_back(c);
      choose(c + 1);
      sites.pop_back();
    }
  };
  choose(0);
  return best;
}

TEST(TypesInOneSearch, AreNeverWorseThanTheBetterOneAlone) {
  for (const std::uint32_t count : {1u, 2u, 3u}) {
    const Intentions intentions = evenFloor(count);
    ASSERT_TRUE(checkIntentions(mixed(), intentions));
    PreparedScene prepared(mixed());
    LayoutSearch search(prepared, intentions, 1);
    search.advance(20000);
    const Evaluation all = bestOfAll(mixed(), intentions, {true, true});
    EXPECT_NEAR(search.evaluation().goal, all.goal, 1e-9) << count;
    for (const std::vector<bool>& alone : {std::vector<bool>{true, false}, {false, true}})
      EXPECT_FALSE(isBetter(bestOfAll(mixed(), intentions, alone), all)) << count;
    EXPECT_TRUE(checkLayout(mixed(), search.incumbent()));
  }
}

TEST(TypesInOneSearch, TiesOfEachTypeAreSearchedAlone) {
  PreparedScene prepared(mixed());
  LuminaireRules rules = evenFloor(2).luminaires;
  const Ties all = tiesUnder(prepared.grid(), rules).front();
  const std::vector<Ties> each = tiesOfEachType(mixed(), all, rules);
  ASSERT_EQ(each.size(), 2u);
  EXPECT_EQ(each[0].members.size() + each[1].members.size(), all.members.size());
  for (std::uint32_t type = 0; type < 2; ++type)
    for (const std::vector<std::uint32_t>& members : each[type].members)
      EXPECT_EQ(mixed().hangings[members.front()].type, type);
  EXPECT_FALSE(each[0].key == all.key);
  rules.types = {{1, 6}, {0, 6}};  // there is a flood in every layout
  EXPECT_EQ(tiesOfEachType(mixed(), all, rules).size(), 1u);
}

/// Each of two moves may keep the counts of the types, and both together not.
TEST(TypesInOneSearch, PairsOfTheBestSitesKeepTheirCounts) {
  PreparedScene prepared(mixed());
  Intentions intentions = evenFloor(4);
  intentions.luminaires.types = {{1, 3}, {1, 3}};
  Evaluator evaluator(prepared, intentions);
  FreeSites freeSites(prepared, intentions.luminaires, 4);
  std::uint32_t found = 0, changed = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    const std::vector<std::uint32_t> sites = randomSites(prepared, intentions.luminaires, random);
    evaluator.load(sites);
    freeSites.load(sites);
    const Surroundings here{evaluator, freeSites, random, 1u << 20, 0};
    ASSERT_TRUE(here.maySurvey()) << "of several ways at a place, too";
    Scan scan;
    scan.found = {{}, 0, evaluator.current()};
    openBestPairs(here, scan);
    tryBestPairs(here, scan, scan.size);
    if (scan.found.count == 0) continue;
    ++found;
    std::vector<std::uint32_t> after = sites;
    for (const Move& move : scan.found.moves) after[move.luminaire] = move.site;
    const std::vector<std::uint32_t> counts = countsIn(mixed(), {after, {}, 1});
    changed += counts != countsIn(mixed(), {sites, {}, 1});
    EXPECT_GE(std::min(counts[0], counts[1]), 1u);
  }
  EXPECT_GT(found, 50u);
  EXPECT_GT(changed, 10u);
}

/// What a search finds by so many evaluations.
Evaluation found(const Scene& scene, const Intentions& intentions, std::uint32_t evaluations) {
  PreparedScene prepared(scene);
  LayoutSearch search(prepared, intentions, 1);
  search.advance(evaluations);
  return search.evaluation();
}

/// Each type searched alone as well, what a bound parts from most mixed layouts is found soon.
TEST(TypesInOneSearch, ABoundThatPartsThemKeepsNobodyFromTheBetterOne) {
  const Scene room = operatorScene(12, 12);
  const std::vector<CandidateType> types = {typeOf(1, 900, 9), typeOf(20, 400, 3.9)};
  Result<CandidateScene> making = CandidateScene::begin(room, types, candidatesOf(room, types, {{}, {}}));
  while (!making->advance(100)) continue;
  const Scene scene = making->finish(Quantity::kIlluminance);
  Intentions intentions = evenFloor(1);
  intentions.luminaires.countHigh = 10;
  intentions.goals = {{Statistic::kPower, Sense::kMinimize, 1, {}, {}}};
  for (const auto& [floor, wall] : {std::pair(140.0, 22.5), {180.0, 22.5}, {280.0, 33.75}}) {
    intentions.constraints = {{Statistic::kMean, floor, kUnbounded, 1, {0}, {}},
                              {Statistic::kMean, -kUnbounded, wall, 1, {1}, {}}};
    EXPECT_FALSE(isBetter(found(scene, intentions, 40000), found(scene, intentions, 1000))) << floor;
  }
}

/// Of a range of counts of the types; the search's best at every step.
void expectKept(std::uint32_t count, std::uint32_t high, TypeRange first, TypeRange second) {
  Intentions intentions = evenFloor(count);
  intentions.luminaires.countHigh = high;
  intentions.luminaires.types = {first, second};
  const Result<Done> checked = checkIntentions(mixed(), intentions);
  ASSERT_TRUE(checked) << checked.error().message;
  PreparedScene prepared(mixed());
  LayoutSearch search(prepared, intentions, 3);
  for (int slice = 0; slice < 20; ++slice) {
    search.advance(300);
    const std::vector<std::uint32_t> counts = countsIn(mixed(), search.incumbent());
    EXPECT_GE(counts[0], first.least);
    EXPECT_LE(counts[0], first.most);
    EXPECT_GE(counts[1], second.least);
    EXPECT_LE(counts[1], second.most);
  }
}

TEST(TypesInOneSearch, KeepTheirCounts) {
  expectKept(3, 0, {0, 1}, {0, 6});
  expectKept(3, 0, {2, 2}, {0, 6});
  expectKept(4, 0, {1, 3}, {2, 2});
  expectKept(2, 5, {1, 2}, {0, 3});
}

TEST(TypesInOneSearch, TradePlacesWhereTheirCountsAreFixed) {
  Intentions intentions = evenFloor(3);
  intentions.luminaires.types = {{1, 1}, {2, 2}};
  PreparedScene prepared(mixed());
  LayoutSearch search(prepared, intentions, 5);
  search.advance(20000);
  // All with one flood and two spots.
  Evaluator evaluator(prepared, intentions);
  Evaluation best{kUnbounded, kUnbounded, 1};
  for (std::uint32_t a = 0; a < mixed().sites.size(); ++a)
    for (std::uint32_t b = 0; b < mixed().sites.size(); ++b)
      for (std::uint32_t c = 0; c < b; ++c) {
        const auto& h = mixed().hangings;
        const bool isApart = h[a].place != h[b].place && h[a].place != h[c].place && h[b].place != h[c].place;
        if (isApart && h[a].type == 0 && h[b].type == 1 && h[c].type == 1)
          evaluator.tryLayout({a, b, c}, best);
      }
  EXPECT_NEAR(search.evaluation().goal, best.goal, 1e-9);
}

TEST(TypesInOneSearch, ALuminaireIsOfTheTypeThatItMustBe) {
  Intentions intentions = evenFloor(3);
  intentions.luminaires.ofType = {kNone, 1, 0};
  ASSERT_TRUE(checkIntentions(mixed(), intentions));
  PreparedScene prepared(mixed());
  for (std::uint64_t seed = 1; seed < 6; ++seed) {
    LayoutSearch search(prepared, intentions, seed);
    search.advance(500);
    const Layout layout = search.incumbent();
    EXPECT_EQ(mixed().hangings[layout.sites[1]].type, 1u);
    EXPECT_EQ(mixed().hangings[layout.sites[2]].type, 0u);
    const Layout before{{layout.sites[2], layout.sites[1], layout.sites[0]}, layout.flux, 1};
    const Layout numbered = numberedAs(mixed(), intentions.luminaires, layout, before);
    EXPECT_EQ(mixed().hangings[numbered.sites[1]].type, 1u);
    EXPECT_EQ(mixed().hangings[numbered.sites[2]].type, 0u);
  }
}

/// Of the best field, of each type.
std::vector<std::uint32_t> countsInField(const Intentions& intentions) {
  PreparedScene prepared(mixed());
  LayoutSearch search(prepared, intentions, 1);
  search.advance(10000);
  return countsIn(mixed(), search.incumbent());
}

TEST(TypesInOneSearch, AFieldIsOfATypeThatMayHangSoOftenAndAlone) {
  using Counts = std::vector<std::uint32_t>;
  Intentions intentions = evenFloor(3);
  LuminaireRules& rules = intentions.luminaires;
  rules.arrangement = {Rule::kField};
  const auto ask = [&](const std::vector<TypeRange>& types) {
    rules.types = types;
    return checkIntentions(mixed(), intentions);
  };
  for (const std::uint32_t type : {0u, 1u}) {
    Counts alone(2, 0);
    alone[type] = 3;
    std::vector<TypeRange> types(2, {0, 6});
    types[type].least = 1;
    ASSERT_TRUE(ask(types));
    EXPECT_EQ(countsInField(intentions), alone);
    types[type].least = 0;
    types[1 - type].most = 2;
    ASSERT_TRUE(ask(types));
    EXPECT_EQ(countsInField(intentions), alone);
  }
  const Result<Done> both = ask({{1, 6}, {1, 6}});
  ASSERT_FALSE(both);
  EXPECT_NE(both.error().message.find("no regular field of 3"), std::string::npos);
  EXPECT_FALSE(ask({{0, 2}, {0, 2}}));
  rules.ofType = {0, kNone, 1};
  EXPECT_FALSE(ask({{0, 6}, {0, 6}}));
  rules.ofType.clear();
  rules.count = 2;
  rules.countHigh = 4;
  ASSERT_TRUE(ask({{0, 2}, {0, 2}}));
  const Counts few = countsInField(intentions);
  EXPECT_EQ(few[0] + few[1], 2u);
}

TEST(TypesInOneSearch, PowerIsTheSumOfTheirWatts) {
  Intentions intentions = evenFloor(2);
  intentions.luminaires.dimmingLow = 0.5;
  intentions.constraints = {{Statistic::kPower, -kUnbounded, 8, 1, {}, {}}};
  PreparedScene prepared(mixed());
  const auto candidate = [&](std::uint32_t place, std::uint32_t type) {
    std::uint32_t c = 0;
    while (mixed().hangings[c].place != place || mixed().hangings[c].type != type) ++c;
    return c;
  };
  const Shown shown = shownOf(prepared, intentions, {{candidate(1, 0), candidate(4, 1)}, {1, 1}, 0.5});
  EXPECT_NEAR(shown.constraints[0].value, 0.5 * (9 + 3), 1e-9);

  // The least power of two: both spots, and the proved bound agrees.
  intentions.luminaires.dimmingLow = 1;
  intentions.goals = {{Statistic::kPower, Sense::kMinimize, 1, {}, {}}};
  intentions.constraints.clear();
  LayoutSearch search(prepared, intentions, 1);
  search.advance(2000);
  EXPECT_EQ(countsIn(mixed(), search.incumbent()), (std::vector<std::uint32_t>{0, 2}));
  LayoutBound bound(prepared, intentions, search);
  while (!bound.done()) bound.advance(1000);
  EXPECT_LE(bound.goal(), search.evaluation().goal + 1e-9);
  EXPECT_GT(bound.goal(), 0);
}

std::string refusal(const std::function<void(LuminaireRules&)>& ask) {
  Intentions intentions = evenFloor(3);
  intentions.luminaires.types = {{0, 6, "flood"}, {0, 6, "spot"}};
  ask(intentions.luminaires);
  const Result<Done> checked = checkIntentions(mixed(), intentions);
  return checked ? std::string() : checked.error().message;
}

TEST(TypesInOneSearch, WhatCannotBeIsSaidInOneLine) {
  const auto says = [](const std::string& part, const std::function<void(LuminaireRules&)>& ask) {
    EXPECT_NE(refusal(ask).find(part), std::string::npos) << refusal(ask);
  };
  EXPECT_EQ(refusal([](LuminaireRules&) {}), "");
  says("the types ask for 4 together, but the count is 3",
       [](auto& r) { r.types[0].least = r.types[1].least = 2; });
  says("the types allow 2 together, but the count is 3",
       [](auto& r) { r.types[0].most = r.types[1].most = 1; });
  says("\"spot\": a count from 4 to 2", [](auto& r) { r.types[1] = {4, 2, "spot"}; });
  says("2 of them must be of \"flood\", of which there may be 1", [](auto& r) {
    r.types[0].most = 1;
    r.ofType = {0, 0};
  });
  says("L2 must be of type 3, which fits nowhere", [](auto& r) { r.ofType = {kNone, 2}; });
  says("L1 must be of \"spot\", but is pinned as one of \"flood\"", [](auto& r) {
    r.pinned = {0};
    r.ofType = {1};
  });
  says("found no 3 places", [](auto& r) {
    r.types[0].least = 3;
    for (std::uint32_t c = 0; c < mixed().sites.size(); ++c)
      if (mixed().hangings[c].type == 0 && mixed().hangings[c].place > 1) r.excluded.push_back(c);
  });
  says("say the flux", [](auto& r) { r.flux = {1, 1, 1}; });
}

TEST(CandidateList, HasEveryWayThatFits) {
  const std::vector<CandidateType> types = {typeOf(1, 900, 9), typeOf(20, 400, 3)};
  const std::vector<Candidate> candidates =
      candidatesOf(room(), types, {{{0, 90}, {}}, {{0}, {{1, 0, 1}, {2, 0, 1}}}});
  ASSERT_EQ(candidates.size(), 6u * 4);
  EXPECT_EQ(candidates[1].turn, 90);
  EXPECT_EQ(candidates[3].aim->x, 2);
  for (std::size_t c = 0; c < candidates.size(); ++c) EXPECT_EQ(candidates[c].way, c % 4);
  // Sites lie half a metre apart on a ceiling; a spot is aimed 1 m below the second one.
  const Vec3 below = room().sites[1].position + room().sites[1].normal;
  const auto within = [&](double angle) {
    return candidatesOf(room(), {types[1]}, {{{0}, {below}, angle}}).size();
  };
  EXPECT_EQ(within(0), 1u);
  EXPECT_EQ(within(27), 3u);  // its neighbours: 26.6 degrees
  EXPECT_EQ(within(180), 6u);
  CandidateType wide = typeOf(1, 900, 9);
  wide.photometric.luminous.length = wide.photometric.luminous.width = 1;
  EXPECT_TRUE(candidatesOf(room(), {wide}, {{}}).empty());  // sites are 0.5 m wide, in one row
}

}  // namespace
}  // namespace fiatlux
