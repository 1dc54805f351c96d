// What is told of a layout: the constraints that it misses, the goal in its unit, and the lines for a person.
#include "precompute/files/solve_report.h"

#include <gtest/gtest.h>

#include "tests/core/synthetic_scene.h"

namespace fiatlux {
namespace {

using Json = nlohmann::ordered_json;

Intentions threeConstraints() {
  Intentions intentions;
  intentions.constraints = {{Statistic::kMean, 300, kUnbounded, 1, {0}, {}},
                            {Statistic::kPower, -kUnbounded, 500, 1, {}, {}},
                            {Statistic::kChebyshev, 100, 200, 2, {}, {}}};
  return intentions;
}

Shown shownWith(std::vector<ConstraintReading> constraints, std::vector<double> goals) {
  Shown shown;
  shown.constraints = std::move(constraints);
  shown.goals = std::move(goals);
  return shown;
}

TEST(SolveReport, OnlyMissedConstraintsAreViolations) {
  const Scene scene = syntheticScene(8, 2);
  const Shown shown = shownWith({{240, 0.2}, {499, 0}, {99.99999, 1e-7}}, {});
  const Json violations = violationsJson(scene, threeConstraints(), shown);
  ASSERT_EQ(violations.size(), 1u);
  EXPECT_EQ(violations[0], Json({{"constraint", 1},
                                 {"statistic", "mean"},
                                 {"surface", scene.surfaces[0].name},
                                 {"value", 240.0},
                                 {"min", 300.0},
                                 {"violation", 0.2}}));
}

TEST(SolveReport, ConstraintsAsLines) {
  const Scene scene = syntheticScene(8, 2);
  const Shown shown = shownWith({{240, 0.2}, {499, 0}, {150, 0}}, {});
  EXPECT_EQ(constraintLine(scene, threeConstraints(), shown, 0),
            "mean of " + scene.surfaces[0].name + " 240 lx (at least 300): NOT met");
  EXPECT_EQ(constraintLine(scene, threeConstraints(), shown, 1), "power 499 lm (at most 500): met");
  EXPECT_EQ(constraintLine(scene, threeConstraints(), shown, 2),
            "chebyshev (alpha 2) of all 150 lx (at least 100, at most 200): met");
}

TEST(SolveReport, WhereNothingGlaresThereIsNoGlare) {
  const Scene scene = syntheticScene(8, 2);
  Intentions intentions;
  intentions.constraints = {{Statistic::kUgr, -kUnbounded, 19, 1, {}, {}}};
  EXPECT_EQ(constraintLine(scene, intentions, shownWith({{-kUnbounded, 0}}, {}), 0),
            "ugr of the worst observer none (at most 19): met");
}

TEST(SolveReport, AThousandthIsMetWithItsMargin) {
  const Scene scene = syntheticScene(8, 2);
  const auto line = [&](Statistic statistic, double violation) {
    Intentions intentions;
    intentions.constraints = {{statistic, 300, kUnbounded, 1, {0}, {}}};
    return constraintLine(scene, intentions, shownWith({{299.8, violation}}, {}), 0);
  };
  EXPECT_TRUE(line(Statistic::kMean, 0.0006).ends_with(": met but for 0.06 %"));
  EXPECT_TRUE(line(Statistic::kMean, 0.0011).ends_with(": NOT met"));
  EXPECT_TRUE(line(Statistic::kMinimum, 0.0006).ends_with(": NOT met")) << "what is true of each patch";
}

TEST(SolveReport, OneGoalIsANumberSeveralAreAList) {
  EXPECT_EQ(goalJson(shownWith({}, {})), Json(nullptr));
  EXPECT_EQ(goalJson(shownWith({}, {0.5})), Json(0.5));
  EXPECT_EQ(goalJson(shownWith({}, {0.5, 2})), Json({0.5, 2}));
}

}  // namespace
}  // namespace fiatlux
