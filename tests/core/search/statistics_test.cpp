// Every statistic of the table: the search, what is shown and the relaxation agree on its value and on
// whether a bound is met, on dark surfaces too.
#include "core/search/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "core/bound/relaxed_intentions.h"
#include "core/search/evaluator.h"
#include "core/search/shown.h"
#include "core/search/start_layout.h"
#include "tests/core/corridor_scene.h"

namespace fiatlux {
namespace {

enum : std::uint32_t { kFloor, kCeiling, kDark, kHalfDark };
constexpr std::uint32_t kLuminaires = 3;

const Vec3 kEast{1, 0, 0};

/// Some light at six points of a plane, as dark as its surface is; two points of the last plane get light on
/// faces only.
PlaneLight pointsOn(std::uint32_t surface) {
  const std::uint32_t sites = fiatlux::testing::smallRoom().responses.sites;
  Responses horizontal{6, sites, {}}, upright{6, sites, {}};
  for (std::uint32_t j = 0; j < sites; ++j)
    for (std::uint32_t p = 0; p < 6; ++p) {
      const bool isDark = surface == kDark || (surface == kHalfDark && j < 10);
      const float light = isDark ? 0 : 0.01f * static_cast<float>(1 + (3 * j + p) % 7);
      upright.illuminance.push_back(0.4f * light);
      horizontal.illuminance.push_back(surface == kHalfDark && p < 2 ? 0 : light);
    }
  return {surface, horizontal, upright, {{kEast, upright}}};
}

/// A small room whose third surface gets no light at all and whose fourth none from the first half of the
/// sites.
const Scene& partlyDarkRoom() {
  static const Scene room = [] {
    Scene scene = fiatlux::testing::smallRoom();
    for (std::uint32_t j = 0; j < scene.responses.sites; ++j)
      for (std::uint32_t p = 0; p < scene.responses.rows; ++p)
        if (scene.patches.surface[p] == kDark || (scene.patches.surface[p] == kHalfDark && j < 10))
          scene.responses.illuminance[std::size_t{j} * scene.responses.rows + p] = 0;
    fiatlux::testing::addStatistics(scene);
    scene.errorBound.assign(scene.surfaces.size(), 0.02f);
    const std::vector<double> none(scene.responses.sites);
    scene.observers = {{{"one", {}, {1, 0, 0}}, {}, {}, none, none},
                       {{"two", {}, {0, 0, 1}}, {}, {}, none, none}};
    for (std::uint32_t j = 0; j < scene.responses.sites; ++j)
      for (std::uint32_t o = 0; o < 2; ++o) {
        scene.observers[o].glare.push_back(1e-4 * (1 + (j + 2 * o) % 5));
        scene.observers[o].background.push_back(1e-3 * (1 + j % 3));
      }
    for (const std::uint32_t surface : {+kFloor, +kDark, +kHalfDark})
      scene.planes.push_back(pointsOn(surface));
    return scene;
  }();
  return room;
}

const std::vector<std::vector<std::uint32_t>> kLayouts = {{0, 7, 19}, {1, 2, 3}, {12, 15, 4}, {9, 10, 11}};

/// Where a statistic may be asked: each surface, a union, all; contrasts against each of these.
std::vector<std::pair<SurfaceSet, SurfaceSet>> setsFor(const StatisticTraits& traits) {
  const std::vector<SurfaceSet> sets = {{kFloor}, {kDark}, {kHalfDark}, {kDark, kHalfDark}, {}};
  if (!traits.needsSurfaces) return {{{}, {}}};
  if (traits.ofPlanes) return {{{kFloor}, {}}, {{kDark}, {}}, {{kHalfDark}, {}}, {{kFloor, kHalfDark}, {}}};
  std::vector<std::pair<SurfaceSet, SurfaceSet>> pairs;
  for (const SurfaceSet& of : sets)
    for (const SurfaceSet& over : sets)
      if (traits.needsOver || &over == &sets[0])
        pairs.emplace_back(of, traits.needsOver ? over : SurfaceSet{});
  return pairs;
}

Intentions three(double dimming) {
  Intentions intentions;
  intentions.luminaires.count = kLuminaires;
  intentions.luminaires.flux = {1000};
  intentions.luminaires.dimmingLow = intentions.luminaires.dimmingHigh = dimming;
  for (const ObserverRows& rows : partlyDarkRoom().observers) intentions.observers.push_back(rows.observer);
  return intentions;
}

Layout layoutOf(const std::vector<std::uint32_t>& sites, double dimming) {
  return {sites, std::vector<double>(kLuminaires, 1000.0), dimming};
}

double valueAt(const ConvexObjective& form, const Layout& layout) {
  double value = form.constant + form.perDimming * layout.dimming;
  const std::size_t m = form.linear.size();
  for (std::size_t i = 0; i < layout.sites.size(); ++i)
    value += form.linear[layout.sites[i]] * layout.flux[i] * layout.dimming;
  for (const ConvexTerm& term : form.terms) {
    double quadratic = 0;
    for (std::size_t i = 0; i < layout.sites.size(); ++i)
      for (std::size_t j = 0; j < layout.sites.size(); ++j)
        quadratic += layout.flux[i] * layout.flux[j] * (*term.matrix)[layout.sites[i] * m + layout.sites[j]];
    value += term.weight * layout.dimming * std::sqrt(quadratic);
  }
  return value;
}

/// Asks one bound of one layout everywhere; returns whether it was met.
bool agreeOn(PreparedScene& prepared, const Constraint& constraint, const Layout& layout) {
  Intentions intentions = three(layout.dimming);
  intentions.constraints = {constraint};
  Evaluator evaluator(prepared, intentions);
  const double searched = evaluator.evaluate(layout.sites).violation;
  const ConstraintReading shown = shownOf(prepared, intentions, layout).constraints[0];
  if (std::isinf(searched)) {
    EXPECT_EQ(shown.violation, searched);
  } else {
    EXPECT_NEAR(missWeightOf(constraint.statistic) * shown.violation, searched, 2e-5 * (1 + searched));
  }
  EXPECT_EQ(shown.violation > 0, shown.margin < 0);
  if (shown.violation > 0) {
    EXPECT_DOUBLE_EQ(shown.violation, -shown.margin);
  } else {
    for (const ConvexObjective& form :
         relaxIntentions(prepared, intentions, {spreadSites(prepared, intentions.luminaires), {}, 1}).sides)
      EXPECT_LE(valueAt(form, layout), 1e-5) << "the relaxation forbids what is met";
  }
  return searched == 0;
}

TEST(Statistics, EachHasOneRowOfItsOwn) {
  std::set<std::string> names;
  for (const StatisticTraits& traits : kStatistics) {
    EXPECT_EQ(&traitsOf(traits.statistic), &traits);
    EXPECT_TRUE(names.insert(traits.name).second) << traits.name;
    EXPECT_TRUE(traits.needsVariance || !traits.needsExtremes) << traits.name;
  }
}

TEST(Statistics, SearchShownAndRelaxationAgreeOnEveryBound) {
  PreparedScene prepared(partlyDarkRoom());
  for (const StatisticTraits& traits : kStatistics) {
    int met = 0, missed = 0;
    for (const auto& [surfaces, over] : setsFor(traits))
      for (const auto& sites : kLayouts)
        for (const double dimming : {1.0, 0.4}) {
          const Layout layout = layoutOf(sites, dimming);
          SCOPED_TRACE(std::string(traits.name) + " of layout " + std::to_string(sites[0]));
          Intentions any = three(dimming);
          const bool onlyMost = traits.unit == Unit::kGlare;  // nobody asks for glare
          any.constraints = {
              {traits.statistic, onlyMost ? -kUnbounded : 0, onlyMost ? 0 : kUnbounded, 1.5, surfaces, over}};
          any.constraints[0].direction = kEast;
          const double value = shownOf(prepared, any, layout).constraints[0].value;
          const double around = std::isfinite(value) && value > 0 ? value : 1;
          for (const double factor : {0.5, 0.9, 1.1, 2.0})
            for (const Side side : {Side::kLower, Side::kUpper}) {
              if (onlyMost && side == Side::kLower) continue;
              Constraint constraint{traits.statistic, -kUnbounded, kUnbounded, 1.5, surfaces, over};
              (side == Side::kLower ? constraint.lower : constraint.upper) = factor * around;
              constraint.direction = kEast;
              ++(agreeOn(prepared, constraint, layout) ? met : missed);
            }
        }
    EXPECT_GT(met, 0) << traits.name;
    EXPECT_GT(missed, 0) << traits.name;
  }
}

TEST(Statistics, AUgrIsOfOneObserverOrOfTheWorstAndDimsAway) {
  PreparedScene prepared(partlyDarkRoom());
  const Layout layout = layoutOf({0, 7, 19}, 1);
  const std::vector<ObserverReading> seen = readObservers(partlyDarkRoom().observers, layout);
  const double one = ugrOf(glareRatio(seen[0])), two = ugrOf(glareRatio(seen[1]));
  ASSERT_GT(std::fabs(one - two), 0.1);
  Intentions intentions = three(1);
  intentions.luminaires.dimmingLow = 0.1;
  for (const std::uint32_t observer : {kNone, 0u, 1u})
    intentions.constraints.push_back({Statistic::kUgr, -kUnbounded, 40, 1, {}, {}, observer});
  const Shown shown = shownOf(prepared, intentions, layout);
  EXPECT_NEAR(shown.constraints[0].value, std::max(one, two), 1e-9);
  EXPECT_NEAR(shown.constraints[1].value, one, 1e-9);
  EXPECT_NEAR(shown.constraints[2].value, two, 1e-9);
  // Halving all fluxes takes 8 log10(2) = 2.4 away: a bound 2.4 below is met by that dimming and no brighter.
  intentions.constraints[0].upper = std::max(one, two) - 8 * std::log10(2.0);
  Evaluator evaluator(prepared, intentions);
  const Evaluation evaluation = evaluator.evaluate(layout.sites);
  EXPECT_EQ(evaluation.violation, 0);
  EXPECT_NEAR(evaluation.dimming, 0.5, 1e-9);
}

TEST(Statistics, AUgrThatIsMissedByThreeUnitsOutweighsNoMeanThatIsMissedByHalf) {
  PreparedScene prepared(partlyDarkRoom());
  const Layout layout = layoutOf({0, 7, 19}, 1);
  Intentions intentions = three(1);
  const auto missed = [&](const Constraint& constraint) {
    intentions.constraints = {constraint};
    return Evaluator(prepared, intentions).evaluate(layout.sites).violation;
  };
  intentions.constraints = {{Statistic::kUgr, -kUnbounded, 40, 1, {}, {}, kNone},
                            {Statistic::kMean, 0, kUnbounded, 1, {kFloor}, {}}};
  const Shown shown = shownOf(prepared, intentions, layout);
  const double blinded =
      missed({Statistic::kUgr, -kUnbounded, shown.constraints[0].value - 3, 1, {}, {}, kNone});
  EXPECT_GT(blinded, 0);
  EXPECT_LT(blinded, missed({Statistic::kMean, 2 * shown.constraints[1].value, kUnbounded, 1, {kFloor}, {}}));
}

TEST(Statistics, SearchAndShownAgreeOnEveryGoal) {
  PreparedScene prepared(partlyDarkRoom());
  for (const StatisticTraits& traits : kStatistics) {
    if (!traits.mayBeGoal) continue;
    for (const auto& [surfaces, over] : setsFor(traits))
      for (const auto& sites : kLayouts)
        for (const Sense sense : {Sense::kMinimize, Sense::kMaximize, Sense::kNear}) {
          if (sense == Sense::kNear && !traits.mayBeAimed) continue;
          Intentions intentions = three(0.4);
          intentions.goals = {{traits.statistic, sense, 1, surfaces, over, 50}};
          Evaluator evaluator(prepared, intentions);
          evaluator.load(sites);
          const double shown = shownOf(prepared, intentions, layoutOf(sites, 0.4)).goals[0];
          EXPECT_FALSE(std::isnan(evaluator.current().goal)) << traits.name;
          if (!std::isfinite(shown)) {
            EXPECT_EQ(std::isnan(shown), std::isnan(evaluator.goalValue(0))) << traits.name;
          } else {
            EXPECT_NEAR(evaluator.goalValue(0), shown, 1e-6 * (1 + shown)) << traits.name;
          }
        }
  }
}

TEST(Statistics, LightAgainstDarknessIsAnInfiniteContrast) {
  PreparedScene prepared(partlyDarkRoom());
  const Layout layout = layoutOf({0, 7, 19}, 1);
  Intentions intentions = three(1);
  intentions.goals = {{Statistic::kContrast, Sense::kMaximize, 1, {kFloor}, {kDark}}};
  intentions.constraints = {{Statistic::kContrast, 3, kUnbounded, 1, {kFloor}, {kDark}},
                            {Statistic::kContrast, -kUnbounded, 3, 1, {kFloor}, {kDark}}};
  const Shown shown = shownOf(prepared, intentions, layout);
  EXPECT_EQ(shown.goals[0], kUnbounded);
  EXPECT_EQ(shown.constraints[0].value, kUnbounded);
  EXPECT_EQ(shown.constraints[0].violation, 0);
  EXPECT_GT(shown.constraints[1].violation, 0);
}

TEST(Statistics, DarknessAgainstDarknessHasNoContrast) {
  PreparedScene prepared(partlyDarkRoom());
  for (const double dimming : {1.0, 0.4}) {
    const Layout layout = layoutOf({1, 2, 3}, dimming);
    for (const Side side : {Side::kLower, Side::kUpper})
      for (const double bound : {0.0, 3.0}) {
        Constraint constraint{Statistic::kContrast, -kUnbounded, kUnbounded, 1, {kHalfDark}, {kDark}};
        (side == Side::kLower ? constraint.lower : constraint.upper) = bound;
        EXPECT_FALSE(agreeOn(prepared, constraint, layout));
        Intentions intentions = three(dimming);
        intentions.constraints = {constraint};
        EXPECT_TRUE(std::isnan(shownOf(prepared, intentions, layout).constraints[0].value));
      }
  }
}

TEST(Statistics, AContrastDoesNotChangeWithTheDimmingDownToNothing) {
  PreparedScene prepared(partlyDarkRoom());
  Intentions intentions = three(1);
  intentions.luminaires.dimmingLow = 0;
  intentions.goals = {{Statistic::kPower, Sense::kMinimize, 1, {}, {}}};
  intentions.constraints = {{Statistic::kContrast, 0.1, kUnbounded, 1, {kFloor}, {kCeiling}}};
  Evaluator evaluator(prepared, intentions);
  const Evaluation darkest = evaluator.evaluate({0, 7, 19});
  EXPECT_EQ(darkest.dimming, 0);
  EXPECT_EQ(darkest.violation, 0);
  const Shown shown = shownOf(prepared, intentions, layoutOf({0, 7, 19}, 0));
  EXPECT_EQ(shown.constraints[0].violation, 0);
  EXPECT_NEAR(shown.constraints[0].value,
              shownOf(prepared, intentions, layoutOf({0, 7, 19}, 1)).constraints[0].value, 1e-12);
}

TEST(Statistics, WhatMissesABoundIsItsMarginTurnedRound) {
  for (const double bound : {-2.0, 0.0, 5.0})
    for (const double value : {-3.0, 0.0, 4.0, 5.0, 9.0, kUnbounded, std::nan("")})
      for (const Side side : {Side::kLower, Side::kUpper})
        EXPECT_EQ(excessOver(bound, side, value), std::max(0.0, -marginTo(bound, side, value)));
}

}  // namespace
}  // namespace fiatlux
