// Ties and fields (site_grid, arrangements) against counts from a formula, and searches over them
// (layout_search, field_scan) against the best of all sets of sites that obey the rule.
#include "core/search/arrangements.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <tuple>

#include "core/search/layout_search.h"
#include "core/search/validate_intentions.h"
#include "tests/core/corridor_scene.h"

namespace fiatlux {
namespace {

using fiatlux::testing::longCorridor;
using fiatlux::testing::smallRoom;

constexpr int kWidth = 5, kDepth = 4;  // of the small room, sites

using Sites = std::vector<std::uint32_t>;

/// Only sites: 20 x 13, as over an open office.
Scene ceiling(int columns = 20, int rows = 13) {
  Scene scene;
  for (int z = 0; z < rows; ++z)
    for (int x = 0; x < columns; ++x)
      scene.sites.push_back({{0.3 + 0.6 * x, 3, 0.3 + 0.6 * z}, {0, -1, 0}, {1, 0, 0}, 0.6});
  return scene;
}

std::size_t fieldsOf(const SiteGrid& grid, std::uint32_t least, std::uint32_t most) {
  std::size_t count = 0;
  Sites sites;
  const Fields fields(grid, least, most);
  fields.visit([&](const Field& field) {
    count += fields.sitesOf(field, sites);
    return true;
  });
  return count;
}

TEST(Arrangements, CountsEveryField) {
  const Scene scene = ceiling();
  const SiteGrid grid(scene);
  EXPECT_EQ(fieldsOf(grid, 6, 6), 14470u);
  EXPECT_EQ(fieldsOf(grid, 12, 12), 8619u);
  EXPECT_EQ(fieldsOf(grid, 2, 24), 90102u);
}

TEST(Arrangements, FieldsInTheMiddleAreTheirOwnMirrorImages) {
  const Scene scene = ceiling();
  const SiteGrid grid(scene);
  for (const PlanAxis axis : {PlanAxis::kX, PlanAxis::kZ, PlanAxis::kBoth}) {
    const bool alongX = axis != PlanAxis::kX, alongZ = axis != PlanAxis::kZ;
    std::size_t middle = 0, counted = 0;
    Sites sites;
    const auto isInMiddle = [&](double Vec3::*direction, double whole) {
      return std::fabs(scene.sites[sites.front()].position.*direction +
                       scene.sites[sites.back()].position.*direction - whole) < 1e-6;
    };
    const auto count = [&](const Fields& fields, bool all) {
      fields.visit([&](const Field& field) {
        if (!fields.sitesOf(field, sites)) return true;
        const bool is = (!alongX || isInMiddle(&Vec3::x, 12)) && (!alongZ || isInMiddle(&Vec3::z, 7.8));
        (all ? counted : middle) += is;
        EXPECT_TRUE(all || is);
        return true;
      });
    };
    count(Fields(grid, 2, 24), true);
    count(Fields(grid, 2, 24, axis), false);
    EXPECT_EQ(middle, counted);
    EXPECT_GT(middle, 0u);
  }
}

/// Of 1 to 30 luminaires: those for whose number there is a field mirrored so.
std::vector<std::uint32_t> numbersWithRoom(const Scene& scene, PlanAxis axis) {
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t count = 1; count <= 30; ++count) {
    LuminaireRules rules;
    rules.count = count;
    rules.arrangement = {Rule::kField, axis};
    if (checkRules(scene, rules)) numbers.push_back(count);
  }
  return numbers;
}

TEST(Arrangements, AnOddNumberOfColumnsHasNoMiddleAmongAnEvenNumberOfPlaces) {
  using ::testing::Contains, ::testing::Each, ::testing::Not, ::testing::Truly;
  const std::vector<std::uint32_t> both = numbersWithRoom(ceiling(), PlanAxis::kBoth);
  EXPECT_EQ(both.size(), 15u);
  EXPECT_THAT(both, Each(Truly([](std::uint32_t count) { return count % 2 == 0; })));
  EXPECT_THAT(numbersWithRoom(ceiling(), PlanAxis::kX), Contains(9));  // its three rows may lie in the middle
  EXPECT_THAT(numbersWithRoom(ceiling(), PlanAxis::kZ), Not(Contains(9)));
  EXPECT_THAT(numbersWithRoom(ceiling(13, 20), PlanAxis::kZ), Contains(9));
  EXPECT_THAT(numbersWithRoom(ceiling(13, 13), PlanAxis::kBoth), Contains(9));
  EXPECT_THAT(numbersWithRoom(ceiling(3, 3), PlanAxis::kX), Not(Contains(12)));
}

TEST(Arrangements, AFieldInTheMiddleKeepsPlacesFreeAndTheLeastDistance) {
  LuminaireRules rules;
  rules.count = 6;
  rules.arrangement = {Rule::kField, PlanAxis::kBoth};
  rules.minDistance = 0.6;
  EXPECT_TRUE(checkRules(ceiling(2, 3), rules));
  rules.minDistance = 0.61;
  EXPECT_FALSE(checkRules(ceiling(2, 3), rules));
  rules.minDistance = 0;
  rules.excluded = {0};
  EXPECT_FALSE(checkRules(ceiling(2, 3), rules));
  rules.excluded = {109, 110, 129, 130, 149, 150};  // those in the very middle; there is room around them
  EXPECT_TRUE(checkRules(ceiling(), rules));
}

TEST(Arrangements, MirrorsKeepAllSitesOfARectangleAndDropThoseWithoutAnImage) {
  Scene scene = ceiling();
  LuminaireRules rules;
  rules.arrangement = {Rule::kSymmetric, PlanAxis::kX};
  EXPECT_EQ(tiesUnder(SiteGrid(scene), rules)[0].members.size(), 20u * 6 + 20);
  rules.arrangement.axis = PlanAxis::kBoth;
  EXPECT_EQ(tiesUnder(SiteGrid(scene), rules)[0].members.size(), 10u * 6 + 10);
  scene.sites.erase(scene.sites.begin() + 25);  // its image in the eleventh line is left alone
  rules.arrangement.axis = PlanAxis::kX;
  const Ties ties = tiesUnder(SiteGrid(scene), rules)[0];
  EXPECT_EQ(ties.members.size(), 20u * 6 + 20 - 1);
}

/// On each site luminaires of two types, the second one turned in two ways: candidates site by site.
Scene threeWays(const Scene& sites) {
  Scene scene;
  for (std::uint32_t place = 0; place < sites.sites.size(); ++place)
    for (std::uint32_t way = 0; way < 3; ++way) {
      scene.sites.push_back(sites.sites[place]);
      scene.hangings.push_back({place, way == 0 ? 0u : 1u, way, 1});
    }
  return scene;
}

TEST(Arrangements, TiesAreOfLuminairesThatHangAlike) {
  const Scene scene = threeWays(ceiling());
  const SiteGrid grid(scene);
  LuminaireRules rules;
  rules.count = 6;
  rules.arrangement = {Rule::kSymmetric, PlanAxis::kX};
  const std::vector<Ties> symmetric = tiesUnder(grid, rules);
  ASSERT_EQ(symmetric.size(), 1u);
  EXPECT_EQ(symmetric[0].members.size(), 3 * (20u * 6 + 20));
  rules.arrangement = {Rule::kRows, PlanAxis::kX};
  std::size_t rows = 0;
  for (const Ties& ties : tiesUnder(grid, rules)) {
    rows += ties.key.perTie == 6 ? ties.members.size() : 0;
    for (const auto& tie : ties.members)
      for (const std::uint32_t site : tie)
        EXPECT_EQ(scene.hangings[site].way, scene.hangings[tie.front()].way);
  }
  EXPECT_EQ(rows, 3u * 13 * (15 + 10 + 5));  // pitches of one, two and three sites
  EXPECT_EQ(fieldsOf(grid, 6, 6), 3 * 14470u);
}

// --- Against all sets of sites

bool isEven(const std::vector<int>& sorted) {
  for (std::size_t i = 2; i < sorted.size(); ++i)
    if (sorted[i] - sorted[i - 1] != sorted[1] - sorted[0]) return false;
  return true;
}

bool isField(const Sites& sites) {
  std::vector<int> xs, zs;
  for (const std::uint32_t s : sites) {
    xs.push_back(static_cast<int>(s) % kWidth);
    zs.push_back(static_cast<int>(s) / kWidth);
  }
  for (std::vector<int>* values : {&xs, &zs}) {
    std::sort(values->begin(), values->end());
    values->erase(std::unique(values->begin(), values->end()), values->end());
  }
  return xs.size() * zs.size() == sites.size() && isEven(xs) && isEven(zs);
}

/// Rows of `count` sites, `step` apart: whatever comes first in a line begins one, at least that far behind
/// the end of the one before.
bool isRows(Sites sites, std::uint32_t count, std::uint32_t step, bool alongX) {
  const auto lineOf = [&](std::uint32_t s) { return alongX ? s / kWidth : s % kWidth; };
  const std::uint32_t jump = alongX ? step : step * kWidth;
  std::vector<std::uint32_t> begins(kWidth + kDepth, 0);  // of each line, the first site of a next row
  while (!sites.empty()) {
    const std::uint32_t first = sites.front();
    if (first < begins[lineOf(first)]) return false;
    begins[lineOf(first)] = first + count * jump;
    for (std::uint32_t k = 0; k < count; ++k) {
      const auto at = std::find(sites.begin(), sites.end(), first + k * jump);
      if (at == sites.end() || lineOf(*at) != lineOf(first)) return false;
      sites.erase(at);
    }
  }
  return true;
}

bool isRows(const Sites& sites, std::uint32_t least) {
  for (std::uint32_t count = least; count <= sites.size(); ++count)
    for (std::uint32_t step = 1; step < kWidth; ++step)
      if (sites.size() % count == 0 &&
          (isRows(sites, count, step, true) || isRows(sites, count, step, false)))
        return true;
  return false;
}

bool isMirrored(const Sites& sites, bool alongX) {
  return std::all_of(sites.begin(), sites.end(), [&](std::uint32_t s) {
    const std::uint32_t x = s % kWidth, z = s / kWidth;
    const std::uint32_t image = alongX ? (kDepth - 1 - z) * kWidth + x : z * kWidth + kWidth - 1 - x;
    return std::binary_search(sites.begin(), sites.end(), image);
  });
}

/// The best of all sets of `count` of the small room's 20 sites that obey a rule.
Evaluation bestOfAll(PreparedScene& prepared, const Intentions& intentions, std::uint32_t count,
                     const std::function<bool(const Sites&)>& obeys) {
  Evaluator evaluator(prepared, intentions);
  Evaluation best{1e9, 0, 1};
  for (std::uint32_t mask = 0; mask < 1u << 20; ++mask) {
    if (static_cast<std::uint32_t>(__builtin_popcount(mask)) != count) continue;
    Sites sites;
    for (std::uint32_t s = 0; s < 20; ++s)
      if (mask >> s & 1) sites.push_back(s);
    if (obeys(sites)) evaluator.tryLayout(sites, best);
  }
  return best;
}

Intentions ask(std::uint32_t count, Rule rule, PlanAxis axis = PlanAxis::kFound) {
  Intentions intentions;
  intentions.luminaires.count = count;
  intentions.luminaires.arrangement = {rule, axis};
  intentions.goals = {{Statistic::kSigma, Sense::kMinimize, 1, {2}, {}}};
  intentions.constraints = {{Statistic::kMean, 90, kUnbounded, 1, {2}, {}}};
  return intentions;
}

Sites sorted(Sites sites) {
  std::sort(sites.begin(), sites.end());
  return sites;
}

void expectBest(const Intentions& intentions, std::uint32_t evaluations,
                const std::function<bool(const Sites&)>& obeys) {
  PreparedScene prepared(smallRoom());
  ASSERT_TRUE(checkIntentions(smallRoom(), intentions));
  const std::uint32_t count = intentions.luminaires.count;
  const Evaluation best = bestOfAll(prepared, intentions, count, obeys);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    LayoutSearch search(prepared, intentions, seed);
    search.advance(evaluations);
    EXPECT_TRUE(obeys(sorted(search.incumbent().sites)));
    EXPECT_EQ(search.incumbent().sites.size(), count);
    EXPECT_NEAR(search.evaluation().violation, best.violation, 1e-9) << count << " seed " << seed;
    EXPECT_NEAR(search.evaluation().goal, best.goal, 1e-7) << count << " seed " << seed;
  }
}

TEST(Arrangements, TheBestFieldIsThatOfAllSets) {
  for (const std::uint32_t count : {1u, 2u, 4u, 6u, 12u})
    expectBest(ask(count, Rule::kField), 10000, isField);
}

TEST(Arrangements, TheBestRowsAreThoseOfAllSets) {
  for (const std::uint32_t count : {2u, 4u, 6u}) {
    Intentions intentions = ask(count, Rule::kRows);
    for (const std::uint32_t least : {2u, 3u}) {
      intentions.luminaires.arrangement.leastInRow = least;
      const auto obeys = [&](const Sites& sites) { return isRows(sites, std::min(least, count)); };
      expectBest(intentions, 60000, obeys);
    }
  }
}

// Twelve pairs are no rows on a ceiling.
TEST(Arrangements, ARowHasAsManyAsAreAskedFor) {
  LuminaireRules rules;
  rules.count = 12;
  rules.arrangement = {Rule::kRows};
  const auto shortest = [&](const Scene& scene) {
    std::uint32_t least = kNone;
    for (const Ties& ties : tiesUnder(SiteGrid(scene), rules)) least = std::min(least, ties.key.perTie);
    return least;
  };
  const Scene scene = ceiling();
  EXPECT_EQ(shortest(scene), 3u);  // what is not said
  rules.arrangement.leastInRow = 5;
  EXPECT_EQ(shortest(scene), 6u);  // twelve do not go into fives
  rules.arrangement.leastInRow = 2;
  EXPECT_EQ(shortest(scene), 2u);
  rules.arrangement.leastInRow = 20;
  EXPECT_EQ(shortest(scene), 12u);  // all in one
  const Result<Done> result = checkRules(ceiling(5, 5), rules);
  ASSERT_FALSE(result);
  EXPECT_NE(result.error().message.find("at least 20 in each"), std::string::npos);
  rules.arrangement.leastInRow = 1;
  EXPECT_FALSE(checkRules(scene, rules));
}

// Two rows whose luminaires alternate on one line are a line of uneven gaps: on a ceiling nobody sees rows.
TEST(Arrangements, RowsOnOneLineDoNotRunIntoEachOther) {
  const Scene scene = ceiling();
  const auto runTogether = [&](const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
    return RowSpan(scene, a).runsInto(RowSpan(scene, b));
  };
  EXPECT_TRUE(runTogether({0, 5, 10}, {2, 7, 12}));
  EXPECT_TRUE(runTogether({2, 7, 12}, {0, 5, 10}));
  EXPECT_TRUE(runTogether({0, 2, 4}, {5, 7, 9}));    // nearer than their pitch
  EXPECT_FALSE(runTogether({0, 2, 4}, {6, 8, 10}));  // one goes on where the other ends
  EXPECT_FALSE(runTogether({0, 2, 4}, {9, 11, 13}));
  EXPECT_FALSE(runTogether({0, 5, 10}, {22, 27, 32}));   // on the next line
  EXPECT_TRUE(runTogether({0, 40, 80}, {20, 60, 100}));  // across

  PreparedScene prepared(smallRoom());
  const std::uint32_t line = kWidth;  // all of the small room but its first line is kept free
  Intentions intentions = ask(4, Rule::kRows, PlanAxis::kX);
  intentions.luminaires.arrangement.leastInRow = 2;
  for (std::uint32_t site = line; site < line * kDepth; ++site)
    intentions.luminaires.excluded.push_back(site);
  intentions.luminaires.pinned = {0, 2};  // of a line of five: a row of 0 2, and another of 1 3 would hold it
  LayoutSearch search(prepared, intentions, 1);
  search.advance(2000);
  EXPECT_TRUE(isRows(sorted(search.incumbent().sites), 2)) << search.incumbent().sites[2];
}

TEST(Arrangements, TheBestSymmetricLayoutIsThatOfAllSets) {
  const auto aboutX = [](const Sites& sites) { return isMirrored(sites, true); };
  const auto aboutZ = [](const Sites& sites) { return isMirrored(sites, false); };
  expectBest(ask(6, Rule::kSymmetric, PlanAxis::kX), 20000, aboutX);
  expectBest(ask(5, Rule::kSymmetric, PlanAxis::kZ), 20000, aboutZ);  // one or three on the axis
  expectBest(ask(6, Rule::kSymmetric, PlanAxis::kBoth), 20000,
             [&](const Sites& sites) { return aboutX(sites) && aboutZ(sites); });
  expectBest(ask(4, Rule::kSymmetric), 20000,
             [&](const Sites& sites) { return aboutX(sites) || aboutZ(sites); });
}

TEST(Arrangements, PlanSymmetryIsExactInMetres) {
  PreparedScene prepared(longCorridor());
  Intentions intentions = ask(9, Rule::kSymmetric, PlanAxis::kZ);
  intentions.constraints.clear();
  intentions.luminaires.countHigh = 12;
  LayoutSearch search(prepared, intentions, 3);
  search.advance(20000);
  const Layout layout = search.incumbent();
  std::vector<std::array<double, 2>> places, images;
  for (const std::uint32_t site : layout.sites) {
    const Vec3& at = longCorridor().sites[site].position;
    places.push_back({at.x, at.z});
    images.push_back({4.5 - at.x, at.z});  // about the middle of 6 cells of 0.75 m
  }
  std::sort(places.begin(), places.end());
  std::sort(images.begin(), images.end());
  EXPECT_EQ(places, images);
  EXPECT_GE(layout.sites.size(), 9u);
  EXPECT_LE(layout.sites.size(), 12u);
}

// --- One member a tie

TEST(Arrangements, TiesOfOneMemberTakeTheSamePathBitForBit) {
  PreparedScene prepared(longCorridor());
  Intentions intentions = ask(6, Rule::kFree);
  intentions.constraints.push_back({Statistic::kMaximum, 1, kUnbounded, 1, {0}, {}});  // no survey of it
  intentions.luminaires.minDistance = 1;
  const Layout start{{3, 50, 99, 140, 200, 250}, {}, 1};
  const Ties alone = tiesUnder(prepared.grid(), intentions.luminaires)[0];
  const std::shared_ptr<PreparedScene> tied = prepared.tied(alone);
  Vns free(prepared, intentions, 5, &start), ties(*tied, intentions, 5, TiedStart{start.sites, 0});
  for (int slice = 0; slice < 20; ++slice) {
    free.advance(1000);
    ties.advance(1000);
    EXPECT_EQ(free.incumbent().sites, ties.incumbent().sites);
    EXPECT_EQ(free.evaluation().goal, ties.evaluation().goal);
    EXPECT_EQ(free.evaluation().violation, ties.evaluation().violation);
  }
}

TEST(Arrangements, AFreeLayoutOfAFixedCountTakesTheSamePathAsBefore) {
  PreparedScene prepared(longCorridor());
  const Intentions intentions = ask(6, Rule::kFree);
  Vns plain(prepared, intentions, 5);
  LayoutSearch search(prepared, intentions, 5);
  plain.advance(5000);
  search.advance(5000);
  EXPECT_EQ(plain.incumbent().sites, search.incumbent().sites);
  EXPECT_TRUE(search.incumbent().ties.empty());
}

// --- Counts

TEST(Arrangements, ARangeOfCountsFindsTheLeastPowerOfAll) {
  PreparedScene prepared(smallRoom());
  Intentions intentions = ask(2, Rule::kFree);
  intentions.luminaires.countHigh = 5;
  intentions.goals = {{Statistic::kPower, Sense::kMinimize, 1, {}, {}}};
  for (const double asked : {20.0, 55.0, 90.0}) {
    intentions.constraints = {{Statistic::kChebyshev, asked, kUnbounded, 0.5, {0}, {}}};
    Evaluation best{1e9, 0, 1};
    for (std::uint32_t count = 2; count <= 5; ++count) {
      const Evaluation e = bestOfAll(prepared, intentions, count, [](const Sites&) { return true; });
      if (isBetter(e, best)) best = e;
    }
    LayoutSearch search(prepared, intentions, 1);
    search.advance(30000);
    EXPECT_NEAR(search.evaluation().violation, best.violation, 1e-9) << asked;
    EXPECT_NEAR(search.evaluation().goal, best.goal, 1e-9) << asked;
  }
}

TEST(Arrangements, SlicesOfAnySizeGiveTheSameLayout) {
  PreparedScene prepared(longCorridor());
  for (const Rule rule : {Rule::kSymmetric, Rule::kRows, Rule::kField}) {
    Intentions intentions = ask(6, rule);
    intentions.luminaires.countHigh = 8;
    LayoutSearch whole(prepared, intentions, 11);
    LayoutSearch sliced(prepared, intentions, 11, nullptr, nullptr, Entering::kInSteps);
    std::size_t steps = 1;
    while (!sliced.enterNext()) ++steps;
    EXPECT_EQ(steps > 1, rule != Rule::kField);
    whole.advance(9000);
    for (std::uint32_t done = 0, slice = 1; done < 9000;
         done += slice, slice = std::min(2 * slice + 1, 9000 - done))
      sliced.advance(std::min(slice, 9000 - done));
    EXPECT_EQ(whole.incumbent().sites, sliced.incumbent().sites);
    EXPECT_EQ(whole.incumbent().ties, sliced.incumbent().ties);
    EXPECT_EQ(whole.evaluation().goal, sliced.evaluation().goal);
    EXPECT_EQ(whole.evaluations(), sliced.evaluations());
    EXPECT_EQ(whole.foundAt(), sliced.foundAt());
  }
}

// --- Pins, exclusions, distances

TEST(Arrangements, RulesOfSitesHoldForTies) {
  PreparedScene prepared(longCorridor());
  for (const Rule rule : {Rule::kSymmetric, Rule::kRows, Rule::kField}) {
    Intentions intentions = ask(6, rule);
    intentions.luminaires.pinned = {kNone, 40};
    for (std::uint32_t site = 200; site < 258; ++site) intentions.luminaires.excluded.push_back(site);
    intentions.luminaires.minDistance = 1.6;
    ASSERT_TRUE(checkIntentions(longCorridor(), intentions)) << static_cast<int>(rule);
    LayoutSearch search(prepared, intentions, 2);
    for (int slice = 0; slice < 10; ++slice) {
      search.advance(700);
      const Sites sites = search.incumbent().sites;
      ASSERT_EQ(sites.size(), 6u);
      EXPECT_EQ(sites[1], 40u);
      for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_LT(sites[i], 200u);
        for (std::size_t k = 0; k < i; ++k) EXPECT_GE(prepared.distance(sites[i], sites[k]), 1.6);
      }
    }
  }
}

TEST(Arrangements, ToHangJustAsFarApartAsAskedIsFarEnough) {
  Scene scene = smallRoom();
  for (std::uint32_t site = 0; site < scene.sites.size(); ++site) {
    // As scene files keep them: 0.9f - 0.3f is less than 0.6.
    scene.sites[site].position.x = 0.3f + 0.6f * static_cast<float>(site % kWidth);
    scene.sites[site].position.z = 0.3f + 0.6f * static_cast<float>(site / kWidth);
  }
  PreparedScene prepared(scene);
  for (const Rule rule : {Rule::kFree, Rule::kSymmetric, Rule::kRows, Rule::kField}) {
    Intentions intentions = ask(kWidth * kDepth, rule);
    intentions.luminaires.minDistance = 0.6;
    const Result<Done> result = checkIntentions(scene, intentions);
    ASSERT_TRUE(result) << result.error().message;
    LayoutSearch search(prepared, intentions, 1);
    search.advance(100);
    EXPECT_EQ(search.incumbent().sites.size(), scene.sites.size());
    intentions.luminaires.minDistance = 0.601;
    EXPECT_FALSE(checkIntentions(scene, intentions));
  }
}

TEST(Arrangements, SayWhatCannotBe) {
  const auto refusal = [](Intentions intentions) {
    const Result<Done> result = checkIntentions(smallRoom(), intentions);
    return result ? std::string() : result.error().message;
  };
  EXPECT_NE(refusal(ask(7, Rule::kField)).find("no regular field of 7"), std::string::npos);
  EXPECT_NE(refusal(ask(7, Rule::kRows)).find("no layout in rows of 7"), std::string::npos);
  EXPECT_NE(refusal(ask(5, Rule::kSymmetric, PlanAxis::kX)).find("no symmetric layout of 5"),
            std::string::npos);
  EXPECT_EQ(refusal(ask(5, Rule::kSymmetric, PlanAxis::kZ)), "");
  EXPECT_NE(refusal(ask(4, Rule::kFree, PlanAxis::kX)).find("\"free\" has no axis"), std::string::npos);
  EXPECT_NE(refusal(ask(4, Rule::kRows, PlanAxis::kBoth)).find("one axis"), std::string::npos);
  Intentions unequal = ask(2, Rule::kRows);
  unequal.luminaires.flux = {100, 200};
  EXPECT_NE(refusal(unequal).find("give one flux"), std::string::npos);
  unequal.luminaires.arrangement = {};
  unequal.luminaires.countHigh = 3;
  unequal.luminaires.flux = {100, 200};
  EXPECT_NE(refusal(unequal).find("give one flux"), std::string::npos);
  Intentions backwards = ask(4, Rule::kFree);
  backwards.luminaires.countHigh = 3;
  EXPECT_NE(refusal(backwards).find("the least comes first"), std::string::npos);
}

}  // namespace
}  // namespace fiatlux
