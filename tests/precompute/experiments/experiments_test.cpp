// The experiments (experiments_dispersion, experiments_intentions, experiments_alpha, experiments_speed) on a
// small room: every part reports, its plots are SVG, and the search finds what the enumeration finds.
#include "precompute/experiments/experiments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/core/corridor_scene.h"

namespace fiatlux {
namespace {

TEST(Experiments, RunOnASmallRoomAndFindTheEnumeratedOptima) {
  PreparedScene prepared(fiatlux::testing::smallRoom());
  Experiments e{prepared, {2}};
  e.runs = 3;
  e.evaluations = 3000;
  experimentDispersion(e);
  experimentIntentions(e);
  experimentChebyshev(e);
  experimentAlpha(e);
  experimentSpeed(e);
  for (const char* part :
       {"## 5.1", "## 5.2", "## 5.3", "## 5.4", "## 5.5", "| homogenize | 3 of 3 |", "| vary | 3 of 3 |"})
    EXPECT_NE(e.report.find(part), std::string::npos) << part << "\n" << e.report;
  EXPECT_GT(e.brightestWall, 0);
  EXPECT_GT(e.guaranteed, 0);
  EXPECT_GE(std::count(e.rows.begin(), e.rows.end(), '\n'), 1 + 3 * 9);
  for (const auto& [name, svg] : e.pictures) {
    EXPECT_EQ(svg.rfind("<svg", 0), 0u) << name;
    EXPECT_EQ(svg.find("nan"), std::string::npos) << name;
  }
}

TEST(Experiments, ProveMoreByPairs) {
  PreparedScene prepared(fiatlux::testing::smallRoom());
  Experiments e{prepared, {2}};
  e.runs = 3;
  const Intentions even = problemOf(e, 4, Statistic::kSigma, Sense::kMinimize, {});
  const RunSummary found = repeat(e, "even", even);
  const auto shareIn = [](const std::string& proved) { return std::stod(proved.substr(7)); };
  const std::string alone = provedText(e, even, found.bestEvaluation);
  ASSERT_EQ(alone.rfind("within ", 0), 0u) << alone;
  e.byPairs = true;
  const std::string byPairs = provedText(e, even, found.bestEvaluation);
  if (byPairs != "proved optimal") EXPECT_LT(shareIn(byPairs), 0.9 * shareIn(alone)) << byPairs << alone;
}

}  // namespace
}  // namespace fiatlux
