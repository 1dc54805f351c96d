// What lighter paint gains, of every statistic, against rooms that are painted so and evaluated anew.
#include "core/session/paint_gains.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "core/candidates/candidate_scene.h"
#include "core/search/plane_values.h"
#include "core/search/shown.h"
#include "core/session/session.h"
#include "tests/core/operator_scene.h"

namespace fiatlux {
namespace {

const Vec3 kX{1, 0, 0};
const Layout kLayout{{0, 2}, {1000, 700}, 0.8};

/// Every statistic that there is, of surfaces, of observers, on grids and on upright planes.
Intentions asked(Quantity quantity) {
  Intentions intentions;
  intentions.quantity = quantity;
  intentions.luminaires.count = 2;
  intentions.observers = {{"along", {0.4, 1.2, 1}, kX}, {"back", {2.6, 1.2, 1.2}, {-1, 0, 0}}};
  intentions.goals = {{Statistic::kMean, Sense::kMaximize, 1, {0}, {}},
                      {Statistic::kSigma, Sense::kMinimize, 1, {1}, {}},
                      {Statistic::kContrast, Sense::kMaximize, 1, {0}, {1}},
                      {Statistic::kPower, Sense::kMinimize, 1, {}, {}}};
  std::vector<Constraint>& constraints = intentions.constraints;
  constraints = {{Statistic::kMinimum, 1, kUnbounded, 1, {1}, {}},
                 {Statistic::kMaximum, 1, kUnbounded, 1, {0}, {}},
                 {Statistic::kUniformity, 0.1, kUnbounded, 1, {0}, {}},
                 {Statistic::kChebyshev, 1, kUnbounded, 1.5, {1}, {}},
                 {Statistic::kPower, 1, kUnbounded, 1, {}, {}},
                 {Statistic::kUgr, -kUnbounded, 19, 1, {}, {}},
                 {Statistic::kUgr, -kUnbounded, 19, 1, {}, {}, 1}};
  for (const bool isLeast : {false, true})
    for (const Statistic each : {Statistic::kCylindrical, Statistic::kModelling, Statistic::kVertical}) {
      const Vec3 direction = each == Statistic::kVertical ? kX : Vec3{};
      constraints.push_back({each, 0.1, kUnbounded, 1, {2}, {}, kNone, {}, isLeast, direction});
    }
  if (quantity == Quantity::kExitance) return intentions;  // which grids know nothing of
  for (const Statistic each : {Statistic::kMean, Statistic::kMinimum, Statistic::kUniformity})
    constraints.push_back({each, 0.1, kUnbounded, 1, {2}, {}, kNone, {}, false, {}, true});
  return intentions;
}

class PaintGains : public ::testing::TestWithParam<Quantity> {
 protected:
  Scene scene = operatorScene(12, 3);
  Session session;
  void SetUp() override { session.adopt(scene); }

  /// All sites of the room under paint, with all that is asked of them.
  Scene painted(const std::vector<SurfacePaint>& paint, const Intentions& asked) {
    CandidateScene candidates = *CandidateScene::ofSquares(scene, {0, 1, 2}, *session.repaint(paint));
    while (!candidates.advance(8)) continue;
    std::vector<ObserverRows> observers = candidates.seenBy(asked.observers);
    std::vector<PlaneLight> planes = *candidates.planesOf(planesAskedOf(asked));
    DirectLight direct = candidates.directLight();
    Scene made = candidates.finish(asked.quantity);
    made.observers = std::move(observers);
    made.planes = std::move(planes);
    made.direct = std::move(direct);
    return made;
  }

  /// Goals, then constraints, of the room under paint, evaluated anew.
  std::vector<double> readings(const std::vector<SurfacePaint>& paint, const Intentions& asked) {
    const Scene made = painted(paint, asked);
    PreparedScene prepared(made);
    const Shown shown = shownOf(prepared, asked, kLayout);
    std::vector<double> all = shown.goals;
    for (const ConstraintReading& reading : shown.constraints) all.push_back(reading.value);
    return all;
  }

  std::vector<PaintGain> gains(const std::vector<SurfacePaint>& paint, const Intentions& asked) {
    const Scene made = painted(paint, asked);
    const auto repaint = session.repaint(paint);
    return *paintGains(scene, *session.photometricLight(), **repaint, {made, kLayout}, asked);
  }
};

TEST_P(PaintGains, OfEveryStatisticAreWhatALittleLighterPaintDoes) {
  const std::vector<SurfacePaint> before = {{0, 0.4}, {1, 0.5}};
  const Intentions all = asked(GetParam());
  const std::vector<PaintGain> told = gains(before, all);
  const std::vector<double> now = readings(before, all);
  ASSERT_EQ(told.size(), 2u);  // the plane only measures
  for (std::uint32_t s = 0; s < 2; ++s) {
    EXPECT_EQ(told[s].surface, s);
    ASSERT_EQ(told[s].goals.size(), all.goals.size());
    ASSERT_EQ(told[s].constraints.size(), all.constraints.size());
    std::vector<SurfacePaint> lighter = before, darker = before;
    lighter[s].reflectance += 0.005;
    darker[s].reflectance -= 0.005;
    const std::vector<double> up = readings(lighter, all), down = readings(darker, all);
    std::vector<double> gained = told[s].goals;
    gained.insert(gained.end(), told[s].constraints.begin(), told[s].constraints.end());
    for (std::size_t i = 0; i < gained.size(); ++i) {
      const double gain = 10 * (up[i] - down[i]);
      EXPECT_NEAR(gained[i], gain, 0.02 * std::fabs(gain) + 2e-4 * std::fabs(now[i]))
          << "surface " << s << ", reading " << i << " of " << now[i];
    }
    // Lighter paint lightens its room, makes glare less, and changes no power.
    EXPECT_GT(told[s].goals[0], 0);
    EXPECT_EQ(told[s].goals[3], 0);
    EXPECT_LT(told[s].constraints[5], -0.1);
    EXPECT_GT(told[s].constraints[7], 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Both, PaintGains, ::testing::Values(Quantity::kIlluminance, Quantity::kExitance));

using PaintGainsOfDirect = PaintGains;
TEST_P(PaintGainsOfDirect, AreNone) {
  Intentions direct;
  direct.quantity = Quantity::kDirect;
  direct.luminaires.count = 2;
  direct.goals = {{Statistic::kMean, Sense::kMaximize, 1, {0}, {}}};
  direct.constraints = {{Statistic::kMinimum, 1, kUnbounded, 1, {1}, {}}};
  for (const PaintGain& gain : gains({{0, 0.4}}, direct)) {
    EXPECT_EQ(gain.goals[0], 0);
    EXPECT_EQ(gain.constraints[0], 0);
  }
}
INSTANTIATE_TEST_SUITE_P(Alone, PaintGainsOfDirect, ::testing::Values(Quantity::kDirect));

using PaintGainsUntold = PaintGains;
TEST_P(PaintGainsUntold, AreAnErrorWhereTheLightOfTheLayoutDoesNotTellWhatIsAsked) {
  const auto repaint = session.repaint({});
  const auto refused = [&](const Intentions& asked, const Scene& lit, const Layout& layout) {
    return !paintGains(scene, *session.photometricLight(), **repaint, {lit, layout}, asked);
  };
  const Intentions all = asked(GetParam());
  EXPECT_TRUE(refused(all, scene, kLayout));  // nobody has looked
  const Scene lit = painted({}, all);
  EXPECT_FALSE(refused(all, lit, kLayout));
  EXPECT_TRUE(refused(all, lit, {{0, 9}, {1, 1}, 1}));
  Intentions others = all;
  others.observers[0].position.y = 1.7;
  EXPECT_TRUE(refused(others, lit, kLayout));
}
INSTANTIATE_TEST_SUITE_P(Some, PaintGainsUntold, ::testing::Values(Quantity::kIlluminance));

TEST(SessionRepaint, SaysWhatCannotBePaintedAndKeepsTheLatest) {
  Session session;
  EXPECT_FALSE(session.repaint({}));
  session.adopt(operatorScene(12, 3));
  const auto refusal = [&](const std::vector<SurfacePaint>& paint) {
    const auto repaint = session.repaint(paint);
    return repaint ? std::string() : repaint.error().message;
  };
  EXPECT_NE(refusal({{9, 0.5}}).find("no surface 9"), std::string::npos);
  EXPECT_NE(refusal({{2, 0.5}}).find("only measures"), std::string::npos);
  EXPECT_NE(refusal({{0, 0.95}}).find("between 0.05 and 0.9"), std::string::npos);
  EXPECT_EQ(session.repaint({{0, 0.5}})->get(), session.repaint({{0, 0.5}})->get());
  Scene old = operatorScene(12, 3);
  old.lightOperator.reset();
  session.adopt(std::move(old));
  EXPECT_NE(refusal({{0, 0.5}}).find("make it again"), std::string::npos);
}

}  // namespace
}  // namespace fiatlux
