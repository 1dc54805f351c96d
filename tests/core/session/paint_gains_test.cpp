// What lighter paint gains against rooms that are painted so.
#include "core/session/paint_gains.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/session/session.h"
#include "tests/core/operator_scene.h"

namespace fiatlux {
namespace {

Intentions asked(Quantity quantity) {
  Intentions intentions;
  intentions.quantity = quantity;
  intentions.luminaires.count = 1;
  intentions.goals = {{Statistic::kMean, Sense::kMaximize, 1, {0}, {}},
                      {Statistic::kSigma, Sense::kMinimize, 1, {1}, {}}};
  intentions.constraints = {{Statistic::kMinimum, 1, kUnbounded, 1, {1}, {}}};
  return intentions;
}

class PaintGains : public ::testing::TestWithParam<Quantity> {
 protected:
  Scene scene = operatorScene(12, 3);
  Session session;
  void SetUp() override { session.adopt(scene); }

  /// The light of the first site in the room under paint.
  std::vector<float> lightUnder(const Repaint& paint) const {
    const float* column = scene.responses.column(0);
    return paint.light({column, column + scene.patches.rows()}, 1);
  }
  double meanUnder(const std::vector<SurfacePaint>& paint) {
    const auto repaint = session.repaint(paint);
    std::vector<float> values = lightUnder(**repaint);
    if (GetParam() == Quantity::kExitance)
      for (std::uint32_t p = 0; p < scene.patches.count; ++p) values[p] *= (*repaint)->reflectance()[p];
    return explicitStatistics(scene, values, {0}).mean;
  }
};

TEST_P(PaintGains, AreWhatALittleLighterPaintDoes) {
  const std::vector<SurfacePaint> before = {{0, 0.4}, {1, 0.5}};
  const auto repaint = session.repaint(before);
  ASSERT_TRUE(repaint);
  const auto gains = paintGains(scene, session.photometricLight()->exchange(), **repaint,
                                lightUnder(**repaint), asked(GetParam()));
  ASSERT_EQ(gains.size(), 2u);  // the plane only measures
  for (std::uint32_t s = 0; s < 2; ++s) {
    EXPECT_EQ(gains[s].surface, s);
    ASSERT_EQ(gains[s].goals.size(), 2u);
    ASSERT_EQ(gains[s].constraints.size(), 1u);
    std::vector<SurfacePaint> lighter = before, darker = before;
    lighter[s].reflectance += 0.005;
    darker[s].reflectance -= 0.005;
    const double gain = 10 * (meanUnder(lighter) - meanUnder(darker));
    EXPECT_GT(gain, 0);
    EXPECT_NEAR(gains[s].goals[0] / gain, 1, 0.02);
  }
}

INSTANTIATE_TEST_SUITE_P(Both, PaintGains, testing::Values(Quantity::kIlluminance, Quantity::kExitance));

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
