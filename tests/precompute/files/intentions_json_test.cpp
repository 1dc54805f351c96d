// intentions.json, with its observers_json: what it may say, and that everything else is refused in one line.
#include "precompute/files/intentions_json.h"

#include <gtest/gtest.h>

#include "tests/core/corridor_scene.h"
#include "tests/precompute/files/intentions_in.h"

namespace fiatlux {
namespace {

/// The small room with a tree of names: "room/floor", "room/ceiling", "yellow wall", "plane" (a measuring
/// plane).
Scene namedRoom() {
  Scene scene = fiatlux::testing::smallRoom();
  scene.surfaces[0].name = "room/floor";
  scene.surfaces[1].name = "room/ceiling";
  scene.surfaces[3].name = "plane";
  scene.surfaces[3].measuring = true;
  return scene;
}

void expectRefusal(const std::string& text, const std::string& part) {
  const Result<Intentions> result = intentionsIn(namedRoom(), text);
  ASSERT_FALSE(result) << text.substr(0, 200);
  EXPECT_NE(result.error().message.find(part), std::string::npos) << result.error().message;
  EXPECT_EQ(result.error().message.find('\n'), std::string::npos);
}

TEST(IntentionsJson, ReadsEverything) {
  const Result<Intentions> result = intentionsIn(namedRoom(), R"({
    "luminaires": {"count": 3, "flux": [100, 200, 300], "dimming": [0.1, 1], "pinned": [2], "excluded": [5, 6], "minDistance": 0.5},
    "goals": [{"surface": "yellow wall", "statistic": "sigma", "sense": "min", "weight": 2},
              {"surface": "room", "over": "plane", "statistic": "contrast", "sense": "max"}],
    "constraints": [{"surface": ["yellow wall", "room/floor"], "statistic": "chebyshev", "alpha": 2, "min": 3},
                    {"statistic": "power", "max": 500}, {"surface": "all", "statistic": "minimum", "min": 1}],
    "quantity": "illuminance"})");
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->luminaires.count, 3u);
  EXPECT_EQ(result->luminaires.flux, (std::vector<double>{100, 200, 300}));
  EXPECT_EQ(result->luminaires.dimmingLow, 0.1);
  EXPECT_EQ(result->luminaires.pinned, (std::vector<std::uint32_t>{2}));
  EXPECT_EQ(result->goals[0].surfaces, (SurfaceSet{2}));
  EXPECT_EQ(result->goals[0].weight, 2);
  EXPECT_EQ(result->goals[1].surfaces, (SurfaceSet{0, 1}));
  EXPECT_EQ(result->goals[1].over, (SurfaceSet{3}));
  EXPECT_EQ(result->constraints[0].surfaces, (SurfaceSet{0, 2}));
  EXPECT_EQ(result->constraints[0].alpha, 2);
  EXPECT_EQ(result->constraints[0].upper, kUnbounded);
  EXPECT_EQ(result->constraints[1].upper, 500);
  EXPECT_EQ(result->constraints[2].surfaces, SurfaceSet{});
}

TEST(IntentionsJson, ReadsAnArrangementAndARangeOfCounts) {
  const Result<Intentions> result = intentionsIn(
      namedRoom(),
      R"({"luminaires": {"count": [3, 8]}, "arrangement": {"rule": "symmetric", "axis": "both"}})");
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->luminaires.count, 3u);
  EXPECT_EQ(result->luminaires.countHigh, 8u);
  EXPECT_EQ(result->luminaires.arrangement.rule, Rule::kSymmetric);
  EXPECT_EQ(result->luminaires.arrangement.axis, PlanAxis::kBoth);
  expectRefusal(R"({"luminaires": {"count": [3]}})", "luminaires.count: a range of counts is [least, most]");
  expectRefusal(R"({"luminaires": {"count": [8, 3]}})", "luminaires.count: a range of counts");
  const Result<Intentions> rows = intentionsIn(
      namedRoom(), R"({"luminaires": {"count": 8}, "arrangement": {"rule": "rows", "leastInRow": 4}})");
  ASSERT_TRUE(rows) << rows.error().message;
  EXPECT_EQ(rows->luminaires.arrangement.leastInRow, 4u);
  expectRefusal(R"({"arrangement": {"rule": "field", "leastInRow": 6}})", "arrangement.leastInRow: ");
  expectRefusal(R"({"arrangement": {"axis": "x"}})", "arrangement: ");
  expectRefusal(R"({"arrangement": {"rule": "circle"}})", "arrangement.rule: ");
  expectRefusal(R"({"arrangement": {"rule": "rows", "axis": "y"}})", "arrangement.axis: ");
  expectRefusal(R"({"arrangement": {"rule": "field"}, "luminaires": {"count": 7}})", "no regular field of 7");
}

TEST(IntentionsJson, ReadsAnAim) {
  const Result<Intentions> result = intentionsIn(
      namedRoom(),
      R"({"goals": [{"surface": "room", "statistic": "mean", "sense": "near", "target": 500, "weight": 2}]})");
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->goals[0].sense, Sense::kNear);
  EXPECT_EQ(result->goals[0].target, 500);
  EXPECT_EQ(result->goals[0].weight, 2);
  const auto goal = [](const std::string& rest) {
    return "{\"goals\": [{\"surface\": \"all\", \"statistic\": " + rest + "}]}";
  };
  expectRefusal(goal(R"("mean", "sense": "near")"), "goal 1: no \"target\"; say near what");
  expectRefusal(goal(R"("mean", "sense": "max", "target": 3)"), "\"target\" belongs to \"near\" only");
  expectRefusal(goal(R"("mean", "sense": "near", "target": 0)"), "goal 1: a target of 0");
  expectRefusal(goal(R"("sigma", "sense": "near", "target": 3)"), "sigma cannot aim at a target");
  expectRefusal(goal(R"("mean", "sense": "next to", "target": 3)"), "known are min, max, near");
}

/// One that tells what comes from where, and whose plane is level.
Scene seeingRoom() {
  Scene room = namedRoom();
  for (std::uint32_t p = 0; p < room.patches.rows(); ++p)
    if (room.patches.surface[p] == 3) room.patches.normal[p] = {0, 1, 0};
  room.lightOperator.emplace();
  room.lightOperator->charts.ofRow = room.patches.surface;
  return room;
}

TEST(IntentionsJson, EveryStatisticOfTheTableIsAConstraintAndTheGoalsAreGoals) {
  const std::string look = R"("observers": [{"position": [1, 1.2, 1], "direction": [0, 0, 1]}], )";
  for (const StatisticTraits& traits : kStatistics) {
    std::string asked = std::string("\"statistic\": \"") + traits.name + "\"";
    if (traits.needsSurfaces) asked += traits.ofPlanes ? R"(, "surface": "plane")" : R"(, "surface": "room")";
    if (traits.statistic == Statistic::kVertical) asked += R"(, "direction": [0, 0, 2])";
    if (traits.needsOver) asked += ", \"over\": \"plane\"";
    const Result<Intentions> bound =
        intentionsIn(seeingRoom(), "{" + look + "\"constraints\": [{" + asked + ", \"max\": 1}]}");
    ASSERT_TRUE(bound) << bound.error().message;
    EXPECT_EQ(bound->constraints[0].statistic, traits.statistic);
    const Result<Intentions> goal =
        intentionsIn(seeingRoom(), "{" + look + "\"goals\": [{" + asked + ", \"sense\": \"min\"}]}");
    EXPECT_EQ(bool(goal), traits.mayBeGoal) << traits.name;
    if (goal) {
      EXPECT_EQ(goal->goals[0].statistic, traits.statistic);
    }
  }
}

TEST(IntentionsJson, ReadsObserversAndWhatGlareIsAskedOfThem) {
  const std::string look = R"("observers": [{"name": "desk", "position": [1, 1.2, 1], "direction": [0, 0, 2]},
      {"position": [2, 1.2, 1], "direction": [1, 0, 0]}])";
  const Result<Intentions> result = intentionsIn(namedRoom(), "{" + look + R"(,
      "constraints": [{"statistic": "ugr", "max": 19}, {"statistic": "ugr", "max": 16, "observer": "desk"}]})");
  ASSERT_TRUE(result) << result.error().message;
  ASSERT_EQ(result->observers.size(), 2u);
  EXPECT_EQ(result->observers[0].direction.z, 1);
  EXPECT_EQ(result->observers[1].name, "observer 2");
  EXPECT_EQ(result->constraints[0].observer, kNone);
  EXPECT_EQ(result->constraints[1].observer, 0u);
  const auto refuse = [&](const std::string& constraint, const char* part) {
    expectRefusal("{" + look + ", \"constraints\": [" + constraint + "]}", part);
  };
  refuse(R"({"statistic": "ugr", "min": 10})", "\"max\" only");
  refuse(R"({"statistic": "ugr", "max": 19, "observer": "door"})", "desk");
  refuse(R"({"statistic": "ugr", "max": 19, "surface": "room"})", "an observer");
  refuse(R"({"statistic": "mean", "surface": "room", "max": 19, "observer": "desk"})", "ugr only");
  expectRefusal(R"({"observers": [], "constraints": [{"statistic": "ugr", "max": 19}]})", "nobody looks");
  expectRefusal(R"({"observers": [{"position": [1, 2], "direction": [1, 0, 0]}]})", "[x, y, z]");
}

TEST(IntentionsJson, DirectLightMayBeAskedForApart) {
  const std::string asked = R"({"constraints": [
      {"statistic": "minimum", "surface": "plane", "min": 1, "quantity": "direct"},
      {"statistic": "mean", "surface": "plane", "min": 300}]})";
  expectRefusal(asked, "constraint 1 (minimum): this room's file does not tell direct light apart");
  const Result<Intentions> result = intentionsIn(seeingRoom(), asked);
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(quantityOf(*result, result->constraints[0]), Quantity::kDirect);
  EXPECT_EQ(quantityOf(*result, result->constraints[1]), Quantity::kIlluminance);
  EXPECT_TRUE(asksForDirect(*result));
  expectRefusal(R"({"constraints": [{"statistic": "power", "max": 9, "quantity": "direct"}]})",
                "power is of no quantity");
  expectRefusal(R"({"goals": [{"statistic": "mean", "surface": "all", "sense": "max", "quantity": "lux"}]})",
                "known are illuminance, exitance, direct");
}

TEST(IntentionsJson, PlanesAreAskedForTheirMeanOrTheirLeastPoint) {
  const Result<Intentions> result = intentionsIn(seeingRoom(), R"({"constraints": [
      {"statistic": "cylindrical", "surface": "plane", "min": 150, "of": "minimum"},
      {"statistic": "vertical", "surface": "plane", "min": 200, "direction": [-3, 0, 0]}]})");
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_TRUE(result->constraints[0].isLeast);
  EXPECT_FALSE(result->constraints[1].isLeast);
  EXPECT_EQ(result->constraints[1].direction.x, -1);
  const auto refuse = [](const std::string& constraint, const char* part) {
    expectRefusal("{\"constraints\": [{" + constraint + ", \"min\": 1}]}", part);
  };
  refuse(R"("statistic": "vertical", "surface": "plane")", "say which way the vertical plane faces");
  refuse(R"("statistic": "vertical", "surface": "plane", "direction": [0, 1, 0])", "faces sideways");
  refuse(R"("statistic": "cylindrical", "surface": "plane", "direction": [1, 0, 0])", "vertical only");
  refuse(R"("statistic": "mean", "surface": "plane", "of": "minimum")",
         "cylindrical, modelling and vertical");
  refuse(R"("statistic": "modelling", "surface": "yellow wall")", "is no measuring plane");
  refuse(R"("statistic": "cylindrical", "surface": "plane")", "it is not level");
}

TEST(IntentionsJson, WithoutDimmingItIsOne) {
  const Result<Intentions> result = intentionsIn(namedRoom(), R"({"luminaires": {"count": 1, "flux": 5}})");
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_EQ(result->luminaires.dimmingLow, 1);
  EXPECT_EQ(result->luminaires.dimmingHigh, 1);
}

TEST(IntentionsJson, RefusesWhatItDoesNotKnow) {
  expectRefusal("{", "line 1");
  expectRefusal("[]", "expected an object");
  expectRefusal(R"({"goal": []})",
                "unknown key \"goal\"; the closest is \"goals\" (known are luminaires, arrangement, goals, "
                "constraints, quantity, observers, taskAreas, paint)");
  expectRefusal(R"({"luminaires": {"cuont": 3}})", "luminaires: unknown key \"cuont\"");
  expectRefusal(R"({"luminaires": {"count": "3"}})", "luminaires.count: expected a number, found a text");
  expectRefusal(R"({"luminaires": {"count": 2.5}})", "whole number");
  expectRefusal(R"({"luminaires": {"pinned": [4294967295]}})", "no such site");
  expectRefusal(R"({"luminaires": {"dimming": [1]}})", "[low, high]");
  expectRefusal(R"({"goals": {}})", "goals: expected a list");
  expectRefusal(R"({"goals": [{"surface": "all", "statistic": "sigma"}]})", "goal 1: no \"sense\"");
  expectRefusal(R"({"goals": [{"surface": "all", "statistic": "minimum", "sense": "max"}]})",
                "goal 1.statistic: unknown \"minimum\"");
  expectRefusal(R"({"constraints": [{"statistic": "mean", "min": 3}]})", "constraint 1: no \"surface\"");
  expectRefusal(R"({"constraints": [{"surface": "all", "statistic": "mean"}]})", "no bound");
  expectRefusal(R"({"constraints": [{"surface": "all", "statistic": "mean", "min": 3, "alpha": 1}]})",
                "alpha");
  expectRefusal(R"({"constraints": [{"surface": "all", "statistic": "contrast", "min": 3}]})", "over");
  expectRefusal(R"({"quantity": "lux"})", "known are illuminance, exitance, direct");
  expectRefusal(R"({"constraints": [{"surface": [], "statistic": "mean", "min": 3}]})", "empty list");
  expectRefusal(R"({"luminaires": {"flux": 1e999}})", "out of range");
}

TEST(IntentionsJson, NamesTheClosestSurfaces) {
  expectRefusal(R"({"goals": [{"surface": "yelow wall", "statistic": "sigma", "sense": "min"}]})",
                "\"yellow wall\"");
  expectRefusal(R"({"goals": [{"surface": "room/flor", "statistic": "sigma", "sense": "min"}]})",
                "\"room/floor\"");
}

TEST(IntentionsJson, SurvivesHostileText) {
  expectRefusal(std::string(100000, '['), "nested deeper than 64");
  expectRefusal(std::string((2 << 20) + 1, ' '), "longer than 2 MB");
  expectRefusal("\xff\xfe{\x00}", "not valid JSON");
  expectRefusal("", "not valid JSON");
}

TEST(IntentionsJson, StrangersTextStaysOnOneLine) {
  expectRefusal(R"({"a\nb\u001b[31m": 1})", "unknown key \"a?b?[31m\"");
  expectRefusal(R"({"quantity": "lux\r\n"})", "unknown \"lux??\"");
  expectRefusal(R"({"goals": [{"surface": "x\ny", "statistic": "sigma", "sense": "min"}]})", "x?y");
}

}  // namespace
}  // namespace fiatlux
